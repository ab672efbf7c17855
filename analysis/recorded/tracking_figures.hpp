// How well bees flew what they were set to fly: the figures of a fleet (beespace/fleet.hpp) as far
// as set and flown positions tell them.
//
// What they cannot tell: how wrong the flown positions are themselves, as they come from the
// sensors of the same bee; and what of a deviation was wind, and what the correction of it.
#pragma once

#include <beespace/track.hpp>

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace beespace::analysis {

// Of many values: the greatest, and that which 999 of 1000 do not exceed.
struct Extreme {
  double greatest = 0.0;
  double usual = 0.0;
};

// How far one bee was from what was set.
struct BeeDeviation {
  std::uint64_t fixes = 0;  // that were compared: one or more
  double farthest_s = 0.0;  // when it was farthest, by the clock of what was flown
  double farthest_m = 0.0;  // and how far
  double mean_m = 0.0;
  double p95_m = 0.0;  // what 95 of 100 do not exceed
};

struct TrackingFigures {
  std::uint64_t fixes = 0;    // that were compared
  std::uint64_t not_set = 0;  // flown fixes at times at which nothing was set
  Extreme deviation_m;        // from set to flown
  Extreme rate_mps;           // how fast that changes, from fix to fix
  Extreme acceleration_mps2;  // how fast the rate does
  // By how much later than set the bees flew: where that brings both closest, over all bees; absent
  // where it makes no difference, as they hardly moved.
  std::optional<double> lag_s;
  Extreme without_lag_m;  // the deviation from what was set so much earlier
  // Of each bee; nothing of one of which no fix was compared.
  std::vector<std::optional<BeeDeviation>> each;
};

// The tracks that a bee was set to fly and flew.
struct SetAndFlown {
  Track set;
  Track flown;
};

// Lags up to `longest_lag_s` are tried, in hundredths of a second. Between two fixes of what was
// set that are more than `max_gap_s` apart nothing was.
TrackingFigures tracking_figures(const std::vector<SetAndFlown>& bees, double max_gap_s,
                                 double longest_lag_s = 3.0);

}  // namespace beespace::analysis
