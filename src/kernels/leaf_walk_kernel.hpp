// The nearest others of all points of a leaf: the leaves around it are found once for its sixteen
// points, and brought to its frame; then floats rule out nearly all that cannot be among the
// nearest.
//
// Included after tree_walk_kernel.hpp, by the same files and under the same rules: what floats
// promise is said in frame_place_kernel.hpp, of one frame. Here, all is in the frame of the leaf's
// node of level 0. Another node's points come to it by x' = (x + offset) * unit, where unit is a
// power of two: how long the unit of the other frame is here. Let c be the largest of these units,
// 1 or above, and no offset longer than 16 c here. With u = 2^-24, a float is off by u c where it
// was, by 16 u c for the offset, and by 17 u c for the sum; the place by u; their difference, the
// squares and sums by 5/2 u relatively:
//   |d_float - d| <= sqrt(3) 35 u c + (5/2 + o(1)) u d  <  a + 2^-22 d    with a = 2^-18 c.
// Let as many others as are wanted have d_float^2 <= T. They are within D = (sqrt(T) + a) (1 +
// 2^-21). What is not farther has a float of at most D (1 + 2^-22) + a, the square of which is
// below T + 2^-16 c (1 + T), as 2 sqrt(T) <= 1 + T and c <= 2^10.
//
// Boxes come to the frame by the same operations, which keep the order of floats, as do those that
// make a gap of a difference: the gap of a box is at most the float of any point in it.
#pragma once

#include "kernels/tree_walk_kernel.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

// NOLINTBEGIN(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr unsigned kMostLeaves = 96;  // around one leaf, a multiple of kFanOut
constexpr double kLongestUnit = 0x1p+10;
constexpr double kShortestUnit = 0x1p-60;  // below, offsets and units would leave the floats
constexpr double kFarthestFrame = 16.0;
constexpr float kNowhere = __builtin_inff();
// NOLINTEND(misc-definitions-in-headers)

[[gnu::always_inline]] inline float limit_around(float enough, float longest_unit) {
  return enough + 0x1p-16F * longest_unit * (1.0F + enough);
}

template <class Lanes>
[[gnu::always_inline]] inline unsigned count_at_most(const float* squares, unsigned size,
                                                     float limit) {
  unsigned count = 0;
  for (unsigned i = 0; i < size; i += kFanOut) {
    count += static_cast<unsigned>(__builtin_popcount(Lanes::load(squares + i).at_most(limit)));
  }
  return count;
}

// x^(2/3), roughly, for x in (0, 1].
[[gnu::always_inline]] inline float two_thirds_power(float x) {
  constexpr std::int32_t kOne = 0x3F800000;
  std::int32_t bits = 0;
  __builtin_memcpy(&bits, &x, sizeof bits);
  bits = kOne + (bits - kOne) / 3 * 2;
  float power = 0.0F;
  __builtin_memcpy(&power, &bits, sizeof power);
  return power;
}

// A square such that at least `wanted` have this or less; seldom many more. `count` are at most
// `high`, and at least as many as are wanted; those beyond the last are infinity.
template <class Lanes>
[[gnu::always_inline]] inline float square_of_enough(const float* squares, unsigned size,
                                                     unsigned count, unsigned wanted, float high) {
  constexpr unsigned kFewMore = 4;
  constexpr unsigned kRounds = 8;
  float low = 0.0F;
  unsigned below = 0;
  for (unsigned round = 0; round < kRounds && count > wanted + kFewMore; ++round) {
    const float part =
        (static_cast<float>(wanted - below) + 0.5F * kFewMore) / static_cast<float>(count - below);
    // Points around a place are as many as the volume; between two squares, about as their
    // difference.
    const float middle = low + (high - low) * (below == 0 ? two_thirds_power(part) : part);
    const unsigned found = count_at_most<Lanes>(squares, size, middle);
    if (found >= wanted) {
      high = middle;
      count = found;
    } else {
      low = middle;
      below = found;
    }
  }
  return high;
}

