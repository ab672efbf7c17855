// The searches for pairs behind find_pairs, visit_pairs, find_neighbors and count_neighbors, with
// their choices open to tests and benchmarks.
#pragma once

#include "base/resources.hpp"
#include "search/choices.hpp"
#include "search/frame.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/pairs.hpp>
#include <beespace/result.hpp>
#include <beespace/search_options.hpp>

#include <cstdint>
#include <vector>

namespace beespace::search {

Status find_pairs(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                  const Choices& choices, std::vector<Pair>& pairs);

// Of a frame without others.
bool visit_pairs(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                 const Choices& choices, const PairVisitor& visit);

Status find_neighbors(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                      const Choices& choices, IdRows& neighbors);

// The rows that sorted pairs make up, of so many points.
void write_rows(const core::Buffer<Pair>& pairs, std::size_t size, std::size_t row_count,
                const core::Resources& with, IdRows& rows);

void count_neighbors(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                     const Choices& choices, std::vector<std::uint32_t>& counts);

}  // namespace beespace::search
