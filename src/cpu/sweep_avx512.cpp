#include "cpu/sweep_kernel.hpp"
#include "cpu/sweep_variants.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  static constexpr unsigned kLanes = 16;

  struct Seen {
    unsigned near;
    unsigned within;
    unsigned before;
    __mmask16 valid;
    __m512 squared;
  };

  explicit Lanes(const Limits& limits)
      : near_(_mm512_set1_ps(limits.near)), far_(_mm512_set1_ps(limits.far)) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t first_x) {
    x_ = _mm512_set1_epi32(x);
    y_ = _mm512_set1_epi32(y);
    z_ = _mm512_set1_epi32(z);
    first_x_ = _mm512_set1_epi32(first_x);
  }

  [[nodiscard]] Seen look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
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
    return {near, within, before, valid, squared};
  }

  static void mark(std::uint8_t* marks, const Seen& seen) {
    _mm_mask_storeu_epi8(marks, static_cast<__mmask16>(seen.near), _mm_set1_epi8(-1));
  }

  static void count(std::uint32_t* counts, const Seen& seen) {
    const __m512i before = _mm512_loadu_si512(counts);
    _mm512_storeu_si512(counts, _mm512_mask_sub_epi32(before, static_cast<__mmask16>(seen.near),
                                                      before, _mm512_set1_epi32(-1)));
  }

  static void store(const PointId* ids, const Seen& seen, PointId* to) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(seen.near),
                                                        _mm512_loadu_si512(ids)));
  }
  static void fill(PointId* to, PointId id) {
    _mm512_storeu_si512(to, _mm512_set1_epi32(static_cast<std::int32_t>(id)));
  }

  static void leave_out(Seen& seen, const PointId* ids, PointId id) {
    seen.valid = _mm512_mask_cmpneq_epi32_mask(seen.valid, _mm512_loadu_si512(ids),
                                               _mm512_set1_epi32(static_cast<std::int32_t>(id)));
  }

  class Nearest {
   public:
    void clear() {
      best_ = second_ = _mm512_set1_ps(kInfinity);
      who_ = _mm512_setzero_si512();
    }
    void add(const Seen& seen, std::uint32_t from) {
      const __m512i lane =
          _mm512_add_epi32(_mm512_set1_epi32(static_cast<std::int32_t>(from)), numbers());
      who_ = _mm512_mask_mov_epi32(who_, keep_two(seen, best_, second_), lane);
    }
    void write(float& best, float& second, std::uint32_t& who) const {
      best = _mm512_reduce_min_ps(best_);
      const auto holds = _mm512_cmp_ps_mask(best_, _mm512_set1_ps(best), _CMP_EQ_OQ);
      const auto lane = static_cast<__mmask16>(holds & -holds);
      second = _mm512_reduce_min_ps(_mm512_mask_mov_ps(best_, lane, second_));
      who = static_cast<std::uint32_t>(
          _mm_cvtsi128_si32(_mm512_castsi512_si128(_mm512_maskz_compress_epi32(lane, who_))));
    }

   private:
    static __m512i numbers() {
      return _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    }
    static __mmask16 keep_two(const Seen& seen, __m512& best, __m512& second) {
      const __mmask16 nearer = _mm512_mask_cmp_ps_mask(seen.valid, seen.squared, best, _CMP_LT_OQ);
      second = _mm512_mask_min_ps(second, seen.valid, second, _mm512_max_ps(best, seen.squared));
      best = _mm512_mask_mov_ps(best, nearer, seen.squared);
      return nearer;
    }

    __m512 best_;
    __m512 second_;
    __m512i who_;
  };

 private:
  __m512 near_;
  __m512 far_;
  __m512i x_{};
  __m512i y_{};
  __m512i z_{};
  __m512i first_x_{};
};

}  // namespace

constinit const Kernels kAvx512Kernels = kernels_over<Lanes>();

}  // namespace beespace::cpu
