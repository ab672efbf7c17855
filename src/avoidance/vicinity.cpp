#include "avoidance/vicinity.hpp"

#include "grid/density.hpp"
#include "grid/size_levels.hpp"

#include <algorithm>

namespace beespace::avoidance {

Status Vicinity::find(const AgentStates& agents, const RunOptions& run) {
  memory_.start_call();
  const double reach_m = reach_in_rows(agents);
  far_.clear();
  is_far_.clear();
  if (reach_m < agents.farthest_reach()) {
    for (PointId bee = 0; bee < agents.size(); ++bee) {
      is_far_.push_back(agents.reach(bee) > reach_m ? 1 : 0);
      if (is_far_.back() != 0) far_.push_back(bee);
    }
  }
  return find_rows(agents.middles(), agents.meet(reach_m, reach_m), run);
}

Status Vicinity::find_within(const PointsView& places, double within_m, const RunOptions& run) {
  far_.clear();
  is_far_.clear();
  return find_rows(places, within_m, run);
}

Status Vicinity::find_rows(const PointsView& places, double within_m, const RunOptions& run) {
  agents_ = places.size();
  const SearchOptions around{.threshold_m = within_m, .threads = run.threads, .stop = run.stop};
  return engine_.find_neighbors(places, around, rows_);
}

// Up to which reach bees have rows: all, unless it costs less to compare a few with all others.
double Vicinity::reach_in_rows(const AgentStates& agents) {
  const auto levels = motion::size_levels(agents.size(), agents.farthest_reach(), memory_,
                                          [&](std::size_t bee) { return agents.reach(bee); });
  if (levels.size() == 1) return levels.front().size;
  const core::DensitySample sample(agents.middles(), memory_);
  const auto cost = [&](const motion::SizeLevel& level) {
    return motion::comparing_cost(sample, agents.meet(level.size, level.size), level.beyond);
  };
  return std::min_element(levels.begin(), levels.end(),
                          [&](const auto& a, const auto& b) { return cost(a) < cost(b); })
      ->size;
}

}  // namespace beespace::avoidance
