#include "report/number_label.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::report {
namespace {

constexpr double kMost = 1e15;  // beyond, the digits of a double do not tell single units apart
constexpr double kDay_s = 86'400.0;

// With a minus sign as wide as a plus, as books have it.
std::string proper(const std::string& digits) {
  return digits.starts_with('-') ? "\u2212" + digits.substr(1) : digits;
}

std::string grouped(std::string_view digits) {
  std::string out;
  const std::size_t first = digits.starts_with('-') ? 1 : 0;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  for (std::size_t i = 0; i < digits.size(); ++i) {
    if (i > first && i < point && (point - i) % 3 == 0) out += ',';
    out += digits[i];
  }
  return proper(out);
}

template <class... Format>
std::string digits_of(double value, Format... format) {
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, format...).ptr;
  return {text.data(), end};
}

struct Unit {
  double metres;
  const char* name;
};

// Both rounded once: so many small units make a metre, and that number is exact.
double in_metres(double value, const Unit& unit) {
  return unit.metres < 1.0 ? value / std::round(1.0 / unit.metres) : value * unit.metres;
}
double in_units(double metres, const Unit& unit) {
  return unit.metres < 1.0 ? metres * std::round(1.0 / unit.metres) : metres / unit.metres;
}

// `usual` is what the length would be called, with this unit.
std::string told_below(double limit_m, double metres, const std::string& usual, const Unit& unit) {
  constexpr std::size_t kMostDecimals = 17;
  if (!(metres < limit_m) || usual.find('e') != std::string::npos) return usual;
  const std::size_t point = usual.find('.');
  std::size_t decimals = 0;
  if (point != std::string::npos) decimals = usual.find(' ', point) - point - 1;
  for (bool first = true; decimals <= kMostDecimals; ++decimals, first = false) {
    const std::string digits =
        digits_of(in_units(metres, unit), std::chars_format::fixed, static_cast<int>(decimals));
    double told = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), told);
    if (in_metres(told, unit) < limit_m) return first ? usual : grouped(digits) + ' ' + unit.name;
  }
  return grouped(digits_of(metres, std::chars_format::fixed)) + " m";
}

// Of a number below 100.
std::string two_digits(std::int64_t number) {
  return {static_cast<char>('0' + number / 10), static_cast<char>('0' + number % 10)};
}

