// The road of count_neighbors through crowds.
#pragma once

#include "base/resources.hpp"
#include "search/search_domain.hpp"
#include "search/tuning_overrides.hpp"

#include <beespace/search_options.hpp>

#include <cstdint>

namespace beespace::search {

// Writes the count of every point of a domain that is complete: neither points nor others are
// missing.
void count_in_crowds(const SearchDomain& domain, const PairOptions& options,
                     const core::Resources& with, const TuningOverrides& tuning,
                     std::uint32_t* counts);

}  // namespace beespace::search
