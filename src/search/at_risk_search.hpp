// The at-risk search behind find_at_risk, with its tuning open to tests and benchmarks.
//
//   points --> crowded? --yes--> prove by cells --> rest? --few--> look around each of them
//                  |                                  |
//                  no                                many
//                  v                                  v
//              sort into a grid --> sweep all rows --> ids, ascending
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/point.hpp>
#include <beespace/search_options.hpp>

#include <vector>

namespace beespace::search {

// The ids of the domain's points that are near another one, or near one of the domain's others.
void find_at_risk(const SearchDomain& domain, const PairOptions& options,
                  const core::Resources& with, const TuningOverrides& tuning,
                  std::vector<PointId>& at_risk);

}  // namespace beespace::search
