// The searches for pairs behind find_pairs, visit_pairs, find_neighbors and count_neighbors, with
// their tuning open to tests and benchmarks.
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace::search {

Status find_pairs(const SearchDomain& domain, const PairOptions& options,
                  const core::Resources& with, const TuningOverrides& tuning,
                  std::vector<Pair>& pairs);

// Of a domain without others.
bool visit_pairs(const SearchDomain& domain, const PairOptions& options,
                 const core::Resources& with, const TuningOverrides& tuning,
                 const PairVisitor& visit);

Status find_neighbors(const SearchDomain& domain, const PairOptions& options,
                      const core::Resources& with, const TuningOverrides& tuning,
                      IdRows& neighbors);

// The rows that sorted pairs make up, of so many points.
void write_rows(const core::Buffer<Pair>& pairs, std::size_t size, std::size_t row_count,
                const core::Resources& with, IdRows& rows);

void count_neighbors(const SearchDomain& domain, const PairOptions& options,
                     const core::Resources& with, const TuningOverrides& tuning,
                     std::vector<std::uint32_t>& counts);

}  // namespace beespace::search
