#include "motion/live/live_predictions.hpp"

#include "motion/predict/prediction.hpp"

#include <beespace/closest_approach.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace beespace::motion {

namespace {

// Whether `pair` is among `pairs`; both ascend, and `at` advances.
bool among(const std::vector<Pair>& pairs, std::vector<Pair>::const_iterator& at,
           const Pair& pair) {
  while (at != pairs.end() && *at < pair) ++at;
  return at != pairs.end() && *at == pair;
}

}  // namespace

LivePredictions::Ahead LivePredictions::ahead(const LiveBees& bees, double now_s) const {
  std::vector<const LiveRun*> runs;
  for (const LiveRun& run : bees.runs()) {
    if (!run.complete && run.moves()) runs.push_back(&run);
  }
  const auto below = [](const LiveRun* a, const LiveRun* b) { return a->bee < b->bee; };
  if (!std::is_sorted(runs.begin(), runs.end(), below)) std::sort(runs.begin(), runs.end(), below);
  Ahead ahead;
  ahead.ids.reserve(runs.size());
  ahead.movers.reserve(runs.size());
  for (const LiveRun* run : runs) {
    const auto now = run->at(now_s);
    ahead.ids.push_back(run->bee);
    ahead.movers.push_back(now->mover);
    if (!enter_.heights_apart) continue;
    ahead.heights_m.push_back(now->height_m);
    ahead.climbs_mps.push_back(now->climb_mps);
  }
  return ahead;
}

// By the leave separation, ascending. Of too many, those that come closest: by a separation with
// few enough pairs; none if there is no such separation.
Result<std::vector<Pair>> LivePredictions::pairs_of(const MoversView& movers,
                                                    const core::Resources& with,
                                                    LeftOut& left_out) {
  std::vector<Pair> pairs;
  std::optional<Error> failed;
  PredictOptions options{
      .threshold_m = leave_.threshold_m, .vertical_m = leave_.vertical_m, .horizon_s = horizon_s_};
  options.max_results = max_pairs_;
  const auto few = [&](double share) {
    options.threshold_m = std::max(kSmallestInMotion, share * leave_.threshold_m);
    if (leave_.vertical_m) {
      options.vertical_m = std::max(kSmallestInMotion, share * *leave_.vertical_m);
    }
    std::vector<Pair> some;
    const Status found = predict_pairs(movers, options, with, some);
    if (found) {
      pairs = std::move(some);
    } else if (found.error().code != ErrorCode::kTooManyResults) {
      failed = found.error();
    }
    return found.has_value();
  };
  const bool any = share_.choose(few);
  if (failed) return *std::move(failed);
  if (!any || share_.value() < 1.0) {
    left_out.add(0, any ? share_.value() * enter_.threshold_m : 0.0);
  }
  return pairs;
}

Result<LeftOut> LivePredictions::predict(const LiveBees& bees, const std::vector<Pair>& entered,
                                         double now_s, const core::Resources& with,
                                         std::vector<SwarmEvent>& events) {
  LeftOut left_out;
  if (!(horizon_s_ > 0.0)) return left_out;
  const Ahead all = ahead(bees, now_s);
  const MoversView straight(all.movers);
  const MoversView view(straight.positions(), straight.velocities(), all.heights_m, all.climbs_mps);
  const auto pairs = pairs_of(view, with, left_out);
  if (!pairs) return pairs.error();
  std::vector<Pair> still;
  std::size_t open = 0;
  auto before = predicted_.cbegin();
  auto inside = entered.cbegin();
  for (const Pair& pair : *pairs) {
    const Pair bee{all.ids[pair.first], all.ids[pair.second]};
    const bool said = among(predicted_, before, bee);
    const bool is_inside = among(entered, inside, bee);
    const State first = state_of(view, pair.first);
    const State second = state_of(view, pair.second);
    if (!said && !in_conflict(first, second, enter_, horizon_s_)) continue;
    still.push_back(bee);
    if (!is_inside) ++open;
    if (said || is_inside) continue;
    const auto report = report_conflict(relative_motion(first, second), enter_, horizon_s_);
    events.push_back({EventKind::kPredicted, now_s + report.span.begins_s, bee.first, bee.second,
                      report.closest_m, now_s + report.closest_s});
  }
  predicted_ = std::move(still);
  open_ = open;
  return left_out;
}

}  // namespace beespace::motion
