// Space cut into cells by planes across its axes: which cell is a point's home, and in which halos
// it is.
#pragma once

#include "base/point_block.hpp"

#include <beespace/point.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::out_of_core {

using CellNumber = std::uint32_t;

// How far apart two points in conflict can be along each axis.
using Reach = std::array<double, 3>;

// Of a cell: where its home points are. It may reach to infinity.
struct Box {
  std::array<double, 3> low{};
  std::array<double, 3> high{};
};

class Cut {
 public:
  // All of space is one cell.
  Cut() : nodes_{leaf(0)}, cells_(1), boxes_{kEverywhere} {}

  // Cuts so that no cell has more than `most` points of the sample, as far as that helps: a cell
  // stays whole where each plane would put most of its points into halos. Coordinates are finite.
  // Reorders the sample.
  static Cut of_sample(std::vector<Point>& sample, std::size_t most, const Reach& reach);

  // Numbered from 0.
  [[nodiscard]] std::size_t cells() const { return boxes_.size(); }
  [[nodiscard]] const std::vector<Box>& boxes() const { return boxes_; }

  // Of the points in a block: where each is at home, and whether it may be in halos, too.
  struct Homes {
    std::array<CellNumber, core::PointBlock::kSize> cell;
    std::array<bool, core::PointBlock::kSize> near_border;
  };
  void find_homes(const core::PointBlock& block, std::size_t count, Homes& homes) const;

  // Calls visit(cell, is_home) for the home of the point, and for each cell in whose halo it is: at
  // least for all whose points can be within reach of it.
  template <class Visit>
  void for_each_cell(const Point& point, Visit&& visit) const {
    const std::array<double, 3> at = {point.x, point.y, point.z};
    descend(0, at, true, visit);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  static constexpr Box kEverywhere = {{-kInfinity, -kInfinity, -kInfinity},
                                      {kInfinity, kInfinity, kInfinity}};

  // A plane across `axis`: what is below `value` belongs to the left child, the rest to the right
  // one, which follows it. Points from `low` to `high` may be within reach of both. A leaf has all
  // points below it, is their left child itself, and has no border: so all of a block can descend
  // in the same steps.
  struct Node {
    double value = kInfinity;
    double low = kInfinity;
    double high = -kInfinity;
    std::uint32_t left = 0;
    std::uint32_t axis = 0;
  };
  static constexpr Node leaf(std::uint32_t index) {
    Node node;
    node.left = index;
    return node;
  }

  template <class Visit>
  void descend(std::uint32_t index, const std::array<double, 3>& at, bool home,
               Visit& visit) const {
    const Node* node = &nodes_[index];
    while (node->left != index) {
      const double coordinate = at[node->axis];
      // Without a branch on the side, which no processor can foretell.
      const auto right = static_cast<std::uint32_t>(coordinate >= node->value);
      if (coordinate >= node->low && coordinate <= node->high) {
        descend(node->left + 1 - right, at, false, visit);
      }
      index = node->left + right;
      node = &nodes_[index];
    }
    visit(cells_[index], home);
  }

  class Builder;

  std::vector<Node> nodes_;
  std::vector<CellNumber> cells_;  // of each node that is a leaf
  std::vector<Box> boxes_;
};

}  // namespace beespace::out_of_core
