// What was recorded, as tracks that the library searches.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "io/recording/recording.hpp"

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <vector>

namespace beespace::analysis {

// One track for each bee, in the units and the frame of in_metres. Curves become straight lines
// within the tolerance. Errors: those of the conversion, with the bee's id.
Result<std::vector<Track>> tracks_of(const io::Recording& recording, Geometry geometry,
                                     double tolerance_m);

// Paths are known all along: into their tracks so many more fixes are put that no two of them are
// farther apart in time than those of others may be.
void keep_paths_whole(const io::Recording& recording, double max_gap_s, std::vector<Track>& tracks);

// The error of one bee of a recording: its id is put before what is wrong.
Error of_bee(Error error, const io::RecordedBee& bee);

}  // namespace beespace::analysis
