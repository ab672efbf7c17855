// With whom each bee comes closest, and how close, whether that is too close or not.
#pragma once

#include <beespace/conflict.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

// One for each track, over all the time in which it and another are there; nothing for one that
// never is with another. Looks within `threshold_m` first, then farther; where that would find too
// many pairs, at those that are left one after the other. Errors: as find_conflicts.
Result<std::vector<std::optional<Conflict>>> closest_of_each(const std::vector<Track>& tracks,
                                                             double threshold_m, double max_gap_s,
                                                             unsigned threads);

}  // namespace beespace::analysis
