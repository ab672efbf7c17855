#include "io/recording/swapped_degrees.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace beespace::io {
namespace {

constexpr double kFar_m = 1'000'000.0;
constexpr double kNear_m = 100'000.0;
constexpr std::size_t kMostBees = 2'000;  // each is compared with each

struct Place {
  double longitude_deg;
  double latitude_deg;
};

// Over a sphere: about is enough.
double metres_between(const Place& a, const Place& b) {
  constexpr double kRadius_m = 6'371'000.0;
  constexpr double kRadians = std::numbers::pi / 180.0;
  const double up = std::sin((b.latitude_deg - a.latitude_deg) * kRadians / 2.0);
  const double along = std::sin((b.longitude_deg - a.longitude_deg) * kRadians / 2.0);
  const double h = up * up + std::cos(a.latitude_deg * kRadians) *
                                 std::cos(b.latitude_deg * kRadians) * along * along;
  return 2.0 * kRadius_m * std::asin(std::min(1.0, std::sqrt(h)));
}

// The nearest of the others, and how far it is.
std::pair<std::size_t, double> nearest(const Place& place, std::size_t self,
                                       const std::vector<Place>& places) {
  std::pair<std::size_t, double> found{self, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == self) continue;
    const double apart_m = metres_between(place, places[i]);
    if (apart_m < found.second) found = {i, apart_m};
  }
  return found;
}

}  // namespace

std::optional<std::string> swapped_degrees_note(const Recording& recording) {
  const auto& bees = recording.bees;
  if (recording.frame != Frame::kWgs84 || bees.size() < 2 || bees.size() > kMostBees) {
    return std::nullopt;
  }
  std::vector<Place> places;
  for (const RecordedBee& bee : bees) {
    if (bee.fixes.empty()) return std::nullopt;
    const Point& at = bee.fixes[bee.fixes.size() / 2].position;
    places.push_back({at.x, at.y});
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place swapped{places[i].latitude_deg, places[i].longitude_deg};
    if (std::abs(swapped.latitude_deg) > 90.0) continue;
    const double far_m = nearest(places[i], i, places).second;
    const auto [other, near_m] = nearest(swapped, i, places);
    if (far_m < kFar_m || near_m > kNear_m) continue;
    return "bee " + excerpt(bees[i].id) + " is " + grouped(far_m / 1000.0, 0) +
           " km from the nearest other one, but would be " + grouped(near_m / 1000.0, 1) +
           " km from " + excerpt(bees[other].id) +
           " with longitude and latitude the other way round; look whether one file has them "
           "under each other's name (--columns lon=...,lat=...)";
  }
  return std::nullopt;
}

}  // namespace beespace::io
