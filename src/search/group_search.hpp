// The search behind find_conflict_groups, with its choices open to tests and benchmarks.
#pragma once

#include "core/resources.hpp"
#include "search/choices.hpp"
#include "search/frame.hpp"

#include <beespace/id_rows.hpp>
#include <beespace/search_options.hpp>

namespace beespace::search {

// Of a frame without others.
void find_conflict_groups(const Frame& frame, const SearchOptions& options,
                          const core::Resources& with, const Choices& choices, IdRows& groups);

}  // namespace beespace::search
