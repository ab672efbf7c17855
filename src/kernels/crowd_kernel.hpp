// The kernels of crowd_kernels.hpp, written once in GNU vectors, which every compiler turns into
// whatever vectors the instruction set has.
//
// Included by the crowd_<instruction set>.cpp files only; as in sweep_kernel.hpp, all is in
// an unnamed namespace and no inline function of a library header is called.
#pragma once

#include "kernels/crowd_kernels.hpp"
#include "kernels/wide_vectors.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

using Ints = Wide<std::int32_t>;
using Floats = Wide<float>;

template <class Number>
[[gnu::always_inline]] inline Ints lanes(const Number* at) {
  return Ints::load(at);
}

[[gnu::always_inline]] inline Floats to_floats(const Ints& ints) {
  Floats floats;
  for (std::size_t k = 0; k < kPieces; ++k) {
    floats.piece[k] = __builtin_convertvector(ints.piece[k], Floats::Piece);
  }
  return floats;
}

// How far sixteen boxes or points are from a box, squared: at least and at most.
struct SquaredReach {
  Floats nearest = Floats::all(0.0F);
  Floats farthest = Floats::all(0.0F);

  // An axis: from the low border of one to the high border of the other, both ways.
  [[gnu::always_inline]] void add(const Ints& up, const Ints& down) {
    const Floats most = to_floats(larger(up, down));
    const Floats least = to_floats(larger(Ints::all(0), larger(-up, -down)));
    farthest = farthest + most * most;
    nearest = nearest + least * least;
  }
};

// Which of 16 boxes lie within the threshold of a box as a whole, and which in part.
struct BoxesSeen {
  Ints near;
  Ints open;

  [[gnu::always_inline]] BoxesSeen(const CrowdNode& asked, std::uint32_t leaf,
                                   const CrowdNode& others, const Limits& limits) {
    SquaredReach reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t first = axis * kCrowdLanes;
      reach.add(lanes(others.high + first) - Ints::all(asked.low[first + leaf]),
                Ints::all(asked.high[first + leaf]) - lanes(others.low + first));
    }
    near = below(reach.farthest, Floats::all(limits.near));
    open = at_most(reach.nearest, Floats::all(limits.far)) & ~near;
  }
};

// Whether a square is above so much of the threshold's that a leaf is wide: its points are told
// apart from those of another leaf one by one, before they are compared with each of them.
[[gnu::always_inline]] inline float wide_from(const Limits& limits) {
  return limits.far * 0.25F;
}

// The squared longest sides of 16 boxes.
[[gnu::always_inline]] inline Floats squared_sides(const CrowdNode& node) {
  Ints longest = Ints::all(0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    longest = larger(longest,
                     lanes(node.high + axis * kCrowdLanes) - lanes(node.low + axis * kCrowdLanes));
  }
  return to_floats(longest) * to_floats(longest);
}

// Which of the 16 points of a leaf are within the threshold of all points of a box, and whether
// that is open for any. Floats lie between those of boxes around them.
struct PointsSeen {
  Ints near;
  Ints open;

  [[gnu::always_inline]] PointsSeen(const CrowdNode& node, std::uint32_t leaf,
                                    const CrowdNode& others, std::uint32_t other,
                                    const Limits& limits) {
    SquaredReach reach;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t box = axis * kCrowdLanes + other;
      const Ints at = lanes(node.position[axis] + std::size_t{leaf} * kCrowdLanes);
      reach.add(Ints::all(others.high[box]) - at, at - Ints::all(others.low[box]));
    }
    near = below(reach.farthest, Floats::all(limits.near));
    open = at_most(reach.nearest, Floats::all(limits.far)) & ~near;
  }
};

class Pairs {
 public:
  Pairs(const CrowdNode& asked, const CrowdNode& others, const Limits& limits,
        const CrowdSums& sums, const CrowdUnsure& unsure)
      : asked_(asked), others_(others), limits_(limits), sums_(sums), unsure_(unsure) {}

