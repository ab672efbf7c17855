#include "analysis/recorded/limits_beside.hpp"

#include "analysis/recorded/findings.hpp"
#include "analysis/recorded/tracks.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace beespace::analysis {
namespace {

using Direction = io::ShowAcceleration::Direction;

constexpr auto kAcceleration = static_cast<std::size_t>(PathLimit::kAcceleration);

// What of a path lies in that direction: its shadow on the ground, or its heights. Derivatives of a
// shadow are the shadows of derivatives.
BezierPath shadow_of(const BezierPath& path, Direction direction) {
  const auto project = [direction](Point& place) {
    if (direction == Direction::kHorizontal) place.z = 0.0;
    if (direction == Direction::kVertical) place.x = place.y = 0.0;
  };
  BezierPath shadow = path;
  project(shadow.begin);
  for (BezierPiece& piece : shadow.pieces) {
    project(piece.end);
    for (Point& control : piece.controls) project(control);
  }
  return shadow;
}

std::optional<Error> check_flight(const Flight& flight, PointId bee, AccelerationCheck& check) {
  PathLimits limits;
  limits[PathLimit::kAcceleration] = check.declared.most_mps2;
  for (const BezierPath& path : flight) {
    const auto checked = check_path(shadow_of(path, check.declared.direction), limits);
    if (!checked) return checked.error();
    for (const PathExcess& excess : checked->excesses) check.excesses.push_back({bee, excess});
    const PathPeak& peak = checked->peaks[kAcceleration];
    if (!check.greatest || peak.value > check.greatest->peak.value) {
      check.greatest = BeePeak{bee, peak};
    }
  }
  return std::nullopt;
}

}  // namespace

Result<LimitsBeside> check_limits_beside(const io::Recording& recording,
                                         const std::vector<Flight>& flights) {
  LimitsBeside found;
  const io::ShowLimits& declared = recording.show->limits;
  for (const io::ShowAcceleration& acceleration : declared.accelerations) {
    AccelerationCheck check{acceleration, {}, {}};
    for (std::size_t bee = 0; bee < flights.size(); ++bee) {
      auto error = check_flight(flights[bee], static_cast<PointId>(bee), check);
      if (error) return of_bee(*std::move(error), recording.bees[bee]);
    }
    if (acceleration.direction != Direction::kNotKnown) {
      found.accelerations.push_back(std::move(check));
    } else if (!check.excesses.empty()) {
      found.not_known.push_back(acceleration.name);
    }
  }
  for (const auto& [name, height_m] : declared.navigation_m) {
    auto check = check_navigation(name, height_m, flights);
    if (!check) return check.error();
    if (!check->kept()) found.not_known.push_back(name);
    found.navigation.push_back(*std::move(check));
  }
  const auto& others = declared.not_looked_at;
  found.not_known.insert(found.not_known.end(), others.begin(), others.end());
  return found;
}

const char* acceleration_noun(Direction direction) {
  switch (direction) {
    case Direction::kHorizontal:
      return "horizontal acceleration";
    case Direction::kVertical:
      return "vertical acceleration";
    case Direction::kAll:
    case Direction::kNotKnown:
      break;
  }
  return "acceleration";
}

std::vector<std::string> skippable_limits(const io::Recording& recording) {
  if (!recording.show) return {};
  const io::ShowLimits& limits = recording.show->limits;
  std::vector<std::string> known = limits.not_looked_at;
  for (const auto& [name, height_m] : limits.navigation_m) known.push_back(name);
  for (const io::ShowAcceleration& limit : limits.accelerations) known.push_back(limit.name);
  return known;
}

}  // namespace beespace::analysis
