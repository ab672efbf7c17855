// What lies ahead of live bees, from their last reports: which pairs, and which of them to tell.
#pragma once

#include "core/resources.hpp"
#include "motion/live_bees.hpp"
#include "motion/live_walks.hpp"
#include "motion/separation.hpp"

#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <vector>

namespace beespace::motion {

class LivePredictions {
 public:
  // A pair becomes predicted by the separation of entering, and stays so by that of leaving.
  LivePredictions(const Separation& enter, const Separation& leave, double horizon_s)
      : enter_(enter), leave_(leave), horizon_s_(horizon_s) {}

  // Tells the pairs that have become predicted and are not in a conflict already. Of a bee that is
  // stale, or was heard of once and without a velocity, nothing is predicted.
  Status predict(const LiveBees& bees, const LiveWalks& walks, double now_s,
                 const core::Resources& with, std::vector<SwarmEvent>& events);
  void forget_all() { predicted_.clear(); }

 private:
  // A pair of bees, the lower id first.
  struct BeePair {
    PointId first;
    PointId second;

    friend auto operator<=>(const BeePair&, const BeePair&) = default;  // NOLINT(*-use-nullptr)
  };

  Separation enter_;
  Separation leave_;
  double horizon_s_;
  std::vector<BeePair> predicted_;  // said, and still in danger; ascending
};

}  // namespace beespace::motion
