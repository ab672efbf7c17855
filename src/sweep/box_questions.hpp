// Points at risk and groups by trees of boxes of doubles: for what floats would leave open too
// often, or a sweep compare too often. Whole boxes are taken or left at once wherever they are
// surely, or exactly, near or far.
//
// Cost: of the pairs of boxes that are open. Those are few unless points of many boxes are within
// and without the threshold of each other; docs/how-it-works.md says where. Working memory: 50 to
// 75 bytes a point.
#pragma once

#include "base/disjoint_sets.hpp"
#include "base/resources.hpp"
#include "sweep/box_join.hpp"
#include "tree/box_tree.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::cpu {

// Writes to at_risk[id] of each point whether one of the others is near.
void mark_in_boxes(const PointsView& points, const PointsView& others, const BoxQuery& question,
                   const core::Resources& with, std::uint8_t* at_risk);

// Joins the sets of all slots of the tree whose points are near.
void join_in_boxes(const core::BoxTree& tree, const BoxQuery& question, const core::Resources& with,
                   core::DisjointSets& sets);

}  // namespace beespace::cpu
