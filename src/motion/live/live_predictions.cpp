#include "motion/live/live_predictions.hpp"

#include "motion/predict/prediction.hpp"

#include <beespace/closest_approach.hpp>

#include <algorithm>
#include <optional>
#include <utility>

namespace beespace::motion {

namespace {

// Whether `pair` is among `pairs`; both ascend, and `at` advances.
bool among(const std::vector<AgentPair>& pairs, std::vector<AgentPair>::const_iterator& at,
           const AgentPair& pair) {
  while (at != pairs.end() && *at < pair) ++at;
  return at != pairs.end() && *at == pair;
}

}  // namespace

void LivePredictions::look_ahead(const LiveBees& bees, double now_s) {
  segments_.clear();
  for (const LiveSegment& segment : bees.segments()) {
    if (!segment.complete && segment.moves()) segments_.push_back(&segment);
  }
  const auto below = [](const LiveSegment* a, const LiveSegment* b) { return a->bee < b->bee; };
  if (!std::is_sorted(segments_.begin(), segments_.end(), below)) {
    std::sort(segments_.begin(), segments_.end(), below);
  }
  ahead_.clear();
  for (const LiveSegment* segment : segments_) {
    const auto now = segment->at(now_s);
    ahead_.ids.push_back(segment->bee);
    ahead_.movers.push_back(now->mover);
    if (!enter_.heights_apart) continue;
    ahead_.heights_m.push_back(now->height_m);
    ahead_.climbs_mps.push_back(now->climb_mps);
  }
}

// By the leave separation, ascending. Of too many, those that come closest: by a separation with
// few enough pairs; none if there is no such separation.
Status LivePredictions::find_pairs(const MoversView& movers, const core::Resources& with,
                                   LeftOut& left_out) {
  pairs_.clear();
  std::optional<Error> failed;
  PredictOptions options{
      .threshold_m = leave_.threshold_m, .vertical_m = leave_.vertical_m, .horizon_s = horizon_s_};
  options.max_results = max_pairs_;
  const auto few = [&](double share) {
    options.threshold_m = std::max(kSmallestInMotion, share * leave_.threshold_m);
    if (leave_.vertical_m) {
      options.vertical_m = std::max(kSmallestInMotion, share * *leave_.vertical_m);
    }
    const Status found = predict_pairs(movers, options, with, some_);
    if (found) {
      pairs_.swap(some_);
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
  return std::monostate{};
}

// Than that, until twice the horizon.
bool LivePredictions::comes_closer(const RelativeMotion<4>& motion, double closest_m) const {
  const TimeSpan longer{0.0, 2.0 * horizon_s_};
  return closest_within(in_metres(motion, enter_), longer).distance_m < closest_m;
}

Result<LeftOut> LivePredictions::predict(const LiveBees& bees,
                                         const std::vector<AgentPair>& entered, double now_s,
                                         const core::Resources& with,
                                         std::vector<SwarmEvent>& events) {
  LeftOut left_out;
  if (!(horizon_s_ > 0.0)) return left_out;
  look_ahead(bees, now_s);
  const MoversView straight(ahead_.movers);
  const MoversView view(straight.positions(), straight.velocities(), ahead_.heights_m,
                        ahead_.climbs_mps);
  if (Status found = find_pairs(view, with, left_out); !found) return found.error();
  still_.clear();
  std::size_t open = 0;
  auto before = predicted_.cbegin();
  auto inside = entered.cbegin();
  for (const Pair& pair : pairs_) {
    const AgentPair bee{ahead_.ids[pair.first], ahead_.ids[pair.second]};
    const bool reported = among(predicted_, before, bee);
    const bool is_inside = among(entered, inside, bee);
    const State first = state_of(view, pair.first);
    const State second = state_of(view, pair.second);
    if (!reported && !in_conflict(first, second, enter_, horizon_s_)) continue;
    still_.push_back(bee);
    if (!is_inside) ++open;
    if (reported || is_inside) continue;
    const auto motion = relative_motion(first, second);
    const auto report = report_conflict(motion, enter_, horizon_s_);
    SwarmEvent event{EventKind::kPredicted, now_s + report.span.begins_s, bee.first, bee.second,
                     report.closest_m,      now_s + report.closest_s};
    event.closing = report.closest_s >= horizon_s_ && comes_closer(motion, report.closest_m);
    events.push_back(event);
  }
  predicted_.swap(still_);
  open_ = open;
  return left_out;
}

}  // namespace beespace::motion
