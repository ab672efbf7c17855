#include "obstacles/extent_tree.hpp"

#include <beespace/mover.hpp>

#include <numeric>

namespace beespace::obstacles {

namespace {

Vector3 smaller(const Vector3& a, const Vector3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vector3 larger(const Vector3& a, const Vector3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

// What has no end is taken to end where the domain does.
double middle(double low, double high) {
  return 0.5 * std::max(low, -kLargestInMotion) + 0.5 * std::min(high, kLargestInMotion);
}
Vector3 middle_of(const Extent& extent) {
  return {middle(extent.low.x, extent.high.x), middle(extent.low.y, extent.high.y),
          middle(extent.low.z, extent.high.z)};
}

constexpr double Vector3::*kAxes[] = {&Vector3::x, &Vector3::y, &Vector3::z};

// Along which the middles are spread most.
double Vector3::*longest_side(const Extent& middles) {
  const Vector3 size = middles.high - middles.low;
  return *std::max_element(std::begin(kAxes), std::end(kAxes),
                           [&](auto a, auto b) { return size.*a < size.*b; });
}

constexpr Extent kNothing{{kInfinity, kInfinity, kInfinity}, {-kInfinity, -kInfinity, -kInfinity}};

void widen(Extent& extent, const Extent& by) {
  extent = {smaller(extent.low, by.low), larger(extent.high, by.high)};
}

}  // namespace

ExtentTree::ExtentTree(std::span<const Extent> extents) : order_(extents.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  if (!extents.empty()) build(extents, 0, static_cast<std::uint32_t>(extents.size()));
  extents_.reserve(extents.size());
  for (const std::uint32_t i : order_) extents_.push_back(extents[i]);
}

void ExtentTree::build(std::span<const Extent> extents, std::uint32_t begin, std::uint32_t end) {
  constexpr std::uint32_t kLeaf = 4;
  Extent all = kNothing;
  Extent middles = kNothing;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Extent& extent = extents[order_[i]];
    widen(all, extent);
    widen(middles, {middle_of(extent), middle_of(extent)});
  }
  const std::size_t at = nodes_.size();
  nodes_.push_back({all, 0, begin, end});
  if (end - begin > kLeaf) {
    nodes_[at].end = begin;
    const auto axis = longest_side(middles);
    // Not nth_element: what it leaves on either side comes in an order that libraries choose.
    std::sort(order_.begin() + begin, order_.begin() + end, [&](std::uint32_t a, std::uint32_t b) {
      const double of_a = middle_of(extents[a]).*axis;
      const double of_b = middle_of(extents[b]).*axis;
      return of_a < of_b || (of_a == of_b && a < b);
    });
    const std::uint32_t half = begin + (end - begin) / 2;
    build(extents, begin, half);
    build(extents, half, end);
  }
  nodes_[at].next = static_cast<std::uint32_t>(nodes_.size());
}

}  // namespace beespace::obstacles
