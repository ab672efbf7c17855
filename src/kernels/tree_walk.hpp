// Walks through a PointTree: the points around a place, and the nearest ones.
//
// One walk an instruction set, all compiled from tree_walk_kernel.hpp. Floats decide what they can
// surely decide, the given doubles the rest, so all walks give the same points.
#pragma once

#include "kernels/sweep.hpp"
#include "tree/nearest_list.hpp"
#include "tree/point_tree.hpp"

#include <beespace/point.hpp>

namespace beespace::cpu {

// The ids that a walk finds, in no particular order.
struct IdSink {
  PointId* next;
  PointId* end;
  // Makes room for kFanOut more ids from `next` on.
  void (*make_room)(IdSink& sink);
};

// A ball around a place, with or without its surface. The radius is zero or above.
struct Ball {
  Point centre;
  double radius_m;
  bool inclusive;

  // Exactly; not inline, as walks may not share inline functions with others.
  [[nodiscard]] bool holds(const Point& point) const;
};

struct TreeWalks {
  // Adds the ids of all points in the ball.
  void (*collect)(const core::TreeView& tree, const Ball& ball, IdSink& sink);
  // Offers the list all points that it may still take.
  void (*find_nearest)(const core::TreeView& tree, const Point& place, core::NearestList& list);
};

// The walks of an available instruction set. AVX-512 has none of its own: comparing 16 boxes or
// points at once instead of twice 8 was measured to be no faster, as memory sets the pace.
TreeWalks tree_walks(InstructionSet set);

}  // namespace beespace::cpu
