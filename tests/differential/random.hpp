// Random numbers that are the same everywhere for the same seed; the distributions of the standard
// library are not.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::differential {

// SplitMix64 (Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014).
class Random {
 public:
  // Of one scene: it depends on nothing that was drawn for the scenes before.
  Random(std::uint64_t seed, std::uint64_t scene) : state_(seed) {
    state_ = next() + scene;
    state_ = next();
  }

  std::uint64_t next() {
    state_ += 0x9e37'79b9'7f4a'7c15;
    std::uint64_t mixed = state_;
    mixed = (mixed ^ mixed >> 30) * 0xbf58'476d'1ce4'e5b9;
    mixed = (mixed ^ mixed >> 27) * 0x94d0'49bb'1331'11eb;
    return mixed ^ mixed >> 31;
  }

  // 0 ... count - 1.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  // low ... high.
  int whole(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::size_t>(high - low) + 1));
  }
  bool once_in(std::size_t times) { return below(times) == 0; }
  bool coin() { return once_in(2); }

  // In [0, 1), and in [low, high).
  double real() { return static_cast<double>(next() >> 11) * 0x1p-53; }
  double between(double low, double high) { return low + (high - low) * real(); }
  double sign() { return coin() ? 1.0 : -1.0; }
  // Of a random power of two from 2^low to 2^high: every order of magnitude is as likely.
  double magnitude(int low, int high) { return std::ldexp(1.0 + real(), whole(low, high)); }

  template <class Value>
  const Value& one_of(const std::vector<Value>& values) {
    return values[below(values.size())];
  }

 private:
  std::uint64_t state_;
};

}  // namespace beespace::differential
