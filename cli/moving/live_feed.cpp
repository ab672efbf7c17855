#include "cli/moving/live_feed.hpp"

#include "cli/number_text.hpp"
#include "io/json_text.hpp"

#include <algorithm>
#include <utility>

namespace beespace::cli {

LiveFeed::LiveFeed(const SwarmOptions& options, double every_s, Tell tell)
    : swarm_(options), times_(every_s), tell_(std::move(tell)) {
}

PointId LiveFeed::number(std::string_view id, std::string_view label) {
  auto known = numbers_.find(id);
  if (known == numbers_.end()) {
    known = numbers_.emplace(id, static_cast<PointId>(names_.size())).first;
    names_.push_back({std::string(id), {}});
  }
  std::string& kept = names_[known->second].label;
  if (!label.empty() && label != kept) kept = label;
  return known->second;
}

Status LiveFeed::take(const Report& report) {
  constexpr double kFarAhead_s = 60.0;
  if (waiting_) {
    // Borne out, unless the clock has gone back.
    const Report before = *std::exchange(waiting_, std::nullopt);
    if (report.time_s < before.time_s - kFarAhead_s) {
      ++ahead_;
    } else if (auto done = pass_on(before); !done) {
      return done;
    }
  }
  if (latest_s_ && report.time_s > *latest_s_ + kFarAhead_s) {
    waiting_ = report;
    return std::monostate{};
  }
  return pass_on(report);
}

Status LiveFeed::pass_on(const Report& report) {
  // More looks than can be counted: one at each new time.
  const auto number = times_.last_before(report.time_s);
  if (!looks_) looks_ = number.value_or(0);
  if (number && *number > *looks_) {
    looks_ = number;
    if (auto done = look(times_.at(*number)); !done) return done;
  } else if (!number && latest_s_ && report.time_s > *latest_s_) {
    if (auto done = look(*latest_s_); !done) return done;
  }
  Status taken = swarm_.update(report);
  idle_s_ = 0.0;
  if (!taken) return taken;
  latest_s_ = std::max(latest_s_.value_or(report.time_s), report.time_s);
  if (reported_) reported_(report);
  return taken;
}

Status LiveFeed::idle(double for_s) {
  idle_s_ += for_s;
  if (!latest_s_) return std::monostate{};
  return look(*latest_s_ + idle_s_);
}

Status LiveFeed::finish() {
  if (waiting_) {
    const Report last = *std::exchange(waiting_, std::nullopt);
    if (auto done = pass_on(last); !done) return done;
  }
  if (!latest_s_) return std::monostate{};
  if (auto done = look(*latest_s_); !done) return done;
  ended_with_ = swarm_.counts();
  const auto events = swarm_.finish(looked_s_);
  if (!events) return events.error();
  if (!events->empty()) tell_(*events);
  return std::monostate{};
}

Status LiveFeed::look(double time_s) {
  looked_s_ = std::max(looked_s_, time_s);
  const auto events = swarm_.advance(looked_s_);
  if (!events) return events.error();
  if (!events->empty()) tell_(*events);
  if (looked_) looked_(looked_s_);
  return std::monostate{};
}

const char* name_of(EventKind kind) {
  switch (kind) {
    case EventKind::kPredicted:
      return "predicted";
    case EventKind::kEntered:
      return "entered";
    case EventKind::kClosestPassed:
      return "closest_passed";
    case EventKind::kLeft:
      return "left";
    case EventKind::kStale:
      return "stale";
    case EventKind::kHeard:
      return "heard";
    case EventKind::kLost:
      return "lost";
    case EventKind::kEnded:
      return "ended";
    case EventKind::kPossible:
      return "possible";
    case EventKind::kOverloaded:
      return "overloaded";
  }
  return "unknown";
}

const char* name_of(SwarmBound bound) {
  switch (bound) {
    case SwarmBound::kNone:
      return "none";
    case SwarmBound::kBees:
      return "bees";
    case SwarmBound::kPairs:
      return "pairs";
    case SwarmBound::kPredicted:
      return "predicted";
    case SwarmBound::kPossible:
      return "possible";
  }
  return "unknown";
}

namespace {

// Behind all else, and only where there is one.
void append_label(std::string& line, const char* key, const BeeName& name) {
  if (name.label.empty()) return;
  line += std::string(", \"") + key + "\": " + io::json_string(name.label);
}

}  // namespace

std::string event_line(const SwarmEvent& event, const LiveFeed& feed) {
  std::string line = "{\"event\": \"";
  line += name_of(event.kind);
  line += "\", \"time_s\": " + exact(event.time_s);
  if (event.kind == EventKind::kStale || event.kind == EventKind::kHeard) {
    if (event.kind == EventKind::kHeard) line += ", \"since_s\": " + exact(event.since_s);
    line += ", \"id\": " + io::json_string(feed.name(event.first).id);
    append_label(line, "label", feed.name(event.first));
    return line + "}\n";
  }
  if (event.kind == EventKind::kOverloaded) {
    line += std::string(", \"bound\": \"") + name_of(event.bound) + "\"";
    line += ", \"left_out\": " + std::to_string(event.count);
    if (event.bound == SwarmBound::kBees) {
      line += ", \"id\": " + io::json_string(feed.name(event.first).id);
    } else {
      line += ", \"distance_m\": " + exact(event.distance_m);
    }
    return line + "}\n";
  }
  line += ", \"first\": " + io::json_string(feed.name(event.first).id);
  line += ", \"second\": " + io::json_string(feed.name(event.second).id);
  line += ", \"distance_m\": " + exact(event.distance_m);
  line += ", \"closest_s\": " + exact(event.closest_s);
  append_label(line, "first_label", feed.name(event.first));
  append_label(line, "second_label", feed.name(event.second));
  return line + "}\n";
}

}  // namespace beespace::cli
