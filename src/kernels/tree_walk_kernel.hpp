// The walks through a PointTree: the algorithm, written once over 16 lanes.
//
// Included by the tree_walk_<instruction set>.cpp files only, each of which brings its own Lanes.
// Those files are compiled for processors that the rest of the library must not require, so nothing
// here may be shared: all is in an unnamed namespace, and no inline function of a library header is
// called.
//
// Lanes is 16 floats, with
//   load(const float*), store(float*), all(float)
//   a - b, a + b, a * b                 rounded like floats; contraction does no harm here
//   above_zero()                        max(a, 0), and 0 for what is not a number
//   between(low, high)                  min(max(a, low), high)
//   one_where_above(float)              1 in lanes above the value, and 0 elsewhere
//   at_most(float), below(float)        one bit a lane; no bit for what is not a number
//   store_chosen(bits, float*)          the lanes with a bit, one behind the other; what follows,
//                                       up to 16 in all, may be written over
//   store_chosen_slots(bits, first, std::uint32_t*)  the same of first, first + 1, ... first + 15
#pragma once

#include "kernels/frame_place_kernel.hpp"
#include "kernels/tree_walk.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

[[gnu::always_inline]] inline unsigned first_bit(std::uint32_t bits) {
  return static_cast<unsigned>(__builtin_ctz(bits));
}

template <class Record>
[[gnu::always_inline]] inline void prefetch(const Record& record) {
  const auto* const bytes = reinterpret_cast<const char*>(&record);
  for (unsigned at = 0; at < sizeof(Record); at += 64) __builtin_prefetch(bytes + at);
}

template <class Lanes>
[[gnu::always_inline]] inline void collect_leaf(const TreeView& tree, const Ball& ball,
                                                const LocalPlace<Lanes>& local, float near_squared,
                                                float far_squared, std::size_t leaf_index,
                                                IdSink& sink) {
  const TreeLeaf& leaf = tree.leaves[leaf_index];
  const Lanes squares = local.squares(leaf);
  const std::uint32_t within = squares.at_most(far_squared);
  if (within == 0) return;
  if (static_cast<std::size_t>(sink.end - sink.next) < kFanOut) sink.make_room(sink);
  std::uint32_t near = squares.below(near_squared);
  for (std::uint32_t open = within & ~near; open != 0; open &= open - 1) {
    const unsigned place = first_bit(open);
    if (ball.holds(tree.points[leaf_index * kFanOut + place])) near |= 1U << place;
  }
  PointId* next = sink.next;
  if (near == 0xFFFF) {
    for (unsigned place = 0; place < kFanOut; ++place) next[place] = leaf.ids[place];
    next += kFanOut;
  } else {
    for (; near != 0; near &= near - 1) *next++ = leaf.ids[first_bit(near)];
  }
  sink.next = next;
}

template <class Lanes>
[[gnu::always_inline]] inline void collect_around(const TreeView& tree, const Ball& ball,
                                                  IdSink& sink) {
  struct Step {
    std::size_t node;
    unsigned level;
  };
  Step steps[kFanOut * core::kMostLevels];
  unsigned open = 0;
  steps[open++] = {0, tree.top};
  while (open != 0) {
    const Step step = steps[--open];
    const TreeNode& node = tree.levels[step.level][step.node];
    const LocalPlace<Lanes> local(node, ball.centre);
    const double radius = ball.radius_m * node.scale;
    const float far_squared = far_limit(radius);
    const std::uint32_t within = local.gaps(node).at_most(far_squared);
    const std::size_t first_child = step.node * kFanOut;
    if (step.level != 0) {
      for (std::uint32_t left = within; left != 0; left &= left - 1) {
        const std::size_t child = first_child + first_bit(left);
        prefetch(tree.levels[step.level - 1][child]);
        steps[open++] = {child, step.level - 1};
      }
      continue;
    }
    for (std::uint32_t left = within; left != 0; left &= left - 1) {
      prefetch(tree.leaves[first_child + first_bit(left)]);
    }
    const float near_squared = near_limit(radius);
    for (std::uint32_t left = within; left != 0; left &= left - 1) {
      collect_leaf(tree, ball, local, near_squared, far_squared, first_child + first_bit(left),
                   sink);
    }
  }
}

