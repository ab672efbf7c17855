// The searches for pairs behind find_pairs, visit_pairs, find_neighbors and count_neighbors, with
// their tuning open to tests and benchmarks.
#pragma once

#include "base/pair_order.hpp"
#include "base/resources.hpp"
#include "search/pair_answer.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/pairs.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace::search {

Status find_pairs(const SearchDomain& domain, const PairOptions& options,
                  const core::Resources& with, const TuningOverrides& tuning, PairAnswer& answer);

// Of a domain without others.
bool visit_pairs(const SearchDomain& domain, const PairOptions& options,
                 const core::Resources& with, const TuningOverrides& tuning,
                 const PairVisitor& visit);

Status find_neighbors(const SearchDomain& domain, const PairOptions& options,
                      const core::Resources& with, const TuningOverrides& tuning,
                      PairAnswer& answer);

// Brings found pairs of so many points into order; an error where they are more than `most`.
Status take_pairs(const core::Vector<core::FoundPairs>& found, core::Direction direction,
                  std::size_t points, std::uint64_t most, const core::Resources& with,
                  PairAnswer& answer);

void count_neighbors(const SearchDomain& domain, const PairOptions& options,
                     const core::Resources& with, const TuningOverrides& tuning,
                     std::vector<std::uint32_t>& counts);

}  // namespace beespace::search
