// The k nearest other points of each point: in a tree of all, whose leaves are neighbours.
#pragma once

#include "base/bounds.hpp"
#include "base/resources.hpp"
#include "search/tuning_overrides.hpp"
#include "tree/nearest_list.hpp"

#include <beespace/nearest.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>
#include <span>

namespace beespace::search {

// The points must be in the domain and in these bounds. `lists`, one for each worker, are lent by
// the caller, for their memory.
void find_k_nearest(const PointsView& points, const core::Bounds& bounds, std::size_t k,
                    const core::Resources& with, const TuningOverrides& tuning,
                    std::span<core::NearestList> lists, NearestRows& rows);

}  // namespace beespace::search
