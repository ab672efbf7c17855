#include "io/recording/swapped_degrees.hpp"

#include "io/bytes/number_text.hpp"
#include "io/problems/excerpt.hpp"

#include <beespace/conflict_groups.hpp>
#include <beespace/geodesy.hpp>
#include <beespace/id_rows.hpp>
#include <beespace/nearest.hpp>
#include <beespace/point.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kFar_m = 1'000'000.0;
constexpr double kNear_m = 100'000.0;

// On the ground below; nothing where it is none.
std::optional<Point> on_ground(double longitude_deg, double latitude_deg) {
  const auto at = to_ecef({longitude_deg, latitude_deg, 0.0});
  return at ? std::optional(*at) : std::nullopt;
}

struct Places {
  std::vector<Point> as_given;
  std::vector<Point> swapped;  // the same ones where they cannot be swapped
};

std::optional<Places> places_of(const Recording& recording) {
  Places places;
  for (const RecordedBee& bee : recording.bees) {
    if (bee.fixes.empty()) return std::nullopt;
    const Point& at = bee.fixes[bee.fixes.size() / 2].position;
    const auto given = on_ground(at.x, at.y);
    if (!given) return std::nullopt;
    places.as_given.push_back(*given);
    places.swapped.push_back(on_ground(at.y, at.x).value_or(*given));
  }
  return places;
}

// The bees of a group have others of it within kFar_m, and none else.
class Groups {
 public:
  static std::optional<Groups> of(const std::vector<Point>& places) {
    auto found = find_conflict_groups(places, {.threshold_m = kFar_m});
    if (!found) return std::nullopt;
    return Groups(places.size(), *found);
  }

  [[nodiscard]] std::uint32_t of_bee(std::size_t bee) const { return group_[bee]; }
  [[nodiscard]] std::uint32_t count() const { return count_; }

 private:
  Groups(std::size_t bees, const IdRows& found) : group_(bees, kAlone) {
    for (std::size_t row = 0; row < found.size(); ++row, ++count_) {
      for (const PointId bee : found[row]) group_[bee] = count_;
    }
    for (std::uint32_t& group : group_) {
      if (group == kAlone) group = count_++;
    }
  }

  static constexpr std::uint32_t kAlone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> group_;
  std::uint32_t count_ = 0;
};

// A bee of the smallest group of which each would be beside one of another group with its degrees
// swapped, and how many there are of it; of equally small ones the first.
std::pair<std::size_t, std::size_t> smallest_swapped(const Groups& groups,
                                                     const std::vector<Nearest>& beside) {
  std::vector<std::size_t> bees(groups.count());
  std::vector<bool> swapped(groups.count(), true);
  for (std::size_t bee = 0; bee < beside.size(); ++bee) {
    const std::uint32_t group = groups.of_bee(bee);
    ++bees[group];
    const bool elsewhere =
        beside[bee].distance_m <= kNear_m && groups.of_bee(beside[bee].id) != group;
    if (!elsewhere) swapped[group] = false;
  }
  std::pair<std::size_t, std::size_t> found{0, 0};
  for (std::size_t bee = 0; bee < beside.size(); ++bee) {
    const std::uint32_t group = groups.of_bee(bee);
    if (!swapped[group] || (found.second != 0 && bees[group] >= found.second)) continue;
    found = {bee, bees[group]};
  }
  return found;
}

}  // namespace

std::optional<SwappedDegrees> swapped_degrees(const Recording& recording) {
  const auto& bees = recording.bees;
  if (recording.frame != Frame::kWgs84 || bees.size() < 2) return std::nullopt;
  const auto places = places_of(recording);
  if (!places) return std::nullopt;
  const auto groups = Groups::of(places->as_given);
  if (!groups || groups->count() < 2) return std::nullopt;
  const auto beside = find_nearest_between(places->swapped, places->as_given);
  if (!beside) return std::nullopt;
  const auto [bee, count] = smallest_swapped(*groups, *beside);
  if (count == 0) return std::nullopt;
  double far_m = std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < bees.size(); ++other) {
    if (groups->of_bee(other) == groups->of_bee(bee)) continue;
    far_m = std::min(far_m, distance(places->as_given[bee], places->as_given[other]));
  }
  const std::string others = count == 1 ? "" : ", as " + grouped(count - 1) + " beside it,";
  return SwappedDegrees{
      count, "bee " + excerpt(bees[bee].id) + others + " is " + grouped(far_m / 1000.0, 0) +
                 " km from the nearest other one, but would be " +
                 grouped((*beside)[bee].distance_m / 1000.0, 1) + " km from " +
                 excerpt(bees[(*beside)[bee].id].id) +
                 " with longitude and latitude the other way round; look whether one file has them "
                 "under each other's name (--columns lon=...,lat=... says which they are)"};
}

}  // namespace beespace::io
