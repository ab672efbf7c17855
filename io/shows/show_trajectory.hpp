// The trajectory of a drone in a show: {"version": 1, "points": [[t, [x, y, z], [controls]], ...]}.
//
// Each entry ends a Bezier piece whose inner control points it lists; times are in seconds from
// takeoffTime, before which the drone is at its first point; positions are in metres.
#pragma once

#include "io/json/json_document.hpp"

#include <beespace/bezier_path.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

struct Trajectory {
  BezierPath path;  // in time of the show
  std::optional<double> takeoff_s;
};

// Errors: kUnsupportedFormat for another version or curves of a higher degree, kMissingColumn,
// kNoPoints, kMalformedRecord, kTimeOrder, those of json_document.hpp; without place.
Result<Trajectory> read_trajectory(JsonElement trajectory);

// Where a drone stands when it does not fly.
struct Ground {
  std::optional<Point> home;     // where it starts; on z = 0 where it is not said
  std::optional<Point> land_at;  // where it is to land
};

// The lowest height that is said of a drone; the ground of a show is at the lowest of all its
// drones.
double lowest_of(const Trajectory& trajectory, const Ground& ground);

// Whether the drone is said to start and to land at that height, and does so, there: it takes off
// from it, and does not move sideways at it.
bool starts_and_lands_at(const Trajectory& trajectory, const Ground& ground, double ground_m);

// Within 0.1 m.
bool on_ground(double height_m, double ground_m);

// Leaves of the path what is flown: all pieces but those at its start and its end in which the
// drone stands still on the ground, and no lower at any time. Standing still any higher is flight,
// whatever the show calls the place. A path of which all pieces are left out is no flight at all.
// Returns whether anything was left out.
bool keep_flight(Trajectory& trajectory, double ground_m);

}  // namespace beespace::io
