// What separates the fields of a table's lines.
#pragma once

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace beespace::io {

inline constexpr std::array<char, 4> kDelimiters = {'\t', ';', ',', ' '};

// A number, also with a decimal comma.
bool looks_numeric(std::string_view text);

struct FieldCount {
  std::size_t fields = 0;
  std::size_t numeric = 0;
};

FieldCount count_fields(std::string_view line, char delimiter);

// The delimiter that makes the most numbers of the first lines, and the least else, but tabs before
// blanks where there are as many tabs in each line; where none does, the first that splits the
// first line.
char find_delimiter(const std::vector<std::string_view>& lines);

// The delimiter that a first line as Excel writes it names, "sep=;". Nothing for other lines.
// Errors: kUnsupportedFormat for one that is not read.
Result<std::optional<char>> delimiter_named_by(std::string_view line);

}  // namespace beespace::io