[[gnu::always_inline]] inline double squared_distance(const Point& p, const Point& q) {
  const double dx = p.x - q.x;
  const double dy = p.y - q.y;
  const double dz = p.z - q.z;
  return dx * dx + dy * dy + dz * dz;
}

// The count-th smallest of the squares of the points in a leaf.
template <class Lanes>
[[gnu::always_inline]] inline float square_in_leaf(const Lanes& squares, std::size_t count) {
  alignas(64) float values[kFanOut];
  squares.store(values);
  Lanes smaller = Lanes::all(0.0F);  // how many are smaller than each
  for (const float value : values) smaller = smaller + squares.one_where_above(value);
  const auto before = static_cast<float>(count - 1);
  const std::uint32_t few_smaller = smaller.at_most(before);
  const std::uint32_t exactly = few_smaller & ~smaller.below(before);
  if (exactly != 0) return values[first_bit(exactly)];
  float found = 0.0F;  // one of several equal ones: the largest that few are smaller than
  for (std::uint32_t left = few_smaller; left != 0; left &= left - 1) {
    const float value = values[first_bit(left)];
    found = value > found ? value : found;
  }
  return found;
}

// The square beyond which no point is among the wanted ones, if as many have squares of at most
// `enough`: with s = kSlack, it is above ((sqrt(enough) + s) (1 + s) + s)^2 (1 + s)^2, the upper
// limit of the distance that surely holds as many.
[[gnu::always_inline]] inline float limit_beyond(float enough) {
  return enough + 0x1p-17F * (1.0F + enough);
}

// The same of a FarPlace's values.
[[gnu::always_inline]] inline float value_beyond(float enough) {
  return enough + 0x1p-18F * (1.0F + (enough < 0.0F ? -enough : enough));
}

template <class Lanes>
[[gnu::always_inline]] inline void offer_points(const TreeView& tree, const Point& place,
                                                std::uint32_t within, std::size_t leaf_index,
                                                core::NearestList& list) {
  const TreeLeaf& leaf = tree.leaves[leaf_index];
  for (; within != 0; within &= within - 1) {
    const unsigned at = first_bit(within);
    const Point& point = tree.points[leaf_index * kFanOut + at];
    const double squared = squared_distance(point, place);
    if (squared <= list.largest_squared) list.offer(point, leaf.ids[at], squared);
  }
}

template <class Lanes>
[[gnu::always_inline]] inline void offer_leaf(const TreeView& tree, const Point& place,
                                              const LocalPlace<Lanes>& local, float far_squared,
                                              std::size_t leaf_index, core::NearestList& list) {
  const Lanes squares = local.squares(tree.leaves[leaf_index]);
  std::uint32_t within = squares.at_most(far_squared);
  if (within == 0) return;
  if (list.most <= kFanOut && !list.is_full) {
    within &= squares.at_most(limit_beyond(square_in_leaf(squares, list.most)));
  }
  offer_points<Lanes>(tree, place, within, leaf_index, list);
}

template <class Lanes>
[[gnu::always_inline]] inline void offer_far_leaf(const TreeView& tree, const Point& place,
                                                  const FarPlace<Lanes>& far, double squared,
                                                  std::size_t leaf_index, core::NearestList& list) {
  const Lanes values = far.values(tree.leaves[leaf_index]);
  std::uint32_t within = values.at_most(far.limit(squared));
  if (within == 0) return;
  if (list.most <= kFanOut && !list.is_full) {
    within &= values.at_most(value_beyond(square_in_leaf(values, list.most)));
  }
  offer_points<Lanes>(tree, place, within, leaf_index, list);
}