  // Of two leaves, those of the second in lanes. Floats of pairs lie between those of their boxes.
  template <bool Both, bool Weighted>
  [[gnu::always_inline]] void count(std::uint32_t leaf, std::uint32_t other) const {
    const std::uint32_t begin = leaf * kCrowdLanes;
    const std::uint32_t left = asked_.size - begin;
    const std::uint32_t end = left < kCrowdLanes ? asked_.size : begin + kCrowdLanes;
    const std::uint32_t from = other * kCrowdLanes;
    const Ints x = lanes(others_.position[0] + from);
    const Ints y = lanes(others_.position[1] + from);
    const Ints z = lanes(others_.position[2] + from);
    const Ints weights = Weighted ? lanes(others_.weights + from) : Ints::all(0);
    const Floats limit_near = Floats::all(limits_.near);
    const Floats limit_far = Floats::all(limits_.far);
    Ints of_others = Ints::all(0);
    Ints open = Ints::all(0);
    for (std::uint32_t i = begin; i < end; ++i) {
      const Floats squared = squared_units(x, y, z, i);
      const Ints near = below(squared, limit_near);
      std::uint32_t* const of_asked = sums_.of_asked + std::size_t{i} * kCrowdLanes;
      if constexpr (Weighted) {
        add_to(of_asked, near & weights);
        if constexpr (Both) {
          of_others = of_others + (near & Ints::all(static_cast<std::int32_t>(asked_.weights[i])));
        }
      } else {
        add_to(of_asked, -near);
        if constexpr (Both) of_others = of_others - near;
      }
      open = open | (at_most(squared, limit_far) & ~near);
    }
    if constexpr (Both) add_to(sums_.of_others + from, of_others);
    if (any(open)) [[unlikely]] {
      decide(begin, end, from, Both);
    }
  }

  // The same where each point of the first leaf is near to all of the second, or to none: false,
  // with nothing counted, if not.
  template <bool Both>
  [[gnu::always_inline]] bool count_asked_alike(std::uint32_t leaf, std::uint32_t other) const {
    const PointsSeen seen(asked_, leaf, others_, other, limits_);
    if (any(seen.open)) return false;
    for (std::uint32_t left = bits_of(seen.near); left != 0; left &= left - 1) {
      const std::uint32_t i = leaf * kCrowdLanes + first_bit(left);
      sums_.of_asked[std::size_t{i} * kCrowdLanes] += others_.leaf_weights[other];
      if constexpr (Both) {
        sums_.of_other_leaves[other] += asked_.weights == nullptr ? 1U : asked_.weights[i];
      }
    }
    return true;
  }

  // And of the second leaf with all of the first.
  template <bool Both, bool Weighted>
  [[gnu::always_inline]] bool count_others_alike(std::uint32_t leaf, std::uint32_t other) const {
    const PointsSeen seen(others_, other, asked_, leaf, limits_);
    if (any(seen.open)) return false;
    std::uint32_t* const of_leaf = sums_.of_asked_leaves + std::size_t{leaf} * kCrowdLanes;
    if constexpr (Weighted) {
      add_to(of_leaf, seen.near & lanes(others_.weights + std::size_t{other} * kCrowdLanes));
    } else {
      add_to(of_leaf, -seen.near);
    }
    if constexpr (Both) {
      add_to(sums_.of_others + std::size_t{other} * kCrowdLanes,
             seen.near & Ints::all(static_cast<std::int32_t>(asked_.leaf_weights[leaf])));
    }
    return true;
  }

 private:
  [[gnu::always_inline]] Floats squared_units(const Ints& x, const Ints& y, const Ints& z,
                                              std::uint32_t i) const {
    const Floats dx = to_floats(x - Ints::all(asked_.position[0][i]));
    const Floats dy = to_floats(y - Ints::all(asked_.position[1][i]));
    const Floats dz = to_floats(z - Ints::all(asked_.position[2][i]));
    return dx * dx + dy * dy + dz * dz;
  }

