// Whether aircraft may have come too close on the arcs that they turn on between two fixes, where
// straight lines from fix to fix keep apart: gliders that circle are outside of their chords nearly
// all the time. The arc over a chord turns as much as the track does from this chord to those
// beside it; where velocities are told, as these do at both ends, if their speed is that of the
// arc.
//
// What follows from it is possible, not certain, and counts where the arcs bring the two nearer by
// more than little.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <string>
#include <vector>

namespace beespace::analysis {

struct TurnArcs {
  // Possible ones, in ascending order of (first, second, begins_s): none of a pair that is in
  // conflict otherwise at some instant of it.
  std::vector<Conflict> conflicts = {};
  std::vector<Track> tracks = {};  // the arcs, in straight lines; empty where none matters
  double most_nearer_m = 0.0;      // by which the two of one of these conflicts are nearer on them
};

// Of aircraft; nothing of others. `tracks` are those of the recording in this geometry, and `known`
// are the conflicts that are found otherwise, in ascending order of (first, second). Errors: those
// of the conversion and of find_conflicts(), with the bee's id.
Result<TurnArcs> follow_turns(const io::Recording& recording, const std::vector<Track>& tracks,
                              Geometry geometry, const ConflictOptions& options,
                              bool with_velocities, const std::vector<Conflict>& known);

// "2 conflicts are possible, not certain: on the arcs on which they turn between fixes two are up
// to 40 m nearer than on straight lines"; nothing where there is none.
std::string turn_arcs_text(const TurnArcs& arcs);

}  // namespace beespace::analysis
