// East, north and up at a place on the Earth.
#pragma once

#include <beespace/geodesy.hpp>
#include <beespace/mover.hpp>
#include <beespace/point.hpp>

#include <optional>
#include <span>
#include <vector>

namespace beespace::report {

// Axes at a place, in ECEF; all of length 1 and at right angles. At the poles and in the middle of
// the Earth, where east is anywhere, they are those of longitude 0.
struct LocalAxes {
  Point east;
  Point north;
  Point up;
};
LocalAxes local_axes_at(const Point& ecef);

// The velocity, in the ECEF frame, of a bee at `ecef`, as seen from there; the inverse of
// to_ecef_velocity.
LocalVelocity to_local_velocity(const Point& ecef, const Velocity& velocity);

// Where that is, for reading: to a tenth of a millimetre from 10 km below the ground to 1,000 km
// above. Deep inside the Earth, which the middle of two may be, only roughly, but always a
// longitude and a latitude.
GeographicPosition to_geographic(const Point& ecef);

// The way back from metres east, north and up of an origin (LocalPlaces): to a millimetre and
// better within 1,000 km of it.
class EarthFrame {
 public:
  // `origin` is one that to_ecef takes.
  explicit EarthFrame(const GeographicPosition& origin);

  [[nodiscard]] GeographicPosition position_of(const Point& place) const;

 private:
  Point origin_;
  LocalAxes axes_;
};

// ECEF positions as metres east, north and up of an origin: for looking at, not for distances,
// which keep their meaning but are rounded once more.
struct LocalPlaces {
  GeographicPosition origin;
  std::vector<Point> places;
};
// The origin is below the middle of all, at height 0, unless it is given; where their middle is
// that of the Earth, below the first.
LocalPlaces around_middle(std::span<const Point> ecef,
                          const std::optional<GeographicPosition>& origin_wanted = {});

}  // namespace beespace::report
