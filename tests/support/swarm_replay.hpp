// A recording reported to a swarm, fix after fix; and the conflicts that find_conflicts finds.
#pragma once

#include "tests/support/recording_scenes.hpp"

#include <beespace/find_conflicts.hpp>
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

namespace beespace::test {

using Events = std::vector<SwarmEvent>;

inline auto key_of(const SwarmEvent& e) {
  return std::tie(e.time_s, e.kind, e.first, e.second, e.distance_m, e.closest_s);
}

inline bool earlier(const SwarmEvent& a, const SwarmEvent& b) {
  return key_of(a) < key_of(b);
}

inline Events of_kind(const Events& events, EventKind kind) {
  Events some;
  std::copy_if(events.begin(), events.end(), std::back_inserter(some),
               [&](const SwarmEvent& event) { return event.kind == kind; });
  return some;
}

// A report, and when it arrives.
struct Delivery {
  double arrives_s;
  PositionReport report;
};

// In the order in which they arrive: each bee's as much later as it says.
inline std::vector<Delivery> deliveries_of(
    const Tracks& tracks, const std::function<double(PointId)>& latency_s = nullptr) {
  std::vector<Delivery> deliveries;
  for (PointId id = 0; id < tracks.size(); ++id) {
    for (std::size_t i = 0; i < tracks[id].fixes.size(); ++i) {
      const auto& [time, position] = tracks[id].fixes[i];
      PositionReport report{id, time, position};
      if (!tracks[id].heights_m.empty()) report.height_m = tracks[id].heights_m[i];
      deliveries.push_back({time + (latency_s ? latency_s(id) : 0.0), report});
    }
  }
  std::stable_sort(deliveries.begin(), deliveries.end(),
                   [](const Delivery& a, const Delivery& b) { return a.arrives_s < b.arrives_s; });
  return deliveries;
}

inline void take_all(Swarm& swarm, double now_s, Events& events) {
  const Result<Events> more = swarm.advance(now_s);
  ASSERT_TRUE(more.has_value()) << more.error().message;
  ASSERT_TRUE(std::is_sorted(more->begin(), more->end(), [](const auto& a, const auto& b) {
    return std::tie(a.time_s, a.kind, a.first, a.second) <
           std::tie(b.time_s, b.kind, b.first, b.second);
  }));
  events.insert(events.end(), more->begin(), more->end());
}

// All events, sorted: the swarm is called every `every_s`, and at last when all are stale.
inline Events replay(const std::vector<Delivery>& deliveries, const SwarmOptions& options,
                     double every_s, SwarmCounts* counts = nullptr) {
  Swarm swarm(options);
  Events events;
  double asks_s = deliveries.empty() ? 0.0 : deliveries.front().arrives_s;
  double last_s = 0.0;
  for (const auto& [arrives_s, report] : deliveries) {
    for (; asks_s < arrives_s; asks_s += every_s) take_all(swarm, asks_s, events);
    EXPECT_TRUE(swarm.update(report).has_value());
    last_s = arrives_s;
  }
  take_all(swarm, std::max(last_s, asks_s) + 2.0 * options.max_age_s, events);
  EXPECT_EQ(swarm.counts().agents, 0U);
  if (counts != nullptr) *counts = swarm.counts();
  std::sort(events.begin(), events.end(), earlier);
  return events;
}

// The events that follow from reports alone.
inline Events happened(const Events& events) {
  Events some;
  for (const SwarmEvent& event : events) {
    const bool of_one = event.kind == EventKind::kStale || event.kind == EventKind::kHeard;
    if (event.kind != EventKind::kPredicted && !of_one) some.push_back(event);
  }
  return some;
}

// A stretch by the leave threshold in which the two come closer than the threshold.
struct ExpectedEncounter {
  Conflict stretch;
  double entered_s;
};

inline std::vector<ExpectedEncounter> expected_encounters(const Tracks& tracks,
                                                          const SwarmOptions& options) {
  ConflictOptions enter;
  enter.threshold_m = options.threshold_m;
  enter.vertical_m = options.vertical_m;
  enter.max_gap_s = options.max_age_s;
  ConflictOptions leave = enter;
  leave.threshold_m *= options.leave_factor;
  if (leave.vertical_m) *leave.vertical_m *= options.leave_factor;
  const auto inner = find_conflicts(tracks, enter).value().conflicts;
  const auto outer = find_conflicts(tracks, leave).value().conflicts;
  std::vector<ExpectedEncounter> expected;
  for (const Conflict& stretch : outer) {
    const auto entered = std::find_if(inner.begin(), inner.end(), [&](const Conflict& conflict) {
      return conflict.first == stretch.first && conflict.second == stretch.second &&
             conflict.begins_s >= stretch.begins_s && conflict.ends_s <= stretch.ends_s;
    });
    if (entered != inner.end()) expected.push_back({stretch, entered->begins_s});
  }
  return expected;
}

}  // namespace beespace::test
