// Decimal text to the nearest double, always correctly rounded.
//
// Two ways in, one answer: join_plain_number() for the digits that fill nearly every file (eight
// digits at a time, exact while mantissa and power of ten are exact doubles, from_chars beyond),
// and parse_number() for every notation. Allocates nothing; thread-safe.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace beespace::io {

enum class NumberKind : std::uint8_t {
  kNumber,
  kNotANumber,
  kNotFinite,  // nan, inf, infinity, in any case, with or without a sign
  kTooLarge,   // a number that no finite double is nearest to
  kTooSmall,   // a number other than 0 that 0 is nearest to
};

// The whole of `text` as a number: [+-] digits [. digits] [e [+-] digits], where the digits before
// or after the point may be missing, but not both.
NumberKind parse_number(std::string_view text, double& value);

// How many bytes behind its last digit join_plain_number() may touch.
inline constexpr std::size_t kPlainNumberOverread = 16;

namespace number_detail {

static_assert(std::endian::native == std::endian::little, "the first digit is the lowest byte");

inline constexpr std::array<double, 16> kPowerOfTen = {
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
inline constexpr std::array<std::uint64_t, 8> kIntegerPowerOfTen = {
    1, 10, 100, 1'000, 10'000, 100'000, 1'000'000, 10'000'000};

inline constexpr std::uint64_t kLargestExactInteger = std::uint64_t{1} << 53;

// The number that eight digits at `text` spell, the first one highest.
inline std::uint64_t join_eight(std::uint64_t digits) {
  constexpr std::uint64_t kMask = 0x0000'00FF'0000'00FFu;
  constexpr std::uint64_t kEvenPairs = 100 + (std::uint64_t{1'000'000} << 32);
  constexpr std::uint64_t kOddPairs = 1 + (std::uint64_t{10'000} << 32);
  digits = digits * 10 + (digits >> 8);
  return ((digits & kMask) * kEvenPairs + ((digits >> 16) & kMask) * kOddPairs) >> 32;
}

// Eight characters as digit values.
inline std::uint64_t load_digits(const char* text) {
  std::uint64_t bytes = 0;
  std::memcpy(&bytes, text, sizeof bytes);
  return bytes ^ 0x3030303030303030u;
}

// The number that the first `count` (0 ... 7) digits spell: shifted up behind leading zeros.
inline std::uint64_t join_first(std::uint64_t digits, std::size_t count) {
  return join_eight((digits << (8 * (7 - count))) << 8);
}

// [-]digits[.digits], any number of them, up to `end`.
bool join_long_number(const char* begin, const char* end, double& value);

}  // namespace number_detail

// The value of [-]digits[.digits], already split: [begin, end) is all of it, `whole` its first
// digit and `whole_count` how many come before the point; `decimals` digits follow the point.
// False when it is none of those that are read here: ask parse_number() then.
inline bool join_plain_number(const char* begin, const char* whole, std::size_t whole_count,
                              std::size_t decimals, const char* end, double& value) {
  namespace detail = number_detail;
  if (whole_count - 1 >= 7) return false;  // none, or more than seven
  std::uint64_t mantissa = detail::join_first(detail::load_digits(whole), whole_count);
  const char* const fraction = whole + whole_count + 1;
  if (decimals < 8) {
    mantissa = mantissa * detail::kIntegerPowerOfTen[decimals] +
               detail::join_first(detail::load_digits(fraction), decimals);
  } else {
    if (decimals > 15 || whole_count + decimals > 19)
      return detail::join_long_number(begin, end, value);
    mantissa = mantissa * 100'000'000u + detail::join_eight(detail::load_digits(fraction));
    mantissa = mantissa * detail::kIntegerPowerOfTen[decimals - 8] +
               detail::join_first(detail::load_digits(fraction + 8), decimals - 8);
  }
  // Up to 2^53 the mantissa is exact and so is 10^decimals: one division rounds correctly.
  if (mantissa > detail::kLargestExactInteger) return detail::join_long_number(begin, end, value);
  const double magnitude =
      static_cast<double>(static_cast<std::int64_t>(mantissa)) / detail::kPowerOfTen[decimals];
  value = begin != whole ? -magnitude : magnitude;
  return true;
}

}  // namespace beespace::io
