#include "cli/recorded/replay_events.hpp"

#include "analysis/recorded/show_conflicts.hpp"
#include "analysis/text/bee_name.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/event_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace beespace::cli {
namespace {

struct RecordedFix {
  double time_s;
  PointId bee;
  std::uint32_t fix;
};

struct ToldEvent {
  SwarmEvent event;
  double said_at_s;
};

std::vector<Value> row_of(const ToldEvent& told, const analysis::LiveFeed& feed) {
  const SwarmEvent& event = told.event;
  std::vector<Value> row{event.time_s, std::string(name_of(event.kind)), {}, {}, {}, {}, {}, {}};
  if (event.kind == EventKind::kStale || event.kind == EventKind::kHeard) {
    row[2] = feed.name(event.first);
    return row;
  }
  row[4] = event.distance_m;
  if (event.kind == EventKind::kOverloaded) return row;
  row[2] = feed.name(event.first);
  row[3] = feed.name(event.second);
  row[5] = event.closest_s;
  if (event.kind != EventKind::kPredicted) return row;
  row[6] = told.said_at_s;
  row[7] = event.closing;
  return row;
}

// What is told of conflicts with drones that stand, in the order of time.
std::vector<SwarmEvent> events_of_standing(const io::Recording& recording,
                                           std::vector<Track> tracks,
                                           const std::vector<Conflict>& conflicts,
                                           analysis::LiveFeed& feed) {
  std::vector<PointId> bees;
  for (const Conflict& each : conflicts) bees.insert(bees.end(), {each.first, each.second});
  analysis::stand_in_tracks(recording, tracks);
  const auto standing = analysis::with_standing(std::move(tracks), recording, bees);
  std::vector<SwarmEvent> events;
  for (const Conflict& each : conflicts) {
    // One that never takes off has no number yet.
    const auto first = feed.number(recording.bees[each.first].id, {});
    const auto second = feed.number(recording.bees[each.second].id, {});
    if (!first || !second) continue;
    const auto tell = [&](EventKind kind, double time_s, double closest_s) {
      const auto a = position_at(standing[each.first], time_s);
      const auto b = position_at(standing[each.second], time_s);
      SwarmEvent event{kind, time_s, std::min(*first, *second), std::max(*first, *second)};
      if (a && b) event.distance_m = std::hypot(a->x - b->x, a->y - b->y, a->z - b->z);
      if (time_s == each.closest_s) event.distance_m = each.closest_m;
      event.closest_s = closest_s;
      events.push_back(event);
    };
    tell(EventKind::kEntered, each.begins_s, each.begins_s);
    if (each.begins_s < each.closest_s && each.closest_s < each.ends_s) {
      tell(EventKind::kClosestPassed, each.closest_s, each.closest_s);
    }
    tell(EventKind::kLeft, each.ends_s, each.closest_s);
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const SwarmEvent& a, const SwarmEvent& b) { return a.time_s < b.time_s; });
  return events;
}

// Each of the second ones before the first that is told later.
std::vector<ToldEvent> put_together(const std::vector<ToldEvent>& told,
                                    const std::vector<SwarmEvent>& beside) {
  std::vector<ToldEvent> all;
  all.reserve(told.size() + beside.size());
  auto next = beside.begin();
  for (const ToldEvent& each : told) {
    for (; next != beside.end() && next->time_s < each.event.time_s; ++next) {
      all.push_back({*next, next->time_s});
    }
    all.push_back(each);
  }
  for (; next != beside.end(); ++next) all.push_back({*next, next->time_s});
  return all;
}

}  // namespace

Result<RecordedEvents> events_of(const io::Recording& recording, const std::vector<Track>& tracks,
                                 analysis::Geometry geometry, const SwarmOptions& options,
                                 const analysis::LiveTimes& times,
                                 const std::vector<Conflict>& standing) {
  std::vector<RecordedFix> fixes;
  for (PointId bee = 0; bee < tracks.size(); ++bee) {
    for (std::uint32_t i = 0; i < tracks[bee].fixes.size(); ++i) {
      fixes.push_back({tracks[bee].fixes[i].time_s, bee, i});
    }
  }
  std::stable_sort(fixes.begin(), fixes.end(),
                   [](const RecordedFix& a, const RecordedFix& b) { return a.time_s < b.time_s; });
  RecordedEvents recorded;
  recorded.rows.calendar = io::calendar_of(recording);
  recorded.rows.columns = {
      {"time_s", nullptr, "time"},       {"event"},      {"first", "first_label"},
      {"second", "second_label"},        {"distance_m"}, {"closest_s", nullptr, "closest"},
      {"said_at_s", nullptr, "said_at"}, {"closing"}};
  recorded.rows.labelled = analysis::has_labels(recording);
  std::vector<ToldEvent> told;
  const analysis::LiveFeed* telling = nullptr;
  analysis::LiveFeed feed(options, times, [&](const std::vector<SwarmEvent>& events) {
    for (const SwarmEvent& event : events) told.push_back({event, telling->looked_s()});
  });
  telling = &feed;
  for (const RecordedFix& at : fixes) {
    const io::RecordedBee& bee = recording.bees[at.bee];
    const auto number = feed.number(bee.id, bee.label);
    if (!number) return feed.too_many();
    PositionReport report{*number, at.time_s, tracks[at.bee].fixes[at.fix].position};
    if (!bee.path) {
      const auto given = in_metres(recording, at.bee, at.fix, geometry);
      if (!given) return given.error();
      report = {report.id,       at.time_s,       given->position,
                given->velocity, given->height_m, given->climb_mps};
    }
    if (auto taken = feed.take(report); !taken) return taken.error();
  }
  if (auto done = feed.finish(); !done) return done.error();
  for (const ToldEvent& each :
       put_together(told, events_of_standing(recording, tracks, standing, feed))) {
    recorded.lines += event_line(each.event, each.said_at_s, feed);
    recorded.rows.rows.push_back(row_of(each, feed));
  }
  return recorded;
}

}  // namespace beespace::cli
