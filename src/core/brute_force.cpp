#include <beespace/brute_force.hpp>

#include "core/exact_distance.hpp"
#include "core/validate.hpp"

namespace beespace {

namespace brute_force {

namespace {

std::optional<Error> check(const PointsView& points, const SearchOptions& options) {
  if (auto error = core::check_options(options)) return error;
  if (auto error = core::check_size(points.size())) return error;
  return core::check_points(points, 0, points.size());
}

}  // namespace

Result<std::vector<PointId>> find_at_risk(const PointsView& points, const SearchOptions& options) {
  if (auto error = check(points, options)) return *std::move(error);
  const core::ProximityTest closer(options.threshold_m, options.inclusive);
  const auto size = static_cast<PointId>(points.size());
  std::vector<PointId> at_risk;
  for (PointId i = 0; i < size; ++i) {
    for (PointId j = 0; j < size; ++j) {
      if (i == j || !closer(points[i], points[j])) continue;
      at_risk.push_back(i);
      break;
    }
  }
  return at_risk;
}

Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points) {
  if (auto error = check(points, {})) return *std::move(error);
  const auto size = static_cast<PointId>(points.size());
  std::optional<ClosestPair> closest;
  for (PointId i = 0; i < size; ++i) {
    for (PointId j = i + 1; j < size; ++j) {
      const bool closer =
          !closest || core::compare_distances(points[i], points[j], points[closest->first],
                                              points[closest->second]) < 0;
      if (closer) closest = ClosestPair{i, j, distance(points[i], points[j])};
    }
  }
  return closest;
}

Result<std::vector<Nearest>> find_nearest(const PointsView& points, const SearchOptions& options) {
  if (auto error = check(points, options)) return *std::move(error);
  const core::ProximityTest closer(options.threshold_m, options.inclusive);
  const auto size = static_cast<PointId>(points.size());
  std::vector<Nearest> nearest(size);
  for (PointId i = 0; i < size; ++i) {
    for (PointId j = 0; j < size; ++j) {
      if (i == j || !closer(points[i], points[j])) continue;
      const PointId best = nearest[i].id;
      const bool nearer =
          best == Nearest::kNobody ||
          core::compare_distances(points[i], points[j], points[i], points[best]) < 0;
      if (nearer) nearest[i] = {j, distance(points[i], points[j])};
    }
  }
  return nearest;
}

}  // namespace brute_force

}  // namespace beespace
