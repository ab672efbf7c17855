#include <beespace/swarm.hpp>

#include "base/kept_crew.hpp"
#include "motion/flush.hpp"
#include "motion/live/live_bees.hpp"
#include "motion/live/live_encounters.hpp"
#include "motion/live/live_overload.hpp"
#include "motion/live/live_possible.hpp"
#include "motion/live/live_predictions.hpp"
#include "motion/separation.hpp"
#include "motion/validate.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace beespace {

namespace {

// What ErrorLocation::record counts in errors about reports.
constexpr const char* kAgents = "agents";

std::optional<Error> check(const SwarmOptions& options) {
  if (auto error = motion::check_separation(options.threshold_m, options.vertical_m)) return error;
  if (auto error = motion::check_heights(options.heights_apart, options.vertical_m)) return error;
  if (auto error = motion::check_height_unit(options.height_unit_m)) return error;
  const auto good = [](double value, double least) {
    return value >= least && motion::in_motion_domain(value);
  };
  if (!good(options.leave_factor, 1.0) || !good(options.horizon_s, 0.0) ||
      !good(options.max_age_s, kSmallestInMotion)) {
    return Error{ErrorCode::kInvalidArgument,
                 "leave_factor must be 1 or more, horizon_s 0 or more, max_age_s above 0, and all "
                 "of them finite",
                 {}};
  }
  if (options.max_speed_mps && !good(*options.max_speed_mps, 0.0)) {
    return Error{ErrorCode::kInvalidArgument,
                 "max_speed_mps must be 0 or more, and finite, where it is given",
                 {}};
  }
  if (options.max_agents == 0 || options.max_pairs == 0) {
    return Error{ErrorCode::kInvalidArgument, "max_agents and max_pairs must be 1 or more", {}};
  }
  return std::nullopt;
}

motion::Separation separation_of(const SwarmOptions& options, double factor) {
  motion::Separation separation{
      options.threshold_m * factor, {}, false, options.heights_apart, options.height_unit_m};
  if (options.vertical_m) separation.vertical_m = *options.vertical_m * factor;
  return separation;
}

Error about_agent(AgentId id, Error error) {
  error.location.array = kAgents;
  error.location.record = id;
  return error;
}

std::optional<Error> check_time(const char* what, double time_s) {
  if (motion::in_motion_domain(time_s)) return std::nullopt;
  return Error{std::isfinite(time_s) ? ErrorCode::kOutsideDomain : ErrorCode::kNotFinite,
               std::string(what) + " is " + std::to_string(time_s) +
                   " s; give a finite number of seconds, below 1.3e+30",
               {}};
}

bool earlier(const SwarmEvent& a, const SwarmEvent& b) {
  return std::tie(a.time_s, a.kind, a.first, a.second, a.bound) <
         std::tie(b.time_s, b.kind, b.first, b.second, b.bound);
}

}  // namespace

// What is inside is not for export.
class __attribute__((visibility("hidden"))) Swarm::State {
 public:
  State(const SwarmOptions& options, Crew* lent)
      : options_(options),
        enter_(separation_of(options, 1.0)),
        leave_(separation_of(options, options.leave_factor)),
        bees_(options.heights_apart),
        encounters_({leave_, enter_, options.leave_factor == 1.0},
                    std::max(0.05, options.leave_factor - 1.0) * options.threshold_m,
                    options.max_pairs),
        predictions_(enter_, leave_, options.horizon_s, options.max_pairs),
        possible_(enter_, options.max_speed_mps.value_or(0.0), options.max_age_s,
                  options.max_pairs),
        crew_(lent) {}

  Status update(PositionReport report);
  void remove(AgentId id) {
    bees_.remove(id);
    possible_.forget(id);
  }
  void lose(AgentId id) { bees_.lose(id); }
  Status advance(double now_s, std::vector<SwarmEvent>& events);
  Status finish(double now_s, std::vector<SwarmEvent>& events);
  Status begin_anew(double now_s, double then_s, std::vector<SwarmEvent>& events);

  [[nodiscard]] SwarmCounts counts() const {
    SwarmCounts counts = counts_;
    counts.agents = bees_.under_way();
    counts.stale = bees_.stale();
    counts.unknown_s = unknown_before_s_ + bees_.unknown_s();
    counts.missed_s = missed_before_s_ + bees_.missed_s();
    counts.heard_once = bees_.heard_once();
    counts.predicted = predictions_.open();
    return counts;
  }
  void movers(double time_s, std::vector<LiveMover>& movers) const;
  [[nodiscard]] std::vector<Silence> silences(double time_s) const;

 private:
  Error refuse(AgentId id);
  void report_refused(double now_s, std::vector<SwarmEvent>& events);
  core::Resources resources();
  void report_silences(double now_s, std::vector<SwarmEvent>& events);
  Status end(double now_s, bool anew, std::vector<SwarmEvent>& events);
  void search(double now_s, const core::Resources& with, std::vector<SwarmEvent>& events);

