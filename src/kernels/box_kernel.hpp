// The kernels of box_kernels.hpp, written once in GNU vectors, which every compiler turns into
// whatever vectors the instruction set has.
//
// Included by the box_<instruction set>.cpp files only; as in crowd_kernel.hpp, all is in an
// unnamed namespace and no inline function of a library header is called.
#pragma once

#include "kernels/box_kernels.hpp"

#if defined(__AVX2__)
#include <immintrin.h>
#endif

#include <cstdint>

// How vectors travel between functions depends on the instruction set; here everything is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace beespace::cpu {
namespace {

// NOLINTNEXTLINE(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr std::uint32_t kHalf = kBoxLanes / 2;

using Doubles [[gnu::vector_size(64)]] = double;
using LooseDoubles [[gnu::vector_size(64), gnu::may_alias, gnu::aligned(8)]] = double;
using Masks [[gnu::vector_size(64)]] = std::int64_t;
using Numbers [[gnu::vector_size(32)]] = std::uint32_t;
using LooseNumbers [[gnu::vector_size(32), gnu::may_alias, gnu::aligned(4)]] = std::uint32_t;

[[gnu::always_inline]] inline Doubles load(BoxLanes from) {
  return *reinterpret_cast<const LooseDoubles*>(from);
}
[[gnu::always_inline]] inline Doubles larger(const Doubles& a, const Doubles& b) {
  return a > b ? a : b;
}
[[gnu::always_inline]] inline Doubles smaller(const Doubles& a, const Doubles& b) {
  return a < b ? a : b;
}

// A bit for each lane of a mask.
[[gnu::always_inline]] inline std::uint32_t bits_of(const Masks& mask) {
#if defined(__AVX512DQ__)
  return _mm512_movepi64_mask(__builtin_bit_cast(__m512i, mask));
#elif defined(__AVX2__)
  struct Halves {
    __m256d low;
    __m256d high;
  };
  const auto halves = __builtin_bit_cast(Halves, mask);
  return static_cast<std::uint32_t>(_mm256_movemask_pd(halves.low) | _mm256_movemask_pd(halves.high)
                                                                         << 4);
#else
  const Masks powers{1, 2, 4, 8, 16, 32, 64, 128};
  const Masks bits = mask & powers;
  return static_cast<std::uint32_t>((bits[0] | bits[1]) | (bits[2] | bits[3]) |
                                    (bits[4] | bits[5]) | (bits[6] | bits[7]));
#endif
}

inline BoxesAround look(const double* low, const double* high, const BoxRow& row,
                        const BoxLimits& limits) {
  BoxesAround seen{0, 0, 0};
  for (std::uint32_t half = 0; half < kBoxLanes; half += kHalf) {
    Doubles nearest{};
    Doubles farthest{};
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t from = axis * kBoxLanes + half;
      const Doubles up = load(row.high + from) - low[axis];
      const Doubles down = high[axis] - load(row.low + from);
      const Doubles most = larger(up, down);
      const Doubles least = larger(Doubles{}, -smaller(up, down));
      farthest += most * most;
      nearest += least * least;
    }
    const std::uint32_t far = bits_of(nearest > limits.far);
    const std::uint32_t near = bits_of(farthest < limits.near) & ~far;
    const std::uint32_t unsure =
        bits_of((nearest >= limits.near) | (farthest <= limits.far)) & ~(far | near);
    seen.near |= near << half;
    seen.unsure |= unsure << half;
    seen.open |= (0xFFU & ~(far | near | unsure)) << half;
  }
  return seen;
}

template <bool Weighted>
[[gnu::always_inline]] inline bool count(const BoxLeaves& leaves, const BoxLimits& limits) {
  Doubles at[3][2];
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    for (std::uint32_t half = 0; half < 2; ++half) {
      const std::uint32_t from = axis * kBoxLanes + half * kHalf;
      at[axis][half] = load(leaves.others + from);
    }
  }
  Masks of_others[2] = {};
  std::uint32_t any = 0;
  for (std::uint32_t rows = leaves.rows; rows != 0; rows &= rows - 1) {
    const auto i = static_cast<std::uint32_t>(__builtin_ctz(rows));
    std::uint32_t near = 0;
    std::uint32_t within = 0;
    for (std::uint32_t half = 0; half < 2; ++half) {
      const Doubles dx = at[0][half] - leaves.asked[i];
      const Doubles dy = at[1][half] - leaves.asked[kBoxLanes + i];
      const Doubles dz = at[2][half] - leaves.asked[2 * kBoxLanes + i];
      const Doubles squared = dx * dx + dy * dy + dz * dz;
      const Masks is_near = squared < limits.near;
      if constexpr (Weighted) {
        of_others[half] += is_near & static_cast<std::int64_t>(leaves.asked_weights[i]);
      } else {
        of_others[half] -= is_near;
      }
      near |= bits_of(is_near) << (half * kHalf);
      within |= bits_of(squared <= limits.far) << (half * kHalf);
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
    LooseNumbers& of_half = *reinterpret_cast<LooseNumbers*>(leaves.of_others + from);
    of_half += __builtin_convertvector(of_others[half], Numbers);
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
  for (std::uint32_t lane = 0; lane < kHalf; ++lane) result[lane] = __builtin_sqrt(values[lane]);
  return result;
}

inline void least_squares(const PlaceAroundCentre& place, const core::ShellRow& row,
                          double* least) {
  const double squared = place.squared * (1.0 - 0x1p-44);
  for (std::uint32_t half = 0; half < kBoxLanes; half += kHalf) {
    const Doubles along = load(row.towards[0] + half) * place.at[0] +
                          load(row.towards[1] + half) * place.at[1] +
                          load(row.towards[2] + half) * place.at[2];
    const Doubles across =
        larger(Doubles{}, place.squared - along * along) + place.squared * 0x1p-48;
    const Doubles most = larger(along * load(row.low + half), along * load(row.high + half)) +
                         roots(across) * load(row.aside + half);
    const Doubles bound = load(row.least + half) + squared - 2.0 * most;
    *reinterpret_cast<LooseDoubles*>(least + half) = bound;
  }
}

// NOLINTNEXTLINE(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr BoxKernels kKernels{look, count_either, least_squares};

}  // namespace
}  // namespace beespace::cpu
