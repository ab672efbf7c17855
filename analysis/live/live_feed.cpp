#include "analysis/live/live_feed.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace beespace::analysis {
namespace {

// For so long at most the clocks of others are waited for to contradict one.
constexpr double kLongestUnopposed_s = 60.0;
// Clocks that differ by this part of what is not believed are named.
constexpr double kNamedShare = 0.25;

// Reports take some time to come: by so much the first of a bee may be late.
constexpr double kLate_s = 0.5;

// An overload that lasts is said again so often.
constexpr double kOverloadedAgain_s = 10.0;

// As it is told: a difference of times since 1970 has no more digits.
double rounded_s(double seconds) {
  constexpr double kMicroseconds = 1e6;
  return std::round(seconds * kMicroseconds) / kMicroseconds;
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

LiveFeed::LiveFeed(const SwarmOptions& options, const LiveTimes& times, Tell tell)
    : swarm_(options),
      max_age_s_(options.max_age_s),
      max_bees_(options.max_agents),
      times_(times.look_every_s),
      clocks_({times.max_skew_s, std::min(options.max_age_s, kLongestUnopposed_s)}),
      lags_(kNamedShare * times.max_skew_s),
      tell_(std::move(tell)) {
  overloaded_s_.fill(kNever);
}

std::optional<AgentId> LiveFeed::number(std::string_view id, std::string_view label) {
  // Bees mostly come in the order in which they came before.
  const AgentId guess = named_last_ < follows_.size() ? follows_[named_last_] : 0;
  std::optional<AgentId> found = guess;
  if (guess >= names_.size() || names_[guess].id != id) found = look_up(id);
  if (!found) return found;
  if (*found != guess && named_last_ < follows_.size()) follows_[named_last_] = *found;
  named_last_ = *found;
  left_at_s_[*found] = kNever;
  std::string& kept = names_[*found].label;
  if (!label.empty() && label != kept) kept = label;
  return found;
}

std::optional<AgentId> LiveFeed::known(std::string_view id) const {
  const auto found = numbers_.find(id);
  return found == numbers_.end() ? std::nullopt : std::optional<AgentId>(found->second);
}

Error LiveFeed::too_many() {
  ++refused_;
  return {ErrorCode::kTooManyPoints,
          "there are " + std::to_string(max_bees_) +
              " bees already; say --max-bees, or which have left",
          {}};
}

std::optional<AgentId> LiveFeed::look_up(std::string_view id) {
  if (const auto known = numbers_.find(id); known != numbers_.end()) return known->second;
  if (free_.empty() && names_.size() >= max_bees_) return std::nullopt;
  AgentId number = static_cast<AgentId>(names_.size());
  if (free_.empty()) {
    names_.emplace_back();
    follows_.push_back(0);
    left_at_s_.push_back(kNever);
  } else {
    number = free_.back();
    free_.pop_back();
  }
  numbers_.emplace(id, number);
  names_[number] = {std::string(id), {}};
  return number;
}

Status LiveFeed::take(const PositionReport& report, double wall_s) {
  if (!clocks_.take(report, wall_s, steps_)) return follow();
  compare_clocks(report);
  return pass_on(report, clocks_.now());
}

void LiveFeed::compare_clocks(const PositionReport& report) {
  lags_.take(report.id, report.time_s, clocks_.now(), apart_);
  for (const ClockLags::Told& told : apart_) {
    const auto kind = told.right ? ClockNote::Kind::kRight : ClockNote::Kind::kApart;
    note({kind, clocks_.now(), told.bee, told.ahead_s, 0.0});
  }
  apart_.clear();
}

// What follows of the clocks. Of reports that are refused the last is told.
Status LiveFeed::follow() {
  Status done = std::monostate{};
  for (const BeeClocks::Step& step : steps_) {
    Status next = std::monostate{};
    switch (step.kind) {
      case BeeClocks::Step::Kind::kReport:
        next = pass_on(step.report, step.now_s);
        break;
      case BeeClocks::Step::Kind::kLost:
        swarm_.lose(step.report.id);
        break;
      case BeeClocks::Step::Kind::kOff:
        note({ClockNote::Kind::kOff, step.now_s, step.report.id, rounded_s(step.ahead_s), 0.0});
        break;
      case BeeClocks::Step::Kind::kRight:
        note({ClockNote::Kind::kRight, step.now_s, step.report.id, rounded_s(step.ahead_s), 0.0});
        break;
      case BeeClocks::Step::Kind::kBack:
        next = go_back(step.now_s, step.anew);
        break;
    }
    if (!next) done = std::move(next);
  }
  steps_.clear();
  return done;
}

void LiveFeed::note(const ClockNote& note) {
  if (note_) note_(note);
}

// The look whose time has passed, if any.
Status LiveFeed::look_before(double now_s) {
  const auto number = times_.last_before(now_s);
  if (!number) {
    // More looks than can be counted: one at each new time.
    if (!looks_) looks_ = 0;
    next_look_s_ = now_s;
    return latest_s_ && now_s > *latest_s_ ? look(*latest_s_) : Status(std::monostate{});
  }
  const bool first = !looks_;
  if (first || *number > *looks_) {
    looks_ = number;
    next_look_s_ = times_.at(*number + 1);
    if (!first) return look(times_.at(*number));
  }
  return std::monostate{};
}

Status LiveFeed::pass_on(const PositionReport& report, double now_s) {
  if (!looks_ || now_s > next_look_s_) {
    if (auto done = look_before(now_s); !done) return done;
  }
  const SwarmCounts before = swarm_.counts();
  Status taken = swarm_.update(report);
  if (!taken) return taken;
  const SwarmCounts after = swarm_.counts();
  if (contrary_ && after.contrary > before.contrary) contrary_(report);
  if (after.missed_s > before.missed_s) note_missed(report.id, after.missed_s - before.missed_s);
  latest_s_ = std::max(latest_s_.value_or(now_s), now_s);
  intervals_.take(report.id, now_s);
  if (reported_) reported_(report, now_s);
  return taken;
}

void LiveFeed::note_missed(AgentId bee, double lasted_s) {
  if (lasted_s <= kLate_s) return;
  ++missed_;
  if (lasted_s > longest_missed_.lasted_s) longest_missed_ = {names_[bee].id, lasted_s};
}

std::optional<AgentId> LiveFeed::leave(std::string_view id) {
  const auto known = numbers_.find(id);
  if (known == numbers_.end()) return std::nullopt;
  const AgentId bee = known->second;
  clocks_.forget(bee);
  lags_.forget(bee);
  intervals_.forget(bee);
  swarm_.remove(bee);
  if (left_at_s_[bee] != kNever) return bee;
  left_at_s_[bee] = clocks_.now();
  leaving_.push_back({left_at_s_[bee], bee});
  return bee;
}

// Numbers of bees that have left are others' once nothing more can be told of them.
void LiveFeed::free_numbers() {
  while (!leaving_.empty() && leaving_.front().at_s + 2.0 * max_age_s_ < looked_s_) {
    const auto [at_s, bee] = leaving_.front();
    leaving_.pop_front();
    if (left_at_s_[bee] != at_s) continue;  // it has come back
    left_at_s_[bee] = kNever;
    numbers_.erase(names_[bee].id);
    names_[bee] = {};
    free_.push_back(bee);
  }
}

Status LiveFeed::look_if_due(double wall_s) {
  if (!looks_ || wall_s < not_before_s_) return std::monostate{};
  const auto number = times_.last_before(clocks_.now(wall_s) - kGrace_s);
  if (!number || *number <= *looks_) return std::monostate{};
  looks_ = number;
  next_look_s_ = times_.at(*number + 1);
  const double began_s = seconds_now();
  Status done = look(times_.at(*number));
  // Reading has its turn too.
  not_before_s_ = wall_s + 2.0 * (seconds_now() - began_s);
  return done;
}

double LiveFeed::next_look_in_s(double wall_s) const {
  if (!looks_) return kLongestWait_s;
  const double due_s = times_.at(*looks_ + 1) - (clocks_.now(wall_s) - kGrace_s);
  return std::clamp(std::max(due_s, not_before_s_ - wall_s), 0.0, kLongestWait_s);
}

// Time goes back: bees that are known at times to come would be in the way. They stay known, as of
// so long ago.
Status LiveFeed::go_back(double now_s, bool anew) {
  const double before_s = std::max(latest_s_.value_or(now_s), looked_s_);
  if (!anew && before_s <= now_s + max_age_s_) {
    looks_.reset();
    return std::monostate{};
  }
  lags_.clear();
  Status done = end(now_s);
  intervals_.clear();
  ended_with_.reset();
  silences_.clear();
  looks_.reset();
  latest_s_.reset();
  looked_s_ = kNever;
  for (Leaving& bee : leaving_) {
    if (left_at_s_[bee.bee] == bee.at_s) left_at_s_[bee.bee] = now_s;
    bee.at_s = now_s;
  }
  ++begun_anew_;
  note({ClockNote::Kind::kAnew, now_s, 0, 0.0, before_s});
  return done;
}

Status LiveFeed::finish() {
  clocks_.finish(steps_);
  Status done = follow();
  Status ended = end();
  return done ? ended : done;
}

Status LiveFeed::end(std::optional<double> anew_s) {
  if (!latest_s_) return std::monostate{};
  if (auto done = look(std::max(*latest_s_, looked_s_)); !done) return done;
  ended_with_ = swarm_.counts();
  silences_ = swarm_.silences(looked_s_);
  // Those that are stale are silences.
  silent_at_the_end_ = intervals_.silent(*latest_s_, max_age_s_);
  const auto events = anew_s ? swarm_.begin_anew(looked_s_, *anew_s) : swarm_.finish(looked_s_);
  if (!events) return events.error();
  if (!events->empty()) tell_(*events);
  return std::monostate{};
}

// What is so at each look is said once in a while.
bool LiveFeed::told_lately(const SwarmEvent& event) {
  if (event.kind != EventKind::kOverloaded) return false;
  double& last_s = overloaded_s_[static_cast<std::size_t>(event.bound)];
  if (looked_s_ >= last_s && looked_s_ < last_s + kOverloadedAgain_s) return true;
  last_s = looked_s_;
  return false;
}

Status LiveFeed::look(double time_s) {
  looked_s_ = std::max(looked_s_, time_s);
  auto events = swarm_.advance(looked_s_);
  if (!events) return events.error();
  if (refused_ > 0) {
    SwarmEvent event;
    event.kind = EventKind::kOverloaded;
    event.time_s = looked_s_;
    event.count = std::exchange(refused_, 0);
    event.bound = SwarmBound::kAgents;
    events->push_back(event);
  }
  std::erase_if(*events, [this](const SwarmEvent& event) { return told_lately(event); });
  if (!events->empty()) tell_(*events);
  free_numbers();
  if (looked_) looked_(looked_s_);
  return std::monostate{};
}

}  // namespace beespace::analysis
