// Sums, differences and products of random doubles: the same formula in any kind of number.
#pragma once

#include "tests/support/scene_maker.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace beespace::test {

class RandomFormula {
 public:
  // Of doubles whose exponents are within +-`most_exponent`. Some of them come twice, so that much
  // cancels: also everything.
  RandomFormula(std::uint32_t seed, int most_exponent) {
    SceneMaker make(seed);
    const std::size_t leaves = 2 + make.below(5);
    for (std::size_t i = 0; i < leaves; ++i) leaves_.push_back(leaf(make, most_exponent));
    if (make.below(2) == 0) leaves_.push_back(-leaves_[0]);
    for (std::size_t step = 1 + make.below(6); step > 0; --step) {
      const std::size_t values = leaves_.size() + steps_.size();
      steps_.push_back({make.below(4), make.below(values), make.below(values)});
    }
  }

  template <class Number>
  [[nodiscard]] Number value() const {
    std::vector<Number> values;
    for (const double leaf : leaves_) values.push_back(Number(leaf));
    for (const auto& [kind, a, b] : steps_) {
      if (kind == 0) values.push_back(values[a] + values[b]);
      if (kind == 1) values.push_back(values[a] - values[b]);
      if (kind == 2) values.push_back(values[a] * values[b]);
      if (kind == 3) values.push_back(-values[a]);
    }
    return values.back();
  }

 private:
  struct Step {
    std::size_t kind;
    std::size_t a;
    std::size_t b;
  };

  // Zero, a power of two, a few bits, or bits all over.
  static double leaf(SceneMaker& make, int most_exponent) {
    const std::size_t kind = make.below(8);
    if (kind == 0) return 0.0;
    double mantissa = 1.0;
    if (kind > 1) mantissa = static_cast<double>(1 + make.below(1000));
    if (kind > 4) mantissa = 1.0 + make.between(0.0, 1.0) + make.between(0.0, 0x1p-30);
    const int exponent =
        static_cast<int>(make.below(static_cast<std::size_t>(2 * most_exponent))) - most_exponent;
    return std::ldexp(make.below(2) == 0 ? mantissa : -mantissa, exponent);
  }

  std::vector<double> leaves_;
  std::vector<Step> steps_;
};

}  // namespace beespace::test
