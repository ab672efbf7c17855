#include "kernels/leaf_walk_kernel.hpp"
#include "kernels/tree_walk_kernel.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  Lanes() = default;
  static Lanes load(const float* from) { return {_mm256_load_ps(from), _mm256_load_ps(from + 8)}; }
  static Lanes all(float value) {
    const __m256 values = _mm256_set1_ps(value);
    return {values, values};
  }
  void store(float* to) const {
    _mm256_store_ps(to, low_);
    _mm256_store_ps(to + 8, high_);
  }

  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return {_mm256_sub_ps(a.low_, b.low_), _mm256_sub_ps(a.high_, b.high_)};
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return {_mm256_add_ps(a.low_, b.low_), _mm256_add_ps(a.high_, b.high_)};
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return {_mm256_mul_ps(a.low_, b.low_), _mm256_mul_ps(a.high_, b.high_)};
  }
  [[nodiscard]] Lanes above_zero() const {
    const __m256 zero = _mm256_setzero_ps();
    return {_mm256_max_ps(low_, zero), _mm256_max_ps(high_, zero)};
  }
  [[nodiscard]] Lanes between(const Lanes& low, const Lanes& high) const {
    return {_mm256_min_ps(_mm256_max_ps(low_, low.low_), high.low_),
            _mm256_min_ps(_mm256_max_ps(high_, low.high_), high.high_)};
  }
  [[nodiscard]] Lanes one_where_above(float value) const {
    const __m256 values = _mm256_set1_ps(value);
    const __m256 one = _mm256_set1_ps(1.0F);
    return {_mm256_and_ps(_mm256_cmp_ps(low_, values, _CMP_GT_OQ), one),
            _mm256_and_ps(_mm256_cmp_ps(high_, values, _CMP_GT_OQ), one)};
  }
  [[nodiscard]] std::uint32_t at_most(float limit) const {
    const __m256 limits = _mm256_set1_ps(limit);
    return bits(_mm256_cmp_ps(low_, limits, _CMP_LE_OQ), _mm256_cmp_ps(high_, limits, _CMP_LE_OQ));
  }
  [[nodiscard]] std::uint32_t below(float limit) const {
    const __m256 limits = _mm256_set1_ps(limit);
    return bits(_mm256_cmp_ps(low_, limits, _CMP_LT_OQ), _mm256_cmp_ps(high_, limits, _CMP_LT_OQ));
  }

  void store_chosen(std::uint32_t lanes, float* to) const {
    alignas(64) float values[kFanOut];
    store(values);
    for (; lanes != 0; lanes &= lanes - 1) *to++ = values[first_bit(lanes)];
  }
  static void store_chosen_slots(std::uint32_t lanes, std::uint32_t first, std::uint32_t* to) {
    for (; lanes != 0; lanes &= lanes - 1) *to++ = first + first_bit(lanes);
  }

 private:
  Lanes(__m256 low, __m256 high) : low_(low), high_(high) {}

  static std::uint32_t bits(__m256 low, __m256 high) {
    return static_cast<std::uint32_t>(_mm256_movemask_ps(low)) |
           static_cast<std::uint32_t>(_mm256_movemask_ps(high)) << 8;
  }

  __m256 low_;
  __m256 high_;
};

void collect(const TreeView& tree, const Ball& ball, IdSink& sink) {
  collect_around<Lanes>(tree, ball, sink);
}

void find_nearest(const TreeView& tree, const Point& place, core::NearestList& list) {
  nearest_around<Lanes>(tree, place, list);
}

void find_nearest_of_leaf(const TreeView& tree, std::size_t leaf, std::size_t wanted,
                          LeafNeighbors& found) {
  LeafWalk<Lanes>(tree, leaf, static_cast<unsigned>(wanted), found).run();
}

}  // namespace

TreeWalks tree_walks_avx2() {
  return {collect, find_nearest, find_nearest_of_leaf};
}

}  // namespace beespace::cpu