// The box of a leaf's points in the frame of a node.
template <class Lanes>
struct LocalBox {
  LocalPlace<Lanes> low;
  LocalPlace<Lanes> high;

  [[gnu::always_inline]] LocalBox(const TreeNode& node, const Point& box_low, const Point& box_high)
      : low(node, box_low), high(node, box_high) {}

  // Squared distances of the boxes of the node's children from this one.
  [[gnu::always_inline]] Lanes gaps(const TreeNode& node) const {
    const Lanes x = gap(node.low[0], node.high[0], low.x, high.x);
    const Lanes y = gap(node.low[1], node.high[1], low.y, high.y);
    const Lanes z = gap(node.low[2], node.high[2], low.z, high.z);
    return x * x + y * y + z * z;
  }
};

// The leaves around a leaf, in its frame.
struct Surroundings {
  alignas(64) float low[3][kMostLeaves];  // of their boxes
  alignas(64) float high[3][kMostLeaves];
  alignas(64) float at[kMostLeaves][3][kFanOut];
  std::uint32_t first_slot[kMostLeaves];
  unsigned count;
  float longest_unit;
};

// Adds leaves of a node of level 0. False if there are too many, or its frame is too different.
template <class Lanes>
[[gnu::always_inline]] inline bool add_leaves(const TreeView& tree, const TreeNode& own,
                                              const TreeNode& node, std::size_t first_leaf,
                                              std::uint32_t leaves, Surroundings& around) {
  const double unit = own.scale / node.scale;
  const double longest = unit > 1.0 ? unit : 1.0;
  if (around.count + static_cast<unsigned>(__builtin_popcount(leaves)) > kMostLeaves) return false;
  if (!(longest <= kLongestUnit) || !(unit >= kShortestUnit)) return false;
  if (longest > static_cast<double>(around.longest_unit)) {
    around.longest_unit = static_cast<float>(longest);
  }
  const auto to_own = static_cast<float>(unit);
  float offset[3];
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double apart = node.origin[axis] - own.origin[axis];
    const double here = apart * own.scale;
    if (!(here <= kFarthestFrame * longest) || !(here >= -kFarthestFrame * longest)) return false;
    offset[axis] = static_cast<float>(apart * node.scale);
  }
  for (; leaves != 0; leaves &= leaves - 1) {
    const unsigned child = first_bit(leaves);
    const TreeLeaf& leaf = tree.leaves[first_leaf + child];
    const unsigned i = around.count++;
    around.first_slot[i] = static_cast<std::uint32_t>((first_leaf + child) * kFanOut);
    for (unsigned axis = 0; axis < 3; ++axis) {
      ((Lanes::load(leaf.at[axis]) + Lanes::all(offset[axis])) * Lanes::all(to_own))
          .store(around.at[i][axis]);
      around.low[axis][i] = (node.low[axis][child] + offset[axis]) * to_own;
      around.high[axis][i] = (node.high[axis][child] + offset[axis]) * to_own;
    }
  }
  return true;
}

// Finds all leaves with points within `squared_reach_m` of the box. False if these are too many, or
// too different.
template <class Lanes>
[[gnu::always_inline]] inline bool look_around(const TreeView& tree, const TreeNode& own,
                                               const Point& low, const Point& high,
                                               double squared_reach_m, Surroundings& around) {
  struct Step {
    std::size_t node;
    unsigned level;
  };
  Step steps[kFanOut * core::kMostLevels];
  unsigned open = 0;
  around.count = 0;
  around.longest_unit = 1.0F;
  steps[open++] = {0, tree.top};
  while (open != 0) {
    const Step step = steps[--open];
    const TreeNode& node = tree.levels[step.level][step.node];
    const LocalBox<Lanes> box(node, low, high);
    const float far_squared = far_limit_of_square(squared_reach_m * (node.scale * node.scale));
    std::uint32_t within = box.gaps(node).at_most(far_squared);
    const std::size_t first_child = step.node * kFanOut;
    if (step.level == 0) {
      if (!add_leaves<Lanes>(tree, own, node, first_child, within, around)) return false;
      continue;
    }
    for (; within != 0; within &= within - 1) {
      const std::size_t child = first_child + first_bit(within);
      prefetch(tree.levels[step.level - 1][child]);
      steps[open++] = {child, step.level - 1};
    }
  }
  // Boxes that are nowhere, up to a multiple of the lanes.
  for (unsigned i = around.count; i % kFanOut != 0; ++i) {
    for (float* low_border : around.low) low_border[i] = kNowhere;
    for (float* high_border : around.high) high_border[i] = -kNowhere;
  }
  return true;
}

