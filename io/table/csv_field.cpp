#include "io/table/csv_field.hpp"

namespace beespace::io {
namespace {

bool needs_quotes(std::string_view text, char delimiter) {
  if (text.empty()) return delimiter == ' ';
  const bool blank_at_end = text.front() == ' ' || text.back() == ' ';
  return blank_at_end || text.find(delimiter) != std::string_view::npos ||
         text.find_first_of("\"\r\n") != std::string_view::npos;
}

}  // namespace

void append_csv_field(std::string& out, std::string_view text, char delimiter) {
  if (!needs_quotes(text, delimiter)) {
    out += text;
    return;
  }
  out += '"';
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  out += '"';
}

}  // namespace beespace::io
