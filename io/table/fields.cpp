#include "io/table/fields.hpp"

#include "io/bytes/characters.hpp"

#include <cstring>

namespace beespace::io {

std::string unquoted(const Field& field) {
  std::string text;
  for (std::size_t i = 0; i < field.text.size(); ++i) {
    text += field.text[i];
    if (field.doubled_quotes && field.text[i] == '"') ++i;
  }
  return text;
}

FieldCursor::FieldCursor(std::string_view line, char delimiter)
    : at_(line.data()), end_(line.data() + line.size()), delimiter_(delimiter) {
  if (delimiter_ == ' ') {
    while (at_ < end_ && is_blank(end_[-1])) --end_;
    skip_blanks();
  }
  more_ = at_ < end_;
}

void FieldCursor::skip_blanks() {
  while (at_ < end_ && is_blank(*at_) && *at_ != delimiter_) ++at_;
  while (delimiter_ == ' ' && at_ < end_ && is_blank(*at_)) ++at_;
}

bool FieldCursor::pass_delimiter() {
  const char* const before = at_;
  skip_blanks();
  if (at_ == end_) {
    more_ = false;
    return true;
  }
  if (delimiter_ == ' ') return at_ > before;
  if (*at_ != delimiter_) return false;
  ++at_;
  return true;
}

bool FieldCursor::next_quoted(Field& field) {
  const char* const begin = ++at_;
  field.doubled_quotes = false;
  while (true) {
    const auto* quote =
        static_cast<const char*>(std::memchr(at_, '"', static_cast<std::size_t>(end_ - at_)));
    if (quote == nullptr) {
      problem_ = "a quote is opened and never closed on this line";
      return false;
    }
    at_ = quote + 1;
    if (at_ == end_ || *at_ != '"') break;
    field.doubled_quotes = true;
    ++at_;
  }
  field.text = std::string_view(begin, static_cast<std::size_t>(at_ - 1 - begin));
  if (pass_delimiter()) return true;
  problem_ = "text follows a closing quote";
  return false;
}

bool FieldCursor::next(Field& field) {
  if (!more_ || !problem_.empty()) return false;
  skip_blanks();
  if (at_ < end_ && *at_ == '"') return next_quoted(field);
  const char* const begin = at_;
  if (delimiter_ == ' ') {
    while (at_ < end_ && !is_blank(*at_)) ++at_;
  } else {
    const void* const found =
        at_ < end_ ? std::memchr(at_, delimiter_, static_cast<std::size_t>(end_ - at_)) : nullptr;
    at_ = found != nullptr ? static_cast<const char*>(found) : end_;
  }
  const char* behind = at_;
  while (behind > begin && is_blank(behind[-1])) --behind;
  field.text = std::string_view(begin, static_cast<std::size_t>(behind - begin));
  field.doubled_quotes = false;
  // A delimiter at the very end of the line has an empty field behind it.
  if (at_ == end_) {
    more_ = false;
  } else {
    pass_delimiter();
  }
  return true;
}

std::vector<std::string> cells_of_line(std::string_view line, char delimiter) {
  std::vector<std::string> cells;
  FieldCursor cursor(line, delimiter);
  for (Field field; cursor.next(field);) cells.emplace_back(without_padding(unquoted(field)));
  return cells;
}

}  // namespace beespace::io