// The first day of the era of 400 years is a 1st of March, so that leap days come last (Howard
// Hinnant, chrono-compatible low-level date algorithms).
std::string date_of(std::int64_t days_since_1970) {
  const std::int64_t days = days_since_1970 + 719'468;
  const std::int64_t era = (days >= 0 ? days : days - 146'096) / 146'097;
  const std::int64_t day_of_era = days - era * 146'097;
  const std::int64_t year_of_era =
      (day_of_era - day_of_era / 1'460 + day_of_era / 36'524 - day_of_era / 146'096) / 365;
  const std::int64_t day_of_year =
      day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
  const std::int64_t month_from_march = (5 * day_of_year + 2) / 153;
  const std::int64_t day = day_of_year - (153 * month_from_march + 2) / 5 + 1;
  const std::int64_t month = month_from_march < 10 ? month_from_march + 3 : month_from_march - 9;
  const std::string year = std::to_string(year_of_era + era * 400 + (month <= 2 ? 1 : 0));
  return std::string(4 - std::min<std::size_t>(4, year.size()), '0') + year + '-' +
         two_digits(month) + '-' + two_digits(day);
}

// From the year 0 to 9999.
bool has_a_date(double since_1970_s) {
  return since_1970_s >= -62'167'219'200.0 && since_1970_s < 253'402'300'800.0;
}

}  // namespace

std::string count_label(std::uint64_t count) {
  return grouped(std::to_string(count));
}

std::string count_label(std::uint64_t count, std::string_view one, std::string_view several) {
  return count_label(count).append(" ").append(count == 1 ? one : several);
}

std::string decimal_label(double value, int decimals) {
  if (std::abs(value) >= kMost) return proper(digits_of(value, std::chars_format::general, 6));
  const std::string digits =
      digits_of(value, std::chars_format::fixed, std::clamp(decimals, 0, 30));
  const bool zero = digits.find_first_of("123456789") == std::string::npos;
  return grouped(zero && digits.front() == '-' ? std::string_view(digits).substr(1) : digits);
}

std::string short_label(double value) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= kMost || size < 1e-6) return proper(digits_of(value, std::chars_format::general, 3));
  const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
  std::string text = decimal_label(value, std::max(0, 3 - before));
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string length_label(double metres) {
  const double size = std::abs(metres);
  if (size > 0.0 && size < 1e-6) return "under 1 \u00B5m";
  if (size > 0.0 && size < kTiny_m) return short_label(metres * 1e6) + " \u00B5m";
  if (size > 0.0 && size < 0.1) return short_label(metres * 1e3) + " mm";
  if (size < 10'000.0) return short_label(metres) + " m";
  return short_label(metres / 1e3) + " km";
}

std::string listed_length(double metres) {
  if (metres < 1e-3) return length_label(metres);
  if (metres < 10'000.0) return decimal_label(metres, metres < 100.0 ? 3 : 1) + " m";
  return decimal_label(metres / 1e3, 1) + " km";
}

namespace {

// In which lengths beside that limit are told, where both are small.
std::optional<Unit> small_unit(double limit_m, double metres) {
  if (limit_m < kTiny_m && metres < 1e-3) return Unit{1e-6, "\u00B5m"};
  if (limit_m < 0.01 && metres < 1.0) return Unit{1e-3, "mm"};
  return std::nullopt;
}

// Beside metres that says nothing.
bool is_next_to_nothing(double limit_m, double metres) {
  return limit_m >= 1.0 && metres > 0.0 && metres < 1e-3;
}
constexpr const char* kNextToNothing = "under 1 mm";

std::string in_small_unit(double limit_m, double metres, const Unit& unit) {
  return told_below(limit_m, metres, short_label(metres / unit.metres) + ' ' + unit.name, unit);
}

}  // namespace

std::string length_label_below(double limit_m, double metres) {
  if (is_next_to_nothing(limit_m, metres)) return kNextToNothing;
  if (const auto small = small_unit(limit_m, metres)) return in_small_unit(limit_m, metres, *small);
  const Unit unit = metres < kTiny_m    ? Unit{1e-6, "\u00B5m"}
                    : metres < 0.1      ? Unit{1e-3, "mm"}
                    : metres < 10'000.0 ? Unit{1.0, "m"}
                                        : Unit{1e3, "km"};
  return told_below(limit_m, metres, length_label(metres), unit);
}

std::string listed_length_below(double limit_m, double metres) {
  if (is_next_to_nothing(limit_m, metres)) return kNextToNothing;
  if (const auto small = small_unit(limit_m, metres)) return in_small_unit(limit_m, metres, *small);
  if (metres < 1e-3) return length_label_below(limit_m, metres);
  const Unit unit = metres < 10'000.0 ? Unit{1.0, "m"} : Unit{1e3, "km"};
  return told_below(limit_m, metres, listed_length(metres), unit);
}

std::string clock_label(double seconds, double step_s) {
  int decimals = 0;
  while (decimals < 6 && step_s < std::pow(10.0, -decimals)) ++decimals;
  const double unit = std::pow(10.0, decimals);
  const auto ticks = std::llround(seconds * unit);
  const auto whole = ticks / static_cast<long long>(unit);
  const auto hours = whole / 3'600;
  std::string text = hours < 100 ? two_digits(hours) : std::to_string(hours);
  text += ':' + two_digits(whole / 60 % 60);
  if (step_s >= 60.0) return text;
  text += ':' + two_digits(whole % 60);
  if (decimals == 0) return text;
  const std::string fraction = std::to_string(ticks % static_cast<long long>(unit));
  return text + '.' + std::string(static_cast<std::size_t>(decimals) - fraction.size(), '0') +
         fraction;
}

std::string date_label(double since_1970_s) {
  if (!has_a_date(since_1970_s)) return {};
  return date_of(static_cast<std::int64_t>(std::floor(since_1970_s / kDay_s)));
}

std::string instant_label(double since_1970_s) {
  if (!has_a_date(since_1970_s)) return {};
  const double microseconds = std::round(since_1970_s * 1e6);
  const double day = std::floor(microseconds / (kDay_s * 1e6));
  const double seconds = (microseconds - day * kDay_s * 1e6) / 1e6;
  std::string clock = clock_label(seconds, 1e-6);
  clock.erase(clock.find_last_not_of('0') + 1);
  if (clock.back() == '.') clock.pop_back();
  return date_of(static_cast<std::int64_t>(day)) + 'T' + clock + 'Z';
}

}  // namespace beespace::report
