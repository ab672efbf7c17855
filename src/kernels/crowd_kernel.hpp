// The kernels of crowd_kernels.hpp, written once in GNU vectors, which every compiler turns into
// whatever vectors the instruction set has.
//
// Included by the crowd_<instruction set>.cpp files only; as in sweep_kernel.hpp, all is in
// an unnamed namespace and no inline function of a library header is called.
#pragma once

#include "kernels/crowd_kernels.hpp"

#include <cstdint>

// How vectors travel between functions depends on the instruction set; here everything is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace beespace::cpu {
namespace {

using Ints [[gnu::vector_size(64), gnu::may_alias, gnu::aligned(4)]] = std::int32_t;
using Floats [[gnu::vector_size(64)]] = float;

[[gnu::always_inline]] inline const Ints& lanes(const std::int32_t* at) {
  return *reinterpret_cast<const Ints*>(at);
}
[[gnu::always_inline]] inline const Ints& lanes(const std::uint32_t* at) {
  return *reinterpret_cast<const Ints*>(at);
}
[[gnu::always_inline]] inline Ints& lanes(std::uint32_t* at) {
  return *reinterpret_cast<Ints*>(at);
}

[[gnu::always_inline]] inline Floats to_floats(const Ints& ints) {
  return __builtin_convertvector(ints, Floats);
}
[[gnu::always_inline]] inline Ints larger(const Ints& a, const Ints& b) {
  return a > b ? a : b;
}

// The lanes of a mask, as a list.
struct Lanes {
  std::uint32_t lane[kCrowdLanes];
  std::uint32_t count = 0;

  [[gnu::always_inline]] explicit Lanes(const Ints& mask) {
    for (std::uint32_t k = 0; k < kCrowdLanes; ++k) {
      lane[count & (kCrowdLanes - 1)] = k;
      count += mask[k] != 0 ? 1U : 0U;
    }
  }
};

// Which of 16 boxes lie within the threshold of a box as a whole, and which in part.
struct BoxesSeen {
  Ints near;
  Ints open;

