#include "cli/watch/live_advice.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace beespace::cli {
namespace {

// All in steps. A report is old after so many; and what a look says is about the time until so many
// after it: the step that is under way, and the one that it advises.
constexpr double kOldAfter = 2.0;
constexpr double kSaidUntil = 2.0;
// How long a look waits for more reports; and what does not count when times are compared.
constexpr double kPatience = 0.5;
constexpr double kSlack = 0.01;

double speed_of(const Velocity& v) {
  return std::hypot(v.x, v.y, v.z);
}

}  // namespace

LiveAdvice::LiveAdvice(const LiveAdviceRequest& request, io::Frame frame, Name name, Tell tell)
    : request_(request),
      ticks_(request.options.step_s),
      frame_(frame),
      name_(std::move(name)),
      tell_(std::move(tell)) {
}

Status LiveAdvice::take(const PositionReport& report, double now_s) {
  const auto [known, is_new] = bees_.try_emplace(report.id);
  Bee& bee = known->second;
  // Late, or repeated.
  if (!is_new && report.time_s <= bee.last_s) return std::monostate{};
  if (!next_) {
    clock_s_ = report.time_s;
    next_ = ticks_.at_or_before(clock_s_);
    if (clock_s_ - ticks_.time_of(*next_) > kSlack * ticks_.step_s()) ++*next_;
    first_ = *next_;
  }
  // One bee that is corrected must not take time on for all: looks would be skipped.
  clock_s_ = std::max(clock_s_, std::min(report.time_s, now_s));
  if (is_new) {
    meet(bee, report);
  } else {
    hear(bee, report);
  }
  await(bee);
  return take_looks();
}

void LiveAdvice::meet(Bee& bee, const PositionReport& report) const {
  bee.preferred = report.velocity.value_or(Velocity{});
  bee.flight.anchor(report.time_s, {report.position, bee.preferred}, ticks_,
                    request_.limits.max_acceleration_mps2);
  bee.doubt = report.velocity ? Doubt::kHeardOnce : Doubt::kNoVelocity;
  bee.last = report.position;
  bee.last_s = report.time_s;
}

void LiveAdvice::hear(Bee& bee, const PositionReport& report) const {
  const double passed_s = report.time_s - bee.last_s;
  // Without its own: a mean, half as old as the report before, and not what can be relied upon.
  const Velocity velocity = report.velocity.value_or(Velocity{
      (report.position.x - bee.last.x) / passed_s, (report.position.y - bee.last.y) / passed_s,
      (report.position.z - bee.last.z) / passed_s});
  const Mover now{report.position, velocity};
  const double acceleration = request_.limits.max_acceleration_mps2;
  const double until_s = (kOldAfter + kSaidUntil) * ticks_.step_s();
  const bool borne_out =
      report.velocity && bee.flight.deviation_m(report.time_s, now, until_s, acceleration) <=
                             request_.options.uncertainty_m;
  if (borne_out) {
    bee.doubt = Doubt::kNone;
  } else {
    bee.flight.anchor(report.time_s, now, ticks_, acceleration);
    bee.preferred = velocity;
    bee.doubt = !report.velocity ? Doubt::kNoVelocity
                : bee.advised    ? Doubt::kNotAsAdvised
                                 : Doubt::kHeardOnce;
  }
  bee.every_s = passed_s;
  bee.last = report.position;
  bee.last_s = report.time_s;
}

bool LiveAdvice::old(const Bee& bee) const {
  return ticks_.time_of(*next_) - bee.last_s > (kOldAfter + kSlack) * ticks_.step_s();
}

// A report that is due before the look where the bee goes on as it did, and not long overdue.
void LiveAdvice::await(Bee& bee) {
  const double step_s = ticks_.step_s();
  const bool in = ticks_.at_or_before(bee.last_s) >= *next_;
  const bool due = bee.last_s + bee.every_s <= ticks_.time_of(*next_) + kSlack * step_s;
  const bool overdue =
      bee.last_s + std::max(bee.every_s, kOldAfter * step_s) < clock_s_ - (1 + kSlack) * step_s;
  const bool awaited = !in && due && !overdue;
  if (awaited && !bee.awaited) ++awaited_;
  if (!awaited && bee.awaited) --awaited_;
  bee.awaited = awaited;
}

void LiveAdvice::go_on_to(Tick tick) {
  next_ = tick;
  for (auto& [id, bee] : bees_) await(bee);
}

Status LiveAdvice::take_looks() {
  for (;;) {
    const Tick now = ticks_.at_or_before(clock_s_);
    // What such a look would say, would have had to be flown before it is said.
    if (now > *next_) {
      skipped_ += static_cast<std::uint64_t>(now - std::max(*next_, first_ + 1));
      go_on_to(now);
    }
    const bool waits_no_longer =
        clock_s_ - ticks_.time_of(*next_) >= (kPatience - kSlack) * ticks_.step_s();
    // At first it is not known which bees will report.
    const bool waits = awaited_ > 0 || *next_ == first_ || now < *next_ - 1;
    if (waits && !waits_no_longer) return std::monostate{};
    if (auto done = look(); !done) return done;
  }
}

