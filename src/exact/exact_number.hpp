// Numbers without rounding: integers of any size times a power of two, which include all sums,
// differences and products of doubles. Slow, and used only where doubles leave a sign open.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::motion {

class ExactNumber {
 public:
  ExactNumber() = default;
  ExactNumber(double value);  // NOLINT(google-explicit-constructor): nothing is lost; finite

  friend ExactNumber operator+(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator-(const ExactNumber& a, const ExactNumber& b);
  friend ExactNumber operator*(const ExactNumber& a, const ExactNumber& b);
  [[nodiscard]] ExactNumber operator-() const;

  // -1, 0 or 1: always known. (An optional, to read like that of a BoundedNumber.)
  [[nodiscard]] std::optional<int> sign() const {
    if (digits_.empty()) return 0;
    return negative_ ? -1 : 1;
  }

 private:
  using Digit = std::uint32_t;
  static constexpr int kDigitBits = 32;

  [[nodiscard]] int end() const { return exponent_ + static_cast<int>(digits_.size()); }
  // The digit of weight 2^(32 * place); zero outside.
  [[nodiscard]] Digit digit(int place) const;
  void trim();

  static int compare_magnitudes(const ExactNumber& a, const ExactNumber& b);
  static ExactNumber add_magnitudes(const ExactNumber& a, const ExactNumber& b);
  static ExactNumber subtract_magnitudes(const ExactNumber& larger, const ExactNumber& smaller);

  // The magnitude is the sum of digits_[i] * 2^(32 * (exponent_ + i)); neither end is zero.
  std::vector<Digit> digits_;
  int exponent_ = 0;
  bool negative_ = false;
};

}  // namespace beespace::motion
