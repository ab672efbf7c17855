// In which order points stand in a PointTree: neighbours together, in boxes as compact as can be.
#pragma once

#include "base/bounds.hpp"
#include "base/buffer.hpp"
#include "base/resources.hpp"
#include "tree/point_tree.hpp"

#include <beespace/points_view.hpp>

#include <cstdint>

namespace beespace::core {

// Entry s of the answer is the index of the point that belongs into slot s. The order does not
// depend on the number of workers. `leaves` and `slots`, which have room for those of a tree, lend
// their memory; their contents are forgotten.
//
// Every node's points are cut into slabs of equal numbers along the widest axis, these again, until
// each child has its share. A cut counts how many points lie in each of up to 4096 intervals along
// the axis and then distributes the points: two passes, no comparison. The points of the interval
// in which a cut falls come to either side of it, which is nearly as good as the median, unless
// many of them lie in it (a crowd and a point far away): then they are cut at their exact doubles.
Buffer<std::uint32_t> point_tree_order(const PointsView& points, const Bounds& bounds,
                                       const Resources& with, Buffer<TreeLeaf>& leaves,
                                       Buffer<Point>& slots);

}  // namespace beespace::core