template <class Lanes>
class LeafWalk {
 public:
  // NOLINTNEXTLINE(clang-analyzer-optin.cplusplus.UninitializedObject): written before it is read
  [[gnu::always_inline]] LeafWalk(const TreeView& tree, std::size_t leaf, unsigned wanted,
                                  LeafNeighbors& found)
      : tree_(tree),
        node_(tree.levels[0][leaf / kFanOut]),
        leaf_(leaf),
        wanted_(wanted),
        found_(found) {}

  [[gnu::always_inline]] void run() {
    for (unsigned& count : found_.counts) count = 0;
    const Point* const points = tree_.points + leaf_ * kFanOut;
    const std::uint32_t places = Lanes::load(tree_.leaves[leaf_].at[0]).below(kNowhere);
    if (places == 0) return;
    float enough[kFanOut];  // squares within which each has as many others as are wanted
    float largest = 0.0F;
    Point low = points[first_bit(places)];
    Point high = low;
    for (std::uint32_t left = places; left != 0; left &= left - 1) {
      const unsigned place = first_bit(left);
      const Point& point = points[place];
      enough[place] = look_nearby(point);
      if (!(enough[place] < kNowhere)) return;
      if (enough[place] > largest) largest = enough[place];
      low = {point.x < low.x ? point.x : low.x, point.y < low.y ? point.y : low.y,
             point.z < low.z ? point.z : low.z};
      high = {point.x > high.x ? point.x : high.x, point.y > high.y ? point.y : high.y,
              point.z > high.z ? point.z : high.z};
    }
    const auto reach = static_cast<double>(limit_around(largest, 1.0F));
    const double squared_reach_m = reach / (node_.scale * node_.scale);
    if (!look_around<Lanes>(tree_, node_, low, high, squared_reach_m, around_)) return;
    for (std::uint32_t left = places; left != 0; left &= left - 1) {
      const unsigned place = first_bit(left);
      found_.counts[place] = settle(place, LocalPlace<Lanes>(node_, points[place]), enough[place]);
    }
  }

 private:
  // A square within which the point itself and as many others as are wanted are, in its leaf or
  // those beside it; infinity if these have fewer.
  [[gnu::always_inline]] float look_nearby(const Point& point) {
    const LocalPlace<Lanes> local(node_, point);
    if (wanted_ < kFanOut) return square_in_leaf(local.squares(tree_.leaves[leaf_]), wanted_ + 1);
    std::size_t block = 2;
    while (block * kFanOut < wanted_ + 1) block *= 2;
    const std::size_t first = leaf_ / block * block;
    unsigned size = 0;
    for (std::size_t at = first; at < first + block; ++at, size += kFanOut) {
      if (!(node_.low[0][at % kFanOut] < kNowhere)) break;  // there is none any more
      local.squares(tree_.leaves[at]).store(squares_ + size);
    }
    float high = 0.0F;
    for (unsigned i = 0; i < size; ++i) {
      if (squares_[i] < kNowhere && squares_[i] > high) high = squares_[i];
    }
    const unsigned count = count_at_most<Lanes>(squares_, size, high);
    if (count < wanted_ + 1) return kNowhere;
    return square_of_enough<Lanes>(squares_, size, count, wanted_ + 1, high);
  }