constexpr float kProbable = 0.04F;  // NOLINT(misc-definitions-in-headers)

// Below this, relative to how far the place is in the frame of a node, or to 1, the slack of floats
// may hide much of what lies beyond a radius: then doubles are asked. (A square.)
constexpr double kVague = 0x1p-30;  // NOLINT(misc-definitions-in-headers)

// How far a box is on an axis, rounded as the distance of its border.
[[gnu::always_inline]] inline double gap_of(double low, double high, double at) {
  return at < low ? low - at : at > high ? at - high : 0.0;
}

// Of the nearest place in a box, the squared_distance.
[[gnu::always_inline]] inline double squared_gap(const core::TreeBox& box, const Point& place) {
  const double x = gap_of(box.low[0], box.high[0], place.x);
  const double y = gap_of(box.low[1], box.high[1], place.y);
  const double z = gap_of(box.low[2], box.high[2], place.z);
  return x * x + y * y + z * z;
}

[[gnu::always_inline]] inline double inside(double low, double high, double at) {
  return at < low ? low : at > high ? high : at;
}

// Whether a box may hold a point that the list would take, decided exactly: a million of boxes that
// rounding cannot tell apart from the nearest point cost no more than those that hold a nearer one.
[[gnu::always_inline]] inline bool may_hold_nearer(const core::TreeBox& box, const Point& place,
                                                   const core::NearestList& list) {
  constexpr double kSurely = 1.0 - 0x1p-47;
  const double squared = squared_gap(box, place);
  if (squared > list.largest_squared) return false;
  if (squared < list.largest_squared * kSurely) return true;
  const Point nearest{inside(box.low[0], box.high[0], place.x),
                      inside(box.low[1], box.high[1], place.y),
                      inside(box.low[2], box.high[2], place.z)};
  return list.would_take(nearest, 0);
}

// A node on the path from the root to where the walk is, and which of its children are left.
template <class Lanes>
struct Visit {
  alignas(64) float gaps[kFanOut];  // squared; from a place far outside: FarPlace's least values
  LocalPlace<Lanes> local;
  FarPlace<Lanes> far;
  const TreeNode* node;
  double squared_scale;
  double vague_below;  // squares of a radius, in the frame
  std::size_t index;
  std::uint32_t left;
  bool is_far;
  bool is_sharp;  // gaps are those of doubles

  [[gnu::always_inline]] void enter(const TreeNode* level, std::size_t node_index, bool is_bottom,
                                    const Point& place) {
    index = node_index;
    node = level + node_index;
    squared_scale = node->scale * node->scale;
    left = 0xFFFF;
    is_sharp = false;
    const double x = place.x - node->origin[0];
    const double y = place.y - node->origin[1];
    const double z = place.z - node->origin[2];
    const double squared = (x * x + y * y + z * z) * squared_scale;
    vague_below = kVague * (squared > 1.0 ? squared : 1.0);
    is_far = far.enter(*node, is_bottom, place);
    local = LocalPlace<Lanes>(*node, place);
    (is_far ? far.least(*node) : local.gaps(*node)).store(gaps);
  }

  // Whether floats may hide what is beyond reach; then the gaps are made anew.
  [[gnu::always_inline]] bool is_vague(const TreeView& tree, unsigned level, const Point& place,
                                       const core::NearestList& list) {
    if (is_far || is_sharp) return true;
    if (squared_reach(list) >= vague_below) return false;
    is_sharp = true;
    for (std::uint32_t some = left; some != 0; some &= some - 1) {
      const unsigned child = first_bit(some);
      if (!(node->low[0][child] < __builtin_inff())) break;  // there is none any more
      const double squared = squared_gap(tree.boxes[level][index * kFanOut + child], place);
      const double in_frame = squared * squared_scale;
      gaps[child] = static_cast<float>(in_frame < kLargestFar ? in_frame : kLargestFar);
    }
    return true;
  }

