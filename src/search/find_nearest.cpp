#include <beespace/nearest.hpp>

#include "core/bounds.hpp"
#include "core/nearest_search.hpp"
#include "core/validate.hpp"
#include "cpu/crew_size.hpp"

namespace beespace {

Result<std::vector<Nearest>> find_nearest_within(const PointsView& points, const SearchOptions& options) {
  if (auto error = core::check_options(options)) return *std::move(error);
  if (auto error = core::check_size(points.size())) return *std::move(error);
  ThreadCrew crew(cpu::crew_size(options.threads, points.size()));
  const Result<core::Bounds> bounds = core::measure(points, crew);
  if (!bounds) return bounds.error();
  return core::nearest_within(points, *bounds, options, crew);
}

}  // namespace beespace
