// The road of count_neighbors through crowds.
#pragma once

#include "base/resources.hpp"
#include "search/choices.hpp"
#include "search/frame.hpp"

#include <beespace/search_options.hpp>

#include <cstdint>

namespace beespace::search {

// Writes the count of every point of a frame in which nobody is missing: neither points nor others.
void count_in_crowds(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                     const Choices& choices, std::uint32_t* counts);

}  // namespace beespace::search
