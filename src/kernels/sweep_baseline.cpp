// The kernels for every processor: GNU vectors of four lanes, which are SSE2 on x86-64 and NEON on
// ARM64.
#include "kernels/sweep_kernel.hpp"
#include "kernels/sweep_variants.hpp"

#include <bit>
#include <cstring>

namespace beespace::cpu {

namespace {

class Lanes {
  using Ints [[gnu::vector_size(16)]] = std::int32_t;

 public:
  static constexpr unsigned kLanes = 4;
  using Words [[gnu::vector_size(16)]] = std::uint32_t;
  using Floats [[gnu::vector_size(16)]] = float;

  struct Seen {
    unsigned near;
    unsigned within;
    unsigned before;
    Ints near_lanes;  // all ones where near
    Ints valid;
    Floats squared;
  };

  explicit Lanes(const Limits& limits) : near_(limits.near), far_(limits.far) {}

  void select(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t bound_x) {
    x_ = Ints{} + x;
    y_ = Ints{} + y;
    z_ = Ints{} + z;
    bound_x_ = Ints{} + bound_x;
  }
  void select_block(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                    std::int32_t reach, std::int32_t slice) {
    x_ = load<Ints>(x);
    y_ = load<Ints>(y);
    z_ = load<Ints>(z);
    bound_x_ = ((x_ + (reach + 1)) & slice) - slice;
  }

  [[nodiscard]] Seen look(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                          std::uint32_t count) const {
    const Ints valid = kNumbers < static_cast<std::int32_t>(count < kLanes ? count : kLanes);
    const Ints other_x = load<Ints>(x);
    Seen seen = compare(other_x, load<Ints>(y), load<Ints>(z), valid);
    seen.before = bits((other_x < bound_x_) & valid);
    return seen;
  }
  [[nodiscard]] Seen meet(std::int32_t x, std::int32_t y, std::int32_t z, unsigned lanes) const {
    return compare(Ints{} + x, Ints{} + y, Ints{} + z, with_bits(lanes));
  }
  [[nodiscard]] Floats squared(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return squared(Ints{} + x, Ints{} + y, Ints{} + z);
  }
  [[nodiscard]] Floats squared(const std::int32_t* x, const std::int32_t* y,
                               const std::int32_t* z) const {
    return squared(load<Ints>(x), load<Ints>(y), load<Ints>(z));
  }
  [[nodiscard]] unsigned reaching(const std::int32_t* x) const {
    return bits(load<Ints>(x) < bound_x_);
  }
  static Floats without(const Floats& squared, unsigned lane) {
    return chosen(with_bits(1U << lane), Floats{} + kInfinity, squared);
  }

  class AtSides {
   public:
    explicit AtSides(const SideLimits& limits) : limits_(limits) {}

    unsigned operator()(const std::int32_t* y, const std::int32_t* z) const {
      const Ints from_y = (load<Ints>(y) & limits_.in_row) ^ limits_.flip_y;
      const Ints from_z = (load<Ints>(z) & limits_.in_row) ^ limits_.flip_z;
      return bits((from_y < limits_.reach_y) & (from_z < limits_.reach_z));
    }

   private:
    SideLimits limits_;
  };
  static unsigned around(const std::int32_t* x, const std::int32_t* y, const std::int32_t* z,
                         const PositionBox& box, float far) {
    const auto beside = [&box](const Ints& at, unsigned axis) {
      const Ints below = box.low[axis] - at;
      const Ints above = at - box.high[axis];
      return (below & (below > 0)) | (above & (above > 0));
    };
    return bits(sum_of_squares(beside(load<Ints>(x), 0), beside(load<Ints>(y), 1),
                               beside(load<Ints>(z), 2)) <= far);
  }
  template <class From, class To>
  static void pack(const From* from, unsigned chosen, To* to) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      *to = std::bit_cast<To>(from[lane]);
      to += chosen >> lane & 1U;
    }
  }
  static void clear(std::int32_t* words) { store(words, Ints{}); }
  static void pack_numbers(std::uint32_t first, unsigned chosen, std::uint32_t* to) {
    for (unsigned lane = 0; lane < kLanes; ++lane) {
      *to = first + lane;
      to += chosen >> lane & 1U;
    }
  }

  static void add_near(Seen& seen, unsigned lanes) {
    seen.near |= lanes;
    seen.near_lanes |= with_bits(lanes);
  }

  static void mark(std::uint8_t* marks, unsigned near) {
    static_assert(std::endian::native == std::endian::little);
    // Byte `lane` keeps bit `lane` of the copies of `near`, which is all that "nonzero" needs.
    auto old = load<std::uint32_t>(marks);
    old |= (near * 0x01010101U) & 0x08040201U;
    store(marks, old);
  }

