#include "analysis/snapshot/closest_in_conflict.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <tuple>

namespace beespace::analysis {

Result<std::vector<Nearest>> closest_in_conflict(Engine& engine, const PointsView& places,
                                                 const PointsView& points,
                                                 const SearchOptions& options,
                                                 const std::vector<PointId>& at_risk) {
  std::vector<Nearest> closest(at_risk.size());
  const auto of = [&](PointId bee) -> Nearest& {
    const auto place = std::lower_bound(at_risk.begin(), at_risk.end(), bee);
    return closest[static_cast<std::size_t>(place - at_risk.begin())];
  };
  const auto take = [](Nearest& known, PointId other, double distance_m) {
    if (std::tie(distance_m, other) < std::tie(known.distance_m, known.id)) {
      known = {other, distance_m};
    }
  };
  const auto seen = engine.visit_pairs(places, options, [&](std::span<const Pair> pairs) {
    for (const auto& [first, second] : pairs) {
      const double distance_m = distance(points[first], points[second]);
      take(of(first), second, distance_m);
      take(of(second), first, distance_m);
    }
    return true;
  });
  if (!seen) return seen.error();
  return closest;
}

}  // namespace beespace::analysis
