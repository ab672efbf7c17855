#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace beespace::io {
namespace {

constexpr std::size_t kLongestNumber = 400;  // a double with decimals: up to 309 digits before

std::string fixed(double value, int decimals) {
  std::array<char, kLongestNumber> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                 std::chars_format::fixed, decimals)
                       .ptr;
  return {text.data(), end};
}

std::string group_digits(const std::string& digits) {
  std::string out;
  const std::size_t first = digits.find_first_of("0123456789");
  const std::size_t point = std::min(digits.find('.'), digits.size());
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > first && i < point && (point - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return out;
}

constexpr double kMillimetre_m = 0.001;

// Without zeros at its end, or the point before them.
std::string without_zeros(std::string digits) {
  while (digits.back() == '0') digits.pop_back();
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

}  // namespace

void append_exact(std::string& out, double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.append(text.data(), end);
}

void append_exact(std::string& out, std::uint64_t value) {
  std::array<char, 20> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  out.append(text.data(), end);
}

std::string exact(double value) {
  std::string out;
  append_exact(out, value);
  return out;
}

std::string grouped(std::uint64_t value) {
  return group_digits(std::to_string(value));
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view several) {
  return grouped(count).append(" ").append(count == 1 ? one : several);
}

std::string grouped(double value, int decimals) {
  return group_digits(fixed(value, decimals));
}

std::string grouped_below(double limit, double value, int decimals) {
  constexpr int kMostDecimals = 17;
  if (!(value < limit)) return grouped(value, decimals);
  for (; decimals <= kMostDecimals; ++decimals) {
    const std::string digits = fixed(value, decimals);
    if (parse_number(digits).value_or(limit) < limit) return group_digits(digits);
  }
  return exact(value);
}

namespace {

// Below a millimetre: "0.0837 mm", with three digits that say something, down to micrometres.
std::string small_length_below(double limit_m, double metres) {
  constexpr double kLeastMillimetres = 0.001;
  const double millimetres = metres / kMillimetre_m;
  if (millimetres < kLeastMillimetres) return "under 0.001 mm";
  const int decimals = 2 - static_cast<int>(std::floor(std::log10(millimetres)));
  return without_zeros(grouped_below(limit_m / kMillimetre_m, millimetres, decimals)) + " mm";
}

}  // namespace

std::string length_below(double limit_m, double metres) {
  // Beside metres that says nothing.
  constexpr double kLarge_m = 1.0;
  if (limit_m >= kLarge_m && metres > 0.0 && metres < kMillimetre_m) return "under 1 mm";
  if (metres > 0.0 && metres < kMillimetre_m) return small_length_below(limit_m, metres);
  if (metres < kMillimetre_m || metres >= 1e12) return length(metres);
  if (metres < 10'000.0) return grouped_below(limit_m, metres, 3) + " m";
  // Divided, both are rounded: the limit may then be as far away as the value.
  const double limit_km = limit_m / 1'000.0;
  const double value_km = metres / 1'000.0;
  if (metres < limit_m && !(value_km < limit_km)) return grouped_below(limit_m, metres, 3) + " m";
  return grouped_below(limit_km, value_km, 1) + " km";
}

int decimals_around(double limit) {
  if (!(limit > 0.0) || limit >= 100.0) return 0;
  return limit >= 10.0 ? 1 : 2;
}

std::string length(double metres) {
  if (metres == 0.0) return "0 m";
  if (metres > 0.0 && metres < kMillimetre_m) return small_length_below(0.0, metres);
  if (metres < kMillimetre_m) return exact(metres) + " m";
  if (metres < 10'000.0) return grouped(metres, 3) + " m";
  if (metres < 1e12) return grouped(metres / 1'000.0, 1) + " km";
  return exact(metres) + " m";
}

std::string duration(double seconds) {
  if (seconds < 1.0) return fixed(seconds * 1e3, 1) + " ms";
  return grouped(seconds, 2) + " s";
}

std::string time_span(double seconds) {
  constexpr double kMinute_s = 60.0;
  constexpr double kHour_s = 3600.0;
  if (seconds > 0.0 && seconds < 0.001) return "less than 0.001 s";
  if (seconds < kMinute_s) {
    return without_zeros(fixed(seconds, 3)) + " s";
  }
  const auto parts = [](double whole, const char* unit, double rest, const char* of_rest) {
    std::string text = grouped(whole, 0) + unit;
    if (rest > 0.0) text.append(" ").append(grouped(rest, 0)).append(of_rest);
    return text;
  };
  const double rounded_s = std::round(seconds);
  if (rounded_s < kHour_s) {
    const double minutes = std::floor(rounded_s / kMinute_s);
    return parts(minutes, " min", rounded_s - minutes * kMinute_s, " s");
  }
  const double minutes = std::round(seconds / kMinute_s);
  const double hours = std::floor(minutes / kMinute_s);
  return parts(hours, " h", minutes - hours * kMinute_s, " min");
}

std::string percentage(double share) {
  return fixed(share * 100.0, 1) + " %";
}

std::string byte_count(std::uint64_t bytes) {
  if (bytes < 1'000) return std::to_string(bytes) + " B";
  constexpr std::array kUnits = {" kB", " MB", " GB", " TB"};
  double value = static_cast<double>(bytes) / 1e3;
  std::size_t unit = 0;
  while (value >= 999.95 && unit + 1 < kUnits.size()) {
    value /= 1e3;
    ++unit;
  }
  return fixed(value, 1) + kUnits[unit];
}

std::optional<double> parse_number(std::string_view text) {
  const bool plus = text.starts_with('+') && !text.starts_with("+-");
  if (plus) text.remove_prefix(1);
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem == std::errc::result_out_of_range && stop == end) return HUGE_VAL;
  if (problem != std::errc{} || stop != end) return std::nullopt;
  return value;
}

std::optional<std::uint64_t> parse_whole(std::string_view text) {
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace beespace::io
