#include "analysis/recorded/last_climb.hpp"

#include "io/units/units.hpp"

#include <cmath>
#include <cstddef>

namespace beespace::analysis {
namespace {

// The last rate that was told, and how long before the last fix.
struct ToldClimb {
  double up_mps = 0.0;
  double before_s = 0.0;
};

std::optional<ToldClimb> told_climb(const io::RecordedBee& bee) {
  const double now_s = bee.fixes.back().time_s;
  for (std::size_t i = bee.velocities.size(); i-- > 0;) {
    const double before_s = now_s - bee.fixes[i].time_s;
    if (before_s > kClimbLasts_s) break;
    if (std::isfinite(bee.velocities[i].z)) return ToldClimb{bee.velocities[i].z, before_s};
  }
  return std::nullopt;
}

// The first of the fixes that a slope is taken of.
std::size_t slope_begins(const io::RecordedBee& bee, double max_age_s) {
  const std::size_t last = bee.fixes.size() - 1;
  const double now_s = bee.fixes[last].time_s;
  std::size_t first = last;
  while (first > 0 && now_s - bee.fixes[first - 1].time_s <= kLongestClimb_s) --first;
  const bool alone = first == last;
  if (alone && last > 0 && now_s - bee.fixes[last - 1].time_s <= max_age_s) --first;
  return first;
}

// Of the straight line nearest to the heights, by least squares.
std::optional<double> slope_of_heights(const io::RecordedBee& bee, double max_age_s) {
  const std::size_t first = slope_begins(bee, max_age_s);
  const std::size_t end = bee.fixes.size();
  // Times and heights are counted from those of the last fix, so that nothing is lost of them.
  const Fix& now = bee.fixes.back();
  if (now.time_s - bee.fixes[first].time_s < kShortestClimb_s) return std::nullopt;
  const auto count = static_cast<double>(end - first);
  double mean_s = 0.0;
  double mean_m = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    mean_s += (bee.fixes[i].time_s - now.time_s) / count;
    mean_m += (bee.fixes[i].position.z - now.position.z) / count;
  }
  double along = 0.0;
  double squares = 0.0;
  for (std::size_t i = first; i < end; ++i) {
    const double at_s = bee.fixes[i].time_s - now.time_s - mean_s;
    along += at_s * (bee.fixes[i].position.z - now.position.z - mean_m);
    squares += at_s * at_s;
  }
  return along / squares;
}

}  // namespace

bool heights_in_steps(const io::Recording& recording, const io::RecordedBee& bee) {
  if (recording.height_unit == io::Unit::kFoot || recording.height_unit == io::Unit::kFlightLevel) {
    return true;
  }
  if (recording.frame != io::Frame::kWgs84 || recording.flat) return false;
  const bool of_aircraft = recording.heights == io::HeightDatum::kPressure ||
                           recording.heights == io::HeightDatum::kEllipsoid;
  // Who is told to fly that fast over ground and not how fast it climbs is an aircraft, too.
  const bool over_ground = !bee.velocities.empty() && std::isfinite(bee.velocities.back().x) &&
                           !std::isfinite(bee.velocities.back().z);
  return of_aircraft || over_ground;
}

std::optional<LastClimb> last_climb(const io::RecordedBee& bee, double max_age_s) {
  const auto told = told_climb(bee);
  if (told && told->before_s == 0.0) return LastClimb{told->up_mps, ClimbFrom::kRecord};
  if (told && told->before_s < kShortestClimb_s) {
    return LastClimb{told->up_mps, ClimbFrom::kEarlier};
  }
  if (const auto slope = slope_of_heights(bee, max_age_s)) {
    return LastClimb{*slope, ClimbFrom::kHeights};
  }
  if (told) return LastClimb{told->up_mps, ClimbFrom::kEarlier};
  return std::nullopt;
}

}  // namespace beespace::analysis
