// Two bees on their way: when are they closest, how close, and when too close?
//
// Each moves in a straight line at constant velocity. They are in conflict in [0, horizon] when
// their distance is below the threshold at some instant of it, decided as real numbers on the given
// doubles: grazing at exactly the threshold is no conflict, unless `inclusive`.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/export.hpp>
#include <beespace/mover.hpp>
#include <beespace/not_given.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <limits>
#include <optional>

namespace beespace {

struct PredictOptions {
  // Metres. Two bees conflict when their distance is below it; with `vertical_m`, their horizontal
  // distance. Must be given.
  double threshold_m = kNotGiven;

  // Metres. Given, two bees conflict when they are closer than the threshold horizontally (in x and
  // y) and closer than this in height (z), both at the same time.
  std::optional<double> vertical_m = {};

  // Seconds from now; zero or more.
  double horizon_s = 60.0;

  // Whether exactly the threshold counts as too close.
  bool inclusive = false;

  // How many threads may work, the calling one included; 0 means one per processor. The answer is
  // the same for every number.
  unsigned threads = 1;

  // More conflicts than this are an error, kTooManyResults.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  // How many metres one unit of heights is that are kept apart from positions, where these are not
  // metres: 0.3048 for feet. Then `vertical_m` and climb rates are in that unit too, and compared
  // with the heights as they are, exactly; distances that are told are in metres all the same.
  double height_unit_m = 1.0;
};

struct Approach {
  // When the two are closest in [0, horizon] in a straight line (the first such instant), and how
  // far apart they are then.
  double closest_s = 0.0;
  double closest_m = 0.0;

  // While they are in conflict, within [0, horizon]; absent when they never are. Where it begins at
  // 0 they are too close now, where it ends at the horizon they still are. With a single instant of
  // contact (`inclusive`) both ends are the same, up to rounding.
  std::optional<TimeSpan> conflict = {};
};

// Errors: kInvalidThreshold, kInvalidArgument for a horizon or vertical_m that makes no sense,
// kNotFinite and kOutsideDomain (the motion domain, see mover.hpp) with 0 for `first` and 1 for
// `second` in place.record.
BEESPACE_API Result<Approach> closest_approach(const Mover& first, const Mover& second,
                                               const PredictOptions& options);

}  // namespace beespace
