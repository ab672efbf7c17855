#include "analysis/scene/pair_ways.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace beespace::analysis {
namespace {

// What a page holds: so many instants in all, so many of a pair.
constexpr std::size_t kMostInstants = 60'000;
constexpr std::size_t kMostOfPair = 400;

// So long before and after a conflict one looks: as long as it lasts, within these.
constexpr double kLeastAround_s = 10.0;
constexpr double kMostAround_s = 120.0;

// The instants at which either turns, within the span; its ends, and when they are closest.
std::vector<double> instants_of(const Conflict& conflict, const TimeSpan& span,
                                const Uprights& uprights) {
  std::vector<double> instants = {span.begins_s, conflict.closest_s, span.ends_s};
  for (const PointId bee : {conflict.first, conflict.second}) {
    const std::vector<Fix>& fixes = uprights.track(bee).fixes;
    const auto before = [](const Fix& fix, double time_s) { return fix.time_s < time_s; };
    const auto begin = std::lower_bound(fixes.begin(), fixes.end(), span.begins_s, before);
    for (auto fix = begin; fix != fixes.end() && fix->time_s <= span.ends_s; ++fix) {
      instants.push_back(fix->time_s);
    }
  }
  std::sort(instants.begin(), instants.end());
  instants.erase(std::unique(instants.begin(), instants.end()), instants.end());
  return instants;
}

bool are_there(const Conflict& conflict, double time_s, const Uprights& uprights) {
  return uprights.in_space_at(conflict.first, time_s) &&
         uprights.in_space_at(conflict.second, time_s);
}

// Those around the closest one between which both are always known, and not too many.
std::vector<double> known_instants(const std::vector<double>& instants, const Conflict& conflict,
                                   const Uprights& uprights) {
  const auto closest = std::lower_bound(instants.begin(), instants.end(), conflict.closest_s);
  auto first = closest;
  const auto known_between = [&](double from_s, double to_s) {
    return are_there(conflict, 0.5 * (from_s + to_s), uprights);
  };
  while (first != instants.begin() && closest - first < std::ptrdiff_t{kMostOfPair / 2} &&
         are_there(conflict, *(first - 1), uprights) && known_between(*(first - 1), *first)) {
    --first;
  }
  auto last = closest;
  while (last + 1 != instants.end() && last - closest < std::ptrdiff_t{kMostOfPair / 2} &&
         are_there(conflict, *(last + 1), uprights) && known_between(*last, *(last + 1))) {
    ++last;
  }
  return {first, last + 1};
}

Point difference(const Point& from, const Point& to) {
  return {to.x - from.x, to.y - from.y, to.z - from.z};
}

report::PairWay way_of(const Conflict& conflict, const Uprights& uprights) {
  const double around_s =
      std::clamp(conflict.ends_s - conflict.begins_s, kLeastAround_s, kMostAround_s);
  const TimeSpan span{conflict.begins_s - around_s, conflict.ends_s + around_s};
  report::PairWay way;
  for (const double time_s :
       known_instants(instants_of(conflict, span, uprights), conflict, uprights)) {
    const auto from = uprights.in_space_at(conflict.first, time_s);
    const auto to = uprights.in_space_at(conflict.second, time_s);
    const auto one = uprights.at(conflict.first, time_s);
    const auto other = uprights.at(conflict.second, time_s);
    if (!from || !to || !one || !other) continue;
    way.times_s.push_back(time_s);
    way.ways.push_back(difference(*from, *to));
    if (!uprights.on_earth()) continue;
    way.ground_ways.push_back(difference(one->ground, other->ground));
    way.heights_m.push_back(other->height_m - one->height_m);
  }
  return way;
}

}  // namespace

std::optional<report::Apart> apart_in(const Conflict& conflict, const Uprights& uprights) {
  // Both are there when they are closest, but for the rounding of that time.
  constexpr double kEarliest = -std::numeric_limits<double>::infinity();
  for (const double time_s : {conflict.closest_s, std::nextafter(conflict.closest_s, kEarliest),
                              std::nextafter(conflict.closest_s, -kEarliest)}) {
    const auto one = uprights.at(conflict.first, time_s);
    const auto other = uprights.at(conflict.second, time_s);
    if (one && other) return apart(*one, *other);
  }
  return std::nullopt;
}

std::vector<report::PairWay> pair_ways(const std::vector<Conflict>& conflicts,
                                       const Uprights& uprights) {
  std::vector<report::PairWay> ways;
  std::size_t instants = 0;
  for (const Conflict& conflict : conflicts) {
    ways.push_back(way_of(conflict, uprights));
    instants += ways.back().times_s.size();
    if (instants > kMostInstants) break;
  }
  return ways;
}

}  // namespace beespace::analysis
