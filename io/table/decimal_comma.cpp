#include "io/table/decimal_comma.hpp"

#include "io/table/table_layout.hpp"

#include <cstddef>
#include <string>

namespace beespace::io {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

std::size_t digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && is_digit(text[end])) ++end;
  return end - at;
}

// A field that is a number with a fraction.
struct Fraction {
  std::size_t mark = 0;    // where its comma or point is, in the field
  std::size_t before = 0;  // how many digits
  std::size_t behind = 0;
  bool exponent = false;
  bool leading_zero = false;
};

// "-12,5", "7.25e-3"; nothing for others.
std::optional<Fraction> fraction_in(std::string_view field) {
  Fraction fraction;
  std::size_t at = !field.empty() && (field[0] == '-' || field[0] == '+') ? 1 : 0;
  fraction.before = digits_at(field, at);
  fraction.leading_zero = fraction.before > 0 && field[at] == '0';
  at += fraction.before;
  if (at == field.size() || (field[at] != ',' && field[at] != '.')) return std::nullopt;
  fraction.mark = at++;
  fraction.behind = digits_at(field, at);
  at += fraction.behind;
  if (fraction.before + fraction.behind == 0) return std::nullopt;
  if (at < field.size() && (field[at] == 'e' || field[at] == 'E')) {
    fraction.exponent = true;
    ++at;
    if (at < field.size() && (field[at] == '-' || field[at] == '+')) ++at;
    const std::size_t digits = digits_at(field, at);
    if (digits == 0) return std::nullopt;
    at += digits;
  }
  return at == field.size() ? std::optional<Fraction>(fraction) : std::nullopt;
}

bool may_be_thousands(const Fraction& fraction) {
  constexpr std::size_t kGroup = 3;
  return fraction.behind == kGroup && fraction.before >= 1 && fraction.before <= kGroup &&
         !fraction.exponent && !fraction.leading_zero;
}

// Calls use(where in the text, fraction) for each field that is one; ends where that is false.
template <class Use>
void for_each_fraction(std::string_view text, char delimiter, Use&& use) {
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = begin;
    while (end < text.size() && text[end] != delimiter && text[end] != '\n' && text[end] != '\r') {
      ++end;
    }
    std::size_t first = begin;
    std::size_t last = end;
    while (first < last && text[first] == ' ') ++first;
    while (last > first && text[last - 1] == ' ') --last;
    const auto fraction = fraction_in(text.substr(first, last - first));
    if (fraction && !use(first + fraction->mark, *fraction)) return;
    begin = end + 1;
  }
}

}  // namespace

std::optional<Bytes> with_decimal_points(std::string_view text) {
  if (text.find(',') == std::string_view::npos) return std::nullopt;
  constexpr bool kSkipBad = true;  // what is wrong is said where the table is read
  const auto table = find_table(text, kSkipBad);
  if (!table || (table->delimiter != ';' && table->delimiter != '\t')) return std::nullopt;
  bool certain = false;
  bool point = false;
  for_each_fraction(text, table->delimiter, [&](std::size_t at, const Fraction& fraction) {
    point = text[at] == '.';
    certain = certain || !may_be_thousands(fraction);
    return !point;
  });
  if (point || !certain) return std::nullopt;
  std::string changed(text);
  for_each_fraction(text, table->delimiter, [&](std::size_t at, const Fraction&) {
    changed[at] = '.';
    return true;
  });
  return copy_of(changed);
}

}  // namespace beespace::io
