#include <beespace/at_risk.hpp>

#include "core/bounds.hpp"
#include "core/validate.hpp"
#include "cpu/crew_size.hpp"
#include "search/at_risk_search.hpp"

namespace beespace {

Result<std::vector<PointId>> find_at_risk(const PointsView& points, const SearchOptions& options) {
  if (auto error = core::check_options(options)) return *std::move(error);
  if (auto error = core::check_size(points.size())) return *std::move(error);
  ThreadCrew crew(cpu::crew_size(options.threads, points.size()));
  const Result<core::Bounds> bounds = core::measure(points, crew);
  if (!bounds) return bounds.error();
  return search::at_risk_ids(points, *bounds, options, crew);
}

}  // namespace beespace
