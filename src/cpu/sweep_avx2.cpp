#include "cpu/sweep_kernel.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  static constexpr unsigned kLanes = 8;

  struct Found {
    unsigned near;
    unsigned within;
    unsigned before;
  };

  explicit Lanes(const Limits& limits)
      : near_(_mm256_set1_ps(limits.near)), far_(_mm256_set1_ps(limits.far)) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t first_x) {
    x_ = _mm256_set1_epi32(x);
    y_ = _mm256_set1_epi32(y);
    z_ = _mm256_set1_epi32(z);
    first_x_ = _mm256_set1_epi32(first_x);
  }

  [[nodiscard]] Found look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                           std::uint32_t count) const {
    const unsigned valid = (1U << (count < kLanes ? count : kLanes)) - 1U;
    const __m256i other_x = load(x);
    const __m256 dx = _mm256_cvtepi32_ps(_mm256_sub_epi32(other_x, x_));
    const __m256 dy = _mm256_cvtepi32_ps(_mm256_sub_epi32(load(y), y_));
    const __m256 dz = _mm256_cvtepi32_ps(_mm256_sub_epi32(load(z), z_));
    const __m256 squared = _mm256_add_ps(
        _mm256_mul_ps(dz, dz), _mm256_add_ps(_mm256_mul_ps(dy, dy), _mm256_mul_ps(dx, dx)));
    const unsigned near = bits(_mm256_cmp_ps(squared, near_, _CMP_LT_OQ)) & valid;
    const unsigned within = bits(_mm256_cmp_ps(squared, far_, _CMP_LE_OQ)) & valid;
    const unsigned before =
        bits(_mm256_castsi256_ps(_mm256_cmpgt_epi32(first_x_, other_x))) & valid;
    return {near, within, before};
  }

  static void mark(std::uint8_t* marks, unsigned near) {
    // Byte `lane` keeps bit `lane` of the copies of `near`, which is all that "nonzero" needs.
    const __m128i copies = _mm_set1_epi8(static_cast<char>(near));
    const __m128i chosen = _mm_and_si128(copies, _mm_set1_epi64x(kBitOfLane));
    auto* const place = reinterpret_cast<__m128i*>(marks);
    _mm_storel_epi64(place, _mm_or_si128(_mm_loadl_epi64(place), chosen));
  }

 private:
  static constexpr long long kBitOfLane = static_cast<long long>(0x8040201008040201U);

  static __m256i load(const std::int32_t* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
  static unsigned bits(__m256 mask) { return static_cast<unsigned>(_mm256_movemask_ps(mask)); }

  __m256 near_;
  __m256 far_;
  __m256i x_{};
  __m256i y_{};
  __m256i z_{};
  __m256i first_x_{};
};

}  // namespace

void sweep_avx2(const Positions& positions, const Neighbourhood& neighbourhood,
                const Limits& limits, std::uint8_t* near_marks, std::uint32_t first_mark,
                const Unsure& unsure) {
  sweep<Lanes>(positions, neighbourhood, limits, near_marks, first_mark, unsure);
}

}  // namespace beespace::cpu
