// The walk around a leaf with AVX-512. The other walks are those of AVX2: comparing 16 boxes or
// points at once instead of twice 8 was measured to be no faster for them, as memory sets the pace.
#include "kernels/leaf_walk_kernel.hpp"

#include <immintrin.h>

namespace beespace::cpu {

namespace {

class Lanes {
 public:
  Lanes() = default;
  static Lanes load(const float* from) { return Lanes(_mm512_load_ps(from)); }
  static Lanes all(float value) { return Lanes(_mm512_set1_ps(value)); }
  void store(float* to) const { _mm512_store_ps(to, values_); }

  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    return Lanes(_mm512_sub_ps(a.values_, b.values_));
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    return Lanes(_mm512_add_ps(a.values_, b.values_));
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    return Lanes(_mm512_mul_ps(a.values_, b.values_));
  }
  [[nodiscard]] Lanes above_zero() const {
    return Lanes(_mm512_max_ps(values_, _mm512_setzero_ps()));
  }
  [[nodiscard]] Lanes one_where_above(float value) const {
    const __mmask16 above = _mm512_cmp_ps_mask(values_, _mm512_set1_ps(value), _CMP_GT_OQ);
    return Lanes(_mm512_maskz_mov_ps(above, _mm512_set1_ps(1.0F)));
  }
  [[nodiscard]] std::uint32_t at_most(float limit) const {
    return _mm512_cmp_ps_mask(values_, _mm512_set1_ps(limit), _CMP_LE_OQ);
  }
  [[nodiscard]] std::uint32_t below(float limit) const {
    return _mm512_cmp_ps_mask(values_, _mm512_set1_ps(limit), _CMP_LT_OQ);
  }
  // To a register first: some processors compress to memory lane by lane.
  void store_chosen(std::uint32_t lanes, float* to) const {
    _mm512_storeu_ps(to, _mm512_maskz_compress_ps(static_cast<__mmask16>(lanes), values_));
  }
  static void store_chosen_slots(std::uint32_t lanes, std::uint32_t first, std::uint32_t* to) {
    const __m512i slots =
        _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(first)),
                         _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15));
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(static_cast<__mmask16>(lanes), slots));
  }

 private:
  explicit Lanes(__m512 values) : values_(values) {}

  __m512 values_;
};

void find_nearest_of_leaf(const TreeView& tree, std::size_t leaf, std::size_t wanted,
                          LeafNeighbors& found) {
  LeafWalk<Lanes>(tree, leaf, static_cast<unsigned>(wanted), found).run();
}

}  // namespace

FindNearestOfLeaf tree_walk_of_leaf_avx512() {
  return find_nearest_of_leaf;
}

}  // namespace beespace::cpu
