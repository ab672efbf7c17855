// The closest to each bee at risk of those that it is in conflict with. With a vertical threshold
// that need not be its nearest: who is close in a straight line may keep apart in height.
#pragma once

#include <beespace/engine.hpp>
#include <beespace/nearest.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <vector>

namespace beespace::analysis {

// One for each of `at_risk`, which are those that these options find, ascending; of equally close
// ones the lowest id. `places` and `points` as for worst_pairs(). Looks at every pair. Errors: as
// Engine::visit_pairs.
Result<std::vector<Nearest>> closest_in_conflict(Engine& engine, const PointsView& places,
                                                 const PointsView& points,
                                                 const SearchOptions& options,
                                                 const std::vector<PointId>& at_risk);

}  // namespace beespace::analysis
