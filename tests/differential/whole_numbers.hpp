// Doubles as what they are: a whole number times a power of two. With one power of two for all
// numbers of a scene, its unit, they are whole numbers, and nothing that is added, multiplied or
// compared is ever rounded. Written for the differential fuzzer alone: it shares nothing with the
// library, its brute force or the oracles of other tests.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

namespace beespace::differential {

// Up to 512 bits without memory of its own, and any size beyond.
using Whole = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<512, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;

// value = mantissa * 2^exponent; the mantissa is odd, or both are 0.
struct Parts {
  std::int64_t mantissa = 0;
  int exponent = 0;
};

// Of a finite double.
inline Parts parts_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const auto field = static_cast<int>(bits >> 52 & 0x7ff);
  std::uint64_t mantissa = bits & 0xf'ffff'ffff'ffff;
  if (field != 0) mantissa |= std::uint64_t{1} << 52;
  if (mantissa == 0) return {};
  const int zeros = std::countr_zero(mantissa);
  const auto odd = static_cast<std::int64_t>(mantissa >> zeros);
  return {bits >> 63 != 0 ? -odd : odd, (field == 0 ? 1 : field) - 1075 + zeros};
}

// The largest power of two that all numbers shown to it are multiples of.
class Unit {
 public:
  void include(double value) {
    if (value != 0.0) exponent_ = std::min(exponent_, parts_of(value).exponent);
  }
  [[nodiscard]] int exponent() const {
    return exponent_ == std::numeric_limits<int>::max() ? 0 : exponent_;
  }

 private:
  int exponent_ = std::numeric_limits<int>::max();
};

// value / 2^unit, where that is a whole number.
inline Whole whole(double value, int unit) {
  const Parts parts = parts_of(value);
  if (parts.mantissa == 0) return 0;
  return Whole(parts.mantissa) << (parts.exponent - unit);
}

inline Whole squared(const Whole& value) {
  return value * value;
}

}  // namespace beespace::differential
