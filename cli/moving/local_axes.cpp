#include "cli/moving/local_axes.hpp"

#include <cmath>

namespace beespace::cli {
namespace {

// Of WGS84: the half axes, and what their squares differ by, of that of either.
constexpr double kEquator_m = 6'378'137.0;
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kPole_m = kEquator_m * (1.0 - kFlattening);
constexpr double kOfEquator = kFlattening * (2.0 - kFlattening);
constexpr double kOfPole = kOfEquator / (1.0 - kOfEquator);

struct Direction {
  double cosine = 1.0;
  double sine = 0.0;
};

Direction direction(double along, double across) {
  const double size = std::hypot(along, across);
  if (!(size > 0.0)) return {};
  return {along / size, across / size};
}

// Bowring: Transformation from spatial to geographical coordinates, Survey Review 23, 1976. One
// step of it is right to a thousandth of a millionth of a degree wherever bees fly.
Direction latitude_of(double from_axis_m, double z) {
  const Direction reduced = direction(from_axis_m * kPole_m, z * kEquator_m);
  const double cubed_sine = reduced.sine * reduced.sine * reduced.sine;
  const double cubed_cosine = reduced.cosine * reduced.cosine * reduced.cosine;
  return direction(from_axis_m - kOfEquator * kEquator_m * cubed_cosine,
                   z + kOfPole * kPole_m * cubed_sine);
}

}  // namespace

LocalVelocity to_local_velocity(const Point& ecef, const Velocity& velocity) {
  const Direction longitude = direction(ecef.x, ecef.y);
  const Direction latitude = latitude_of(std::hypot(ecef.x, ecef.y), ecef.z);
  const Velocity& v = velocity;
  const double outward = v.x * longitude.cosine + v.y * longitude.sine;
  return {v.y * longitude.cosine - v.x * longitude.sine,
          v.z * latitude.cosine - outward * latitude.sine,
          outward * latitude.cosine + v.z * latitude.sine};
}

}  // namespace beespace::cli
