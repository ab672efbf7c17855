// The grids of a domain for one threshold, ready for queries.
#pragma once

#include "base/resources.hpp"
#include "exact/exact_distance.hpp"
#include "grid/sorted_grid.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"
#include "sweep/row_sweeps.hpp"

#include <beespace/search_options.hpp>

#include <optional>

namespace beespace::search {

class QueryGrids {
 public:
  QueryGrids(const SearchDomain& domain, const PairOptions& options, const core::Resources& with,
             const TuningOverrides& tuning);
  QueryGrids(const QueryGrids&) = delete;
  QueryGrids& operator=(const QueryGrids&) = delete;
  ~QueryGrids() = default;

  [[nodiscard]] cpu::SweepQuery question() const;

 private:
  const SearchDomain& domain_;
  core::ProximityTest closer_;
  cpu::InstructionSet instruction_set_;
  double threshold_m_;
  core::SortedGrid points_;
  std::optional<core::SortedGrid> others_;
};

}  // namespace beespace::search
