#include "motion/live_predictions.hpp"

#include "motion/prediction.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/mover.hpp>

#include <algorithm>
#include <utility>

namespace beespace::motion {

Status LivePredictions::predict(const LiveBees& bees, const LiveWalks& walks, double now_s,
                                const core::Resources& with, std::vector<SwarmEvent>& events) {
  if (!(horizon_s_ > 0.0)) return std::monostate{};
  std::vector<Mover> movers;
  std::vector<double> heights_m;
  std::vector<double> climbs_mps;
  std::vector<PointId> ids;
  for (const LiveRun& run : bees.runs()) {
    if (run.complete) continue;
    const auto now = run.at(now_s);
    if (!now) continue;
    movers.push_back(now->mover);
    ids.push_back(run.bee);
    if (!enter_.heights_apart) continue;
    heights_m.push_back(now->height_m);
    climbs_mps.push_back(now->climb_mps);
  }
  const MoversView all(movers);
  const MoversView view(all.positions(), all.velocities(), heights_m, climbs_mps);
  const PredictOptions wide{
      .threshold_m = leave_.threshold_m, .vertical_m = leave_.vertical_m, .horizon_s = horizon_s_};
  std::vector<Pair> pairs;
  Status found = predict_pairs(view, wide, with, pairs);
  if (!found) return found;
  std::vector<BeePair> still;
  for (const Pair& pair : pairs) {
    PointId a = ids[pair.first];
    PointId b = ids[pair.second];
    if (a > b) std::swap(a, b);
    const bool said = std::binary_search(predicted_.begin(), predicted_.end(), BeePair{a, b});
    const State first = state_of(view, pair.first);
    const State second = state_of(view, pair.second);
    if (!said && !in_conflict(first, second, enter_, horizon_s_)) continue;
    still.push_back({a, b});
    if (said || walks.have_entered(a, b)) continue;
    const auto report = report_conflict(relative_motion(first, second), enter_, horizon_s_);
    events.push_back({EventKind::kPredicted, now_s + report.span.begins_s, a, b, report.closest_m,
                      now_s + report.closest_s});
  }
  std::sort(still.begin(), still.end());
  predicted_ = std::move(still);
  return std::monostate{};
}

}  // namespace beespace::motion
