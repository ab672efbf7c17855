// All conflicts of a recording: along straight lines from fix to fix, along the curves of a show or
// of given velocities, along the arcs of aircraft that turn, and with drones that stand on the
// ground. What `beespace replay` and those who call it from a program are told.
#pragma once

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/apart.hpp"
#include "analysis/recorded/chords.hpp"
#include "analysis/recorded/turn_arcs.hpp"
#include "analysis/recorded/velocity_curves.hpp"
#include "analysis/recorded/worst_moment.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::analysis {

struct AllConflicts {
  RecordedConflicts recorded;
  // Of the conflicts: with a drone on the ground, or with an aircraft that stands still.
  std::vector<Conflict> with_standing;
  VelocityCurves curves;  // whose conflicts are among them
  Chords chords;          // which of them are possible as the two turn
  TurnArcs arcs;          // whose conflicts are among them, too
  // The closest of the conflicts; where there is none, of all encounters, if there is no vertical
  // threshold, with which how far apart two are in a straight line says little.
  std::optional<Conflict> closest;
  // Where that is with a drone on the ground, or of two that stand: the same of two in the air.
  std::optional<Conflict> closest_in_the_air;
  // Left out: conflicts of two that both say that they have landed.
  std::size_t standing_count = 0;
};

// `tracks` are those of the recording in this geometry. With `straight` velocities are not looked
// at. Errors: those of find_conflicts() and of the conversion, with the bee's id.
Result<AllConflicts> all_conflicts(const io::Recording& recording, const std::vector<Track>& tracks,
                                   Geometry geometry, const ConflictOptions& options,
                                   bool straight);

// Whether some two bees are there at the same time: otherwise nothing was compared. `in_space` are
// the tracks in space, and `found` is what was found.
bool has_encounters(const AllConflicts& found, const io::Recording& recording,
                    const std::vector<Track>& in_space, const ConflictOptions& options);

// How far apart the two of a conflict are on what they were found in conflict along, with a
// vertical threshold: these lines, the curves, or the arcs. All must outlive the answer.
ApartOf apart_along(const std::vector<Track>& lines, const VelocityCurves& curves,
                    const TurnArcs& arcs, double height_unit_m);
// Likewise when they are worst in it.
WorstOf worst_along(const std::vector<Track>& lines, const VelocityCurves& curves,
                    const TurnArcs& arcs, double height_unit_m, const Minima& minima);

}  // namespace beespace::analysis
