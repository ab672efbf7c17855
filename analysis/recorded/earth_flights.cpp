#include "analysis/recorded/earth_flights.hpp"

#include "analysis/geometry/geometry.hpp"

#include <beespace/geodesy.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

// From one place to the next, along the ground in the middle between both, and up.
Result<Point> way_between(const Point& from, const Point& to) {
  constexpr double kRadians = 3.14159265358979323846 / 180.0;
  const auto a = to_ecef(GeographicPosition{from.x, from.y, from.z});
  if (!a) return a.error();
  const auto b = to_ecef(GeographicPosition{to.x, to.y, to.z});
  if (!b) return b.error();
  const double longitude = kRadians * (from.x + 0.5 * std::remainder(to.x - from.x, 360.0));
  const double latitude = kRadians * 0.5 * (from.y + to.y);
  const Point d{b->x - a->x, b->y - a->y, b->z - a->z};
  const double outwards = std::cos(longitude) * d.x + std::sin(longitude) * d.y;
  return Point{flushed(std::cos(longitude) * d.y - std::sin(longitude) * d.x),
               flushed(std::cos(latitude) * d.z - std::sin(latitude) * outwards),
               flushed(to.z - from.z)};
}

Point moved(const Point& a, const Point& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

Point way_flown(const Velocity& v, double seconds) {
  return {flushed(v.x * seconds), flushed(v.y * seconds), flushed(v.z * seconds)};
}

// A log without velocities may have zeros for them.
bool says_velocities(const io::RecordedBee& bee) {
  const bool any = std::any_of(bee.velocities.begin(), bee.velocities.end(), [](const Velocity& v) {
    return is_known(v) && (v.x != 0.0 || v.y != 0.0 || v.z != 0.0);
  });
  const bool moves = std::any_of(bee.fixes.begin(), bee.fixes.end(), [&](const Fix& fix) {
    return fix.position != bee.fixes.front().position;
  });
  const bool known = std::any_of(bee.velocities.begin(), bee.velocities.end(),
                                 [](const Velocity& v) { return is_known(v); });
  return any || (known && !moves);
}

constexpr auto kAccelerated = static_cast<std::size_t>(PathLimit::kAcceleration);
constexpr auto kHigh = static_cast<std::size_t>(PathLimit::kHeight);

// Stretches that meet become one.
void unite(std::vector<PathExcess>& excesses) {
  std::stable_sort(excesses.begin(), excesses.end(), [](const PathExcess& a, const PathExcess& b) {
    return std::tuple(a.limit, a.begins_s) < std::tuple(b.limit, b.begins_s);
  });
  std::vector<PathExcess> united;
  for (const PathExcess& next : excesses) {
    if (united.empty() || united.back().limit != next.limit ||
        united.back().ends_s < next.begins_s) {
      united.push_back(next);
      continue;
    }
    PathExcess& last = united.back();
    last.ends_s = std::max(last.ends_s, next.ends_s);
    if (next.peak.value > last.peak.value) last.peak = next.peak;
  }
  excesses = std::move(united);
}

// Of the limits that are looked at along these.
std::optional<Error> add_check(const Flight& flight, const PathLimits& limits,
                               const std::array<bool, kPathLimits>& looked_at, PathCheck& check) {
  PathLimits some = limits;
  for (std::size_t k = 0; k < kPathLimits; ++k) {
    if (!looked_at[k]) some.most[k] = std::numeric_limits<double>::infinity();
  }
  for (const BezierPath& path : flight) {
    auto found = check_path(path, some);
    if (!found) return std::move(found).error();
    check.excesses.insert(check.excesses.end(), found->excesses.begin(), found->excesses.end());
    for (std::size_t k = 0; k < kPathLimits; ++k) {
      if (looked_at[k] && found->peaks[k].value > check.peaks[k].value) {
        check.peaks[k] = found->peaks[k];
      }
    }
  }
  return std::nullopt;
}

}  // namespace

bool logs_velocities(const io::Recording& recording) {
  return std::any_of(recording.bees.begin(), recording.bees.end(), says_velocities);
}

Result<EarthFlight> earth_flight_of(const io::Recording& recording, std::size_t bee,
                                    bool with_velocities, double max_gap_s) {
  const io::RecordedBee& of = recording.bees[bee];
  const bool both = with_velocities && says_velocities(of);
  EarthFlight flight;
  Point place;
  Point flown_to;
  for (std::size_t i = 0; i < of.fixes.size(); ++i) {
    const Fix& fix = of.fixes[i];
    if (i == 0 || fix.time_s - of.fixes[i - 1].time_s > max_gap_s) {
      place = flown_to = {0.0, 0.0, fix.position.z};
      flight.places.push_back({fix.time_s, place, {}});
      if (both) flight.velocities.push_back({fix.time_s, flown_to, {}});
      continue;
    }
    const Fix& before = of.fixes[i - 1];
    const auto way = way_between(before.position, fix.position);
    if (!way) return way.error();
    place = moved(place, *way);
    // Of heights no sum: they are what the height is limited by.
    place.z = fix.position.z;
    flight.places.back().pieces.push_back({fix.time_s, place, {}, 0});
    if (!both) continue;
    const double half_s = 0.5 * (fix.time_s - before.time_s);
    BezierPiece piece{fix.time_s, moved(flown_to, *way), {}, 0};
    if (is_known(of.velocities[i - 1]) && is_known(of.velocities[i])) {
      piece.controls[0] = moved(flown_to, way_flown(of.velocities[i - 1], half_s));
      piece.control_count = 1;
      piece.end = moved(piece.controls[0], way_flown(of.velocities[i], half_s));
    }
    flown_to = piece.end;
    flight.velocities.back().pieces.push_back(piece);
  }
  return flight;
}

Result<PathCheck> check_earth_flight(const EarthFlight& flight, const PathLimits& limits) {
  PathCheck check;
  for (PathPeak& peak : check.peaks) peak.value = -std::numeric_limits<double>::infinity();
  std::array<bool, kPathLimits> by_places;
  by_places.fill(true);
  by_places[kAccelerated] = flight.velocities.empty();
  std::array<bool, kPathLimits> by_velocities;
  by_velocities.fill(true);
  by_velocities[kHigh] = false;
  if (auto error = add_check(flight.places, limits, by_places, check)) return *std::move(error);
  if (auto error = add_check(flight.velocities, limits, by_velocities, check)) {
    return *std::move(error);
  }
  unite(check.excesses);
  return check;
}

}  // namespace beespace::analysis