  static Words words(const std::uint32_t* from) { return load<Words>(from); }
  static Floats floats(const std::uint32_t* from) { return load<Floats>(from); }

  static void store(const Words& ids, unsigned near, PointId* to) {
    for (; near != 0; near &= near - 1) {
      *to++ = ids[__builtin_ctz(near)];
    }
  }
  static void store(const PointId* ids, unsigned near, PointId* to) {
    for (; near != 0; near &= near - 1) {
      *to++ = ids[__builtin_ctz(near)];
    }
  }
  static void fill(PointId* to, PointId id) {
    for (unsigned lane = 0; lane < kLanes; ++lane) to[lane] = id;
  }

  static unsigned meeting(const Floats& squared, const float* radii, const float* others) {
    return at_most(squared, load<Floats>(radii) + load<Floats>(others));
  }
  static unsigned meeting(const Floats& squared, const Floats& radii, float other) {
    return at_most(squared, radii + other);
  }

  static void leave_out(Seen& seen, const PointId* ids, PointId id) {
    seen.valid &= load<Ints>(ids) != static_cast<std::int32_t>(id);
  }

  class Tally {
   public:
    void clear() { counts_ = Ints{}; }
    void add(const Seen& seen) { counts_ -= seen.near_lanes; }
    void write(std::uint32_t* to) const { Lanes::store(to, counts_); }

   private:
    Ints counts_;
  };

  class Nearest {
   public:
    void clear() {
      best_ = second_ = Floats{} + kInfinity;
      who_ = Ints{};
    }
    void add(const Seen& seen, std::uint32_t from) {
      const Floats counted = chosen(seen.valid, seen.squared, Floats{} + kInfinity);
      take(kNumbers + static_cast<std::int32_t>(from), keep_two(counted, best_, second_));
    }
    void add_one(const Floats& squared, std::uint32_t who) {
      take(Ints{} + static_cast<std::int32_t>(who), keep_two(squared, best_, second_));
    }
    void read(const float* best, const float* second, const std::uint32_t* who) {
      best_ = load<Floats>(best);
      second_ = load<Floats>(second);
      who_ = load<Ints>(who);
    }
    void write_lanes(float* best, float* second, std::uint32_t* who) const {
      Lanes::store(best, best_);
      Lanes::store(second, second_);
      Lanes::store(who, who_);
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
    void take(const Ints& who, const Ints& nearer) { who_ = (who & nearer) | (who_ & ~nearer); }

    static Ints keep_two(const Floats& squared, Floats& best, Floats& second) {
      const Ints nearer = squared < best;
      const Floats larger = chosen(nearer, best, squared);
      best = chosen(nearer, squared, best);
      second = chosen(larger < second, larger, second);
      return nearer;
    }

    Floats best_;
    Floats second_;
    Ints who_;
  };

 private:
  static unsigned at_most(const Floats& squared, const Floats& distance) {
    return bits(squared <= distance * distance);
  }

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
  static Floats chosen(const Ints& lanes, const Floats& yes, const Floats& no) {
    return std::bit_cast<Floats>((std::bit_cast<Ints>(yes) & lanes) |
                                 (std::bit_cast<Ints>(no) & ~lanes));
  }
  // All ones in the lanes whose bits are set.
  static Ints with_bits(unsigned lanes) {
    const Ints bit = {1, 2, 4, 8};
    return (bit & static_cast<std::int32_t>(lanes)) == bit;
  }

  [[nodiscard]] Floats squared(const Ints& x, const Ints& y, const Ints& z) const {
    return sum_of_squares(x - x_, y - y_, z - z_);
  }
  static Floats sum_of_squares(const Ints& x, const Ints& y, const Ints& z) {
    const Floats dx = __builtin_convertvector(x, Floats);
    const Floats dy = __builtin_convertvector(y, Floats);
    const Floats dz = __builtin_convertvector(z, Floats);
    return dx * dx + dy * dy + dz * dz;
  }
  [[nodiscard]] Seen compare(const Ints& x, const Ints& y, const Ints& z, const Ints& valid) const {
    const Floats distances = squared(x, y, z);
    const Ints near = (distances < near_) & valid;
    const Ints within = (distances <= far_) & valid;
    return {bits(near), bits(within), 0, near, valid, distances};
  }

  static unsigned bits(const Ints& mask) {
    return static_cast<unsigned>((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
  }

  float near_;
  float far_;
  Ints x_{};
  Ints y_{};
  Ints z_{};
  Ints bound_x_{};
};

}  // namespace

constinit const Kernels kBaselineKernels = kernels_over<Lanes>();

}  // namespace beespace::cpu
