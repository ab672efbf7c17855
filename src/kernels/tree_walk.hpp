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

// For each point of a leaf, what may be among its nearest others.
struct LeafNeighbors {
  static constexpr std::size_t kMostWanted = 192;  // so many others of each can be asked for

  std::uint32_t*
      slots;  // a row of `room` for each place of the leaf, the nearest first, as floats tell
  std::size_t room;
  std::uint32_t counts[core::kFanOut];  // how many of the row are used; 0 where the walk gave up
};

using FindNearestOfLeaf = void (*)(const core::TreeView& tree, std::size_t leaf, std::size_t wanted,
                                   LeafNeighbors& found);

struct TreeWalks {
  // Adds the ids of all points in the ball.
  void (*collect)(const core::TreeView& tree, const Ball& ball, IdSink& sink);
  // Offers the list all points that it may still take.
  void (*find_nearest)(const core::TreeView& tree, const Point& place, core::NearestList& list);
  // Finds all that may be among the `wanted` nearest others of each point of a leaf. Gives up where
  // that are many, as in crowds and where a dense part borders on an empty one.
  FindNearestOfLeaf find_nearest_of_leaf;
};

// The walks of an available instruction set.
TreeWalks tree_walks(InstructionSet set);

}  // namespace beespace::cpu
