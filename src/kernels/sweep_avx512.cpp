#include "kernels/sweep_kernel.hpp"
#include "kernels/sweep_variants.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  static constexpr unsigned kLanes = 16;
  using Words = __m512i;
  using Floats = __m512;

  struct Seen {
    unsigned near;
    unsigned within;
    unsigned before;
    __mmask16 valid;
    __m512 squared;
  };

  explicit Lanes(const Limits& limits)
      : near_(_mm512_set1_ps(limits.near)), far_(_mm512_set1_ps(limits.far)) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t bound_x) {
    x_ = _mm512_set1_epi32(x);
    y_ = _mm512_set1_epi32(y);
    z_ = _mm512_set1_epi32(z);
    bound_x_ = _mm512_set1_epi32(bound_x);
  }
  void select_block(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                    std::int32_t reach, std::int32_t slice) {
    x_ = _mm512_loadu_si512(x);
    y_ = _mm512_loadu_si512(y);
    z_ = _mm512_loadu_si512(z);
    const __m512i slices = _mm512_set1_epi32(slice);
    const __m512i farthest = _mm512_add_epi32(x_, _mm512_set1_epi32(reach + 1));
    bound_x_ = _mm512_sub_epi32(_mm512_and_si512(farthest, slices), slices);
  }

  [[nodiscard]] Seen look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                          std::uint32_t count) const {
    const auto valid = static_cast<__mmask16>(_bzhi_u32(0xFFFF, count < kLanes ? count : kLanes));
    const __m512i other_x = _mm512_loadu_si512(x);
    Seen seen = compare(other_x, _mm512_loadu_si512(y), _mm512_loadu_si512(z), valid);
    seen.before = _mm512_mask_cmplt_epi32_mask(valid, other_x, bound_x_);
    return seen;
  }
  [[nodiscard]] Seen meet(std::int32_t x, std::int32_t y, std::int32_t z, unsigned lanes) const {
    return compare(_mm512_set1_epi32(x), _mm512_set1_epi32(y), _mm512_set1_epi32(z),
                   static_cast<__mmask16>(lanes));
  }
  [[nodiscard]] Floats squared(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return squared(_mm512_set1_epi32(x), _mm512_set1_epi32(y), _mm512_set1_epi32(z));
  }
  [[nodiscard]] Floats squared(const std::int32_t* x, const std::int32_t* y,
                               const std::int32_t* z) const {
    return squared(_mm512_loadu_si512(x), _mm512_loadu_si512(y), _mm512_loadu_si512(z));
  }
  [[nodiscard]] unsigned reaching(const std::int32_t* x) const {
    return _mm512_cmplt_epi32_mask(_mm512_loadu_si512(x), bound_x_);
  }
  static Floats without(Floats squared, unsigned lane) {
    return _mm512_mask_mov_ps(squared, static_cast<__mmask16>(1U << lane),
                              _mm512_set1_ps(kInfinity));
  }

  class AtSides {
   public:
    explicit AtSides(const SideLimits& limits)
        : in_row_(_mm512_set1_epi32(limits.in_row)),
          flip_y_(_mm512_set1_epi32(limits.flip_y)),
          flip_z_(_mm512_set1_epi32(limits.flip_z)),
          reach_y_(_mm512_set1_epi32(limits.reach_y)),
          reach_z_(_mm512_set1_epi32(limits.reach_z)) {}

    unsigned operator()(const std::int32_t* y, const std::int32_t* z) const {
      const __m512i in_y = _mm512_and_si512(_mm512_loadu_si512(y), in_row_);
      const __m512i in_z = _mm512_and_si512(_mm512_loadu_si512(z), in_row_);
      const __mmask16 at_y = _mm512_cmplt_epi32_mask(_mm512_xor_si512(in_y, flip_y_), reach_y_);
      return _mm512_mask_cmplt_epi32_mask(at_y, _mm512_xor_si512(in_z, flip_z_), reach_z_);
    }

   private:
    __m512i in_row_;
    __m512i flip_y_;
    __m512i flip_z_;
    __m512i reach_y_;
    __m512i reach_z_;
  };
  static unsigned around(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                         const PositionBox& box, float far) {
    const auto beside = [&box](const std::int32_t* from, unsigned axis) {
      const __m512i at = _mm512_loadu_si512(from);
      const __m512i below = _mm512_sub_epi32(_mm512_set1_epi32(box.low[axis]), at);
      const __m512i above = _mm512_sub_epi32(at, _mm512_set1_epi32(box.high[axis]));
      return _mm512_max_epi32(_mm512_max_epi32(below, above), _mm512_setzero_si512());
    };
    return _mm512_cmp_ps_mask(sum_of_squares(beside(x, 0), beside(y, 1), beside(z, 2)),
                              _mm512_set1_ps(far), _CMP_LE_OQ);
  }
  template <class From, class To>
  static void pack(const From* from, unsigned chosen, To* to) {
    _mm512_storeu_si512(
        to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(chosen), _mm512_loadu_si512(from)));
  }
  static void clear(std::int32_t* words) { _mm512_storeu_si512(words, _mm512_setzero_si512()); }
  static void pack_numbers(std::uint32_t first, unsigned chosen, std::uint32_t* to) {
    _mm512_storeu_si512(
        to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(chosen), numbers_from(first)));
  }

  static void add_near(Seen& seen, unsigned lanes) { seen.near |= lanes; }

  static void mark(std::uint8_t* marks, unsigned near) {
    _mm_mask_storeu_epi8(marks, static_cast<__mmask16>(near), _mm_set1_epi8(-1));
  }

  static Words words(const std::uint32_t* from) { return _mm512_loadu_si512(from); }
  static Floats floats(const std::uint32_t* from) { return _mm512_loadu_ps(from); }

  static void store(const PointId* ids, unsigned near, PointId* to) { store(words(ids), near, to); }
  static void store(Words ids, unsigned near, PointId* to) {
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(near), ids));
  }
  static void fill(PointId* to, PointId id) {
    _mm512_storeu_si512(to, _mm512_set1_epi32(static_cast<std::int32_t>(id)));
  }

  static unsigned meeting(Floats squared, const float* radii, const float* others) {
    return at_most(squared, _mm512_add_ps(_mm512_loadu_ps(radii), _mm512_loadu_ps(others)));
  }
  static unsigned meeting(Floats squared, Floats radii, float other) {
    return at_most(squared, _mm512_add_ps(radii, _mm512_set1_ps(other)));
  }

  static void leave_out(Seen& seen, const PointId* ids, PointId id) {
    seen.valid = _mm512_mask_cmpneq_epi32_mask(seen.valid, _mm512_loadu_si512(ids),
                                               _mm512_set1_epi32(static_cast<std::int32_t>(id)));
  }

  class Tally {
   public:
    void clear() { counts_ = _mm512_setzero_si512(); }
    void add(const Seen& seen) {
      counts_ = _mm512_mask_sub_epi32(counts_, static_cast<__mmask16>(seen.near), counts_,
                                      _mm512_set1_epi32(-1));
    }
    void write(std::uint32_t* to) const { _mm512_storeu_si512(to, counts_); }

   private:
    __m512i counts_;
  };

  class Nearest {
   public:
    void clear() {
      best_ = second_ = _mm512_set1_ps(kInfinity);
      who_ = _mm512_setzero_si512();
    }
    void add(const Seen& seen, std::uint32_t from) {
      const __m512 counted =
          _mm512_mask_mov_ps(_mm512_set1_ps(kInfinity), seen.valid, seen.squared);
      who_ = _mm512_mask_mov_epi32(who_, keep_two(counted, best_, second_), numbers_from(from));
    }
    void add_one(Floats squared, std::uint32_t who) {
      who_ = _mm512_mask_mov_epi32(who_, keep_two(squared, best_, second_),
                                   _mm512_set1_epi32(static_cast<std::int32_t>(who)));
    }
    void read(const float* best, const float* second, const std::uint32_t* who) {
      best_ = _mm512_loadu_ps(best);
      second_ = _mm512_loadu_ps(second);
      who_ = _mm512_loadu_si512(who);
    }
    void write_lanes(float* best, float* second, std::uint32_t* who) const {
      _mm512_storeu_ps(best, best_);
      _mm512_storeu_ps(second, second_);
      _mm512_storeu_si512(who, who_);
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
    static __mmask16 keep_two(Floats squared, __m512& best, __m512& second) {
      const __mmask16 nearer = _mm512_cmp_ps_mask(squared, best, _CMP_LT_OQ);
      second = _mm512_min_ps(second, _mm512_max_ps(best, squared));
      best = _mm512_min_ps(best, squared);
      return nearer;
    }

    __m512 best_;
    __m512 second_;
    __m512i who_;
  };

 private:
  static unsigned at_most(Floats squared, __m512 distance) {
    return _mm512_cmp_ps_mask(squared, _mm512_mul_ps(distance, distance), _CMP_LE_OQ);
  }

  static __m512i numbers_from(std::uint32_t first) {
    return _mm512_add_epi32(_mm512_set1_epi32(static_cast<std::int32_t>(first)),
                            _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0));
  }

  [[nodiscard]] Floats squared(__m512i x, __m512i y, __m512i z) const {
    return sum_of_squares(_mm512_sub_epi32(x, x_), _mm512_sub_epi32(y, y_),
                          _mm512_sub_epi32(z, z_));
  }
  static Floats sum_of_squares(__m512i x, __m512i y, __m512i z) {
    const __m512 dx = _mm512_cvtepi32_ps(x);
    const __m512 dy = _mm512_cvtepi32_ps(y);
    const __m512 dz = _mm512_cvtepi32_ps(z);
    return _mm512_fmadd_ps(dz, dz, _mm512_fmadd_ps(dy, dy, _mm512_mul_ps(dx, dx)));
  }
  [[nodiscard]] Seen compare(__m512i x, __m512i y, __m512i z, __mmask16 valid) const {
    const __m512 distances = squared(x, y, z);
    const unsigned near = _mm512_mask_cmp_ps_mask(valid, distances, near_, _CMP_LT_OQ);
    const unsigned within = _mm512_mask_cmp_ps_mask(valid, distances, far_, _CMP_LE_OQ);
    return {near, within, 0, valid, distances};
  }

  __m512 near_;
  __m512 far_;
  __m512i x_{};
  __m512i y_{};
  __m512i z_{};
  __m512i bound_x_{};
};

}  // namespace

constinit const Kernels kAvx512Kernels = kernels_over<Lanes>();

}  // namespace beespace::cpu
