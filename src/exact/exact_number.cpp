#include "exact/exact_number.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::motion {

ExactNumber::ExactNumber(double value) : negative_(value < 0.0) {
  if (value == 0.0) return;
  constexpr int kMantissaBits = 53;
  int exponent = 0;
  const double fraction = std::frexp(std::abs(value), &exponent);
  auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, kMantissaBits));
  exponent -= kMantissaBits;
  // Down to a whole digit: the rest, 0 to 31 bits, becomes part of the digits.
  exponent_ = (exponent - (exponent & (kDigitBits - 1))) / kDigitBits;
  const auto shift = static_cast<unsigned>(exponent & (kDigitBits - 1));
  const std::uint64_t low = mantissa << shift;
  const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);
  digits_ = {static_cast<Digit>(low), static_cast<Digit>(low >> kDigitBits),
             static_cast<Digit>(high)};
  trim();
}

ExactNumber::Digit ExactNumber::digit(int place) const {
  if (place < exponent_ || place >= end()) return 0;
  return digits_[static_cast<std::size_t>(place - exponent_)];
}

void ExactNumber::trim() {
  while (!digits_.empty() && digits_.back() == 0) digits_.pop_back();
  const auto nonzero = std::find_if(digits_.begin(), digits_.end(), [](Digit d) { return d != 0; });
  exponent_ += static_cast<int>(nonzero - digits_.begin());
  digits_.erase(digits_.begin(), nonzero);
  if (digits_.empty()) negative_ = false;
}

int ExactNumber::compare_magnitudes(const ExactNumber& a, const ExactNumber& b) {
  if (a.digits_.empty() || b.digits_.empty()) {
    return static_cast<int>(b.digits_.empty()) - static_cast<int>(a.digits_.empty());
  }
  if (a.end() != b.end()) return a.end() < b.end() ? -1 : 1;
  const int lowest = std::min(a.exponent_, b.exponent_);
  for (int place = a.end() - 1; place >= lowest; --place) {
    if (a.digit(place) != b.digit(place)) return a.digit(place) < b.digit(place) ? -1 : 1;
  }
  return 0;
}

ExactNumber ExactNumber::add_magnitudes(const ExactNumber& a, const ExactNumber& b) {
  if (a.digits_.empty()) return b;
  if (b.digits_.empty()) return a;
  ExactNumber sum;
  sum.exponent_ = std::min(a.exponent_, b.exponent_);
  const int top = std::max(a.end(), b.end());
  std::uint64_t carry = 0;
  for (int place = sum.exponent_; place <= top; ++place) {
    carry += std::uint64_t{a.digit(place)} + b.digit(place);
    sum.digits_.push_back(static_cast<Digit>(carry));
    carry >>= kDigitBits;
  }
  sum.trim();
  return sum;
}

ExactNumber ExactNumber::subtract_magnitudes(const ExactNumber& larger,
                                             const ExactNumber& smaller) {
  if (smaller.digits_.empty()) return larger;
  ExactNumber difference;
  difference.exponent_ = std::min(larger.exponent_, smaller.exponent_);
  std::uint64_t borrow = 0;
  for (int place = difference.exponent_; place < larger.end(); ++place) {
    const std::uint64_t subtrahend = smaller.digit(place) + borrow;
    const std::uint64_t minuend = larger.digit(place);
    borrow = minuend < subtrahend ? 1 : 0;
    difference.digits_.push_back(static_cast<Digit>(minuend - subtrahend));
  }
  difference.trim();
  return difference;
}

ExactNumber ExactNumber::operator-() const {
  ExactNumber negated = *this;
  negated.negative_ = !negative_ && !digits_.empty();
  return negated;
}

ExactNumber operator+(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber sum;
  bool negative = a.negative_;
  if (a.negative_ == b.negative_) {
    sum = ExactNumber::add_magnitudes(a, b);
  } else if (ExactNumber::compare_magnitudes(a, b) >= 0) {
    sum = ExactNumber::subtract_magnitudes(a, b);
  } else {
    sum = ExactNumber::subtract_magnitudes(b, a);
    negative = b.negative_;
  }
  sum.negative_ = negative && !sum.digits_.empty();
  return sum;
}

ExactNumber operator-(const ExactNumber& a, const ExactNumber& b) {
  return a + (-b);
}

ExactNumber operator*(const ExactNumber& a, const ExactNumber& b) {
  ExactNumber product;
  product.exponent_ = a.exponent_ + b.exponent_;
  product.digits_.resize(a.digits_.size() + b.digits_.size());
  for (std::size_t i = 0; i < a.digits_.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t k = 0; k < b.digits_.size(); ++k) {
      // At most (2^32 - 1)^2 + 2 (2^32 - 1), which is 2^64 - 1.
      carry += std::uint64_t{a.digits_[i]} * b.digits_[k] + product.digits_[i + k];
      product.digits_[i + k] = static_cast<ExactNumber::Digit>(carry);
      carry >>= ExactNumber::kDigitBits;
    }
    product.digits_[i + b.digits_.size()] = static_cast<ExactNumber::Digit>(carry);
  }
  product.negative_ = a.negative_ != b.negative_;
  product.trim();
  return product;
}

}  // namespace beespace::motion