  SwarmOptions options_;
  motion::Separation enter_;
  motion::Separation leave_;
  motion::LiveBees bees_;
  motion::LiveEncounters encounters_;
  motion::LivePredictions predictions_;
  motion::LivePossible possible_;
  std::optional<double> now_s_;
  SwarmCounts counts_;
  std::uint64_t refused_ = 0;  // since the last advance(), first of this bee
  AgentId refused_first_ = 0;
  double unknown_before_s_ = 0.0;        // of bees before the last finish()
  double missed_before_s_ = 0.0;         // the same
  std::vector<motion::Return> returns_;  // silences that are over, since the last advance()
  core::Memory memory_;
  core::KeptCrew crew_;
};

Status Swarm::State::update(PositionReport report) {
  if (auto error = check(options_)) return *std::move(error);
  report.time_s = motion::flushed(report.time_s);
  report.position = motion::flushed(report.position);
  if (report.velocity) report.velocity = motion::flushed(*report.velocity);
  report.height_m = motion::flushed(report.height_m);
  report.climb_mps = motion::flushed(report.climb_mps);
  const Mover mover{report.position, report.velocity.value_or(Velocity{})};
  auto bad = motion::check_mover(mover, 0);
  if (!bad) bad = motion::check_height(report.height_m, report.climb_mps, 0);
  if (!bad) bad = check_time("the time of the report", report.time_s);
  if (bad) return about_agent(report.id, *std::move(bad));
  switch (bees_.take(report, options_.max_age_s, options_.max_agents)) {
    case motion::LiveBees::Taken::kFull:
      return refuse(report.id);
    case motion::LiveBees::Taken::kYes:
      ++counts_.taken;
      break;
    case motion::LiveBees::Taken::kRepeated:
      ++counts_.repeated;
      break;
    case motion::LiveBees::Taken::kLate:
      ++counts_.late;
      break;
    case motion::LiveBees::Taken::kContrary:
      ++counts_.contrary;
      break;
  }
  return std::monostate{};
}

Error Swarm::State::refuse(AgentId id) {
  if (refused_ == 0) refused_first_ = id;
  ++refused_;
  ++counts_.refused;
  return about_agent(id, {ErrorCode::kTooManyPoints,
                          "there are " + std::to_string(options_.max_agents) +
                              " agents already; remove some that are gone, or allow for more "
                              "(max_agents)",
                          {}});
}

void Swarm::State::report_refused(double now_s, std::vector<SwarmEvent>& events) {
  if (refused_ == 0) return;
  events.push_back({EventKind::kOverloaded, now_s, refused_first_, refused_first_, 0.0, now_s, 0.0,
                    std::exchange(refused_, 0), SwarmBound::kAgents});
}

core::Resources Swarm::State::resources() {
  memory_.start_call();
  return {crew_.of(options_.threads, bees_.under_way()), memory_};
}

void Swarm::State::report_silences(double now_s, std::vector<SwarmEvent>& events) {
  const auto report_stale = [&](AgentId bee, double last_s) {
    events.push_back({EventKind::kStale, last_s, bee, bee, 0.0, last_s, last_s});
  };
  bees_.take_returns(returns_);
  for (const motion::Return& back : returns_) {
    if (!back.reported_stale) report_stale(back.bee, back.since_s);
    events.push_back(
        {EventKind::kHeard, back.heard_s, back.bee, back.bee, 0.0, back.heard_s, back.since_s});
  }
  bees_.complete_stale(now_s, options_.max_age_s, report_stale);
}

void Swarm::State::search(double now_s, const core::Resources& with,
                          std::vector<SwarmEvent>& events) {
  bees_.settle(now_s, options_.max_age_s);
  encounters_.search(bees_, with, events).report(now_s, SwarmBound::kPairs, events);
}

Status Swarm::State::advance(double now_s, std::vector<SwarmEvent>& events) {
  events.clear();
  if (auto error = check(options_)) return *std::move(error);
  now_s = motion::flushed(now_s);
  if (auto error = check_time("the time to advance to", now_s)) return *std::move(error);
  if (now_s < now_s_.value_or(now_s)) {
    return Error{ErrorCode::kTimeOrder,
                 "cannot advance to " + std::to_string(now_s) +
                     " s; give a time that is not before the last",
                 {}};
  }
  now_s_ = now_s;
  report_silences(now_s, events);
  const core::Resources with = resources();
  // Before the search, which forgets where bees were.
  if (options_.max_speed_mps) {
    possible_.search(bees_, returns_, now_s, with, events)
        .report(now_s, SwarmBound::kPossible, events);
  }
  search(now_s, with, events);
  const auto predicted = predictions_.predict(bees_, encounters_.entered(), now_s, with, events);
  if (!predicted) {
    events.clear();
    return predicted.error();
  }
  predicted->report(now_s, SwarmBound::kPredicted, events);
  report_refused(now_s, events);
  std::sort(events.begin(), events.end(), earlier);
  return std::monostate{};
}

