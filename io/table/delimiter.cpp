#include "io/table/delimiter.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/fields.hpp"

#include <algorithm>
#include <string>

namespace beespace::io {
namespace {

// "1,5": a number as half of the world writes it.
bool is_decimal_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || comma + 1 == text.size()) return false;
  std::string point(text);
  point[comma] = '.';
  double value = 0.0;
  return parse_number(point, value) == NumberKind::kNumber;
}

std::size_t numbers_between(const std::vector<std::string_view>& lines, char delimiter) {
  std::size_t numeric = 0;
  for (const auto line : lines) numeric += count_fields(line, delimiter).numeric;
  return numeric;
}

// Whether tabs separate all lines alike, though blanks would, too: between two of them may be
// nothing, or a text of several words.
bool tabs_separate(const std::vector<std::string_view>& lines) {
  const auto tabs_in = [](std::string_view line) {
    return std::count(line.begin(), line.end(), '\t');
  };
  const auto tabs = tabs_in(lines.front());
  if (tabs == 0) return false;
  const bool alike = std::all_of(lines.begin(), lines.end(),
                                 [&](std::string_view line) { return tabs_in(line) == tabs; });
  return alike && 2 * numbers_between(lines, '\t') >= numbers_between(lines, ' ');
}

bool is_delimiter(char c) {
  return std::find(std::begin(kDelimiters), std::end(kDelimiters), c) != std::end(kDelimiters);
}

}  // namespace

bool looks_numeric(std::string_view text) {
  text = without_padding(text);
  double value = 0.0;
  return parse_number(text, value) != NumberKind::kNotANumber || is_decimal_comma(text);
}

FieldCount count_fields(std::string_view line, char delimiter) {
  FieldCount count;
  Field field;
  FieldCursor cursor(line, delimiter);
  while (cursor.next(field)) {
    ++count.fields;
    if (looks_numeric(field.text)) ++count.numeric;
  }
  return count;
}

// ',' is asked after ';' and tab, since it may also be a decimal comma.
char find_delimiter(const std::vector<std::string_view>& lines) {
  char best = '\0';
  std::size_t most = 0;
  std::size_t least_else = 0;
  char splitting = '\0';
  for (const char delimiter : kDelimiters) {
    std::size_t numeric = 0;
    std::size_t other = 0;
    for (const auto line : lines) {
      const FieldCount count = count_fields(line, delimiter);
      if (count.fields < 2) continue;
      numeric += count.numeric;
      other += count.fields - count.numeric;
    }
    if (numeric > most || (numeric == most && numeric > 0 && other < least_else)) {
      most = numeric;
      least_else = other;
      best = delimiter;
    }
    if (splitting == '\0' && count_fields(lines.front(), delimiter).fields > 1) {
      splitting = delimiter;
    }
  }
  if (best == ' ' && tabs_separate(lines)) return '\t';
  if (best != '\0') return best;
  return splitting != '\0' ? splitting : ',';
}

Result<std::optional<char>> delimiter_named_by(std::string_view line) {
  std::string_view text = without_padding(line);
  if (text.size() >= 2 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  constexpr std::string_view kBefore = "sep=";
  if (text.size() < kBefore.size() || lower_case(text.substr(0, kBefore.size())) != kBefore) {
    return std::optional<char>();
  }
  const std::string_view named = text.substr(kBefore.size());
  if (named.empty()) return std::optional<char>('\t');  // which is taken for padding
  if (named.size() == 1 && is_delimiter(named.front())) return std::optional<char>(named.front());
  return Error{ErrorCode::kUnsupportedFormat,
               excerpt(line) +
                   " names a delimiter that is not read; separate fields with commas, semicolons "
                   "or tabs",
               {}};
}

}  // namespace beespace::io
