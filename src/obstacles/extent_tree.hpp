// A static tree of boxes, for what is near to a place.
#pragma once

#include "obstacles/solid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace beespace::obstacles {

// How far away a box is. Rounded down by more than the rounding of it, so nothing in the box is
// ever computed to be nearer.
inline double distance_to(const Extent& extent, const Vector3& place) {
  const auto gap = [](double low, double high, double at) {
    return std::max({low - at, at - high, 0.0});
  };
  const Vector3 gaps{gap(extent.low.x, extent.high.x, place.x),
                     gap(extent.low.y, extent.high.y, place.y),
                     gap(extent.low.z, extent.high.z, place.z)};
  return length(gaps) * (1.0 - 0x1p-48);
}

// Halved at the median of the longer side, again and again, until few boxes are left. Order and
// shape depend on the boxes only. Immutable, so any number of threads may look at once.
class ExtentTree {
 public:
  ExtentTree() = default;
  explicit ExtentTree(std::span<const Extent> extents);

  // Which of the extents comes where: what is kept in this order is visited place by place.
  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

  // Calls visit(position in order()) for all within reach, in that order.
  template <class Visit>
  void visit_near(const Vector3& place, double reach, Visit&& visit) const {
    std::size_t at = 0;
    while (at < nodes_.size()) {
      const Node& node = nodes_[at];
      if (!(distance_to(node.extent, place) <= reach)) {
        at = node.next;
        continue;
      }
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (distance_to(extents_[i], place) <= reach) visit(i);
      }
      ++at;
    }
  }

  // The same, nearer halves first; visit returns the reach that is left.
  template <class Visit>
  void visit_nearest_first(const Vector3& place, double reach, Visit&& visit) const {
    std::array<std::uint32_t, kMostLevels> waiting;
    std::size_t count = 0;
    if (!nodes_.empty()) waiting[count++] = 0;
    while (count > 0) {
      const std::uint32_t at = waiting[--count];
      const Node& node = nodes_[at];
      if (!(distance_to(node.extent, place) <= reach)) continue;
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        if (distance_to(extents_[i], place) <= reach) reach = visit(i);
      }
      if (node.begin < node.end) continue;
      const std::uint32_t one = at + 1;
      const std::uint32_t other = nodes_[one].next;
      const bool one_first =
          distance_to(nodes_[one].extent, place) <= distance_to(nodes_[other].extent, place);
      waiting[count++] = one_first ? other : one;
      waiting[count++] = one_first ? one : other;
    }
  }

 private:
  // Each is followed by its first half, that by its second one; `next` is behind all of them.
  struct Node {
    Extent extent;
    std::uint32_t next = 0;
    std::uint32_t begin = 0;  // of what a leaf holds; none in a node that has halves
    std::uint32_t end = 0;
  };
  // Halves differ by one at most, so 2^32 boxes make 33 levels; on each one half waits.
  static constexpr std::size_t kMostLevels = 40;

  void build(std::span<const Extent> extents, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
  std::vector<Extent> extents_;  // in this order
};

}  // namespace beespace::obstacles
