// What every search needs to know: how close is too close, and how much of the machine to use.
#pragma once

#include <beespace/not_given.hpp>

#include <cstdint>
#include <limits>
#include <optional>
#include <span>

namespace beespace {

struct SearchOptions {
  // Metres. Two points conflict when their distance is below it. Finite and above zero, inside
  // the coordinate domain (see point.hpp). Must be given: there is no default.
  double threshold_m = kNotGiven;

  // Whether a distance of exactly the threshold counts as too close: "<=" instead of "<".
  bool inclusive = false;

  // How many threads may work, the calling one included; 0 means one per processor.
  // The answer is the same for every number.
  unsigned threads = 1;

  // Pairs and neighbours can outnumber the points a thousandfold: a search that would return more
  // of them than this returns kTooManyResults instead.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();

  // Metres. Given, two points conflict when they are closer than the threshold horizontally (in x
  // and y) and closer than this in height (z): a cylinder instead of a sphere. Each of the two is
  // compared on its own, as real numbers. The nearest of a point is then the nearest by the
  // straight line among those in its cylinder.
  std::optional<double> vertical_m = {};

  // Empty, or a height for each point, kept apart from the positions: for `vertical_m` between
  // points whose third axis is not the height. Then positions are horizontal: of geographic ones,
  // those brought to height 0 (see to_ecef). The straight line is that of the positions and the
  // heights: the root of the sum of the squares of both distances.
  std::span<const double> heights_m = {};
  // The same of the other set, in searches between two; both have heights apart, or none has.
  std::span<const double> other_heights_m = {};

  // How many metres one unit of heights is that are kept apart, where these are not metres: 0.3048
  // for feet; 1e-6 to 1e6. Then `vertical_m` is in that unit too, and compared with the heights as
  // they are, exactly; straight lines are in metres all the same.
  double height_unit_m = 1.0;
};

}  // namespace beespace
