// The kernels for every processor: GNU vectors of four lanes, which are SSE2 on x86-64 and NEON on
// ARM64.
#include "cpu/sweep_kernel.hpp"
#include "cpu/sweep_variants.hpp"

#include <bit>
#include <cstring>

namespace beespace::cpu {

namespace {

class Lanes {
  using Ints [[gnu::vector_size(16)]] = std::int32_t;
  using Floats [[gnu::vector_size(16)]] = float;

 public:
  static constexpr unsigned kLanes = 4;

  struct Seen {
    unsigned near;
    unsigned within;
    unsigned before;
    Ints near_lanes;  // all ones where near
    Ints valid;
    Floats squared;
  };

  explicit Lanes(const Limits& limits) : near_(limits.near), far_(limits.far) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t first_x) {
    x_ = x;
    y_ = y;
    z_ = z;
    first_x_ = first_x;
  }

  [[nodiscard]] Seen look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                          std::uint32_t count) const {
    const auto counting = static_cast<std::int32_t>(count < kLanes ? count : kLanes);
    const Ints valid = kNumbers < counting;
    const Ints other_x = load<Ints>(x);
    const Floats dx = __builtin_convertvector(other_x - x_, Floats);
    const Floats dy = __builtin_convertvector(load<Ints>(y) - y_, Floats);
    const Floats dz = __builtin_convertvector(load<Ints>(z) - z_, Floats);
    const Floats squared = dx * dx + dy * dy + dz * dz;
    const Ints near = (squared < near_) & valid;
    const Ints within = (squared <= far_) & valid;
    return {bits(near), bits(within), bits((other_x < first_x_) & valid), near, valid, squared};
  }

  static void mark(std::uint8_t* marks, const Seen& seen) {
    static_assert(std::endian::native == std::endian::little);
    // Byte `lane` keeps bit `lane` of the copies of `near`, which is all that "nonzero" needs.
    auto old = load<std::uint32_t>(marks);
    old |= (seen.near * 0x01010101U) & 0x08040201U;
    store(marks, old);
  }

  static void count(std::uint32_t* counts, const Seen& seen) {
    store(counts, load<Ints>(counts) - seen.near_lanes);
  }

  static void store(const PointId* ids, const Seen& seen, PointId* to) {
    for (unsigned near = seen.near; near != 0; near &= near - 1) {
      *to++ = ids[__builtin_ctz(near)];
    }
  }
  static void fill(PointId* to, PointId id) {
    for (unsigned lane = 0; lane < kLanes; ++lane) to[lane] = id;
  }

  static void leave_out(Seen& seen, const PointId* ids, PointId id) {
    seen.valid &= load<Ints>(ids) != static_cast<std::int32_t>(id);
  }

  class Nearest {
   public:
    void clear() {
      best_ = second_ = Floats{} + kInfinity;
      who_ = Ints{};
    }
    void add(const Seen& seen, std::uint32_t from) {
      const Ints lane = kNumbers + static_cast<std::int32_t>(from);
      const Ints nearer = keep_two(seen, best_, second_);
      who_ = (lane & nearer) | (who_ & ~nearer);
    }
    void write(float& best, float& second, std::uint32_t& who) const {
      best = second = kInfinity;
      for (unsigned lane = 0; lane < kLanes; ++lane) {
        if (best_[lane] < best) {
          second = best < second_[lane] ? best : second_[lane];
          best = best_[lane];
          who = static_cast<std::uint32_t>(who_[lane]);
        } else if (best_[lane] < second) {
          second = best_[lane];
        }
      }
    }

   private:
    static Ints keep_two(const Seen& seen, Floats& best, Floats& second) {
      const Floats far = Floats{} + kInfinity;
      const Floats squared = select(seen.valid, seen.squared, far);
      const Ints nearer = squared < best;
      const Floats larger = select(nearer, best, squared);
      best = select(nearer, squared, best);
      second = select(larger < second, larger, second);
      return nearer;
    }
    static Floats select(const Ints& chosen, const Floats& yes, const Floats& no) {
      return std::bit_cast<Floats>((std::bit_cast<Ints>(yes) & chosen) |
                                   (std::bit_cast<Ints>(no) & ~chosen));
    }

    Floats best_;
    Floats second_;
    Ints who_;
  };

 private:
  static constexpr Ints kNumbers = {0, 1, 2, 3};

  template <class Words, class From>
  static Words load(const From* from) {
    Words loaded;
    std::memcpy(&loaded, from, sizeof loaded);
    return loaded;
  }
  template <class To, class Words>
  static void store(To* to, const Words& words) {
    std::memcpy(to, &words, sizeof words);
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

constinit const Kernels kBaselineKernels = kernels_over<Lanes>();

}  // namespace beespace::cpu
