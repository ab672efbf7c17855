// A place in the frame of a node of a PointTree: how far boxes and points are from it, in floats of
// which is proved what they promise. Included by tree_walk_kernel.hpp, under the same rules, and
// with the Lanes that it describes.
//
// What the floats promise. Write u = 2^-24. In the frame of a node of level 0 all points p have
// coordinates in [-1, 1]; their floats are off by at most u. The place q can be anywhere; its
// floats are off by u |q_i| (1 + 2^-28, for the doubles on the way, here and below).
//
// Points. On an axis with |q_i| <= 4 the difference is off by 5 u, and by u relatively from its own
// rounding. On an axis with |q_i| > 4 the true difference is at least 3/4 |q_i|, so the 5/4 u |q_i|
// of both are 5/3 u relatively. With three roundings in the sum of squares, 3/2 u in the root:
//   |d_float - d| <= sqrt(3) 5 u + (8/3 + 3/2 + o(1)) u d  <  2^-20 (1 - 2^-2) + 2^-21 d.
// So d_float < r - 2^-20 (1 + r) proves d < r, and d_float > r + 2^-20 (1 + r) proves d > r, with
// something left for rounding these limits and squaring them.
//
// Boxes. With m = max(1, |b|), a border b lies kBoxMargin m = 16 u m outside of the points, of
// which rounding takes less than 2 u m. On an axis with |q_i| <= 4 m that is more than the 4 u m by
// which q_i may be off; on one with |q_i| > 4 m the gap is at least 3/4 |q_i|, and too large by at
// most 4/3 u relatively. So a box that the floats see beyond the upper limit holds no point within
// r.
//
// Places far outside of a frame (FarPlace). There, the distances of all points are nearly the same,
// and an error relative to them hides which is the nearest. What tells points p apart is
//   g(p) = (|q - p|^2 - |q|^2) / 2n = sum of p_i (k p_i - a_i),  k = 1/2n, a = q/n,
// where n = |q_1| + |q_2| + |q_3|, at least 32. The doubles q_i are right to 2^-53 relatively.
//   Of an axis: k p_i and a_i are off by 2 u and u relatively, their difference and the product by
// u more, each: at most u |p_i| (4 k |p_i| + 3 |a_i|), and with the sums less than 8 u times
// G = sum of |p_i| (k |p_i| + |a_i|). A box has its least value on each axis where that is nearest
// to q_i; the value itself is a float of a border or, between these, of q_i, and near the vertex of
// a parabola its rounding changes no more than k (u q_i)^2, which is far less than u G. So
// the sum less 2^-20 G is below the value of every point in the box.
//   Points of a leaf are in [-1, 1], where G < 1 + 3 k; and they are off by u themselves, which
// changes g by less than 2 u. So their floats are right to 2^-20.
//   The limit of a squared distance S is (S - |q|^2) / 2n, in doubles, where |q|^2 is off by
// 5 2^-53 relatively: at most 2^-50 n in all, as |q| <= n.
//
// Far away and very small: coordinates of q beyond 2^61 are taken for 2^61; then d_float > 2^60,
// which neither limit reaches unless all points are to be looked at anyway. Underflow moves squares
// by 2^-149, next to limits that are 0 or at least 2^-40.
#pragma once

#include "kernels/tree_walk.hpp"

namespace beespace::cpu {
namespace {

using core::kFanOut;
using core::kFarthest;
using core::TreeLeaf;
using core::TreeNode;
using core::TreeView;

// NOLINTBEGIN(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr double kSlack = 0x1p-20;
constexpr double kLargestFar = 0x1p+126;
constexpr double kLargestNear = 0x1p+118;
// NOLINTEND(misc-definitions-in-headers)

// The upper limit of squared floats for a radius in the units of a frame.
[[gnu::always_inline]] inline float far_limit(double radius) {
  const double far = (radius + kSlack) * (1.0 + kSlack);
  const double squared = far * far;
  return static_cast<float>(squared < kLargestFar ? squared : kLargestFar);
}

// The same, or a little more, from the square of the radius: with s = kSlack,
//   ((r + s) (1 + s))^2 <= (r^2 + s (r^2 + 1) + s^2) (1 + s)^2 < r^2 (1 + 4 s) + 2 s.
[[gnu::always_inline]] inline float far_limit_of_square(double squared_radius) {
  const double squared = squared_radius * (1.0 + 4.0 * kSlack) + 2.0 * kSlack;
  return static_cast<float>(squared < kLargestFar ? squared : kLargestFar);
}

[[gnu::always_inline]] inline float near_limit(double radius) {
  const double near = radius * (1.0 - kSlack) - kSlack;
  if (!(near > 0.0)) return 0.0F;
  const double squared = near * near;
  return static_cast<float>(squared < kLargestNear ? squared : kLargestNear);
}

// How far boxes are, on one axis, from the stretch between two places, or from a place: one of the
// two is not above zero.
template <class Lanes>
[[gnu::always_inline]] inline Lanes gap(const float* its_low, const float* its_high,
                                        const Lanes& low, const Lanes& high) {
  return (Lanes::load(its_low) - high).above_zero() + (low - Lanes::load(its_high)).above_zero();
}

template <class Lanes>
[[gnu::always_inline]] inline Lanes gap(const float* its_low, const float* its_high,
                                        const Lanes& at) {
  return gap(its_low, its_high, at, at);
}

// A place in the frame of a node.
template <class Lanes>
struct LocalPlace {
  Lanes x;
  Lanes y;
  Lanes z;

