// Which of the next 64 bytes are no digits? One bit each: the map by which plain lines are split.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace beespace::io {

inline constexpr std::size_t kDigitMaskBytes = 64;

// Bit i stands for text[i]; all 64 bytes must be readable. This is the definition; it runs where
// there is nothing faster.
inline std::uint64_t non_digit_mask_portable(const char* text) {
  constexpr std::uint64_t kLow = 0x7F7F7F7F7F7F7F7Fu;
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < kDigitMaskBytes; i += 8) {
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, text + i, sizeof bytes);
    const std::uint64_t values = bytes ^ 0x3030303030303030u;
    // 10 ... 127 plus 0x76 reaches the top bit of its byte; larger values have it already.
    const std::uint64_t others =
        (((values & kLow) + 0x7676767676767676u) | values) & 0x8080808080808080u;
    // The eight top bits, moved side by side.
    mask |= ((others * 0x0002040810204081u) >> 56) << i;
  }
  return mask;
}

#if defined(__SSE2__)

inline std::uint64_t non_digit_mask(const char* text) {
  const __m128i zeros = _mm_set1_epi8('0');
  const __m128i ten = _mm_set1_epi8(10);
  std::uint64_t mask = 0;
  for (std::size_t i = 0; i < kDigitMaskBytes; i += 16) {
    const __m128i bytes = _mm_loadu_si128(reinterpret_cast<const __m128i*>(text + i));
    const __m128i values = _mm_xor_si128(bytes, zeros);
    const __m128i others = _mm_cmpeq_epi8(_mm_max_epu8(values, ten), values);
    mask |= std::uint64_t{static_cast<std::uint32_t>(_mm_movemask_epi8(others))} << i;
  }
  return mask;
}

#else

inline std::uint64_t non_digit_mask(const char* text) {
  return non_digit_mask_portable(text);
}

#endif

}  // namespace beespace::io
