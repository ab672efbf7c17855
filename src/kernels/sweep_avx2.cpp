#include "kernels/sweep_kernel.hpp"
#include "kernels/sweep_variants.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  static constexpr unsigned kLanes = 8;
  using Words = __m256i;
  using Floats = __m256;

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

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t bound_x) {
    x_ = _mm256_set1_epi32(x);
    y_ = _mm256_set1_epi32(y);
    z_ = _mm256_set1_epi32(z);
    bound_x_ = _mm256_set1_epi32(bound_x);
  }
  void select_block(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                    std::int32_t reach, std::int32_t slice) {
    x_ = load(x);
    y_ = load(y);
    z_ = load(z);
    const __m256i slices = _mm256_set1_epi32(slice);
    const __m256i farthest = _mm256_add_epi32(x_, _mm256_set1_epi32(reach + 1));
    bound_x_ = _mm256_sub_epi32(_mm256_and_si256(farthest, slices), slices);
  }

  [[nodiscard]] Seen look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                          std::uint32_t count) const {
    const auto counting = static_cast<std::int32_t>(count < kLanes ? count : kLanes);
    const __m256i valid = _mm256_cmpgt_epi32(_mm256_set1_epi32(counting), numbers_from(0));
    const __m256i other_x = load(x);
    Seen seen = compare(other_x, load(y), load(z), valid);
    seen.before = bits(_mm256_and_si256(_mm256_cmpgt_epi32(bound_x_, other_x), valid));
    return seen;
  }
  [[nodiscard]] Seen meet(std::int32_t x, std::int32_t y, std::int32_t z, unsigned lanes) const {
    return compare(_mm256_set1_epi32(x), _mm256_set1_epi32(y), _mm256_set1_epi32(z),
                   with_bits(lanes));
  }
  [[nodiscard]] Floats squared(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return squared(_mm256_set1_epi32(x), _mm256_set1_epi32(y), _mm256_set1_epi32(z));
  }
  [[nodiscard]] Floats squared(const std::int32_t* x, const std::int32_t* y,
                               const std::int32_t* z) const {
    return squared(load(x), load(y), load(z));
  }
  [[nodiscard]] unsigned reaching(const std::int32_t* x) const {
    return bits(_mm256_cmpgt_epi32(bound_x_, load(x)));
  }
  static Floats without(Floats squared, unsigned lane) {
    return _mm256_blendv_ps(squared, _mm256_set1_ps(kInfinity),
                            _mm256_castsi256_ps(with_bits(1U << lane)));
  }

  class AtSides {
   public:
    explicit AtSides(const SideLimits& limits)
        : in_row_(_mm256_set1_epi32(limits.in_row)),
          flip_y_(_mm256_set1_epi32(limits.flip_y)),
          flip_z_(_mm256_set1_epi32(limits.flip_z)),
          reach_y_(_mm256_set1_epi32(limits.reach_y)),
          reach_z_(_mm256_set1_epi32(limits.reach_z)) {}

    unsigned operator()(const std::int32_t* y, const std::int32_t* z) const {
      const __m256i from_y = _mm256_xor_si256(_mm256_and_si256(load(y), in_row_), flip_y_);
      const __m256i from_z = _mm256_xor_si256(_mm256_and_si256(load(z), in_row_), flip_z_);
      return bits(_mm256_and_si256(_mm256_cmpgt_epi32(reach_y_, from_y),
                                   _mm256_cmpgt_epi32(reach_z_, from_z)));
    }

   private:
    __m256i in_row_;
    __m256i flip_y_;
    __m256i flip_z_;
    __m256i reach_y_;
    __m256i reach_z_;
  };
  static unsigned around(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                         const PositionBox& box, float far) {
    const auto beside = [&box](__m256i at, unsigned axis) {
      const __m256i below = _mm256_sub_epi32(_mm256_set1_epi32(box.low[axis]), at);
      const __m256i above = _mm256_sub_epi32(at, _mm256_set1_epi32(box.high[axis]));
      return _mm256_max_epi32(_mm256_max_epi32(below, above), _mm256_setzero_si256());
    };
    const __m256 squared =
        sum_of_squares(beside(load(x), 0), beside(load(y), 1), beside(load(z), 2));
    return static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_cmp_ps(squared, _mm256_set1_ps(far), _CMP_LE_OQ)));
  }
  template <class From, class To>
  static void pack(const From* from, unsigned chosen, To* to) {
    store(to, _mm256_permutevar8x32_epi32(load(from), chosen_first(chosen)));
  }
  static void clear(std::int32_t* words) { store(words, _mm256_setzero_si256()); }
  static void pack_numbers(std::uint32_t first, unsigned chosen, std::uint32_t* to) {
    store(to, _mm256_permutevar8x32_epi32(numbers_from(first), chosen_first(chosen)));
  }

  static void add_near(Seen& seen, unsigned lanes) {
    seen.near |= lanes;
    seen.near_lanes = _mm256_or_si256(seen.near_lanes, with_bits(lanes));
  }

  static void mark(std::uint8_t* marks, unsigned near) {
    // Byte `lane` keeps bit `lane` of the copies of `near`, which is all that "nonzero" needs.
    const __m128i copies = _mm_set1_epi8(static_cast<char>(near));
    const __m128i chosen = _mm_and_si128(copies, _mm_set1_epi64x(kBitOfLane));
    auto* const place = reinterpret_cast<__m128i*>(marks);
    _mm_storel_epi64(place, _mm_or_si128(_mm_loadl_epi64(place), chosen));
  }

  static Words words(const std::uint32_t* from) { return load(from); }
  static Floats floats(const std::uint32_t* from) { return _mm256_castsi256_ps(load(from)); }

  static void store(const PointId* ids, unsigned near, PointId* to) { store(load(ids), near, to); }
  static void store(Words ids, unsigned near, PointId* to) {
    store(to, _mm256_permutevar8x32_epi32(ids, chosen_first(near)));
  }
  static void fill(PointId* to, PointId id) {
    store(to, _mm256_set1_epi32(static_cast<std::int32_t>(id)));
  }

  static unsigned meeting(Floats squared, const float* radii, const float* others) {
    return at_most(squared, _mm256_add_ps(_mm256_loadu_ps(radii), _mm256_loadu_ps(others)));
  }
  static unsigned meeting(Floats squared, Floats radii, float other) {
    return at_most(squared, _mm256_add_ps(radii, _mm256_set1_ps(other)));
  }

  static void leave_out(Seen& seen, const PointId* ids, PointId id) {
    const __m256i out =
        _mm256_cmpeq_epi32(load(ids), _mm256_set1_epi32(static_cast<std::int32_t>(id)));
    seen.valid = _mm256_andnot_si256(out, seen.valid);
  }

  class Tally {
   public:
    void clear() { counts_ = _mm256_setzero_si256(); }
    void add(const Seen& seen) { counts_ = _mm256_sub_epi32(counts_, seen.near_lanes); }
    void write(std::uint32_t* to) const { store(to, counts_); }

   private:
    __m256i counts_;
  };

  class Nearest {
   public:
    void clear() {
      best_ = second_ = _mm256_set1_ps(kInfinity);
      who_ = _mm256_setzero_si256();
    }
    void add(const Seen& seen, std::uint32_t from) {
      const __m256 far = _mm256_set1_ps(kInfinity);
      const __m256 counted = _mm256_blendv_ps(far, seen.squared, _mm256_castsi256_ps(seen.valid));
      who_ = _mm256_blendv_epi8(who_, numbers_from(from), keep_two(counted, best_, second_));
    }
    void add_one(Floats squared, std::uint32_t who) {
      who_ = _mm256_blendv_epi8(who_, _mm256_set1_epi32(static_cast<std::int32_t>(who)),
                                keep_two(squared, best_, second_));
    }
    void read(const float* best, const float* second, const std::uint32_t* who) {
      best_ = _mm256_loadu_ps(best);
      second_ = _mm256_loadu_ps(second);
      who_ = load(who);
    }
    void write_lanes(float* best, float* second, std::uint32_t* who) const {
      _mm256_storeu_ps(best, best_);
      _mm256_storeu_ps(second, second_);
      store(who, who_);
    }
    void write(float& best, float& second, std::uint32_t& who) const {
      float bests[kLanes];
      float seconds[kLanes];
      std::uint32_t whos[kLanes];
      write_lanes(bests, seconds, whos);
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
    static __m256i keep_two(Floats squared, __m256& best, __m256& second) {
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
  static unsigned at_most(Floats squared, __m256 distance) {
    return static_cast<unsigned>(
        _mm256_movemask_ps(_mm256_cmp_ps(squared, _mm256_mul_ps(distance, distance), _CMP_LE_OQ)));
  }

  static constexpr long long kBitOfLane = static_cast<long long>(0x8040201008040201U);

  static __m256i numbers_from(std::uint32_t first) {
    return _mm256_add_epi32(_mm256_set1_epi32(static_cast<std::int32_t>(first)),
                            _mm256_set_epi32(7, 6, 5, 4, 3, 2, 1, 0));
  }
  // All ones in the lanes whose bits are set.
  static __m256i with_bits(unsigned lanes) {
    const __m256i bit = _mm256_set_epi32(128, 64, 32, 16, 8, 4, 2, 1);
    const __m256i copies = _mm256_set1_epi32(static_cast<std::int32_t>(lanes));
    return _mm256_cmpeq_epi32(_mm256_and_si256(copies, bit), bit);
  }
  // For a permutation: the lanes whose bits are set, in order; then any.
  static __m256i chosen_first(unsigned chosen) {
    const auto lanes = static_cast<long long>(kChosenFirst.lanes[chosen]);
    return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(lanes));
  }
  struct ChosenFirst {
    std::uint64_t lanes[256];  // a byte each
  };
  static constexpr ChosenFirst kChosenFirst = [] {
    ChosenFirst all{};
    for (unsigned chosen = 0; chosen < 256; ++chosen) {
      unsigned place = 0;
      for (unsigned lane = 0; lane < 8; ++lane) {
        if ((chosen >> lane & 1U) != 0) {
          all.lanes[chosen] |= std::uint64_t{lane} << (8 * place++);
        }
      }
    }
    return all;
  }();

  [[nodiscard]] Floats squared(__m256i x, __m256i y, __m256i z) const {
    return sum_of_squares(_mm256_sub_epi32(x, x_), _mm256_sub_epi32(y, y_),
                          _mm256_sub_epi32(z, z_));
  }
  static Floats sum_of_squares(__m256i x, __m256i y, __m256i z) {
    const __m256 dx = _mm256_cvtepi32_ps(x);
    const __m256 dy = _mm256_cvtepi32_ps(y);
    const __m256 dz = _mm256_cvtepi32_ps(z);
    return _mm256_add_ps(_mm256_mul_ps(dz, dz),
                         _mm256_add_ps(_mm256_mul_ps(dy, dy), _mm256_mul_ps(dx, dx)));
  }
  [[nodiscard]] Seen compare(__m256i x, __m256i y, __m256i z, __m256i valid) const {
    const __m256 distances = squared(x, y, z);
    const __m256i near =
        _mm256_and_si256(_mm256_castps_si256(_mm256_cmp_ps(distances, near_, _CMP_LT_OQ)), valid);
    const __m256i within =
        _mm256_and_si256(_mm256_castps_si256(_mm256_cmp_ps(distances, far_, _CMP_LE_OQ)), valid);
    return {bits(near), bits(within), 0, near, valid, distances};
  }
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
  __m256i bound_x_{};
};

}  // namespace

constinit const Kernels kAvx2Kernels = kernels_over<Lanes>();

}  // namespace beespace::cpu
