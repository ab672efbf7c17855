// How far apart the two of each conflict are horizontally and vertically, of a recording that
// memory does not hold: its fixes are read once more.
#pragma once

#include "analysis/recorded/apart.hpp"

#include <beespace/conflict.hpp>
#include <beespace/recording_out_of_core.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <vector>

namespace beespace::cli {

struct LargeHeights {
  bool apart = false;  // from positions
  double unit_m = 1.0;
};

// Of conflicts that are sorted by first, second and begin, and that must outlive what is returned;
// tracks have the first fix and the last one of each bee. Errors: those of
// RecordingOutOfCore::visit_fixes.
Result<analysis::ApartOf> large_apart_of(RecordingOutOfCore& fixes,
                                         const std::vector<Conflict>& conflicts,
                                         const std::vector<Track>& tracks,
                                         const LargeHeights& heights);

}  // namespace beespace::cli
