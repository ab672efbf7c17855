// The paths of all movers to the horizon, in steps of time: which may pass each other in each.
#pragma once

#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "grid/size_levels.hpp"
#include "motion/passing/passing_search.hpp"
#include "motion/predict/prediction.hpp"
#include "motion/separation.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/mover.hpp>

#include <cstdint>

namespace beespace::motion {

class PredictionSteps {
 public:
  // Options are valid. All must outlive this object.
  PredictionSteps(const MoversView& movers, const PredictOptions& options,
                  const core::Resources& with, const PredictionTuning& tuning);

  [[nodiscard]] const Separation& separation() const { return separation_; }

  // Whether all positions and velocities lie in the motion domain; if not, for_each() must not be
  // called.
  [[nodiscard]] bool in_domain() const { return in_domain_; }

  // Calls visit(found) after each step, with the pairs that find_passing found in it and in no step
  // before: hardly any pair twice, and in a step little more than `most`. As long as visit returns
  // true.
  template <class Visit>
  void for_each(const DecidePass& decide, std::uint64_t most, Visit&& visit) {
    double begin = 0.0;
    for (bool first = true; first || begin < options_.horizon_s; first = false) {
      const double end = step_end(begin);
      if (!visit(passing(begin, end, decide, most))) return;
      begin = end;
    }
  }

 private:
  [[nodiscard]] PointsView middles() const;
  void choose_drift();
  void look_at_movers();
  void move_middles_to(double time);
  double step_end(double begin);
  double cheapest_step(double begin, double left);
  core::Vector<core::FoundPairs> passing(double begin, double end, const DecidePass& decide,
                                         std::uint64_t most);

  const MoversView& movers_;
  const PredictOptions& options_;
  Separation separation_;
  const core::Resources& with_;
  const PredictionTuning& tuning_;
  Velocity drift_;           // relative to it, nearly all movers are slower
  double fastest_ = 0.0;     // relative to it
  double farthest_m_ = 0.0;  // largest coordinate
  bool in_domain_ = true;
  core::Buffer<Point> middles_;  // at this time
  double middles_time_ = 0.0;
  core::Bounds bounds_;
  core::Buffer<Move> moves_;
  core::Vector<SizeLevel> speeds_;  // possible limits between slow and fast ones
};

}  // namespace beespace::motion
