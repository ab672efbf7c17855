#include "cpu/sweep_kernel.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  static constexpr unsigned kLanes = 16;

  struct Found {
    unsigned near;
    unsigned within;
    unsigned before;
  };

  explicit Lanes(const Limits& limits)
      : near_(_mm512_set1_ps(limits.near)), far_(_mm512_set1_ps(limits.far)) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t first_x) {
    x_ = _mm512_set1_epi32(x);
    y_ = _mm512_set1_epi32(y);
    z_ = _mm512_set1_epi32(z);
    first_x_ = _mm512_set1_epi32(first_x);
  }

  [[nodiscard]] Found look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                           std::uint32_t count) const {
    const auto valid = static_cast<__mmask16>(_bzhi_u32(0xFFFF, count < kLanes ? count : kLanes));
    const __m512i other_x = _mm512_loadu_si512(x);
    const __m512 dx = _mm512_cvtepi32_ps(_mm512_sub_epi32(other_x, x_));
    const __m512 dy = _mm512_cvtepi32_ps(_mm512_sub_epi32(_mm512_loadu_si512(y), y_));
    const __m512 dz = _mm512_cvtepi32_ps(_mm512_sub_epi32(_mm512_loadu_si512(z), z_));
    const __m512 squared = _mm512_fmadd_ps(dz, dz, _mm512_fmadd_ps(dy, dy, _mm512_mul_ps(dx, dx)));
    const unsigned near = _mm512_mask_cmp_ps_mask(valid, squared, near_, _CMP_LT_OQ);
    const unsigned within = _mm512_mask_cmp_ps_mask(valid, squared, far_, _CMP_LE_OQ);
    const unsigned before = _mm512_mask_cmplt_epi32_mask(valid, other_x, first_x_);
    return {near, within, before};
  }

  static void mark(std::uint8_t* marks, unsigned near) {
    _mm_mask_storeu_epi8(marks, static_cast<__mmask16>(near), _mm_set1_epi8(-1));
  }

 private:
  __m512 near_;
  __m512 far_;
  __m512i x_{};
  __m512i y_{};
  __m512i z_{};
  __m512i first_x_{};
};

}  // namespace

void sweep_avx512(const Positions& positions, const Neighbourhood& neighbourhood,
                  const Limits& limits, std::uint8_t* near_marks, std::uint32_t first_mark,
                  const Unsure& unsure) {
  sweep<Lanes>(positions, neighbourhood, limits, near_marks, first_mark, unsure);
}

}  // namespace beespace::cpu