Status Swarm::State::end(double now_s, bool anew, std::vector<SwarmEvent>& events) {
  Status advanced = advance(now_s, events);
  if (!advanced) return advanced;
  bees_.complete_all(anew);
  search(now_s, resources(), events);
  std::sort(events.begin(), events.end(), earlier);
  predictions_.forget_all();
  possible_.forget_all();
  now_s_.reset();
  return std::monostate{};
}

Status Swarm::State::finish(double now_s, std::vector<SwarmEvent>& events) {
  Status ended = end(now_s, false, events);
  if (!ended) return ended;
  unknown_before_s_ += bees_.unknown_s();
  missed_before_s_ += bees_.missed_s();
  bees_ = motion::LiveBees(options_.heights_apart);
  return std::monostate{};
}

Status Swarm::State::begin_anew(double now_s, double then_s, std::vector<SwarmEvent>& events) {
  then_s = motion::flushed(then_s);
  events.clear();
  if (auto error = check_time("the time to begin anew at", then_s)) return *std::move(error);
  Status ended = end(now_s, true, events);
  if (ended) bees_.begin_anew(then_s - now_s);
  return ended;
}

void Swarm::State::movers(double time_s, std::vector<LiveMover>& movers) const {
  movers.clear();
  time_s = motion::flushed(time_s);
  if (!motion::in_motion_domain(time_s)) return;
  movers.reserve(bees_.known().size());
  for (const auto& [id, bee] : bees_.known()) {
    LiveMover mover{id, {bee.last.position, {}}, bee.last.time_s, bee.last.position, true, false};
    mover.stale = bee.stale();
    if (bee.has_segment()) {
      const motion::LiveSegment& segment = bees_.segments()[bee.segment];
      const Fix& last = segment.fixes.back();
      mover = {id, {last.position, {}}, last.time_s, last.position, false, segment.moves()};
      if (const auto now = segment.at(time_s)) mover.mover = now->mover;
    }
    movers.push_back(mover);
  }
  std::sort(movers.begin(), movers.end(),
            [](const LiveMover& a, const LiveMover& b) { return a.id < b.id; });
}

std::vector<Silence> Swarm::State::silences(double time_s) const {
  std::vector<Silence> silences;
  for (const auto& [id, bee] : bees_.known()) {
    Silence silence{id, bee.unknown_s, {}};
    if (bee.stale()) {
      silence.since_s = bee.last.time_s;
      silence.unknown_s += std::max(0.0, time_s - bee.last.time_s);
    }
    if (silence.unknown_s > 0.0 || silence.since_s) silences.push_back(silence);
  }
  std::sort(silences.begin(), silences.end(),
            [](const Silence& a, const Silence& b) { return a.id < b.id; });
  return silences;
}

Swarm::Swarm(const SwarmOptions& options) : state_(std::make_unique<State>(options, nullptr)) {
}
Swarm::Swarm(const SwarmOptions& options, Crew& crew)
    : state_(std::make_unique<State>(options, &crew)) {
}
Swarm::Swarm(Swarm&&) noexcept = default;
Swarm& Swarm::operator=(Swarm&&) noexcept = default;
Swarm::~Swarm() = default;

Status Swarm::update(const PositionReport& report) {
  return state_->update(report);
}

void Swarm::remove(AgentId id) {
  state_->remove(id);
}

void Swarm::lose(AgentId id) {
  state_->lose(id);
}

Status Swarm::advance(double now_s, std::vector<SwarmEvent>& events) {
  return state_->advance(now_s, events);
}

Result<std::vector<SwarmEvent>> Swarm::advance(double now_s) {
  std::vector<SwarmEvent> events;
  return advance(now_s, events).transform([&](std::monostate) { return std::move(events); });
}

Result<std::vector<SwarmEvent>> Swarm::finish(double now_s) {
  std::vector<SwarmEvent> events;
  return state_->finish(now_s, events).transform([&](std::monostate) { return std::move(events); });
}

Result<std::vector<SwarmEvent>> Swarm::begin_anew(double now_s, double then_s) {
  std::vector<SwarmEvent> events;
  return state_->begin_anew(now_s, then_s, events).transform([&](std::monostate) {
    return std::move(events);
  });
}

SwarmCounts Swarm::counts() const {
  return state_->counts();
}

std::vector<LiveMover> Swarm::movers(double time_s) const {
  std::vector<LiveMover> movers;
  state_->movers(time_s, movers);
  return movers;
}

void Swarm::movers(double time_s, std::vector<LiveMover>& movers) const {
  state_->movers(time_s, movers);
}

std::vector<Silence> Swarm::silences(double time_s) const {
  return state_->silences(time_s);
}

}  // namespace beespace
