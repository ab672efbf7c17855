#include "analysis/recorded/begins_in_air.hpp"

#include "analysis/recorded/landed_times.hpp"
#include "io/bytes/number_text.hpp"
#include "io/recording/flat_distance.hpp"

#include <beespace/point.hpp>
#include <beespace/track.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace beespace::analysis {
namespace {

// Heights of satellite fixes waver by less, and a drone on the ground is not carried so fast.
constexpr double kClearlyHigher_m = 5.0;
constexpr double kMoves_m = 1.0;
constexpr double kMovesWithin_s = 5.0;
// Satellite fixes of one that stands wander over ground by less in that time.
constexpr double kMovesAtOnce_m = 2.0;
// No roof is above the ground beside it so near.
constexpr double kSamePlace_m = 3.0;
// Above the place of take-off, by its own word.
constexpr double kFliesAbove_m = 2.0;

double over_ground_m(const Point& a, const Point& b, io::Frame frame) {
  const Point apart = io::flat_offset_m(a, b, frame);
  return std::hypot(apart.x, apart.y);
}

bool moves_at_first(const io::RecordedBee& bee, io::Frame frame) {
  const Fix& first = bee.fixes.front();
  return std::any_of(bee.fixes.begin(), bee.fixes.end(), [&](const Fix& fix) {
    return fix.time_s <= first.time_s + kMovesWithin_s &&
           io::flat_distance_m(first.position, fix.position, frame) > kMoves_m;
  });
}

// Its lowest fix, of which there are some.
const Fix& lowest_of(const io::RecordedBee& bee) {
  return *std::min_element(bee.fixes.begin(), bee.fixes.end(),
                           [](const Fix& a, const Fix& b) { return a.position.z < b.position.z; });
}

bool flies_at_first(const io::Recording& recording, PointId number) {
  const io::RecordedBee& bee = recording.bees[number];
  const Fix& first = bee.fixes.front();
  if (bee.on_surface || has_landed(recording, number, first.time_s)) return false;
  if (bee.took_off_at_m) return first.position.z - *bee.took_off_at_m > kFliesAbove_m;
  const Point& lowest = lowest_of(bee).position;
  if (first.position.z - lowest.z <= kClearlyHigher_m) return false;
  return !bee.landed.empty() || moves_at_first(bee, recording.frame) ||
         over_ground_m(first.position, lowest, recording.frame) <= kSamePlace_m;
}

}  // namespace

std::size_t begins_in_air(const io::Recording& recording, const MaxGap& max_gap) {
  const bool flown = recording.of_drones || recording.called_drones;
  if (!flown || recording.show || recording.flat || recording.reach || recording.of_aircraft ||
      recording.of_animals) {
    return 0;
  }
  double begins_s = std::numeric_limits<double>::infinity();
  for (const io::RecordedBee& bee : recording.bees) {
    if (!bee.fixes.empty()) begins_s = std::min(begins_s, bee.fixes.front().time_s);
  }
  std::size_t count = 0;
  for (PointId number = 0; number < recording.bees.size(); ++number) {
    const io::RecordedBee& bee = recording.bees[number];
    if (bee.fixes.empty() || bee.fixes.front().time_s > begins_s + max_gap.seconds) continue;
    if (flies_at_first(recording, number)) ++count;
  }
  return count;
}

bool may_stand_at_first(const io::Recording& recording, PointId number) {
  const io::RecordedBee& bee = recording.bees[number];
  if (bee.fixes.empty()) return false;
  const Fix& first = bee.fixes.front();
  if (bee.on_surface || has_landed(recording, number, first.time_s)) return true;
  if (bee.took_off_at_m) return first.position.z - *bee.took_off_at_m <= kFliesAbove_m;
  if (first.position.z - lowest_of(bee).position.z > kClearlyHigher_m) return false;
  // It may take off at once.
  return std::none_of(bee.fixes.begin(), bee.fixes.end(), [&](const Fix& fix) {
    return fix.time_s <= first.time_s + kMovesWithin_s &&
           over_ground_m(first.position, fix.position, recording.frame) > kMovesAtOnce_m;
  });
}

std::string begins_in_air_text(std::size_t bees) {
  if (bees == 0) return {};
  return io::counted(bees, "drone is", "drones are") +
         " in the air when the recording begins: what was before is not known";
}

}  // namespace beespace::analysis
