#include "cli/recorded/replay_events.hpp"

#include "analysis/text/bee_name.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/event_lines.hpp"

#include <algorithm>

namespace beespace::cli {
namespace {

struct RecordedFix {
  double time_s;
  PointId bee;
  std::uint32_t fix;
};

std::vector<Value> row_of(const SwarmEvent& event, const analysis::LiveFeed& feed) {
  if (event.kind == EventKind::kStale || event.kind == EventKind::kHeard) {
    return {event.time_s, std::string(name_of(event.kind)), feed.name(event.first), {}, {}, {}};
  }
  if (event.kind == EventKind::kOverloaded) {
    return {event.time_s, std::string(name_of(event.kind)), {}, {}, event.distance_m, {}};
  }
  return {event.time_s,           std::string(name_of(event.kind)),
          feed.name(event.first), feed.name(event.second),
          event.distance_m,       event.closest_s};
}

}  // namespace

Result<RecordedEvents> events_of(const io::Recording& recording, const std::vector<Track>& tracks,
                                 analysis::Geometry geometry, const SwarmOptions& options,
                                 const analysis::LiveTimes& times) {
  std::vector<RecordedFix> fixes;
  for (PointId bee = 0; bee < tracks.size(); ++bee) {
    for (std::uint32_t i = 0; i < tracks[bee].fixes.size(); ++i) {
      fixes.push_back({tracks[bee].fixes[i].time_s, bee, i});
    }
  }
  std::stable_sort(fixes.begin(), fixes.end(),
                   [](const RecordedFix& a, const RecordedFix& b) { return a.time_s < b.time_s; });
  RecordedEvents recorded;
  recorded.rows.columns = {
      {"time_s"},     {"event"},    {"first", "first_label"}, {"second", "second_label"},
      {"distance_m"}, {"closest_s"}};
  recorded.rows.labelled = analysis::has_labels(recording);
  const analysis::LiveFeed* seen = nullptr;
  analysis::LiveFeed feed(options, times, [&](const std::vector<SwarmEvent>& events) {
    for (const SwarmEvent& event : events) {
      recorded.lines += event_line(event, *seen);
      recorded.rows.rows.push_back(row_of(event, *seen));
    }
  });
  seen = &feed;
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
  return recorded;
}

}  // namespace beespace::cli
