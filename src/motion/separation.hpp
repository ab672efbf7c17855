// How close is too close, and what it says of two bees that move in straight lines: the exact
// decision, and the times and distances of the report.
#pragma once

#include <beespace/closest_approach.hpp>
#include <beespace/mover.hpp>

#include <optional>

namespace beespace::motion {

struct Separation {
  double threshold_m;
  std::optional<double> vertical_m = {};
  bool inclusive = false;
};

inline Separation separation_of(const PredictOptions& options) {
  return {options.threshold_m, options.vertical_m, options.inclusive};
}

// Whether two bees in constant motion are in conflict at some instant of [0, horizon]: exact.
bool in_conflict(const Mover& a, const Mover& b, const Separation& separation, double horizon_s);

// When they are closest in [0, horizon]; and, for two of whom in_conflict says so, from when to when
// they are in conflict, and closest in between.
struct ConflictReport {
  TimeSpan span;
  double closest_s;
  double closest_m;
};
Approach closest_in(const Mover& a, const Mover& b, double horizon_s);
ConflictReport report_conflict(const Mover& a, const Mover& b, const Separation& separation,
                               double horizon_s);

}  // namespace beespace::motion
