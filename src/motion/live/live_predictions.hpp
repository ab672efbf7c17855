// Predicted conflicts of live bees, from their last reports: the pairs, and which of them to
// report.
#pragma once

#include "base/resources.hpp"
#include "motion/live/live_bees.hpp"
#include "motion/live/live_overload.hpp"
#include "motion/separation.hpp"

#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <cstddef>
#include <vector>

namespace beespace::motion {

class LivePredictions {
 public:
  // A pair becomes predicted by the separation of entering, and stays so by that of leaving.
  LivePredictions(const Separation& enter, const Separation& leave, double horizon_s,
                  std::size_t max_pairs)
      : enter_(enter), leave_(leave), horizon_s_(horizon_s), max_pairs_(max_pairs) {}

  // Reports the pairs that have become predicted and are not among the `entered` (ids, ascending).
  // Nothing is predicted for a bee that is stale, or was heard once and without a velocity. Returns
  // what there were too many of.
  Result<LeftOut> predict(const LiveBees& bees, const std::vector<AgentPair>& entered, double now_s,
                          const core::Resources& with, std::vector<SwarmEvent>& events);
  void forget_all() {
    predicted_.clear();
    open_ = 0;
  }
  // Pairs that have been predicted, are still in danger, and have not entered.
  [[nodiscard]] std::size_t open() const { return open_; }

 private:
  // Bees that move, by ascending ids.
  struct Ahead {
    void clear() {
      ids.clear();
      movers.clear();
      heights_m.clear();
      climbs_mps.clear();
    }

    std::vector<AgentId> ids;
    std::vector<Mover> movers;
    std::vector<double> heights_m;
    std::vector<double> climbs_mps;
  };
  void look_ahead(const LiveBees& bees, double now_s);
  [[nodiscard]] bool comes_closer(const RelativeMotion<4>& motion, double closest_m) const;
  Status find_pairs(const MoversView& movers, const core::Resources& with, LeftOut& left_out);

  Separation enter_;
  Separation leave_;
  double horizon_s_;
  std::size_t max_pairs_;
  Share share_;                       // of the separation, within which pairs are predicted
  std::vector<AgentPair> predicted_;  // reported, and still in danger; ascending
  std::size_t open_ = 0;              // of them: not among the entered

  // Of one call, kept for their memory.
  std::vector<const LiveSegment*> segments_;
  Ahead ahead_;
  std::vector<Pair> pairs_;  // indices of ahead_
  std::vector<Pair> some_;
  std::vector<AgentPair> still_;
};

}  // namespace beespace::motion
