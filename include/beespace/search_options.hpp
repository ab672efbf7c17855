// What every search needs to know: how close is too close, and how much of the machine to use.
#pragma once

#include <cstdint>
#include <limits>

namespace beespace {

struct SearchOptions {
  // Metres. Two points conflict when their distance is below it. Finite and above zero, inside
  // the coordinate domain (see point.hpp).
  double threshold_m = 100.0;

  // Whether a distance of exactly the threshold counts as too close: "<=" instead of "<".
  bool inclusive = false;

  // How many threads may work, the calling one included; 0 means one per processor.
  // The answer is the same for every number.
  unsigned threads = 1;

  // Pairs and neighbours can outnumber the points a thousandfold: a search that would return more
  // of them than this returns kTooManyResults instead.
  std::uint64_t max_results = std::numeric_limits<std::uint64_t>::max();
};

}  // namespace beespace
