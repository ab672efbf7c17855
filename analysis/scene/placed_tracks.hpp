// Tracks in metres set down on the Earth, to be compared with those of positions in degrees.
#pragma once

#include "io/recording/show_facts.hpp"
#include "report/placement.hpp"

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <vector>

namespace beespace::analysis {

// Where the show says that it is.
report::Placement placement_of(const io::ShowPlace& place);

// Turns each place into an ECEF position. Errors: kOutsideDomain for those farther than
// kFarthestPlaced_m from the origin, or at no height that there is; those of to_ecef for the
// origin.
Status place_tracks(std::vector<Track>& tracks, const report::Placement& placement);

}  // namespace beespace::analysis
