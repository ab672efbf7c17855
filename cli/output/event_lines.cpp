#include "cli/output/event_lines.hpp"

#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

namespace beespace::cli {

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
    case SwarmBound::kAgents:
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
void append_label(std::string& line, const char* key, const analysis::BeeName& name) {
  if (name.label.empty()) return;
  line += std::string(", \"") + key + "\": " + io::json_string(name.label);
}

}  // namespace

std::string event_line(const SwarmEvent& event, const analysis::LiveFeed& feed) {
  std::string line = "{\"event\": \"";
  line += name_of(event.kind);
  line += "\", \"time_s\": " + io::exact(event.time_s);
  if (event.kind == EventKind::kStale || event.kind == EventKind::kHeard) {
    if (event.kind == EventKind::kHeard) line += ", \"since_s\": " + io::exact(event.since_s);
    line += ", \"id\": " + io::json_string(feed.name(event.first).id);
    append_label(line, "label", feed.name(event.first));
    return line + "}\n";
  }
  if (event.kind == EventKind::kOverloaded) {
    line += std::string(", \"bound\": \"") + name_of(event.bound) + "\"";
    line += ", \"left_out\": " + std::to_string(event.count);
    if (event.bound != SwarmBound::kAgents)
      line += ", \"distance_m\": " + io::exact(event.distance_m);
    return line + "}\n";
  }
  line += ", \"first\": " + io::json_string(feed.name(event.first).id);
  line += ", \"second\": " + io::json_string(feed.name(event.second).id);
  line += ", \"distance_m\": " + io::exact(event.distance_m);
  if (event.kind == EventKind::kPossible || event.kind == EventKind::kLost) {
    line += ", \"since_s\": " + io::exact(event.since_s);
  }
  line += ", \"closest_s\": " + io::exact(event.closest_s);
  append_label(line, "first_label", feed.name(event.first));
  append_label(line, "second_label", feed.name(event.second));
  return line + "}\n";
}

std::string clock_line(const analysis::ClockNote& note, const analysis::LiveFeed& feed) {
  std::string line = "{\"event\": ";
  line += note.kind == analysis::ClockNote::Kind::kAnew ? "\"clocks_anew\"" : "\"clock\"";
  line += ", \"time_s\": " + io::exact(note.time_s);
  if (note.kind == analysis::ClockNote::Kind::kAnew) {
    return line + ", \"before_s\": " + io::exact(note.before_s) + "}\n";
  }
  line += ", \"id\": " + io::json_string(feed.name(note.bee).id);
  line += ", \"ahead_s\": " + io::exact(note.ahead_s);
  line += note.kind == analysis::ClockNote::Kind::kOff ? ", \"right\": false" : ", \"right\": true";
  append_label(line, "label", feed.name(note.bee));
  return line + "}\n";
}

}  // namespace beespace::cli
