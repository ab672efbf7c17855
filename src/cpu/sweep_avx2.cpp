#include "cpu/sweep_kernel.hpp"
#include "cpu/sweep_variants.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  static constexpr unsigned kLanes = 8;

  struct Seen {
    unsigned near;
    unsigned within;
    unsigned before;
    __m256i near_lanes;  // all ones where near
    __m256i valid;
    __m256 squared;
  };

  explicit Lanes(const Limits& limits)
      : near_(_mm256_set1_ps(limits.near)), far_(_mm256_set1_ps(limits.far)) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t first_x) {
    x_ = _mm256_set1_epi32(x);
    y_ = _mm256_set1_epi32(y);
    z_ = _mm256_set1_epi32(z);
    first_x_ = _mm256_set1_epi32(first_x);
  }

  [[nodiscard]] Seen look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                          std::uint32_t count) const {
    const auto counting = static_cast<std::int32_t>(count < kLanes ? count : kLanes);
    const __m256i valid = _mm256_cmpgt_epi32(_mm256_set1_epi32(counting), numbers());
    const __m256i other_x = load(x);
    const __m256 dx = _mm256_cvtepi32_ps(_mm256_sub_epi32(other_x, x_));
    const __m256 dy = _mm256_cvtepi32_ps(_mm256_sub_epi32(load(y), y_));
    const __m256 dz = _mm256_cvtepi32_ps(_mm256_sub_epi32(load(z), z_));
    const __m256 squared = _mm256_add_ps(
        _mm256_mul_ps(dz, dz), _mm256_add_ps(_mm256_mul_ps(dy, dy), _mm256_mul_ps(dx, dx)));
    const __m256i near =
        _mm256_and_si256(_mm256_castps_si256(_mm256_cmp_ps(squared, near_, _CMP_LT_OQ)), valid);
    const __m256i within =
        _mm256_and_si256(_mm256_castps_si256(_mm256_cmp_ps(squared, far_, _CMP_LE_OQ)), valid);
    const __m256i before = _mm256_and_si256(_mm256_cmpgt_epi32(first_x_, other_x), valid);
    return {bits(near), bits(within), bits(before), near, valid, squared};
  }

  static void mark(std::uint8_t* marks, const Seen& seen) {
    // Byte `lane` keeps bit `lane` of the copies of `near`, which is all that "nonzero" needs.
    const __m128i copies = _mm_set1_epi8(static_cast<char>(seen.near));
    const __m128i chosen = _mm_and_si128(copies, _mm_set1_epi64x(kBitOfLane));
    auto* const place = reinterpret_cast<__m128i*>(marks);
    _mm_storel_epi64(place, _mm_or_si128(_mm_loadl_epi64(place), chosen));
  }

  static void count(std::uint32_t* counts, const Seen& seen) {
    store(counts, _mm256_sub_epi32(load(counts), seen.near_lanes));
  }

  static void store(const PointId* ids, const Seen& seen, PointId* to) {
    for (unsigned near = seen.near; near != 0; near &= near - 1) {
      *to++ = ids[__builtin_ctz(near)];
    }
  }
  static void fill(PointId* to, PointId id) {
    store(to, _mm256_set1_epi32(static_cast<std::int32_t>(id)));
  }

  static void leave_out(Seen& seen, const PointId* ids, PointId id) {
    const __m256i out =
        _mm256_cmpeq_epi32(load(ids), _mm256_set1_epi32(static_cast<std::int32_t>(id)));
    seen.valid = _mm256_andnot_si256(out, seen.valid);
  }

  class Nearest {
   public:
    void clear() {
      best_ = second_ = _mm256_set1_ps(kInfinity);
      who_ = _mm256_setzero_si256();
    }
    void add(const Seen& seen, std::uint32_t from) {
      const __m256i lane =
          _mm256_add_epi32(_mm256_set1_epi32(static_cast<std::int32_t>(from)), numbers());
      who_ = _mm256_blendv_epi8(who_, lane, keep_two(seen, best_, second_));
    }
    void write(float& best, float& second, std::uint32_t& who) const {
      float bests[kLanes];
      float seconds[kLanes];
      std::uint32_t whos[kLanes];
      _mm256_storeu_ps(bests, best_);
      _mm256_storeu_ps(seconds, second_);
      store(whos, who_);
      best = second = kInfinity;
      for (unsigned lane = 0; lane < kLanes; ++lane) {
        if (bests[lane] < best) {
          second = best < seconds[lane] ? best : seconds[lane];
          best = bests[lane];
          who = whos[lane];
        } else if (bests[lane] < second) {
          second = bests[lane];
        }
      }
    }

   private:
    static __m256i keep_two(const Seen& seen, __m256& best, __m256& second) {
      const __m256 far = _mm256_set1_ps(kInfinity);
      const __m256 squared = _mm256_blendv_ps(far, seen.squared, _mm256_castsi256_ps(seen.valid));
      const __m256 nearer = _mm256_cmp_ps(squared, best, _CMP_LT_OQ);
      second = _mm256_min_ps(second, _mm256_max_ps(best, squared));
      best = _mm256_min_ps(best, squared);
      return _mm256_castps_si256(nearer);
    }

    __m256 best_;
    __m256 second_;
    __m256i who_;
  };

 private:
  static constexpr long long kBitOfLane = static_cast<long long>(0x8040201008040201U);

  static __m256i numbers() { return _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0); }
  template <class Word>
  static __m256i load(const Word* from) {
    return _mm256_loadu_si256(reinterpret_cast<const __m256i*>(from));
  }
  template <class Word>
  static void store(Word* to, __m256i words) {
    _mm256_storeu_si256(reinterpret_cast<__m256i*>(to), words);
  }
  static unsigned bits(__m256i lanes) {
    return static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(lanes)));
  }

  __m256 near_;
  __m256 far_;
  __m256i x_{};
  __m256i y_{};
  __m256i z_{};
  __m256i first_x_{};
};

}  // namespace

constinit const Kernels kAvx2Kernels = kernels_over<Lanes>();

}  // namespace beespace::cpu
