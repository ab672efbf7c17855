// What was recorded, or planned, as curves: for checks that look along them, each bee with times of
// its own.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/conflict.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>
#include <beespace/verify_path.hpp>

#include <optional>
#include <vector>

namespace beespace::analysis {

// From one gap to the next: none is empty, one without pieces is there for an instant.
using Flight = std::vector<BezierPath>;

// From one fix to the next, on the curve with the velocities at both.
BezierPiece piece_to(const Fix& from, const Velocity& v, const Fix& to, const Velocity& w);

// When a path ends.
double path_end_s(const BezierPath& path);

// One flight for each bee of a recording in metres: the curve of a show; between fixes straight
// lines, or where `with_velocities`, which all fixes then have, the curves that have these.
std::vector<Flight> flights_of(const io::Recording& recording, bool with_velocities,
                               double max_gap_s);

// As straight lines within the tolerance. Errors: those of to_track(), with the bee's id.
Result<std::vector<Track>> tracks_of(const std::vector<Flight>& flights,
                                     const io::Recording& recording, double tolerance_m);

// As closest_on_paths, of places as they are written: 1.92 - 1.12 is 0.8 of decimals, and less of
// the doubles that stand for them. Where all places and the threshold are whole micrometres, these
// are compared, in which doubles are exact; otherwise the doubles as they are.
Result<std::optional<PathEncounter>> closest_as_written(const BezierPath& first,
                                                        const BezierPath& second,
                                                        const TimeSpan& during, double threshold_m);

// The same of two flights.
Result<std::optional<PathEncounter>> closest_of(const Flight& first, const Flight& second,
                                                const TimeSpan& during, double threshold_m);

}  // namespace beespace::analysis
