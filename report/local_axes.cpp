#include "report/local_axes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace beespace::report {
namespace {

// Of WGS84: the half axes, and what their squares differ by, of that of either.
constexpr double kEquator_m = 6'378'137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kPole_m = kEquator_m * (1.0 - kFlattening);
constexpr double kOfEquator = kFlattening * (2.0 - kFlattening);
constexpr double kOfPole = kOfEquator / (1.0 - kOfEquator);
// No bee is deeper than this, but the middle of those that are far from each other may be.
constexpr double kDeep_m = kPole_m - 100'000.0;

struct Direction {
  double cosine = 1.0;
  double sine = 0.0;

  [[nodiscard]] double degrees() const {
    const double degrees = std::atan2(sine, cosine) * 180.0 / std::numbers::pi;
    return std::clamp(degrees, -180.0, 180.0);
  }
};

Direction direction(double along, double across) {
  const double size = std::hypot(along, across);
  if (!(size > 0.0)) return {};
  return {along / size, across / size};
}

// Bowring: Transformation from spatial to geographical coordinates, Survey Review 23, 1976. One
// step of it is right to a thousandth of a millionth of a degree wherever bees fly. Near the middle
// of the Earth it goes beyond the poles; deep inside, latitudes are those seen from the middle.
Direction latitude_of(double from_axis_m, double z) {
  if (std::hypot(from_axis_m, z) < kDeep_m) return direction(from_axis_m, z);
  const Direction reduced = direction(from_axis_m * kPole_m, z * kEquator_m);
  const double cubed_sine = reduced.sine * reduced.sine * reduced.sine;
  const double cubed_cosine = reduced.cosine * reduced.cosine * reduced.cosine;
  return direction(from_axis_m - kOfEquator * kEquator_m * cubed_cosine,
                   z + kOfPole * kPole_m * cubed_sine);
}

struct Directions {
  Direction longitude;
  Direction latitude;
};

Directions directions_of(const Point& ecef) {
  return {direction(ecef.x, ecef.y), latitude_of(std::hypot(ecef.x, ecef.y), ecef.z)};
}

}  // namespace

LocalAxes local_axes_at(const Point& ecef) {
  const auto [longitude, latitude] = directions_of(ecef);
  return {{-longitude.sine, longitude.cosine, 0.0},
          {-latitude.sine * longitude.cosine, -latitude.sine * longitude.sine, latitude.cosine},
          {latitude.cosine * longitude.cosine, latitude.cosine * longitude.sine, latitude.sine}};
}

LocalVelocity to_local_velocity(const Point& ecef, const Velocity& velocity) {
  const auto [longitude, latitude] = directions_of(ecef);
  const Velocity& v = velocity;
  const double outward = v.x * longitude.cosine + v.y * longitude.sine;
  return {v.y * longitude.cosine - v.x * longitude.sine,
          v.z * latitude.cosine - outward * latitude.sine,
          outward * latitude.cosine + v.z * latitude.sine};
}

GeographicPosition to_geographic(const Point& ecef) {
  const auto [longitude, latitude] = directions_of(ecef);
  // Along the normal of the ellipsoid, from where it meets the surface.
  const double from_axis_m = std::hypot(ecef.x, ecef.y);
  const double sine = latitude.sine;
  const double normal_m = kEquator_m / std::sqrt(1.0 - kOfEquator * sine * sine);
  const double height_m =
      from_axis_m * latitude.cosine + ecef.z * sine - normal_m * (1.0 - kOfEquator * sine * sine);
  return {longitude.degrees(), latitude.degrees(), height_m};
}

}  // namespace beespace::report