  [[gnu::always_inline]] static std::uint32_t first_bit(std::uint32_t bits) {
    return static_cast<std::uint32_t>(__builtin_ctz(bits));
  }

  [[gnu::noinline]] void decide(std::uint32_t begin, std::uint32_t end, std::uint32_t from,
                                bool both) const {
    const Ints x = lanes(others_.position[0] + from);
    const Ints y = lanes(others_.position[1] + from);
    const Ints z = lanes(others_.position[2] + from);
    for (std::uint32_t i = begin; i < end; ++i) {
      const Floats squared = squared_units(x, y, z, i);
      const Ints open =
          at_most(squared, Floats::all(limits_.far)) & ~below(squared, Floats::all(limits_.near));
      for (std::uint32_t left = bits_of(open); left != 0; left &= left - 1) {
        unsure_.decide(unsure_.context, asked_.first_slot + i,
                       others_.first_slot + from + first_bit(left), both);
      }
    }
  }

  const CrowdNode& asked_;
  const CrowdNode& others_;
  const Limits limits_;
  const CrowdSums sums_;
  const CrowdUnsure& unsure_;
};

// NOLINTNEXTLINE(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr std::int32_t kLaneNumbers[kCrowdLanes] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                    8, 9, 10, 11, 12, 13, 14, 15};

enum class With : std::uint8_t { kOthers, kOthersBothWays, kItself };

template <With Whom, bool Weighted>
void count_crowds(const CrowdNode& asked, const CrowdNode& others, const Limits& limits,
                  const CrowdSums& sums, const CrowdUnsure& unsure) {
  constexpr bool kBoth = Whom != With::kOthers;
  const Pairs pairs(asked, others, limits, sums, unsure);
  const std::uint32_t leaves = (asked.size + kCrowdLanes - 1) / kCrowdLanes;
  const Floats wide = Floats::all(wide_from(limits));
  const std::uint32_t asked_wide = bits_of(below(wide, squared_sides(asked)));
  const std::uint32_t others_wide = bits_of(below(wide, squared_sides(others)));
  for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
    BoxesSeen seen(asked, leaf, others, limits);
    std::uint32_t* const of_leaf = sums.of_asked_leaves + std::size_t{leaf} * kCrowdLanes;
    if constexpr (Whom == With::kItself) {
      if ((bits_of(seen.near) >> leaf & 1U) != 0) {
        of_leaf[leaf] += others.leaf_weights[leaf];
      } else {
        pairs.count<false, Weighted>(leaf, leaf);
      }
      const Ints later =
          below(Ints::all(static_cast<std::int32_t>(leaf)), Ints::load(kLaneNumbers));
      seen.near = seen.near & later;
      seen.open = seen.open & later;
    }
    add_to(of_leaf, seen.near & lanes(others.leaf_weights));
    if constexpr (kBoth) {
      add_to(sums.of_other_leaves,
             seen.near & Ints::all(static_cast<std::int32_t>(asked.leaf_weights[leaf])));
    }
    const bool is_wide = (asked_wide >> leaf & 1U) != 0;
    for (std::uint32_t left = bits_of(seen.open); left != 0; left &= left - 1) {
      const auto other = static_cast<std::uint32_t>(__builtin_ctz(left));
      if (is_wide && pairs.count_asked_alike<kBoth>(leaf, other)) continue;
      if ((others_wide >> other & 1U) != 0 &&
          pairs.count_others_alike<kBoth, Weighted>(leaf, other)) {
        continue;
      }
      pairs.count<kBoth, Weighted>(leaf, other);
    }
  }
}

// NOLINTNEXTLINE(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr CrowdKernels kKernels{
    {count_crowds<With::kOthersBothWays, false>, count_crowds<With::kOthersBothWays, true>},
    {count_crowds<With::kOthers, false>, count_crowds<With::kOthers, true>},
    {count_crowds<With::kItself, false>, count_crowds<With::kItself, true>}};

}  // namespace
}  // namespace beespace::cpu
