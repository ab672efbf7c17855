// The times at which advice is given: whole multiples of the step, counted in integers, so that
// none is passed over for the rounding of a time.
#pragma once

#include "analysis/live/look_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace beespace::cli {

using Tick = std::int64_t;

class AdviceTicks {
 public:
  explicit AdviceTicks(double step_s) : step_s_(step_s), times_(step_s) {}

  [[nodiscard]] double step_s() const { return step_s_; }
  [[nodiscard]] double time_of(Tick tick) const { return times_.at(tick); }

  // The last tick at or before a time. A time that is a tick but for how times are written and
  // rounded is at it: clocks may be read a little before the step is full. Beyond what counts tick
  // by tick: the last that does.
  [[nodiscard]] Tick at_or_before(double time_s) const {
    constexpr double kMost = 1e15;
    const double steps = std::clamp(time_s / step_s_, -kMost, kMost);
    const double nearest = std::nearbyint(steps);
    return static_cast<Tick>(std::abs(steps - nearest) <= tolerance(steps) ? nearest
                                                                           : std::floor(steps));
  }

 private:
  // In steps: a hundredth, or what times of this size cannot tell apart.
  static double tolerance(double steps) {
    return std::max(0.01, 4 * std::numeric_limits<double>::epsilon() * std::abs(steps));
  }

  double step_s_;
  analysis::LookTimes times_;
};

}  // namespace beespace::cli
