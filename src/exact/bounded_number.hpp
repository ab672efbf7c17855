// A double with a bound of its error, which is propagated beside the value.
#pragma once

#include <cmath>
#include <optional>

namespace beespace::motion {

// The true number is within `error` of `value`, give or take a factor of 1 + 2^-40 on the error:
// errors are themselves sums of fewer than 2^12 rounded terms, none negative, each of which is
// wrong by at most 2^-53 of itself. sign() allows for that.
class BoundedNumber {
 public:
  BoundedNumber() = default;
  BoundedNumber(double value) : value_(value) {}  // NOLINT(google-explicit-constructor): exact

  friend BoundedNumber operator+(const BoundedNumber& a, const BoundedNumber& b) {
    const double sum = a.value_ + b.value_;
    return {sum, a.error_ + b.error_ + std::abs(sum) * kRounding};
  }
  friend BoundedNumber operator-(const BoundedNumber& a, const BoundedNumber& b) {
    const double difference = a.value_ - b.value_;
    return {difference, a.error_ + b.error_ + std::abs(difference) * kRounding};
  }
  friend BoundedNumber operator*(const BoundedNumber& a, const BoundedNumber& b) {
    if (a.is_zero() || b.is_zero()) return {};  // exactly: of bees that hover, or fly as one
    const double product = a.value_ * b.value_;
    return {product, std::abs(a.value_) * b.error_ + a.error_ * (std::abs(b.value_) + b.error_) +
                         std::abs(product) * kRounding + kUnderflow};
  }
  BoundedNumber operator-() const { return {-value_, error_}; }

  // -1, 0 or 1; nothing where the error leaves it open, or where something overflowed.
  [[nodiscard]] std::optional<int> sign() const {
    if (value_ > error_ * kSlack) return 1;
    if (-value_ > error_ * kSlack) return -1;
    if (is_zero()) return 0;
    return std::nullopt;
  }

 private:
  [[nodiscard]] bool is_zero() const { return value_ == 0.0 && error_ == 0.0; }

  BoundedNumber(double value, double error) : value_(value), error_(error) {}

  static constexpr double kRounding = 0x1p-53;
  // An upper limit of what a product loses when it, or its error, becomes too small for a double.
  static constexpr double kUnderflow = 0x1p-1020;
  static constexpr double kSlack = 1.0 + 0x1p-40;

  double value_ = 0.0;
  double error_ = 0.0;
};

}  // namespace beespace::motion