  [[gnu::always_inline]] double squared_reach(const core::NearestList& list) const {
    return list.largest_squared * squared_scale;
  }
  [[gnu::always_inline]] float far_squared(const core::NearestList& list) const {
    return far_limit_of_square(squared_reach(list));
  }

  // Prefetches the leaves that will probably be needed: those within reach if that is known.
  [[gnu::always_inline]] void prefetch_leaves(const TreeView& tree,
                                              const core::NearestList& list) const {
    const float reach = far_squared(list);
    const float probable = reach < kProbable ? reach : kProbable;
    for (std::uint32_t some = Lanes::load(gaps).at_most(probable); some != 0; some &= some - 1) {
      const std::size_t leaf = index * kFanOut + first_bit(some);
      prefetch(tree.leaves[leaf]);
      for (unsigned i = 0; i < kFanOut; i += 2)
        __builtin_prefetch(&tree.points[leaf * kFanOut + i]);
    }
  }

  [[gnu::always_inline]] void drop_beyond(float far_squared) {
    left &= Lanes::load(gaps).at_most(far_squared);
  }
  [[gnu::always_inline]] void drop_far_beyond(const core::NearestList& list) {
    const double squared = squared_reach(list);
    left &= Lanes::load(gaps).at_most(far.limit(squared));
    // Boxes may lie outside of the frame of their node, near the place: then this tells more.
    if (left != 0) left &= local.gaps(*node).at_most(far_limit_of_square(squared));
  }

  [[gnu::always_inline]] unsigned take_nearest() {
    const std::uint32_t around = is_far ? 0 : left & Lanes::load(gaps).at_most(0.0F);
    unsigned nearest = first_bit(around != 0 ? around : left);
    if (around == 0) {
      for (std::uint32_t others = left & (left - 1); others != 0; others &= others - 1) {
        const unsigned child = first_bit(others);
        if (gaps[child] < gaps[nearest]) nearest = child;
      }
    }
    left &= ~(1U << nearest);
    return nearest;
  }
};

// Whether a child whose points are all at one place has any to offer: a million of them cost no
// more than those that the list takes.
[[gnu::always_inline]] inline bool is_worth_it(const TreeView& tree, const TreeNode& node,
                                               unsigned level, std::size_t child,
                                               const core::NearestList& list) {
  if ((node.same_place >> (child % kFanOut) & 1U) == 0) return true;
  const std::size_t leaf = child << (4 * level);
  return list.would_take(tree.points[leaf * kFanOut], tree.leaves[leaf].ids[0]);
}

template <class Lanes>
[[gnu::always_inline]] inline void nearest_around(const TreeView& tree, const Point& place,
                                                  core::NearestList& list) {
  Visit<Lanes> path[core::kMostLevels];
  unsigned level = tree.top;
  path[level].enter(tree.levels[level], 0, level == 0, place);
  for (;;) {
    Visit<Lanes>& visit = path[level];
    const bool is_vague = visit.is_vague(tree, level, place, list);
    const float far_squared = visit.far_squared(list);
    if (visit.is_far) {
      visit.drop_far_beyond(list);
    } else {
      visit.drop_beyond(far_squared);
    }
    if (visit.left == 0) {
      if (level == tree.top) return;
      ++level;
      continue;
    }
    const std::size_t child = visit.index * kFanOut + visit.take_nearest();
    if (!is_worth_it(tree, *visit.node, level, child, list)) continue;
    if (is_vague && !may_hold_nearer(tree.boxes[level][child], place, list)) continue;
    if (level == 0) ++list.leaves;
    if (level == 0 && visit.is_far) {
      offer_far_leaf(tree, place, visit.far, visit.squared_reach(list), child, list);
    } else if (level == 0) {
      offer_leaf(tree, place, visit.local, far_squared, child, list);
    } else {
      --level;
      path[level].enter(tree.levels[level], child, level == 0, place);
      if (level == 0 && !path[0].is_far) path[0].prefetch_leaves(tree, list);
    }
  }
}

}  // namespace
}  // namespace beespace::cpu
