// Aircraft that a scenario creates, one after the other, from there on: along their tracks,
// as nothing else is said of them.
#pragma once

#include "analysis/recorded/last_snapshot.hpp"
#include "io/recording/recording.hpp"

#include <beespace/track.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

// Of each mover of the snapshot, from its creation until the end of the horizon, in seconds from
// the time of the snapshot. Nothing where no time before it was passed over, or where one is moved
// or not known on the way, so that it did not fly on as created. `geometry` is that of the
// snapshot.
std::optional<std::vector<Track>> created_flights(const io::Recording& recording,
                                                  const Snapshot& snapshot, Geometry geometry,
                                                  double horizon_s);

}  // namespace beespace::analysis
