// The walks for every processor: GNU vectors of four lanes, which are SSE2 on x86-64 and NEON on
// ARM64.
#include "kernels/leaf_walk_kernel.hpp"
#include "kernels/tree_walk_kernel.hpp"

#include <cstring>

namespace beespace::cpu {

namespace {

using Floats [[gnu::vector_size(16)]] = float;
using Masks [[gnu::vector_size(16)]] = std::int32_t;

class Lanes {
  static constexpr unsigned kParts = kFanOut / 4;

 public:
  Lanes() = default;
  static Lanes load(const float* from) {
    Lanes loaded;
    std::memcpy(loaded.parts_, from, sizeof loaded.parts_);
    return loaded;
  }
  static Lanes all(float value) {
    Lanes same;
    for (Floats& part : same.parts_) part = Floats{value, value, value, value};
    return same;
  }
  void store(float* to) const { std::memcpy(to, parts_, sizeof parts_); }

  friend Lanes operator-(const Lanes& a, const Lanes& b) {
    Lanes difference;
    for (unsigned k = 0; k < kParts; ++k) difference.parts_[k] = a.parts_[k] - b.parts_[k];
    return difference;
  }
  friend Lanes operator+(const Lanes& a, const Lanes& b) {
    Lanes sum;
    for (unsigned k = 0; k < kParts; ++k) sum.parts_[k] = a.parts_[k] + b.parts_[k];
    return sum;
  }
  friend Lanes operator*(const Lanes& a, const Lanes& b) {
    Lanes product;
    for (unsigned k = 0; k < kParts; ++k) product.parts_[k] = a.parts_[k] * b.parts_[k];
    return product;
  }
  [[nodiscard]] Lanes above_zero() const {
    Lanes above;
    for (unsigned k = 0; k < kParts; ++k) {
      // The bits of the values where they are above zero, and no bit elsewhere.
      Masks value;
      std::memcpy(&value, &parts_[k], sizeof value);
      value &= parts_[k] > 0.0F;
      std::memcpy(&above.parts_[k], &value, sizeof value);
    }
    return above;
  }
  [[nodiscard]] Lanes between(const Lanes& low, const Lanes& high) const {
    Lanes within;
    for (unsigned k = 0; k < kParts; ++k) {
      for (unsigned lane = 0; lane < 4; ++lane) {
        float value = parts_[k][lane];
        if (value < low.parts_[k][lane]) value = low.parts_[k][lane];
        if (value > high.parts_[k][lane]) value = high.parts_[k][lane];
        within.parts_[k][lane] = value;
      }
    }
    return within;
  }
  [[nodiscard]] Lanes one_where_above(float value) const {
    Lanes ones;
    for (unsigned k = 0; k < kParts; ++k) {
      const Masks above = parts_[k] > value;
      const Floats one{1.0F, 1.0F, 1.0F, 1.0F};
      Masks bits;
      std::memcpy(&bits, &one, sizeof bits);
      bits &= above;
      std::memcpy(&ones.parts_[k], &bits, sizeof bits);
    }
    return ones;
  }
  [[nodiscard]] std::uint32_t at_most(float limit) const {
    return bits([&](const Floats& part) -> Masks { return part <= limit; });
  }
  [[nodiscard]] std::uint32_t below(float limit) const {
    return bits([&](const Floats& part) -> Masks { return part < limit; });
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
  // Every lane brings a bit of its own, so that adding them up keeps them apart.
  template <class Compare>
  [[gnu::always_inline]] std::uint32_t bits(const Compare& compare) const {
    const Masks lane{1, 2, 4, 8};
    Masks found{};
    for (unsigned k = 0; k < kParts; ++k) found |= compare(parts_[k]) & (lane << (4 * k));
    return static_cast<std::uint32_t>((found[0] | found[1]) | (found[2] | found[3]));
  }

  Floats parts_[kParts];
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

TreeWalks tree_walks_baseline() {
  return {collect, find_nearest, find_nearest_of_leaf};
}

}  // namespace beespace::cpu
