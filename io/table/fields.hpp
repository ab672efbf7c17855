// One line of a text table, field by field: delimiters, quotes, padding blanks.
//
// With the delimiter ' ' any run of blanks and tabs separates; otherwise every delimiter does, and
// blanks around a field do not belong to it. A field in double quotes may hold the delimiter, and
// a quote as "". Nothing is copied.
#pragma once

#include "io/bytes/characters.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// The longest line taken for a record, in bytes.
inline constexpr std::size_t kLongestLine = std::size_t{1} << 20;

struct Field {
  std::string_view text = {};   // without padding and outer quotes
  bool doubled_quotes = false;  // holds "" that stands for "
};

// The text that a field means.
std::string unquoted(const Field& field);

class FieldCursor {
 public:
  // `line` has no line end. Nothing comes from an empty line.
  FieldCursor(std::string_view line, char delimiter);

  // The next field; false at the end of the line, or when it is malformed.
  bool next(Field& field);

  // What is wrong with the field that next() stopped at; empty when nothing is.
  [[nodiscard]] std::string_view problem() const { return problem_; }

 private:
  void skip_blanks();
  bool next_quoted(Field& field);
  // Moves past the delimiter behind a field; false when something else stands there.
  bool pass_delimiter();

  const char* at_;
  const char* end_;
  char delimiter_;
  bool more_;
  std::string_view problem_ = {};
};

// What the fields of a line mean, without padding; nothing of an empty line.
std::vector<std::string> cells_of_line(std::string_view line, char delimiter);

}  // namespace beespace::io
