// What a search for conflicts along straight lines does not say of a drone show: whether the
// possible ones are conflicts along the curves, and who comes too close to a drone on the ground.
//
// A drone stands on the ground before its path begins there, and after it ends there, as long as
// any other flies; one that never takes off stands all the time. Two that both stand are no
// conflict. Of tables, too, the time on the ground was left out in reading.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <vector>

namespace beespace::analysis {

// Where a drone is while it does not fly.
struct Standing {
  PointId bee = 0;
  TimeSpan span;
  Point at;
};

// Before and after the flight of each drone of a show, in their order; nothing for what is no show.
std::vector<Standing> standing_in(const io::Recording& recording);

// Tracks of all bees, those of `bees` with their time on the ground.
std::vector<Track> with_standing(std::vector<Track> tracks, const io::Recording& recording,
                                 const std::vector<PointId>& bees);

// Conflicts between a drone in the air and one that stands, in ascending order of (first, second,
// begins_s). `tracks` are those of the bees, in metres. Nothing for what is no show.
Result<std::vector<Conflict>> conflicts_with_standing(const io::Recording& recording,
                                                      const std::vector<Track>& tracks,
                                                      const ConflictOptions& options);

// Gives drones that never take off tracks of their own, to be drawn.
void stand_in_tracks(const io::Recording& recording, std::vector<Track>& tracks);

// Decides along the curves of a show, and in the decimals that are written, when two are closer:
// of a conflict of straight lines within some tolerance that is one conflict, several, or none.
Result<std::vector<Conflict>> settled_conflicts(const io::Recording& recording,
                                                const ConflictOptions& options,
                                                std::vector<Conflict> conflicts);

// Both: the settled ones, and those with drones that stand.
struct ShowConflicts {
  std::vector<Conflict> conflicts;
  std::vector<Conflict> with_standing;  // of these
};
Result<ShowConflicts> conflicts_of_show(const io::Recording& recording,
                                        const std::vector<Track>& tracks,
                                        const ConflictOptions& options,
                                        std::vector<Conflict> conflicts);

}  // namespace beespace::analysis
