// Random numbers that are the same everywhere for a seed.
#pragma once

#include <cstdint>

namespace beespace::closed_loop {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits() >> 11U) * 0x1p-53);
  }
  // From 0 to below `count`.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(bits() % count); }
  bool happens(double probability) { return between(0, 1) < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace beespace::closed_loop
