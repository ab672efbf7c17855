// Tracks as fixes in an order that means nothing.
#pragma once

#include <beespace/agent_id.hpp>
#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/points_view.hpp>
#include <beespace/recording_out_of_core.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <vector>

namespace beespace::test {

// The tracks' numbers in between, so that they are not their ids.
inline AgentId agent_of(PointId track) {
  return (std::uint64_t{1} << 63U) - 20 + 7 * AgentId{track};
}

struct Fixes {
  std::vector<AgentId> agents;
  std::vector<double> times_s;
  std::vector<Point> positions;
  std::vector<double> heights;  // or none

  [[nodiscard]] PointsView view() const { return PointsView(positions).with_heights(heights); }
};

inline Fixes fixes_of(const std::vector<Track>& tracks, std::uint64_t seed) {
  Fixes all;
  for (PointId id = 0; id < tracks.size(); ++id) {
    for (std::size_t at = 0; at < tracks[id].fixes.size(); ++at) {
      all.agents.push_back(agent_of(id));
      all.times_s.push_back(tracks[id].fixes[at].time_s);
      all.positions.push_back(tracks[id].fixes[at].position);
      if (!tracks[id].heights_m.empty()) all.heights.push_back(tracks[id].heights_m[at]);
    }
  }
  std::vector<std::size_t> order(all.agents.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937_64(seed));
  Fixes mixed;
  for (const std::size_t at : order) {
    mixed.agents.push_back(all.agents[at]);
    mixed.times_s.push_back(all.times_s[at]);
    mixed.positions.push_back(all.positions[at]);
    if (!all.heights.empty()) mixed.heights.push_back(all.heights[at]);
  }
  return mixed;
}

// What is expected, under the ids of agents.
inline std::vector<LargeConflict> large(std::span<const Conflict> conflicts) {
  std::vector<LargeConflict> all;
  for (const Conflict& c : conflicts) {
    all.push_back(
        {agent_of(c.first), agent_of(c.second), c.begins_s, c.closest_s, c.ends_s, c.closest_m});
  }
  return all;
}
inline std::vector<LargeGap> large(std::span<const Gap> gaps) {
  std::vector<LargeGap> all;
  for (const Gap& gap : gaps) all.push_back({agent_of(gap.track), gap.begins_s, gap.ends_s});
  return all;
}

}  // namespace beespace::test
