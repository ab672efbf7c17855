// The kernels of box_kernels.hpp, written once in GNU vectors, which every compiler turns into
// whatever vectors the instruction set has.
//
// Included by the box_<instruction set>.cpp files only; as in crowd_kernel.hpp, all is in an
// unnamed namespace and no inline function of a library header is called.
#pragma once

#include "kernels/box_kernels.hpp"
#include "kernels/wide_vectors.hpp"

#include <cstdint>

namespace beespace::cpu {
namespace {

// NOLINTNEXTLINE(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr std::uint32_t kHalf = kBoxLanes / 2;

using Doubles = Wide<double>;
using Masks = Wide<std::int64_t>;

[[gnu::always_inline]] inline Doubles load(BoxLanes from) {
  return Doubles::load(from);
}

inline BoxesAround look(const double* low, const double* high, const BoxRow& row,
                        const BoxLimits& limits) {
  const Doubles limit_near = Doubles::all(limits.near);
  const Doubles limit_far = Doubles::all(limits.far);
  BoxesAround seen{0, 0, 0};
  for (std::uint32_t half = 0; half < kBoxLanes; half += kHalf) {
    Doubles nearest = Doubles::all(0.0);
    Doubles farthest = Doubles::all(0.0);
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t from = axis * kBoxLanes + half;
      const Doubles up = load(row.high + from) - Doubles::all(low[axis]);
      const Doubles down = Doubles::all(high[axis]) - load(row.low + from);
      const Doubles most = larger(up, down);
      const Doubles least = larger(Doubles::all(0.0), larger(-up, -down));
      farthest = farthest + most * most;
      nearest = nearest + least * least;
    }
    const std::uint32_t far = bits_of(below(limit_far, nearest));
    const std::uint32_t near = bits_of(below(farthest, limit_near)) & ~far;
    const std::uint32_t unsure =
        bits_of(at_most(limit_near, nearest) | at_most(farthest, limit_far)) & ~(far | near);
    seen.near |= near << half;
    seen.unsure |= unsure << half;
    seen.open |= (0xFFU & ~(far | near | unsure)) << half;
  }
  return seen;
}

template <bool Weighted>
[[gnu::always_inline]] inline bool count(const BoxLeaves& leaves, const BoxLimits& limits) {
  const Doubles limit_near = Doubles::all(limits.near);
  const Doubles limit_far = Doubles::all(limits.far);
  Doubles at[3][2];
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    for (std::uint32_t half = 0; half < 2; ++half) {
      const std::uint32_t from = axis * kBoxLanes + half * kHalf;
      at[axis][half] = load(leaves.others + from);
    }
  }
  Masks of_others[2] = {Masks::all(0), Masks::all(0)};
  std::uint32_t any = 0;
  for (std::uint32_t rows = leaves.rows; rows != 0; rows &= rows - 1) {
    const auto i = static_cast<std::uint32_t>(__builtin_ctz(rows));
    std::uint32_t near = 0;
    std::uint32_t within = 0;
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Doubles dx = at[0][half] - Doubles::all(leaves.asked[i]);
      const Doubles dy = at[1][half] - Doubles::all(leaves.asked[kBoxLanes + i]);
      const Doubles dz = at[2][half] - Doubles::all(leaves.asked[2 * kBoxLanes + i]);
      const Doubles squared = dx * dx + dy * dy + dz * dz;
      const Masks is_near = below(squared, limit_near);
      if constexpr (Weighted) {
        of_others[half] = of_others[half] + (is_near & Masks::all(leaves.asked_weights[i]));
      } else {
        of_others[half] = of_others[half] - is_near;
      }
      near |= bits_of(is_near) << (half * kHalf);
      within |= bits_of(at_most(squared, limit_far)) << (half * kHalf);
    }
    if constexpr (Weighted) {
      for (std::uint32_t left = near; left != 0; left &= left - 1) {
        leaves.of_asked[i] += leaves.other_weights[__builtin_ctz(left)];
      }
    } else {
      leaves.of_asked[i] += static_cast<std::uint32_t>(__builtin_popcount(near));
    }
    leaves.unsure[i] = static_cast<std::uint16_t>(within & ~near);
    any |= within & ~near;
  }
  for (std::uint32_t half = 0; half < 2; ++half) {
    const std::uint32_t from = half * kHalf;
    std::int64_t sums[kHalf];
    of_others[half].store(sums);
    for (std::uint32_t lane = 0; lane < kHalf; ++lane) {
      leaves.of_others[from + lane] += static_cast<std::uint32_t>(sums[lane]);
    }
  }
  return any != 0;
}

inline bool count_either(const BoxLeaves& leaves, const BoxLimits& limits) {
  return leaves.other_weights == nullptr ? count<false>(leaves, limits)
                                         : count<true>(leaves, limits);
}

// Lane by lane, which compilers make one instruction of.
[[gnu::always_inline]] inline Doubles roots(const Doubles& values) {
  Doubles result;
  for (std::size_t k = 0; k < kPieces; ++k) {
    for (std::size_t lane = 0; lane < Doubles::kLanes; ++lane) {
      result.piece[k][lane] = __builtin_sqrt(values.piece[k][lane]);
    }
  }
  return result;
}

inline void least_squares(const PlaceAroundCentre& place, const core::ShellRow& row,
                          double* least) {
  const Doubles squared = Doubles::all(place.squared);
  for (std::uint32_t half = 0; half < kBoxLanes; half += kHalf) {
    const Doubles along = load(row.towards[0] + half) * Doubles::all(place.at[0]) +
                          load(row.towards[1] + half) * Doubles::all(place.at[1]) +
                          load(row.towards[2] + half) * Doubles::all(place.at[2]);
    const Doubles across =
        larger(Doubles::all(0.0), squared - along * along) + Doubles::all(place.squared * 0x1p-48);
    const Doubles most = larger(along * load(row.low + half), along * load(row.high + half)) +
                         roots(across) * load(row.aside + half);
    const Doubles bound = load(row.least + half) + Doubles::all(place.squared * (1.0 - 0x1p-44)) -
                          Doubles::all(2.0) * most;
    bound.store(least + half);
  }
}

// NOLINTNEXTLINE(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr BoxKernels kKernels{look, count_either, least_squares};

}  // namespace
}  // namespace beespace::cpu
