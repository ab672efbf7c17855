// The trajectory of a drone in a show: {"version": 1, "points": [[t, [x, y, z], [controls]], ...]}.
//
// Each entry ends a Bezier piece whose inner control points it lists; times are in seconds,
// positions in metres.
#pragma once

#include "io/json/json_document.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

struct Trajectory {
  BezierPath path;
  std::optional<double> takeoff_s;
  std::optional<double> landing_s;
};

// Errors: kUnsupportedFormat for another version or curves of a higher degree, kMissingColumn,
// kNoPoints, kMalformedRecord, kTimeOrder, those of json_document.hpp; without place.
Result<Trajectory> read_trajectory(JsonElement trajectory);

// Where a drone stands when it does not fly.
struct Ground {
  std::optional<Point> home;  // where it starts; the first point of the path where it is not said
  std::optional<Point> land_at;  // where it is to land
};

// Leaves of the path what is flown: the pieces that overlap the time between take-off and landing,
// whole, but not those at its start and its end in which the drone stands still at home, where it
// lands, or no higher than home. A path that is left without pieces is no flight at all. Returns
// whether anything was left out.
bool keep_flight(Trajectory& trajectory, const Ground& ground);

}  // namespace beespace::io
