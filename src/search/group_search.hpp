// The search behind find_conflict_groups, with its tuning open to tests and benchmarks.
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/search_options.hpp>

namespace beespace::search {

// Of a domain without others.
void find_conflict_groups(const SearchDomain& domain, const PairOptions& options,
                          const core::Resources& with, const TuningOverrides& tuning,
                          IdRows& groups);

// Writes groups of two or more, given by the root of each id, in the order of their lowest member,
// members ascending: ids are gone through in order, and each goes to the end of its group.
void write_groups(const core::Buffer<std::uint32_t>& root_of, std::size_t size,
                  const core::Resources& with, IdRows& groups);

}  // namespace beespace::search
