// The search behind find_nearest and its relatives, with its choices open to tests and benchmarks.
//
// Everybody is looked at within a radius in which most find somebody; then, again and again, those
// who have not found their nearest within a larger one.
#pragma once

#include "base/resources.hpp"
#include "search/choices.hpp"
#include "search/frame.hpp"

#include <beespace/nearest.hpp>
#include <beespace/search_options.hpp>

#include <optional>
#include <vector>

namespace beespace::search {

// For each of the frame's points its nearest other, or its nearest of the frame's others; within
// the options' threshold if there are options.
void find_nearest(const Frame& frame, const std::optional<SearchOptions>& within,
                  const core::Resources& with, const Choices& choices,
                  std::vector<Nearest>& nearest);

// The closest of all pairs of one of the frame's points and one of its others.
// `nearest` is room to work in.
std::optional<ClosestPair> find_closest_between(const Frame& frame, const core::Resources& with,
                                                const Choices& choices,
                                                std::vector<Nearest>& nearest);

}  // namespace beespace::search
