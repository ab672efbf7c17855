// Everybody at the beginning of a step, and how far apart they are to be.
#pragma once

#include "avoidance/flyer.hpp"

#include <beespace/advise.hpp>
#include <beespace/crew.hpp>
#include <beespace/mover.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace beespace::avoidance {

// A distance to keep.
struct Keep {
  double asked_m = 0.0;
  double kept_m = 0.0;       // a little more, for rounding
  double certified_m = 0.0;  // who is closer than this has lost what rounding was allowed
};

// Of the distance to keep: who is no farther beyond it presses others.
inline constexpr double kPresses = 0.6;

class Flyers {
 public:
  // `limits` has one for each or one for all.
  void take(const MoversView& movers, std::span<const FlightLimits> limits,
            const AdviseOptions& options, Crew& crew);

  [[nodiscard]] std::size_t size() const { return flyers_.size(); }
  [[nodiscard]] const Flyer& operator[](std::size_t bee) const { return flyers_[bee]; }
  // How a bee comes to a stop as it flies now.
  [[nodiscard]] const Segment& way_to_stop(std::size_t bee) const { return ways_[bee].to_stop; }
  // How far from there it may get in the step and the stop after it.
  [[nodiscard]] double strays(std::size_t bee) const { return ways_[bee].strays_m; }
  [[nodiscard]] double fastest() const { return extremes_.speed_mps; }

  [[nodiscard]] const Keep& apart() const { return apart_; }
  [[nodiscard]] const Keep& clearance() const { return clearance_; }

  // Everything that a bee may do in the step and the stop after it lies in a ball; and so does
  // half of what it presses.
  [[nodiscard]] PointsView middles() const { return std::span<const Point>(middles_); }
  [[nodiscard]] double reach(std::size_t bee) const { return ways_[bee].reach_m; }
  [[nodiscard]] double farthest_reach() const { return extremes_.reach_m; }
  // Two whose middles are farther apart than this are nothing to each other, whatever both do: two
  // who reach so far; these two.
  [[nodiscard]] double meet(double reach_m, double other_reach_m) const {
    return (apart_.kept_m + reach_m + other_reach_m) * (1.0 + 0x1p-40);
  }
  [[nodiscard]] bool may_meet(PointId bee, PointId other) const {
    const Vector3 between = core::vector_of(middles_[bee]) - core::vector_of(middles_[other]);
    const double meet_m = meet(ways_[bee].reach_m, ways_[other].reach_m);
    return dot(between, between) <= meet_m * meet_m;
  }
  // False where two ways to a stop are surely farther apart than this.
  [[nodiscard]] bool ways_may_be_within(PointId bee, PointId other, double apart_m) const {
    const Vector3 between = core::vector_of(middles_[bee]) - core::vector_of(middles_[other]);
    const double within_m = (apart_m + ways_[bee].half_m + ways_[other].half_m) * (1.0 + 0x1p-40);
    return dot(between, between) <= within_m * within_m;
  }

 private:
  struct Way {
    Segment to_stop;
    double half_m;  // as long
    double strays_m;
    double reach_m;
  };
  // The largest of all.
  struct Extremes {
    double reach_m = 0.0;
    double speed_mps = 0.0;
    double farthest_m = 0.0;  // of the coordinates

    void add(const Extremes& other) {
      reach_m = std::max(reach_m, other.reach_m);
      speed_mps = std::max(speed_mps, other.speed_mps);
      farthest_m = std::max(farthest_m, other.farthest_m);
    }
  };

  std::vector<Point> middles_;  // of the ways
  std::vector<Way> ways_;
  std::vector<Flyer> flyers_;
  Extremes extremes_;
  Keep apart_;      // from each other
  Keep clearance_;  // from obstacles
};

}  // namespace beespace::avoidance
