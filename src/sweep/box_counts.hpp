// Counts neighbours by trees of boxes of doubles: for what floats would leave open too often.
//
// Whole boxes are counted or left at once wherever they are surely, or exactly, near or far; of a
// set with itself each pair is looked at once. Leaves that are open are compared point by point,
// sixteen pairs at a time. Two clumps that are tiny next to their distance are sorted along the
// line between them (sweep/line_counts.hpp).
//
// Cost: of the pairs of boxes that are open. Those are few unless points of many boxes are within
// and without the threshold of each other; docs/how-it-works.md says where.
#pragma once

#include "base/resources.hpp"
#include "sweep/box_join.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::cpu {

// A set, none empty, and how many points there are at each of its places; null: one.
struct Places {
  PointsView points;
  const std::uint32_t* weights;
};

// Writes to counts[id] how many of the others are near; null: of the points themselves, where a
// point is near to itself. Working memory: 55 bytes a point of both sets, and up to 28 a
// point of two clumps; of a set with itself, 5 more for every further worker.
void count_in_boxes(const Places& points, const Places* others, const BoxQuery& question,
                    const core::Resources& with, std::uint32_t* counts);

}  // namespace beespace::cpu
