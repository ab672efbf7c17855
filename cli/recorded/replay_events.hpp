// A recording as `watch` would have seen it: fix after fix in the order of time.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "analysis/live/live_feed.hpp"
#include "cli/output/rows.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/result.hpp>
#include <beespace/swarm.hpp>
#include <beespace/track.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct RecordedEvents {
  std::string lines;  // as `watch` prints them
  Rows rows;
};

// The tracks are those of that geometry. `standing` are the conflicts with drones on the ground,
// which report nothing there: they are told of beside the others.
Result<RecordedEvents> events_of(const io::Recording& recording, const std::vector<Track>& tracks,
                                 analysis::Geometry geometry, const SwarmOptions& options,
                                 const analysis::LiveTimes& times,
                                 const std::vector<Conflict>& standing);

}  // namespace beespace::cli
