// Conflicts of straight lines, looked at along the curves for which these stand.
#pragma once

#include "analysis/recorded/flights.hpp"

#include <beespace/conflict.hpp>
#include <beespace/result.hpp>

#include <vector>

namespace beespace::analysis {

// When in the time of the conflict the two are closer than the threshold, decided by
// closest_as_written(): one conflict, several, or none. The search joins those between which two
// may be closer for all that it knows, as where they hover exactly the threshold apart. Within a
// piece of both curves all from the first to the last instant at which they are closer is one,
// known to a microsecond and never too short. Where the two flights are not there at the same time,
// nothing excludes the conflict: it stays as it is.
Result<std::vector<Conflict>> along_curves(const Conflict& conflict, const Flight& first,
                                           const Flight& second, double threshold_m);

}  // namespace beespace::analysis
