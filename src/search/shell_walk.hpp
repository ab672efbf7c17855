// Nearest points to places near a centre, around which they may lie on a shell: there, boxes tell
// too little (tree/shell_tree.hpp).
#pragma once

#include "base/resources.hpp"
#include "kernels/box_kernels.hpp"
#include "tree/nearest_list.hpp"
#include "tree/shell_tree.hpp"

#include <beespace/point.hpp>
#include <beespace/points_view.hpp>

#include <cstddef>

namespace beespace::search {

class ShellWalk {
 public:
  // Of at least one point.
  ShellWalk(const PointsView& points, const Point& centre, cpu::InstructionSet set,
            const core::Resources& with)
      : tree_(points, centre, with), kernels_(cpu::box_kernels(set)) {}

  // Offers the list all points that it may still take.
  void find_nearest(const Point& place, core::NearestList& list) const;

 private:
  void visit(unsigned level, std::size_t node, const Point& place,
             const cpu::PlaceAroundCentre& around, core::NearestList& list) const;
  void offer_leaf(std::size_t leaf, const Point& place, core::NearestList& list) const;

  core::ShellTree tree_;
  const cpu::BoxKernels& kernels_;
};

}  // namespace beespace::search
