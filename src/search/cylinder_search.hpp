// The searches with a vertical threshold: pairs that are near in a sphere around the cylinder, each
// decided exactly, and what follows from them.
#pragma once

#include "core/resources.hpp"
#include "search/choices.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/pairs.hpp>
#include <beespace/points_view.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace::search {

class CylinderSearch {
 public:
  // Options have a vertical threshold, and all three must outlive the search.
  CylinderSearch(const PointsView& points, const SearchOptions& options,
                 const core::Resources& with, const Choices& choices)
      : points_(points), options_(options), with_(with), choices_(choices) {}

  Status find_at_risk(std::vector<PointId>& at_risk) const;
  Status find_pairs(std::vector<Pair>& pairs) const;
  Status find_neighbors(IdRows& neighbors) const;
  Status count_neighbors(std::vector<std::uint32_t>& counts) const;
  Status find_groups(IdRows& groups) const;
  // True when all pairs were seen, as visit_pairs.
  Result<bool> visit_pairs(const PairVisitor& visit) const;

 private:
  const PointsView& points_;
  const SearchOptions& options_;
  const core::Resources& with_;
  const Choices& choices_;
};

}  // namespace beespace::search
