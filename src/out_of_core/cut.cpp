#include "out_of_core/cut.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

namespace beespace::out_of_core {

namespace {

// Each side of a plane has at least this share of the points, and at most the next one of them is
// in halos because of it.
constexpr std::size_t kFewestAside = 64;  // one of so many
constexpr std::size_t kMostInHalos = 2;
// A plane so many points farther from the middle is as good as one with a point more in halos.
constexpr std::size_t kOffTheMiddle = 8;

double along(const Point& point, std::size_t axis) {
  if (axis == 0) return point.x;
  return axis == 1 ? point.y : point.z;
}

struct Plane {
  std::size_t axis = 0;
  double value = 0.0;
};

}  // namespace

class Cut::Builder {
 public:
  Builder(std::size_t most, const Reach& reach) : most_(most), reach_(reach) {}

  Cut build(std::span<Point> sample) {
    cut_.boxes_.clear();
    split(0, sample, kEverywhere);
    return std::move(cut_);
  }

 private:
  void split(std::uint32_t index, std::span<Point> sample, const Box& box) {
    Plane plane;
    if (sample.size() <= most_ || !find_plane(sample, plane)) {
      cut_.nodes_[index] = leaf(index);
      cut_.cells_[index] = static_cast<CellNumber>(cut_.boxes_.size());
      cut_.boxes_.push_back(box);
      return;
    }
    const auto [axis, value] = plane;
    const double reach = reach_[axis];
    const auto left = static_cast<std::uint32_t>(cut_.nodes_.size());
    // Rounding keeps order: what lies within reach of a point on the other side is not beyond the
    // rounded sum either.
    cut_.nodes_[index] = {value, value - reach, value + reach, left,
                          static_cast<std::uint32_t>(axis)};
    cut_.nodes_.resize(cut_.nodes_.size() + 2);
    cut_.cells_.resize(cut_.nodes_.size());
    const auto middle = std::partition(
        sample.begin(), sample.end(),
        [axis = axis, value = value](const Point& point) { return along(point, axis) < value; });
    const auto lower = static_cast<std::size_t>(middle - sample.begin());
    Box below = box;
    Box above = box;
    below.high[axis] = value;
    above.low[axis] = value;
    split(left, sample.first(lower), below);
    split(left + 1, sample.subspan(lower), above);
  }

  // Across the axis along which the points reach farthest, or else the next one: where few points
  // are within reach of the plane, near their middle.
  bool find_plane(std::span<const Point> sample, Plane& plane) {
    std::array<std::pair<double, std::size_t>, 3> widths;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(
          sample.begin(), sample.end(),
          [axis](const auto& a, const auto& b) { return along(a, axis) < along(b, axis); });
      widths[axis] = {(along(*low, axis) - along(*high, axis)) / reach_[axis], axis};
    }
    std::sort(widths.begin(), widths.end());
    return std::any_of(widths.begin(), widths.end(), [&](const auto& width) {
      plane.axis = width.second;
      sorted_.clear();
      for (const Point& point : sample) sorted_.push_back(along(point, plane.axis));
      std::sort(sorted_.begin(), sorted_.end());
      return find_value(reach_[plane.axis], plane.value);
    });
  }

  // Of the coordinates, but for the lowest.
  bool find_value(double reach, double& value) const {
    const std::size_t count = sorted_.size();
    const auto above_lowest = static_cast<std::size_t>(
        std::upper_bound(sorted_.begin(), sorted_.end(), sorted_.front()) - sorted_.begin());
    const std::size_t begin = std::max(count / kFewestAside, above_lowest);
    const std::size_t end = count - count / kFewestAside;
    std::size_t lightest = count;
    std::size_t first = 0;  // not farther below than the reach
    std::size_t last = 0;   // the first one that is farther above
    for (std::size_t at = begin; at < end; ++at) {
      while (sorted_[at] - sorted_[first] > reach) ++first;
      while (last < count && sorted_[last] - sorted_[at] <= reach) ++last;
      if (last - first > count / kMostInHalos) continue;
      const std::size_t off = at < count / 2 ? count / 2 - at : at - count / 2;
      const std::size_t weight = last - first + off / kOffTheMiddle;
      if (weight < lightest) {
        lightest = weight;
        value = sorted_[at];
      }
    }
    return lightest < count;
  }

  std::size_t most_;
  Reach reach_;
  Cut cut_;
  std::vector<double> sorted_;
};

Cut Cut::of_sample(std::vector<Point>& sample, std::size_t most, const Reach& reach) {
  return Builder(std::max<std::size_t>(most, 1), reach).build(sample);
}

void Cut::find_homes(const core::PointBlock& block, std::size_t count, Homes& homes) const {
  auto& at = homes.cell;  // nodes at first
  std::fill_n(at.begin(), count, 0U);
  std::fill_n(homes.near_border.begin(), count, false);
  const std::array<const double*, 3> axes = {block.axis(0), block.axis(1), block.axis(2)};
  // A level at a time, so that no point waits for the one before it.
  std::uint32_t moved = 1;
  while (moved != 0) {
    moved = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Node& node = nodes_[at[i]];
      const double coordinate = axes[node.axis][i];
      homes.near_border[i] |= (coordinate >= node.low) & (coordinate <= node.high);
      const std::uint32_t below = node.left + static_cast<std::uint32_t>(coordinate >= node.value);
      moved |= below ^ at[i];
      at[i] = below;
    }
  }
  for (std::size_t i = 0; i < count; ++i) at[i] = cells_[at[i]];
}

}  // namespace beespace::out_of_core
