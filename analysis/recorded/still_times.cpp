#include "analysis/recorded/still_times.hpp"

#include "io/recording/flat_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>

namespace beespace::analysis {
namespace {

constexpr double kLeastStill_s = 60.0;
constexpr double kMostBetween_s = 60.0;  // from one report of standing to the next
constexpr double kMostStill_mps = 0.3;   // speeds are told in knots
constexpr double kOnePlace_m = 50.0;     // so far receivers of satellites stray
constexpr double kOneHeight_m = 30.0;    // heights go in steps of 25 ft, as pressure does

bool tells_no_speed(const io::RecordedBee& bee, std::size_t fix) {
  const Velocity& velocity = bee.velocities[fix];
  return std::hypot(velocity.x, velocity.y) <= kMostStill_mps;  // not where it is unknown
}

}  // namespace

std::vector<TimeSpan> still_times(const io::RecordedBee& bee, io::Frame frame) {
  std::vector<TimeSpan> times;
  if (bee.velocities.size() != bee.fixes.size()) return times;
  const auto goes_on = [&](std::size_t first, std::size_t last, std::size_t next) {
    const Point& from = bee.fixes[first].position;
    const Point& to = bee.fixes[next].position;
    return tells_no_speed(bee, next) &&
           bee.fixes[next].time_s - bee.fixes[last].time_s <= kMostBetween_s &&
           io::flat_distance_m(from, to, frame) <= kOnePlace_m &&
           std::abs(to.z - from.z) <= kOneHeight_m;
  };
  for (std::size_t first = 0; first < bee.fixes.size();) {
    std::size_t last = first;
    if (tells_no_speed(bee, first)) {
      while (last + 1 < bee.fixes.size() && goes_on(first, last, last + 1)) ++last;
    }
    const TimeSpan time{bee.fixes[first].time_s, bee.fixes[last].time_s};
    if (time.ends_s - time.begins_s >= kLeastStill_s) times.push_back(time);
    first = last + 1;
  }
  return times;
}

std::vector<Conflict> beside_still(const io::Recording& recording,
                                   const std::vector<Conflict>& conflicts) {
  std::vector<Conflict> beside;
  if (!recording.of_aircraft) return beside;
  std::map<PointId, std::vector<TimeSpan>> known;  // of those in conflict
  const auto stands = [&](PointId bee, const Conflict& conflict) {
    auto found = known.find(bee);
    if (found == known.end()) {
      found = known.emplace(bee, still_times(recording.bees[bee], recording.frame)).first;
    }
    return std::any_of(found->second.begin(), found->second.end(), [&](const TimeSpan& time) {
      return time.begins_s <= conflict.begins_s && conflict.ends_s <= time.ends_s;
    });
  };
  std::copy_if(conflicts.begin(), conflicts.end(), std::back_inserter(beside),
               [&](const Conflict& conflict) {
                 return stands(conflict.first, conflict) || stands(conflict.second, conflict);
               });
  return beside;
}

}  // namespace beespace::analysis
