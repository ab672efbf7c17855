#include "report/earth_frame.hpp"

#include "report/local_axes.hpp"

#include <beespace/nearest.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace beespace::report {
namespace {

// Of WGS84.
constexpr double kMajorAxis_m = 6'378'137.0;
constexpr double kFlatness = 1.0 / 298.257223563;
constexpr double kSquaredEccentricity = kFlatness * (2.0 - kFlatness);

constexpr double kDegree = std::numbers::pi / 180.0;

double along(const Point& a, const Point& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

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

EarthFrame::EarthFrame(const GeographicPosition& origin) {
  const double longitude = origin.longitude_deg * kDegree;
  const double latitude = origin.latitude_deg * kDegree;
  const double sine = std::sin(latitude);
  const double cosine = std::cos(latitude);
  east_ = {-std::sin(longitude), std::cos(longitude), 0.0};
  north_ = {-sine * std::cos(longitude), -sine * std::sin(longitude), cosine};
  up_ = {cosine * std::cos(longitude), cosine * std::sin(longitude), sine};
  const double flattened = 1.0 - kSquaredEccentricity * sine * sine;
  east_radius_m_ = kMajorAxis_m / std::sqrt(flattened);
  north_radius_m_ = east_radius_m_ * (1.0 - kSquaredEccentricity) / flattened;
}

Point EarthFrame::place_of(const Point& ecef) const {
  const Point vertical = local_axes_at(ecef).up;
  const double eastwards = along(vertical, east_);
  const double northwards = along(vertical, north_);
  const double height_m = to_geographic(ecef).height_m;
  const double leaning = std::hypot(eastwards, northwards);
  const double angle = std::atan2(leaning, along(vertical, up_));
  // At the antipode any direction is one to it.
  if (!(leaning > 0.0)) return {0.0, north_radius_m_ * angle, height_m};
  const double stretch = angle / leaning;
  return {east_radius_m_ * stretch * eastwards, north_radius_m_ * stretch * northwards, height_m};
}

GeographicPosition EarthFrame::position_of(const Point& place) const {
  const double eastwards = place.x / east_radius_m_;
  const double northwards = place.y / north_radius_m_;
  const double angle = std::hypot(eastwards, northwards);
  const double shrink = angle > 0.0 ? std::sin(angle) / angle : 1.0;
  const auto mixed = [&](double e, double n, double u) {
    return shrink * (eastwards * e + northwards * n) + std::cos(angle) * u;
  };
  const Point vertical{mixed(east_.x, north_.x, up_.x), mixed(east_.y, north_.y, up_.y),
                       mixed(east_.z, north_.z, up_.z)};
  const double longitude = std::atan2(vertical.y, vertical.x);
  const double latitude = std::atan2(vertical.z, std::hypot(vertical.x, vertical.y));
  return {std::clamp(longitude / kDegree, -180.0, 180.0), latitude / kDegree, place.z};
}

LocalPlaces around_middle(std::span<const Point> ecef,
                          const std::optional<GeographicPosition>& origin_wanted) {
  LocalPlaces local;
  local.origin = origin_wanted ? *origin_wanted : below_middle(ecef);
  const EarthFrame frame(local.origin);
  local.places.reserve(ecef.size());
  for (const Point& p : ecef) local.places.push_back(frame.place_of(p));
  return local;
}

double bend_m(const EarthFrame& frame, const Point& from, const Point& to) {
  // The ground falls away from a short line as a sphere does; what the map adds is far less.
  constexpr double kShort_m = 100.0;
  constexpr double kLeastRadius_m = 6.0e6;
  const double flown_m = distance(from, to);
  if (flown_m < kShort_m) return flown_m * flown_m / (8.0 * kLeastRadius_m);
  const Point a = frame.place_of(from);
  const Point b = frame.place_of(to);
  const Point middle =
      frame.place_of({0.5 * (from.x + to.x), 0.5 * (from.y + to.y), 0.5 * (from.z + to.z)});
  return std::hypot(0.5 * (a.x + b.x) - middle.x, 0.5 * (a.y + b.y) - middle.y,
                    0.5 * (a.z + b.z) - middle.z);
}

}  // namespace beespace::report
