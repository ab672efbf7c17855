#include <beespace/nearest.hpp>

#include "core/bounds.hpp"
#include "core/closest_pair.hpp"
#include "core/validate.hpp"
#include "cpu/crew_size.hpp"

namespace beespace {

Result<std::optional<ClosestPair>> find_closest_pair(const PointsView& points, unsigned threads) {
  if (auto error = core::check_size(points.size())) return *std::move(error);
  ThreadCrew crew(cpu::crew_size(threads, points.size()));
  const Result<core::Bounds> bounds = core::measure(points, crew);
  if (!bounds) return bounds.error();
  if (points.size() < 2) return std::optional<ClosestPair>();
  const core::IdPair pair = core::closest_pair(points, *bounds, crew);
  return std::optional(
      ClosestPair{pair.first, pair.second, distance(points[pair.first], points[pair.second])});
}

}  // namespace beespace
