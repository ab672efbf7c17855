// Numbers of tables, most of which are short: read with one division.
#pragma once

#include "io/bytes/number.hpp"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace beespace::io {

// [-]digits[.digits] while it fits: one division of exact doubles rounds correctly.
inline bool read_short_number(std::string_view text, double& value) {
  constexpr std::size_t kMostDigits = 15;
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) text.remove_prefix(1);
  if (text.empty() || text.size() > kMostDigits + 1) return false;
  std::uint64_t mantissa = 0;
  std::size_t point = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '.' && point == text.size() && i > 0) {
      point = i;
      continue;
    }
    const auto digit = static_cast<unsigned char>(text[i] - '0');
    if (digit > 9) return false;
    mantissa = mantissa * 10 + digit;
  }
  const std::size_t decimals = point == text.size() ? 0 : text.size() - point - 1;
  if (text.size() - (point == text.size() ? 0 : 1) > kMostDigits) return false;
  const double magnitude = static_cast<double>(mantissa) / number_detail::kPowerOfTen[decimals];
  value = negative ? -magnitude : magnitude;
  return true;
}

inline NumberKind read_number(std::string_view text, double& value) {
  if (read_short_number(text, value)) return NumberKind::kNumber;
  return parse_number(text, value);
}

}  // namespace beespace::io
