// The octree of the textbooks (Meagher 1980), which the paper weighs against its hash: a cube has
// eight children once it holds more than a few points; nodes joined by pointers.
#pragma once

#include <beespace/point.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

namespace beespace::compare {

class TextbookOctree {
 public:
  explicit TextbookOctree(double threshold_m) : squared_(threshold_m * threshold_m) {}

  void insert(const Point& point, PointId id) { bees_.push_back({point, id}); }

  // Builds the tree from all that was inserted.
  void finish() {
    root_ = std::make_unique<Node>();
    if (bees_.empty()) return;
    Point low = bees_.front().point;
    Point high = low;
    for (const Bee& bee : bees_) {
      const Point& at = bee.point;
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    root_->centre = {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
    root_->half_side = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / 2;
    for (const Bee& bee : bees_) add(*root_, bee, 0);
  }

  [[nodiscard]] std::vector<PointId> find() const {
    std::vector<PointId> found;
    for (const Bee& bee : bees_) {
      if (has_other(*root_, bee)) found.push_back(bee.id);
    }
    return found;
  }

  static const std::vector<PointId>& ids(const std::vector<PointId>& found) { return found; }

 private:
  struct Bee {
    Point point;
    PointId id = 0;
  };
  struct Node {
    Point centre;
    double half_side = 0.0;
    std::vector<Bee> bees;  // of a leaf
    std::array<std::unique_ptr<Node>, 8> children;
    bool is_leaf = true;
  };

  static constexpr std::size_t kMostPerLeaf = 8;
  static constexpr unsigned kDeepest = 40;  // or bees at one place would split it for ever

  static Node& child(Node& node, const Point& at) {
    const bool x = at.x >= node.centre.x;
    const bool y = at.y >= node.centre.y;
    const bool z = at.z >= node.centre.z;
    auto& slot = node.children[(x ? 1u : 0u) | (y ? 2u : 0u) | (z ? 4u : 0u)];
    if (slot == nullptr) {
      const double half = node.half_side / 2;
      slot = std::make_unique<Node>();
      slot->centre = {node.centre.x + (x ? half : -half), node.centre.y + (y ? half : -half),
                      node.centre.z + (z ? half : -half)};
      slot->half_side = half;
    }
    return *slot;
  }

  static void add(Node& node, const Bee& bee, unsigned depth) {
    if (!node.is_leaf) return add(child(node, bee.point), bee, depth + 1);
    node.bees.push_back(bee);
    if (node.bees.size() <= kMostPerLeaf || depth == kDeepest) return;
    node.is_leaf = false;
    const std::vector<Bee> bees = std::move(node.bees);
    node.bees = {};
    for (const Bee& each : bees) add(child(node, each.point), each, depth + 1);
  }

  static double squared_distance(const Point& a, const Point& b) {
    const double x = a.x - b.x;
    const double y = a.y - b.y;
    const double z = a.z - b.z;
    return x * x + y * y + z * z;
  }

  [[nodiscard]] bool reaches(const Node& node, const Point& at) const {
    // A little wider, since the centres of small cubes are rounded.
    const double half = node.half_side * (1.0 + 1e-12);
    const double x = std::max(std::fabs(at.x - node.centre.x) - half, 0.0);
    const double y = std::max(std::fabs(at.y - node.centre.y) - half, 0.0);
    const double z = std::max(std::fabs(at.z - node.centre.z) - half, 0.0);
    return x * x + y * y + z * z <= squared_;
  }

  bool has_other(const Node& node, const Bee& bee) const {
    for (const Bee& other : node.bees) {
      if (other.id != bee.id && squared_distance(other.point, bee.point) < squared_) return true;
    }
    if (node.is_leaf) return false;
    for (const auto& child : node.children) {
      if (child != nullptr && reaches(*child, bee.point) && has_other(*child, bee)) return true;
    }
    return false;
  }

  double squared_;
  std::vector<Bee> bees_;
  std::unique_ptr<Node> root_;
};

}  // namespace beespace::compare