  [[gnu::always_inline]] BoxesSeen(const CrowdNode& asked, std::uint32_t leaf,
                                   const CrowdNode& others, const Limits& limits) {
    Floats nearest{};
    Floats farthest{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Ints up =
          lanes(others.high + axis * kCrowdLanes) - asked.low[axis * kCrowdLanes + leaf];
      const Ints down =
          asked.high[axis * kCrowdLanes + leaf] - lanes(others.low + axis * kCrowdLanes);
      const Floats most = to_floats(larger(up, down));
      const Floats least = to_floats(larger(Ints{}, larger(-up, -down)));
      farthest += most * most;
      nearest += least * least;
    }
    near = farthest < limits.near;
    open = (nearest <= limits.far) & ~near;
  }
};

// Whether a square is above so much of the threshold's that a leaf is wide: its points are told apart
// from those of another leaf one by one, before they are compared with each of them.
[[gnu::always_inline]] inline float wide_from(const Limits& limits) {
  return limits.far * 0.25F;
}

// The squared longest sides of 16 boxes.
[[gnu::always_inline]] inline Floats squared_sides(const CrowdNode& node) {
  Ints longest{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    longest = larger(longest, lanes(node.high + axis * kCrowdLanes) -
                                  lanes(node.low + axis * kCrowdLanes));
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
    Floats nearest{};
    Floats farthest{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Ints at = lanes(node.position[axis] + std::size_t{leaf} * kCrowdLanes);
      const Ints up = others.high[axis * kCrowdLanes + other] - at;
      const Ints down = at - others.low[axis * kCrowdLanes + other];
      const Floats most = to_floats(larger(up, down));
      const Floats least = to_floats(larger(Ints{}, larger(-up, -down)));
      farthest += most * most;
      nearest += least * least;
    }
    near = farthest < limits.near;
    open = (nearest <= limits.far) & ~near;
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
    const Ints weights = Weighted ? lanes(others_.weights + from) : Ints{};
    Ints of_others{};
    Ints open{};
    for (std::uint32_t i = begin; i < end; ++i) {
      const Floats squared = squared_units(x, y, z, i);
      const Ints near = squared < limits_.near;
      Ints& of_asked = lanes(sums_.of_asked + std::size_t{i} * kCrowdLanes);
      if constexpr (Weighted) {
        of_asked += near & weights;
        if constexpr (Both) of_others += near & static_cast<std::int32_t>(asked_.weights[i]);
      } else {
        of_asked -= near;
        if constexpr (Both) of_others -= near;
      }
      open |= (squared <= limits_.far) & ~near;
    }
    if constexpr (Both) lanes(sums_.of_others + from) += of_others;
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
    const Lanes listed(seen.near);
    for (std::uint32_t k = 0; k < listed.count; ++k) {
      const std::uint32_t i = leaf * kCrowdLanes + listed.lane[k];
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
    Ints& of_leaf = lanes(sums_.of_asked_leaves + std::size_t{leaf} * kCrowdLanes);
    if constexpr (Weighted) {
      of_leaf += seen.near & lanes(others_.weights + std::size_t{other} * kCrowdLanes);
    } else {
      of_leaf -= seen.near;
    }
    if constexpr (Both) {
      lanes(sums_.of_others + std::size_t{other} * kCrowdLanes) +=
          seen.near & static_cast<std::int32_t>(asked_.leaf_weights[leaf]);
    }
    return true;
  }

 private:
  [[gnu::always_inline]] Floats squared_units(const Ints& x, const Ints& y, const Ints& z,
                                              std::uint32_t i) const {
    const Floats dx = to_floats(x - asked_.position[0][i]);
    const Floats dy = to_floats(y - asked_.position[1][i]);
    const Floats dz = to_floats(z - asked_.position[2][i]);
    return dx * dx + dy * dy + dz * dz;
  }

  [[gnu::always_inline]] static bool any(const Ints& mask) {
    // By value: Ints may lie anywhere, a reference to Longs must be aligned as a whole vector.
    using Longs [[gnu::vector_size(64)]] = std::int64_t;
    const auto halves = __builtin_bit_cast(Longs, mask);
    return (halves[0] | halves[1] | halves[2] | halves[3] | halves[4] | halves[5] | halves[6] |
            halves[7]) != 0;
  }

  [[gnu::noinline]] void decide(std::uint32_t begin, std::uint32_t end, std::uint32_t from,
                                bool both) const {
    const Ints x = lanes(others_.position[0] + from);
    const Ints y = lanes(others_.position[1] + from);
    const Ints z = lanes(others_.position[2] + from);
    for (std::uint32_t i = begin; i < end; ++i) {
      const Floats squared = squared_units(x, y, z, i);
      const Ints open = (squared <= limits_.far) & ~(squared < limits_.near);
      if (!any(open)) continue;
      const Lanes listed(open);
      for (std::uint32_t k = 0; k < listed.count; ++k) {
        unsure_.decide(unsure_.context, asked_.first_slot + i,
                       others_.first_slot + from + listed.lane[k], both);
      }
    }
  }

  const CrowdNode& asked_;
  const CrowdNode& others_;
  const Limits limits_;
  const CrowdSums sums_;
  const CrowdUnsure& unsure_;
};

enum class With : std::uint8_t { kOthers, kOthersBothWays, kItself };

template <With Whom, bool Weighted>
void count_crowds(const CrowdNode& asked, const CrowdNode& others, const Limits& limits,
                  const CrowdSums& sums, const CrowdUnsure& unsure) {
  constexpr bool kBoth = Whom != With::kOthers;
  constexpr Ints kNumbers{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
  const Pairs pairs(asked, others, limits, sums, unsure);
  const std::uint32_t leaves = (asked.size + kCrowdLanes - 1) / kCrowdLanes;
  const Ints asked_wide = squared_sides(asked) > wide_from(limits);
  const Ints others_wide = squared_sides(others) > wide_from(limits);
  for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
    BoxesSeen seen(asked, leaf, others, limits);
    Ints& of_leaf = lanes(sums.of_asked_leaves + std::size_t{leaf} * kCrowdLanes);
    if constexpr (Whom == With::kItself) {
      const auto own = static_cast<std::int32_t>(leaf);
      of_leaf += seen.near & (kNumbers == own) & lanes(others.leaf_weights);
      if (seen.near[leaf] == 0) pairs.count<false, Weighted>(leaf, leaf);
      seen.near &= kNumbers > own;
      seen.open &= kNumbers > own;
    }
    of_leaf += seen.near & lanes(others.leaf_weights);
    if constexpr (kBoth) {
      lanes(sums.of_other_leaves) +=
          seen.near & static_cast<std::int32_t>(asked.leaf_weights[leaf]);
    }
    const Lanes open(seen.open);
    for (std::uint32_t k = 0; k < open.count; ++k) {
      const std::uint32_t other = open.lane[k];
      if (asked_wide[leaf] != 0 && pairs.count_asked_alike<kBoth>(leaf, other)) continue;
      if (others_wide[other] != 0 && pairs.count_others_alike<kBoth, Weighted>(leaf, other)) continue;
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
