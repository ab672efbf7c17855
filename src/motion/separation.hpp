// How close is too close, and what it says of two bees that move in straight lines: the exact
// decision, and the times and distances of the report.
#pragma once

#include "motion/relative_motion.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/mover.hpp>

#include <optional>

namespace beespace::motion {

struct Separation {
  double threshold_m;
  std::optional<double> vertical_m = {};
  bool inclusive = false;
};

// Of PredictOptions or ConflictOptions.
template <class Options>
Separation separation_of(const Options& options) {
  return {options.threshold_m, options.vertical_m, options.inclusive};
}

// Whether two bees in constant motion are in conflict at some instant of [0, horizon]: exact.
bool in_conflict(const Mover& a, const Mover& b, const Separation& separation, double horizon_s);

RelativeMotion<3> relative_motion(const Mover& a, const Mover& b);

// Of two who are in conflict: from when to when, and closest in between.
struct ConflictReport {
  TimeSpan span;
  double closest_s;
  double closest_m;
};
ConflictReport report_conflict(const RelativeMotion<3>& motion, const Separation& separation,
                               double horizon_s);

}  // namespace beespace::motion
