#include "io/bytes/number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace beespace::io {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool equals_ignoring_case(std::string_view text, std::string_view lower) {
  return std::equal(text.begin(), text.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

// What the text says of its size, enough to tell an overflow from an underflow.
struct Scan {
  bool valid = false;
  bool zero = true;
  std::int64_t magnitude = 0;  // the first non-zero digit stands at 10^(magnitude - 1)
};

std::int64_t scan_exponent(std::string_view text, std::size_t& at) {
  constexpr std::int64_t kEnough = 1'000'000'000'000;
  const bool negative = at < text.size() && text[at] == '-';
  if (at < text.size() && (text[at] == '-' || text[at] == '+')) ++at;
  std::int64_t exponent = 0;
  for (; at < text.size() && is_digit(text[at]); ++at) {
    exponent = std::min(kEnough, exponent * 10 + (text[at] - '0'));
  }
  return negative ? -exponent : exponent;
}

// `text` without its sign.
Scan scan_unsigned(std::string_view text) {
  Scan scan;
  std::size_t at = 0;
  std::size_t digits = 0;
  for (; at < text.size() && is_digit(text[at]); ++at, ++digits) {
    if (text[at] != '0') scan.zero = false;
    if (!scan.zero) ++scan.magnitude;
  }
  if (at < text.size() && text[at] == '.') {
    for (++at; at < text.size() && is_digit(text[at]); ++at, ++digits) {
      if (text[at] != '0') scan.zero = false;
      if (scan.zero) --scan.magnitude;
    }
  }
  if (digits == 0) return scan;
  if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
    ++at;
    const std::size_t before = at;
    scan.magnitude += scan_exponent(text, at);
    if (at == before || !is_digit(text[at - 1])) return scan;
  }
  scan.valid = at == text.size();
  return scan;
}

}  // namespace

NumberKind parse_number(std::string_view text, double& value) {
  const bool negative = !text.empty() && text.front() == '-';
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  const Scan scan = scan_unsigned(text);
  if (!scan.valid) {
    const bool named = equals_ignoring_case(text, "nan") || equals_ignoring_case(text, "inf") ||
                       equals_ignoring_case(text, "infinity");
    return named ? NumberKind::kNotFinite : NumberKind::kNotANumber;
  }
  double magnitude = 0.0;
  if (!scan.zero && scan.magnitude > 400) return NumberKind::kTooLarge;
  if (!scan.zero && scan.magnitude <= -400) return NumberKind::kTooSmall;
  if (!scan.zero) {
    const auto result = std::from_chars(text.data(), text.data() + text.size(), magnitude);
    if (result.ec == std::errc::result_out_of_range) {
      if (scan.magnitude > 0) return NumberKind::kTooLarge;
      return NumberKind::kTooSmall;
    }
    if (!std::isfinite(magnitude)) return NumberKind::kTooLarge;
    if (magnitude == 0.0) return NumberKind::kTooSmall;
  }
  value = negative ? -magnitude : magnitude;
  return NumberKind::kNumber;
}

namespace number_detail {

bool join_long_number(const char* begin, const char* end, double& value) {
  const auto result = std::from_chars(begin, end, value, std::chars_format::fixed);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace number_detail

}  // namespace beespace::io
