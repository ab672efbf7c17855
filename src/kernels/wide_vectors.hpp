// Vectors of 64 bytes, in pieces as wide as the vectors of the instruction set. GNU vectors that
// are wider than these are kept in memory by GCC, and compared lane by lane.
//
// Included by kernels, under their rules: all is in an unnamed namespace.
#pragma once

#if defined(__AVX2__)
#include <immintrin.h>
#elif defined(__SSE2__)
#include <emmintrin.h>
#endif

#include <cstddef>
#include <cstdint>
#include <type_traits>

// How vectors travel between functions depends on the instruction set; here everything is inlined.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace beespace::cpu {
namespace {

// NOLINTBEGIN(misc-definitions-in-headers): in an unnamed namespace, once in each kernel
constexpr std::size_t kWideBytes = 64;
#if defined(__AVX512F__)
constexpr std::size_t kPieceBytes = 64;
#elif defined(__AVX2__)
constexpr std::size_t kPieceBytes = 32;
#else
constexpr std::size_t kPieceBytes = 16;
#endif
constexpr std::size_t kPieces = kWideBytes / kPieceBytes;
// NOLINTEND(misc-definitions-in-headers)

template <class Lane>
struct Wide {
  using Piece [[gnu::vector_size(kPieceBytes)]] = Lane;
  using LoosePiece [[gnu::vector_size(kPieceBytes), gnu::may_alias, gnu::aligned(4)]] = Lane;
  static constexpr std::size_t kLanes = kPieceBytes / sizeof(Lane);  // of a piece

  Piece piece[kPieces];

  template <class Number>
  [[gnu::always_inline]] static Wide load(const Number* from) {
    static_assert(sizeof(Number) == sizeof(Lane));
    Wide result;
    for (std::size_t k = 0; k < kPieces; ++k) {
      result.piece[k] = *reinterpret_cast<const LoosePiece*>(from + k * kLanes);
    }
    return result;
  }
  [[gnu::always_inline]] static Wide all(Lane value) {
    Wide result;
    for (Piece& piece : result.piece) piece = Piece{} + value;
    return result;
  }
  template <class Number>
  [[gnu::always_inline]] void store(Number* to) const {
    for (std::size_t k = 0; k < kPieces; ++k) {
      *reinterpret_cast<LoosePiece*>(to + k * kLanes) = piece[k];
    }
  }
};

// Adds lanes to the numbers that lie there.
template <class Lane, class Number>
[[gnu::always_inline]] inline void add_to(Number* sums, const Wide<Lane>& lanes) {
  for (std::size_t k = 0; k < kPieces; ++k) {
    *reinterpret_cast<typename Wide<Lane>::LoosePiece*>(sums + k * Wide<Lane>::kLanes) +=
        lanes.piece[k];
  }
}

template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator+(Wide<Lane> a, const Wide<Lane>& b) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] += b.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator-(Wide<Lane> a, const Wide<Lane>& b) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] -= b.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator*(Wide<Lane> a, const Wide<Lane>& b) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] *= b.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator-(Wide<Lane> a) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] = -a.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator&(Wide<Lane> a, const Wide<Lane>& b) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] &= b.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator|(Wide<Lane> a, const Wide<Lane>& b) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] |= b.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> operator~(Wide<Lane> a) {
  for (std::size_t k = 0; k < kPieces; ++k) a.piece[k] = ~a.piece[k];
  return a;
}
template <class Lane>
[[gnu::always_inline]] inline Wide<Lane> larger(Wide<Lane> a, const Wide<Lane>& b) {
  for (std::size_t k = 0; k < kPieces; ++k) {
    a.piece[k] = a.piece[k] > b.piece[k] ? a.piece[k] : b.piece[k];
  }
  return a;
}

// Masks: all bits of the lanes for which it is so, in integers as wide.
template <class Lane>
using MaskOf = Wide<std::conditional_t<sizeof(Lane) == 4, std::int32_t, std::int64_t>>;

template <class Lane>
[[gnu::always_inline]] inline MaskOf<Lane> below(const Wide<Lane>& a, const Wide<Lane>& b) {
  MaskOf<Lane> mask;
  for (std::size_t k = 0; k < kPieces; ++k) mask.piece[k] = a.piece[k] < b.piece[k];
  return mask;
}
template <class Lane>
[[gnu::always_inline]] inline MaskOf<Lane> at_most(const Wide<Lane>& a, const Wide<Lane>& b) {
  MaskOf<Lane> mask;
  for (std::size_t k = 0; k < kPieces; ++k) mask.piece[k] = a.piece[k] <= b.piece[k];
  return mask;
}

// A bit for each lane of a mask.
template <class Lane>
[[gnu::always_inline]] inline std::uint32_t bits_of(const Wide<Lane>& mask) {
  constexpr bool kIsLong = sizeof(Lane) == 8;
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < kPieces; ++k) {
    std::uint32_t of_piece = 0;
#if defined(__AVX512DQ__)
    const auto piece = __builtin_bit_cast(__m512i, mask.piece[k]);
    of_piece = kIsLong ? _mm512_movepi64_mask(piece) : _mm512_movepi32_mask(piece);
#elif defined(__AVX2__)
    const auto piece = mask.piece[k];
    of_piece =
        static_cast<std::uint32_t>(kIsLong ? _mm256_movemask_pd(__builtin_bit_cast(__m256d, piece))
                                           : _mm256_movemask_ps(__builtin_bit_cast(__m256, piece)));
#elif defined(__SSE2__)
    const auto piece = mask.piece[k];
    of_piece =
        static_cast<std::uint32_t>(kIsLong ? _mm_movemask_pd(__builtin_bit_cast(__m128d, piece))
                                           : _mm_movemask_ps(__builtin_bit_cast(__m128, piece)));
#else
    for (std::size_t lane = 0; lane < Wide<Lane>::kLanes; ++lane) {
      of_piece |= (mask.piece[k][lane] != 0 ? 1U : 0U) << lane;
    }
#endif
    bits |= of_piece << (k * Wide<Lane>::kLanes);
  }
  return bits;
}

// Whether a mask has any lane.
template <class Lane>
[[gnu::always_inline]] inline bool any(const Wide<Lane>& mask) {
#if defined(__SSE2__)
  return bits_of(mask) != 0;
#else
  using Words [[gnu::vector_size(kPieceBytes)]] = std::uint64_t;
  auto lanes = mask.piece[0];
  for (std::size_t k = 1; k < kPieces; ++k) lanes |= mask.piece[k];
  const auto words = __builtin_bit_cast(Words, lanes);
  return (words[0] | words[1]) != 0;
#endif
}

}  // namespace
}  // namespace beespace::cpu
