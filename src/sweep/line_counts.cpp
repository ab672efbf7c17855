#include "sweep/line_counts.hpp"

#include "exact/two_doubles.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::cpu {

namespace {

double size_on(const core::Bounds& box, std::size_t axis) {
  return box.high[axis] - box.low[axis];
}

double longest_side(const core::Bounds& box) {
  return std::max({size_on(box, 0), size_on(box, 1), size_on(box, 2)});
}

Point low_corner(const core::Bounds& box) {
  return {box.low[0], box.low[1], box.low[2]};
}

}  // namespace

bool LineCounts::suits(const core::Bounds& a, const core::Bounds& b) const {
  constexpr double kSmall = 0x1p-10;
  return longest_side(a) + longest_side(b) <= threshold_ * kSmall;
}

bool LineCounts::count(const LineSide& one, const LineSide& two) {
  const core::Bounds a = one.tree.box(one.node);
  const core::Bounds b = two.tree.box(two.node);
  towards_ = {2.0 * (b.low[0] - a.low[0]), 2.0 * (b.low[1] - a.low[1]),
              2.0 * (b.low[2] - a.low[2])};
  sort(two, low_corner(b));
  if (!find(one, low_corner(a), limits(a, b))) return false;
  add(one, two);
  return true;
}

LineCounts::Limits LineCounts::limits(const core::Bounds& a, const core::Bounds& b) const {
  const double towards[3] = {towards_.x, towards_.y, towards_.z};
  double along_line = 0.0;
  double apart = 0.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    along_line += std::abs(towards[axis]) * (size_on(a, axis) + size_on(b, axis));
    const double most = std::max(size_on(a, axis), size_on(b, axis));
    apart += most * most;
  }
  core::TwoDoubles beyond;
  beyond.add_square(threshold_, 1.0);
  beyond.add_squared_distance(low_corner(a), low_corner(b), -1.0);
  const double left = beyond.value();
  const double slack = 0x1p-46 * (along_line + std::abs(left) + apart) + 0x1p-96 * beyond.size();
  return {left - apart - slack, left + slack};
}

double LineCounts::along(const Point& point, const Point& corner) const {
  return towards_.x * (point.x - corner.x) + towards_.y * (point.y - corner.y) +
         towards_.z * (point.z - corner.z);
}

void LineCounts::sort(const LineSide& two, const Point& corner) {
  sorted_.clear();
  sorted_.reserve(two.end() - two.first());
  for (std::size_t slot = two.first(); slot < two.end(); ++slot) {
    sorted_.push_back({along(two.tree.point(slot), corner), static_cast<std::uint32_t>(slot)});
  }
  std::sort(sorted_.begin(), sorted_.end(),
            [](const Key& a, const Key& b) { return a.along < b.along; });
}

// Whether there are few between the limits.
bool LineCounts::find(const LineSide& one, const Point& corner, const Limits& limits) {
  constexpr std::size_t kMostOpen = 16;  // for each point
  found_.clear();
  found_.reserve(one.end() - one.first());
  std::size_t open = 0;
  const std::size_t most = kMostOpen * (sorted_.size() + one.end() - one.first());
  for (std::size_t slot = one.first(); slot < one.end() && open <= most; ++slot) {
    const double own = along(one.tree.point(slot), corner);
    const auto is_below = [](const Key& key, double limit) { return key.along < limit; };
    const auto near = std::lower_bound(sorted_.begin(), sorted_.end(), own + limits.near, is_below);
    auto far = near;
    while (far != sorted_.end() && far->along <= own + limits.far && open <= most) {
      ++far;
      ++open;
    }
    found_.push_back({static_cast<std::uint32_t>(near - sorted_.begin()),
                      static_cast<std::uint32_t>(far - sorted_.begin())});
  }
  return open <= most;
}

void LineCounts::add(const LineSide& one, const LineSide& two) {
  // How many there are before each place of the sorted, then what is added to those.
  added_.assign(sorted_.size() + 1, 0U);
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    added_[i + 1] = added_[i] + two.weights[sorted_[i].slot];
  }
  for (std::size_t slot = one.first(); slot < one.end(); ++slot) {
    one.sums[slot] += added_[found_[slot - one.first()].near];
  }
  added_.assign(sorted_.size() + 1, 0U);
  for (std::size_t slot = one.first(); slot < one.end(); ++slot) {
    const Found& found = found_[slot - one.first()];
    added_[found.near] += one.weights[slot];
    if (found.near != found.not_after) decide(one, slot, two, found);
  }
  if (two.sums == nullptr) return;
  std::uint32_t sum = 0;
  for (std::size_t i = sorted_.size(); i > 0; --i) {
    sum += added_[i];
    two.sums[sorted_[i - 1].slot] += sum;
  }
}

void LineCounts::decide(const LineSide& one, std::size_t slot, const LineSide& two,
                        const Found& found) {
  const Point place = one.tree.point(slot);
  for (std::uint32_t i = found.near; i < found.not_after; ++i) {
    const std::uint32_t other = sorted_[i].slot;
    if (!closer_(place, two.tree.point(other))) continue;
    one.sums[slot] += two.weights[other];
    if (two.sums != nullptr) two.sums[other] += one.weights[slot];
  }
}

}  // namespace beespace::cpu
