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
  // and y) and closer than this in height (z): a cylinder instead of a sphere. For points at risk,
  // pairs, neighbours, counts and groups of one swarm. Such a search looks at every pair that is
  // near in a sphere around the cylinder, whatever the question.
  std::optional<double> vertical_m = {};

  // Empty, or a height for each point, kept apart from the positions: for `vertical_m` between
  // points whose third axis is not the height. Then positions are horizontal: of geographic ones,
  // those brought to height 0 (see to_ecef).
  std::span<const double> heights_m = {};
};

}  // namespace beespace
