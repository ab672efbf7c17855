// Where two fixes of a bee are too far apart in time for a straight line between them: where
// it was is unknown. One rule for everything that reads a recording.
//
// Unless it is said with --max-gap, the data says how far that is: kGapFactor times its typical
// interval. That is the median of the bees' median intervals; bees of fewer than kFixesToTell fixes
// have no say where others have more, so that two fixes hours apart do not make hours usual. Of an
// even number it is the lower one of the two in the middle: a shorter gap leaves more unknown, a
// longer one may take for known what is not. A show is a plan, and has no gaps.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/find_conflicts.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

inline constexpr double kGapFactor = 5.0;
inline constexpr std::size_t kFixesToTell = 4;

struct MaxGap {
  double seconds;                   // infinite: never
  std::optional<double> typical_s;  // where it comes from the data
  bool asked = false;               // by --max-gap
  double interval_s = 0.0;          // the typical one, also where it is asked for; 0: there is none
};

// Of seconds that come from the data three digits count, so that --max-gap can say the same.
MaxGap max_gap_of(const io::Recording& recording, const std::optional<double>& asked);

// The same, of what is known of each bee with two fixes or more: how many it has, and the lower
// median of the times between them.
struct BeeInterval {
  std::uint64_t fixes = 0;
  double median_s = 0.0;
};
BeeInterval interval_of(const io::RecordedBee& bee);
MaxGap max_gap_of(const std::vector<BeeInterval>& bees, const std::optional<double>& asked);

// A --max-gap that leaves no gap between fixes that are so far apart as a rule.
double max_gap_for(double interval_s);
// The same, and hardly more: whole seconds, of longer ones five each.
double max_gap_just_for(double interval_s);

// The longest time between two fixes that is joined by a straight line though it is more than twice
// what is usual, of all and of this bee. Nothing of shows, and where only ends are kept.
std::optional<Gap> longest_bridged(const io::Recording& recording, const MaxGap& max_gap);

// "5 s, 5 times the typical interval of 1 s (--max-gap)".
std::string max_gap_text(const MaxGap& max_gap);

}  // namespace beespace::analysis