  LocalPlace() = default;
  [[gnu::always_inline]] LocalPlace(const TreeNode& node, const Point& place)
      : x(local(place.x, node.origin[0], node.scale)),
        y(local(place.y, node.origin[1], node.scale)),
        z(local(place.z, node.origin[2], node.scale)) {}

  // Squared distances of the boxes of the node's children.
  [[gnu::always_inline]] Lanes gaps(const TreeNode& node) const {
    const Lanes gap_x = gap(node.low[0], node.high[0], x);
    const Lanes gap_y = gap(node.low[1], node.high[1], y);
    const Lanes gap_z = gap(node.low[2], node.high[2], z);
    return gap_x * gap_x + gap_y * gap_y + gap_z * gap_z;
  }

  [[gnu::always_inline]] Lanes squares(const TreeLeaf& leaf) const {
    const Lanes dx = Lanes::load(leaf.at[0]) - x;
    const Lanes dy = Lanes::load(leaf.at[1]) - y;
    const Lanes dz = Lanes::load(leaf.at[2]) - z;
    return dx * dx + dy * dy + dz * dz;
  }

 private:
  [[gnu::always_inline]] static Lanes local(double at, double origin, double scale) {
    double value = (at - origin) * scale;
    if (value > kFarthest) value = kFarthest;
    if (value < -kFarthest) value = -kFarthest;
    return Lanes::all(static_cast<float>(value));
  }
};

// A place far outside of a frame: what tells boxes and points apart by their distances from it.
template <class Lanes>
class FarPlace {
 public:
  // Whether the place is so far away; only then the rest may be called.
  [[gnu::always_inline]] bool enter(const TreeNode& node, bool is_bottom, const Point& place) {
    const double far_from = is_bottom ? kFar : kFar * core::kReachAbove;
    const double at[3] = {(place.x - node.origin[0]) * node.scale,
                          (place.y - node.origin[1]) * node.scale,
                          (place.z - node.origin[2]) * node.scale};
    double sum = 0.0;
    for (const double coordinate : at) sum += coordinate < 0.0 ? -coordinate : coordinate;
    if (!(sum >= far_from) || !(sum <= kFarthest)) return false;
    sum_ = sum;
    squared_ = at[0] * at[0] + at[1] * at[1] + at[2] * at[2];
    half_inverse_ = Lanes::all(static_cast<float>(0.5 / sum));
    for (unsigned axis = 0; axis < 3; ++axis) {
      at_[axis] = Lanes::all(static_cast<float>(at[axis]));
      share_[axis] = Lanes::all(static_cast<float>(at[axis] / sum));
      share_size_[axis] = size_of(share_[axis]);
    }
    return true;
  }

  // Beyond this value, no point has a squared distance of at most this, in the units of the frame.
  [[gnu::always_inline]] float limit(double squared) const {
    const double value = (squared - squared_) / (2.0 * sum_);
    const double size = value < 0.0 ? -value : value;
    const double above = value + 0x1p-50 * sum_ + kSlack * (1.0 + size);
    return static_cast<float>(above < kLargestFar ? above : kLargestFar);
  }

  // At most the values of all points in the boxes of the node's children.
  [[gnu::always_inline]] Lanes least(const TreeNode& node) const {
    return least(node, 0) + least(node, 1) + least(node, 2);
  }

  [[gnu::always_inline]] Lanes values(const TreeLeaf& leaf) const {
    return value(leaf, 0) + value(leaf, 1) + value(leaf, 2);
  }

 private:
  static constexpr double kFar = 32.0;

  [[gnu::always_inline]] static Lanes size_of(const Lanes& a) {
    return a.above_zero() + (Lanes::all(0.0F) - a).above_zero();
  }
  [[gnu::always_inline]] Lanes least(const TreeNode& node, unsigned axis) const {
    const Lanes at = at_[axis].between(Lanes::load(node.low[axis]), Lanes::load(node.high[axis]));
    const Lanes size = size_of(at);
    return at * (half_inverse_ * at - share_[axis]) -
           Lanes::all(static_cast<float>(kSlack)) * size *
               (half_inverse_ * size + share_size_[axis]);
  }
  [[gnu::always_inline]] Lanes value(const TreeLeaf& leaf, unsigned axis) const {
    const Lanes at = Lanes::load(leaf.at[axis]);
    return at * (half_inverse_ * at - share_[axis]);
  }

  Lanes at_[3];
  Lanes share_[3];
  Lanes share_size_[3];
  Lanes half_inverse_;
  double sum_;
  double squared_;
};

}  // namespace
}  // namespace beespace::cpu
