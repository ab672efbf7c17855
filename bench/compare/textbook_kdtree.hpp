// The kd-tree of the textbooks (Bentley 1975), which the paper weighs against its hash: a node a
// point, split at the median, axes taking turns, nodes joined by pointers.
#pragma once

#include <beespace/point.hpp>

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

namespace beespace::compare {

class TextbookKdTree {
 public:
  explicit TextbookKdTree(double threshold_m)
      : threshold_m_(threshold_m), squared_(threshold_m * threshold_m) {}

  void insert(const Point& point, PointId id) { bees_.push_back({point, id}); }

  // Builds the tree from all that was inserted.
  void finish() { root_ = build(bees_, 0); }

  // In the order of the tree.
  [[nodiscard]] std::vector<PointId> find() const {
    std::vector<PointId> found;
    for (const Bee& bee : bees_) {
      if (has_other(root_.get(), bee, 0)) found.push_back(bee.id);
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
    Bee bee;
    std::unique_ptr<Node> low;
    std::unique_ptr<Node> high;
  };

  static double coordinate(const Point& point, unsigned axis) {
    if (axis == 0) return point.x;
    return axis == 1 ? point.y : point.z;
  }

  static std::unique_ptr<Node> build(std::span<Bee> bees, unsigned axis) {
    if (bees.empty()) return nullptr;
    const std::size_t middle = bees.size() / 2;
    std::nth_element(bees.begin(), bees.begin() + static_cast<std::ptrdiff_t>(middle), bees.end(),
                     [axis](const Bee& a, const Bee& b) {
                       return coordinate(a.point, axis) < coordinate(b.point, axis);
                     });
    auto node = std::make_unique<Node>();
    node->bee = bees[middle];
    node->low = build(bees.first(middle), (axis + 1) % 3);
    node->high = build(bees.subspan(middle + 1), (axis + 1) % 3);
    return node;
  }

  bool has_other(const Node* node, const Bee& bee, unsigned axis) const {
    if (node == nullptr) return false;
    const Point& at = node->bee.point;
    const double x = at.x - bee.point.x;
    const double y = at.y - bee.point.y;
    const double z = at.z - bee.point.z;
    if (node->bee.id != bee.id && x * x + y * y + z * z < squared_) return true;
    const double beyond = coordinate(bee.point, axis) - coordinate(at, axis);
    const unsigned next = (axis + 1) % 3;
    const Node* nearer = beyond < 0.0 ? node->low.get() : node->high.get();
    const Node* farther = beyond < 0.0 ? node->high.get() : node->low.get();
    if (has_other(nearer, bee, next)) return true;
    return (beyond < 0.0 ? -beyond : beyond) <= threshold_m_ && has_other(farther, bee, next);
  }

  double threshold_m_;
  double squared_;
  std::vector<Bee> bees_;
  std::unique_ptr<Node> root_;
};

}  // namespace beespace::compare
