// What the verifier does not tell of a simulation: whether bees keep to limits of their own, and
// who is nearest to an obstacle at the end of a step.
#pragma once

#include "sim/closed_loop.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::cli {

struct NearestApproach {
  PointId bee = 0;
  std::size_t obstacle = 0;
  double distance_m = 0.0;  // below zero: inside
  double time_s = 0.0;
};

struct WatchFigures {
  std::uint64_t breaches = 0;  // of limits of their own, a bee a step
  // The nearest that a bee came to an obstacle, where that is less than twice the clearance.
  std::optional<NearestApproach> nearest = {};
};

class SimulateWatch {
 public:
  // `limits` has one for each bee, or none.
  SimulateWatch(std::vector<FlightLimits> limits, const AdviseOptions& advice)
      : limits_(std::move(limits)), clearance_m_(advice.clearance_m), step_s_(advice.step_s) {}

  // At the beginning, and after each step.
  void see(const sim::ClosedLoop& loop);
  [[nodiscard]] const WatchFigures& figures() const { return figures_; }

 private:
  void see_limits(const std::vector<Mover>& movers);
  void see_obstacles(const sim::ClosedLoop& loop, const ObstacleMap& map);

  std::vector<FlightLimits> limits_;
  double clearance_m_;
  double step_s_;
  std::vector<Mover> before_;  // at the end of the step before
  WatchFigures figures_;
};

}  // namespace beespace::cli
