#include "io/recording/doubled_drones.hpp"

#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>
#include <vector>

namespace beespace::io {
namespace {

constexpr const char* kWhatToDo =
    ": read the show alone, or one of them after the other; a bee of the table that is another one "
    "needs another id and place";

// Grids are written to the centimetre or better, and without heights, or with those of the place.
bool is_at(const Point& one, const Point& other) {
  constexpr double kAside_m = 0.01;
  constexpr double kAbove_m = 1.0;
  return std::abs(one.x - other.x) <= kAside_m && std::abs(one.y - other.y) <= kAside_m &&
         std::abs(one.z - other.z) <= kAbove_m;
}

bool stands_still(const RecordedBee& bee) {
  return std::all_of(bee.fixes.begin(), bee.fixes.end(),
                     [&bee](const Fix& fix) { return fix.position == bee.fixes.front().position; });
}

std::optional<std::string> problem_of(const RecordedBee& bee,
                                      const std::vector<const RecordedBee*>& drones,
                                      const std::unordered_set<std::string>& names) {
  if (names.contains(bee.id)) {
    return "bee " + excerpt(bee.id) + " is also a drone of the show, and would be two" + kWhatToDo;
  }
  if (!stands_still(bee)) return std::nullopt;
  for (const RecordedBee* drone : drones) {
    const Point& begin = drone->path ? drone->path->begin : *drone->stands;
    if (!is_at(bee.fixes.front().position, begin)) continue;
    return "bee " + excerpt(bee.id) + " stands where drone " + excerpt(drone->id) +
           " of the show begins, as in a take-off grid of the same drones, and would be another "
           "one" +
           kWhatToDo;
  }
  return std::nullopt;
}

}  // namespace

std::optional<DoubledDrone> doubled_drone(const TrackGathering& tracks) {
  std::vector<const RecordedBee*> drones;
  std::unordered_set<std::string> names;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const RecordedBee& bee = tracks.recorded(i);
    if (!bee.path && !bee.stands) continue;
    drones.push_back(&bee);
    names.insert(bee.id);
  }
  if (drones.empty()) return std::nullopt;
  std::size_t fix = 0;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const RecordedBee& bee = tracks.recorded(i);
    if (bee.fixes.empty()) continue;
    if (auto problem = problem_of(bee, drones, names))
      return DoubledDrone{*std::move(problem), fix};
    fix += bee.fixes.size();
  }
  return std::nullopt;
}

}  // namespace beespace::io
