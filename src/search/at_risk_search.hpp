// The at-risk search behind find_at_risk, with its choices open to tests and benchmarks.
//
//   points --> crowded? --yes--> prove by cells --> rest? --few--> look around each of them
//                  |                                  |
//                  no                                many
//                  v                                  v
//              sort into a grid --> sweep all rows --> ids, ascending
#pragma once

#include "base/resources.hpp"
#include "search/choices.hpp"
#include "search/frame.hpp"

#include <beespace/point.hpp>
#include <beespace/search_options.hpp>

#include <vector>

namespace beespace::search {

// The ids of the frame's points that are near another one, or near one of the frame's others.
void find_at_risk(const Frame& frame, const SearchOptions& options, const core::Resources& with,
                  const Choices& choices, std::vector<PointId>& at_risk);

}  // namespace beespace::search
