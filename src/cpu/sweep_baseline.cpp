// The kernel for every processor: GNU vectors of four lanes, which are SSE2 on x86-64 and NEON on
// ARM64.
#include "cpu/sweep_kernel.hpp"

#include <bit>
#include <cstring>

namespace beespace::cpu {

namespace {

class Lanes {
  using Ints [[gnu::vector_size(16)]] = std::int32_t;
  using Floats [[gnu::vector_size(16)]] = float;

 public:
  static constexpr unsigned kLanes = 4;

  struct Found {
    unsigned near;
    unsigned within;
    unsigned before;
  };

  explicit Lanes(const Limits& limits) : near_(limits.near), far_(limits.far) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t first_x) {
    x_ = x;
    y_ = y;
    z_ = z;
    first_x_ = first_x;
  }

  [[nodiscard]] Found look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                           std::uint32_t count) const {
    const unsigned valid = (1U << (count < kLanes ? count : kLanes)) - 1U;
    const Ints other_x = load(x);
    const Floats dx = __builtin_convertvector(other_x - x_, Floats);
    const Floats dy = __builtin_convertvector(load(y) - y_, Floats);
    const Floats dz = __builtin_convertvector(load(z) - z_, Floats);
    const Floats squared = dx * dx + dy * dy + dz * dz;
    const unsigned near = bits(squared < near_) & valid;
    const unsigned within = bits(squared <= far_) & valid;
    return {near, within, bits(other_x < first_x_) & valid};
  }

  static void mark(std::uint8_t* marks, unsigned near) {
    static_assert(std::endian::native == std::endian::little);
    // Byte `lane` keeps bit `lane` of the copies of `near`, which is all that "nonzero" needs.
    std::uint32_t old = 0;
    std::memcpy(&old, marks, sizeof old);
    old |= (near * 0x01010101U) & 0x08040201U;
    std::memcpy(marks, &old, sizeof old);
  }

 private:
  static Ints load(const std::int32_t* from) {
    Ints loaded;
    std::memcpy(&loaded, from, sizeof loaded);
    return loaded;
  }
  static unsigned bits(const Ints& mask) {
    return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
  }

  float near_;
  float far_;
  std::int32_t x_ = 0;
  std::int32_t y_ = 0;
  std::int32_t z_ = 0;
  std::int32_t first_x_ = 0;
};

}  // namespace

void sweep_baseline(const Positions& positions, const Neighbourhood& neighbourhood,
                    const Limits& limits, std::uint8_t* near_marks, std::uint32_t first_mark,
                    const Unsure& unsure) {
  sweep<Lanes>(positions, neighbourhood, limits, near_marks, first_mark, unsure);
}

}  // namespace beespace::cpu
