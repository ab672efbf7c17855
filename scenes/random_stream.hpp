// Random numbers that are the same on every machine.
//
// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014): a
// counter in steps of the golden ratio, and a mixer. The conversions to doubles use only exact
// operations and + and *, never the standard library's distributions, which differ between
// libraries. A plain value; a few nanoseconds a number.
#pragma once

#include <cstdint>

namespace beespace::scenes {

class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9E37'79B9'7F4A'7C15u;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30u)) * 0xBF58'476D'1CE4'E5B9u;
    mixed = (mixed ^ (mixed >> 27u)) * 0x94D0'49BB'1331'11EBu;
    return mixed ^ (mixed >> 31u);
  }

  // In [0, 1): a multiple of 2^-53, exact.
  double uniform() { return static_cast<double>(bits() >> 11u) * 0x1p-53; }

  double uniform(double low, double high) {
    const double offset = (high - low) * uniform();
    return low + offset;
  }

  // 0 ... count - 1, for count > 0.
  std::uint32_t index(std::uint32_t count) {
    return static_cast<std::uint32_t>(((bits() >> 32u) * count) >> 32u);
  }

  // Mean 0, variance 1: the sum of twelve uniform numbers less 6, which is close to the normal
  // distribution, without a tail beyond 6. Summed as integers, so that nothing rounds but the
  // conversion at the end.
  double nearly_normal() {
    constexpr int kSummands = 12;
    constexpr std::int64_t kMean = std::int64_t{6} << 53u;
    std::int64_t sum = 0;
    for (int i = 0; i < kSummands; ++i) sum += static_cast<std::int64_t>(bits() >> 11u);
    return static_cast<double>(sum - kMean) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

}  // namespace beespace::scenes
