#include "analysis/recorded/flights.hpp"

#include "analysis/recorded/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

namespace beespace::analysis {
namespace {

Flight flight_between_fixes(const io::RecordedBee& bee, bool with_velocities, double max_gap_s) {
  Flight flight;
  for (std::size_t i = 0; i < bee.fixes.size(); ++i) {
    const Fix& fix = bee.fixes[i];
    const bool goes_on = i > 0 && fix.time_s - bee.fixes[i - 1].time_s <= max_gap_s;
    if (!goes_on) {
      flight.push_back({fix.time_s, fix.position, {}});
    } else if (with_velocities) {
      flight.back().pieces.push_back(
          piece_to(bee.fixes[i - 1], bee.velocities[i - 1], fix, bee.velocities[i]));
    } else {
      flight.back().pieces.push_back({fix.time_s, fix.position, {}, 0});
    }
  }
  return flight;
}

constexpr double kMicrometres = 1e6;

// Nothing where that is no whole number of them.
std::optional<double> in_micrometres(double metres) {
  constexpr double kMost = 0x1p53;
  const double whole = std::round(metres * kMicrometres);
  // A double that is read from a decimal is the one nearest to it, and so is this quotient.
  if (!(std::abs(whole) < kMost) || whole / kMicrometres != metres) return std::nullopt;
  return whole;
}

std::optional<Point> in_micrometres(const Point& p) {
  const auto x = in_micrometres(p.x);
  const auto y = in_micrometres(p.y);
  const auto z = in_micrometres(p.z);
  if (!x || !y || !z) return std::nullopt;
  return Point{*x, *y, *z};
}

std::optional<BezierPath> in_micrometres(BezierPath path) {
  bool whole = true;
  const auto change = [&whole](Point& p) {
    const auto changed = in_micrometres(p);
    whole = whole && changed;
    if (changed) p = *changed;
  };
  change(path.begin);
  for (BezierPiece& piece : path.pieces) {
    change(piece.end);
    for (std::size_t i = 0; i < piece.control_count; ++i) change(piece.controls[i]);
    if (!whole) return std::nullopt;
  }
  return whole ? std::optional(std::move(path)) : std::nullopt;
}

}  // namespace

BezierPiece piece_to(const Fix& from, const Velocity& v, const Fix& to, const Velocity& w) {
  const double third_s = (to.time_s - from.time_s) / 3.0;
  const Point& p = from.position;
  const Point& q = to.position;
  return {to.time_s,
          q,
          {{{p.x + v.x * third_s, p.y + v.y * third_s, p.z + v.z * third_s},
            {q.x - w.x * third_s, q.y - w.y * third_s, q.z - w.z * third_s}}},
          2};
}

double path_end_s(const BezierPath& path) {
  return path.pieces.empty() ? path.begins_s : path.pieces.back().ends_s;
}

std::vector<Flight> flights_of(const io::Recording& recording, bool with_velocities,
                               double max_gap_s) {
  std::vector<Flight> flights;
  flights.reserve(recording.bees.size());
  for (const io::RecordedBee& bee : recording.bees) {
    flights.push_back(bee.path ? Flight{*bee.path}
                               : flight_between_fixes(bee, with_velocities, max_gap_s));
  }
  return flights;
}

Result<std::vector<Track>> tracks_of(const std::vector<Flight>& flights,
                                     const io::Recording& recording, double tolerance_m) {
  std::vector<Track> tracks(flights.size());
  for (std::size_t bee = 0; bee < flights.size(); ++bee) {
    for (const BezierPath& path : flights[bee]) {
      auto run = to_track(path, tolerance_m);
      if (!run) return of_bee(std::move(run).error(), recording.bees[bee]);
      tracks[bee].tolerance_m = std::max(tracks[bee].tolerance_m, run->tolerance_m);
      tracks[bee].fixes.insert(tracks[bee].fixes.end(), run->fixes.begin(), run->fixes.end());
    }
  }
  return tracks;
}

Result<std::optional<PathEncounter>> closest_as_written(const BezierPath& first,
                                                        const BezierPath& second,
                                                        const TimeSpan& during,
                                                        double threshold_m) {
  const auto threshold_um = in_micrometres(threshold_m);
  const auto one = threshold_um ? in_micrometres(first) : std::nullopt;
  const auto other = one ? in_micrometres(second) : std::nullopt;
  if (!other) return closest_on_paths(first, second, during, threshold_m);
  auto found = closest_on_paths(*one, *other, during, *threshold_um);
  if (!found || !*found) return found;
  PathEncounter& encounter = **found;
  encounter.closest_m /= kMicrometres;
  if (!encounter.closer) encounter.closest_m = std::max(encounter.closest_m, threshold_m);
  return found;
}

Result<std::optional<PathEncounter>> closest_of(const Flight& first, const Flight& second,
                                                const TimeSpan& during, double threshold_m) {
  std::optional<PathEncounter> closest;
  for (const BezierPath& one : first) {
    for (const BezierPath& other : second) {
      const double from_s = std::max(one.begins_s, other.begins_s);
      if (from_s > std::min(path_end_s(one), path_end_s(other))) continue;
      auto found = closest_as_written(one, other, during, threshold_m);
      if (!found) return found;
      if (!*found) continue;
      const bool closer = (*found)->closer || (closest && closest->closer);
      if (!closest || (*found)->closest_m < closest->closest_m) closest = *found;
      closest->closer = closer;
    }
  }
  return closest;
}

}  // namespace beespace::analysis