  // Finds all that may be among the nearest others of the point at this place. Returns how many
  // they are; 0 if too many.
  [[gnu::always_inline]] unsigned settle(unsigned place, const LocalPlace<Lanes>& local,
                                         float enough) {
    const float limit = limit_around(enough, around_.longest_unit);
    unsigned size = 0;
    unsigned count = 0;
    for (unsigned first = 0; first < around_.count; first += kFanOut) {
      const Lanes gaps = gaps_of_boxes(local, first);
      for (std::uint32_t near = gaps.at_most(limit); near != 0; near &= near - 1) {
        const unsigned i = first + first_bit(near);
        const Lanes its = squares_of(local, around_.at[i]);
        its.store(squares_ + size);
        count += static_cast<unsigned>(__builtin_popcount(its.at_most(limit)));
        first_slots_[size / kFanOut] = around_.first_slot[i];
        if (around_.first_slot[i] == leaf_ * kFanOut) {  // not the point itself
          squares_[size + place] = kNowhere;
          --count;
        }
        size += kFanOut;
      }
    }
    if (count < wanted_) return 0;
    const float fewer = square_of_enough<Lanes>(squares_, size, count, wanted_, limit);
    return write_sorted(place, size, limit_around(fewer, around_.longest_unit));
  }

  [[gnu::always_inline]] Lanes gaps_of_boxes(const LocalPlace<Lanes>& local, unsigned first) const {
    const Lanes x = gap(around_.low[0] + first, around_.high[0] + first, local.x);
    const Lanes y = gap(around_.low[1] + first, around_.high[1] + first, local.y);
    const Lanes z = gap(around_.low[2] + first, around_.high[2] + first, local.z);
    return x * x + y * y + z * z;
  }

  [[gnu::always_inline]] static Lanes squares_of(const LocalPlace<Lanes>& local,
                                                 const float (&at)[3][kFanOut]) {
    const Lanes dx = Lanes::load(at[0]) - local.x;
    const Lanes dy = Lanes::load(at[1]) - local.y;
    const Lanes dz = Lanes::load(at[2]) - local.z;
    return dx * dx + dy * dy + dz * dz;
  }

  // Those with at most this square, in the order of squares. 0 if there is no room for them.
  [[gnu::always_inline]] unsigned write_sorted(unsigned place, unsigned size, float limit) {
    alignas(64) float kept[kMostKept];
    std::uint32_t kept_slots[kMostKept];
    unsigned count = 0;
    for (unsigned i = 0; i < size; i += kFanOut) {
      const Lanes squares = Lanes::load(squares_ + i);
      const std::uint32_t within = squares.at_most(limit);
      if (count + kFanOut > kMostKept) return 0;
      squares.store_chosen(within, kept + count);
      Lanes::store_chosen_slots(within, first_slots_[i / kFanOut], kept_slots + count);
      count += static_cast<unsigned>(__builtin_popcount(within));
    }
    if (count > found_.room) return 0;
    const unsigned end = (count + kFanOut - 1) / kFanOut * kFanOut;
    for (unsigned i = count; i < end; ++i) kept[i] = kNowhere;
    std::uint32_t* const to = found_.slots + place * found_.room;
    for (unsigned i = 0; i < count; ++i) to[i] = kFree;
    for (unsigned i = 0; i < count; ++i) {
      unsigned rank = 0;
      for (unsigned k = 0; k < end; k += kFanOut) {
        rank += static_cast<unsigned>(__builtin_popcount(Lanes::load(kept + k).below(kept[i])));
      }
      while (to[rank] != kFree) ++rank;  // equal squares, in the order in which they were found
      to[rank] = kept_slots[i];
    }
    return count;
  }

  static constexpr unsigned kMostKept = 256;
  static constexpr std::uint32_t kFree = 0xFFFFFFFF;

  const TreeView& tree_;
  const TreeNode& node_;
  std::size_t leaf_;
  unsigned wanted_;
  LeafNeighbors& found_;
  Surroundings around_;
  alignas(64) float squares_[kMostLeaves * kFanOut];  // from one point
  std::uint32_t first_slots_[kMostLeaves];            // of sixteen squares each
};

}  // namespace
}  // namespace beespace::cpu
