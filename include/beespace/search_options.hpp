// What every search needs to know: how close is too close, and how much of the machine to use.
#pragma once

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
};

}  // namespace beespace
