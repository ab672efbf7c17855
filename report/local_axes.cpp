#include "report/local_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// Of an origin, which is a place on the Earth; where it is none, there is still something to see.
Point place_of(const GeographicPosition& origin) {
  const auto place = to_ecef(origin);
  return place ? *place : Point{kEquator_m, 0.0, 0.0};
}

double dot(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
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

EarthFrame::EarthFrame(const GeographicPosition& origin)
    : origin_(place_of(origin)), axes_(local_axes_at(origin_)) {
}

GeographicPosition EarthFrame::position_of(const Point& place) const {
  const auto& [east, north, up] = axes_;
  const auto along = [&place](double e, double n, double u) {
    return place.x * e + place.y * n + place.z * u;
  };
  return to_geographic({origin_.x + along(east.x, north.x, up.x),
                        origin_.y + along(east.y, north.y, up.y),
                        origin_.z + along(east.z, north.z, up.z)});
}

namespace {

// Of those around the whole Earth, whose middle is in no direction: below the first.
GeographicPosition below_middle(std::span<const Point> ecef) {
  constexpr double kNoDirection_m = 1.0;
  Point sum;
  for (const Point& p : ecef) sum = {sum.x + p.x, sum.y + p.y, sum.z + p.z};
  const double count = static_cast<double>(std::max<std::size_t>(1, ecef.size()));
  Point middle{sum.x / count, sum.y / count, sum.z / count};
  if (!ecef.empty() && std::hypot(middle.x, middle.y, middle.z) < kNoDirection_m) {
    middle = ecef.front();
  }
  const GeographicPosition above = to_geographic(middle);
  return {above.longitude_deg, above.latitude_deg, 0.0};
}

}  // namespace

LocalPlaces around_middle(std::span<const Point> ecef,
                          const std::optional<GeographicPosition>& origin_wanted) {
  LocalPlaces local;
  local.origin = origin_wanted ? *origin_wanted : below_middle(ecef);
  const Point origin = place_of(local.origin);
  const LocalAxes axes = local_axes_at(origin);
  local.places.reserve(ecef.size());
  for (const Point& p : ecef) {
    const Point from{p.x - origin.x, p.y - origin.y, p.z - origin.z};
    local.places.push_back({dot(from, axes.east), dot(from, axes.north), dot(from, axes.up)});
  }
  return local;
}

}  // namespace beespace::report