std::optional<int> LiveAdvice::patience_ms() const {
  if (!next_ || ticks_.at_or_before(clock_s_) < *next_) return std::nullopt;
  constexpr double kMost = 1e6;
  return static_cast<int>(std::clamp(std::ceil(kPatience * ticks_.step_s() * 1000.0), 1.0, kMost));
}

Status LiveAdvice::waited() {
  if (!patience_ms()) return std::monostate{};
  if (auto done = look(); !done) return done;
  return take_looks();
}

void LiveAdvice::start_anew(double time_s) {
  const double shift_s = time_s - clock_s_ - ticks_.step_s();
  for (auto& [id, bee] : bees_) {
    bee.last_s += shift_s;
    bee.flight = NominalFlight();
    bee.flight.anchor(bee.last_s, {bee.last, bee.preferred}, ticks_,
                      request_.limits.max_acceleration_mps2);
    if (bee.doubt != Doubt::kNoVelocity) bee.doubt = Doubt::kHeardOnce;
    bee.awaited = false;
  }
  awaited_ = 0;
  next_.reset();
}

Status LiveAdvice::finish() {
  return patience_ms() ? look() : Status(std::monostate{});
}

void LiveAdvice::note_clock(AgentId id, bool off) {
  if (off) {
    clocks_off_.insert(id);
  } else {
    clocks_off_.erase(id);
  }
}

void LiveAdvice::remove(AgentId id) {
  clocks_off_.erase(id);
  const auto known = bees_.find(id);
  if (known == bees_.end()) return;
  if (known->second.awaited) --awaited_;
  bees_.erase(known);
}

// Nothing is known but how far it may have come.
bool LiveAdvice::unknown(const Bee& bee) const {
  return ticks_.time_of(*next_) - bee.last_s > request_.max_age_s ||
         (bee.doubt == Doubt::kNoVelocity && bee.every_s == 0.0);
}

void LiveAdvice::add(AgentId number, Bee& bee) {
  bee.flight.extend(*next_ + 1, bee.advised, ticks_, request_.limits.max_acceleration_mps2);
  const Mover mover = bee.flight.end();
  FlightLimits limits = request_.limits;
  limits.max_speed_mps = std::max(limits.max_speed_mps, speed_of(mover.velocity));
  if (unknown(bee)) {
    const double age_s = ticks_.time_of(*next_ + 1) - bee.last_s;
    unknown_.push_back(
        {bee.last, limits.max_speed_mps * std::max(age_s, 0.0), limits.max_speed_mps, number});
  }
  movers_.push_back(mover);
  preferred_.push_back(bee.preferred);
  limits_.push_back(limits);
}

Status LiveAdvice::look() {
  movers_.clear();
  preferred_.clear();
  limits_.clear();
  unknown_.clear();
  AgentId number = 0;
  for (auto& [id, bee] : bees_) add(number++, bee);
  request_.options.unknown = unknown_;
  Status advised = adviser_.advise(movers_, preferred_, limits_, request_.options, advised_);
  if (advised) tell_all();
  go_on_to(*next_ + 1);
  return advised;
}

void LiveAdvice::tell_all() {
  const AdviceTimes times{ticks_.time_of(*next_), ticks_.time_of(*next_ + 1)};
  LookCounts counts;
  counts.bees = bees_.size();
  std::string text;
  std::size_t i = 0;
  for (auto& [id, bee] : bees_) {
    const Advice& advice = advised_.advice[i];
    const Mover& mover = movers_[i++];
    Doubt doubt = bee.doubt;
    if (ticks_.time_of(*next_) - bee.last_s > request_.max_age_s) doubt = Doubt::kStale;
    if (doubt == Doubt::kNone && old(bee)) doubt = Doubt::kOldReport;
    if (doubt == Doubt::kNone && advice.kind == AdviceKind::kNone) doubt = Doubt::kRefused;
    if (doubt == Doubt::kNone && !advice.keeps_apart) doubt = Doubt::kTooClose;
    // Until the next advice takes effect, as all that is said.
    if (doubt == Doubt::kNone && advice.clear_of_unknown_s < ticks_.step_s()) {
      doubt = Doubt::kNearUnknown;
    }
    if (doubt == Doubt::kNone && clocks_off_.contains(id)) doubt = Doubt::kClockOff;
    if (doubt == Doubt::kNone && unplaced_) doubt = Doubt::kUnplaced;
    ++counts.doubts[static_cast<std::size_t>(doubt)];
    // A bee that is heard of no more after this has its name in one line at least.
    const bool told = !bee.advised || doubt != Doubt::kNone || !(advice.velocity == mover.velocity);
    bee.advised = true;
    if (advice.kind == AdviceKind::kNone) {
      bee.flight.fly(mover.velocity, false, ticks_, request_.limits.max_acceleration_mps2);
    } else {
      bee.flight.fly(advice.velocity, told, ticks_, request_.limits.max_acceleration_mps2);
    }
    if (!told) continue;
    ++counts.told;
    append_advice_line(text, times, name_(id), mover, advice, doubt, frame_);
  }
  append_advised_line(text, times, counts);
  told_ += counts.told;
  uncertified_ += counts.bees - counts.doubts[0];
  tell_(text);
}

}  // namespace beespace::cli
