#include "cli/output/event_lines.hpp"

#include "io/json/json_writer.hpp"

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

void write_label(io::JsonWriter& json, const char* key, const analysis::BeeName& name) {
  if (!name.label.empty()) json.member(key, name.label);
}

// Labels come behind all else.
void write_members(io::JsonWriter& json, const SwarmEvent& event, double said_at_s,
                   const analysis::LiveFeed& feed) {
  json.member("event", name_of(event.kind));
  if (event.kind == EventKind::kPredicted) json.member("said_at_s", said_at_s);
  json.member("time_s", event.time_s);
  if (event.kind == EventKind::kStale || event.kind == EventKind::kHeard) {
    if (event.kind == EventKind::kHeard) json.member("since_s", event.since_s);
    json.member("id", feed.name(event.first).id);
    return write_label(json, "label", feed.name(event.first));
  }
  if (event.kind == EventKind::kOverloaded) {
    json.member("bound", name_of(event.bound)).member("left_out", event.count);
    if (event.bound != SwarmBound::kAgents) json.member("distance_m", event.distance_m);
    return;
  }
  json.member("first", feed.name(event.first).id).member("second", feed.name(event.second).id);
  json.member("distance_m", event.distance_m);
  if (event.kind == EventKind::kPossible || event.kind == EventKind::kLost) {
    json.member("since_s", event.since_s);
  }
  json.member("closest_s", event.closest_s);
  if (event.closing) json.member("closing", true);
  write_label(json, "first_label", feed.name(event.first));
  write_label(json, "second_label", feed.name(event.second));
}

void write_members(io::JsonWriter& json, const analysis::ClockNote& note,
                   const analysis::LiveFeed& feed) {
  const bool anew = note.kind == analysis::ClockNote::Kind::kAnew;
  json.member("event", anew ? "clocks_anew" : "clock").member("time_s", note.time_s);
  if (anew) {
    json.member("before_s", note.before_s);
    return;
  }
  json.member("id", feed.name(note.bee).id).member("ahead_s", note.ahead_s);
  json.member("right", note.kind == analysis::ClockNote::Kind::kRight);
  if (note.kind == analysis::ClockNote::Kind::kApart) json.member("corrected", false);
  write_label(json, "label", feed.name(note.bee));
}

std::string line_of(const auto&... told) {
  std::string line;
  io::JsonWriter json(line);
  json.begin_object();
  write_members(json, told...);
  json.end();
  return line + '\n';
}

}  // namespace

std::string event_line(const SwarmEvent& event, double said_at_s, const analysis::LiveFeed& feed) {
  return line_of(event, said_at_s, feed);
}

std::string clock_line(const analysis::ClockNote& note, const analysis::LiveFeed& feed) {
  return line_of(note, feed);
}

}  // namespace beespace::cli
