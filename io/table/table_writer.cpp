#include "io/table/table_writer.hpp"

#include "io/bytes/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace beespace::io {
namespace {

constexpr double kMostWhole = 1e15;  // written without an exponent

bool needs_quotes(std::string_view text, char delimiter) {
  if (text.empty()) return delimiter == ' ';
  const bool blank_at_end = text.front() == ' ' || text.back() == ' ';
  return blank_at_end || text.find(delimiter) != std::string_view::npos ||
         text.find_first_of("\"\r\n") != std::string_view::npos;
}

constexpr std::string_view kBreaks = "\t\n\v\f\r";

void append_on_one_line(std::string& out, std::string_view text) {
  const auto begin = static_cast<std::ptrdiff_t>(out.size());
  out += text;
  std::replace_if(
      out.begin() + begin, out.end(),
      [](char c) { return kBreaks.find(c) != std::string_view::npos; }, ' ');
}

}  // namespace

void append_field(std::string& out, std::string_view text, char delimiter) {
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

std::string& TableWriter::next() {
  if (!begins_row_) out_ += delimiter_;
  begins_row_ = false;
  return out_;
}

TableWriter& TableWriter::header(std::string_view names) {
  while (true) {
    const std::size_t comma = names.find(',');
    next() += names.substr(0, comma);
    if (comma == std::string_view::npos) return *this;
    names.remove_prefix(comma + 1);
  }
}

TableWriter& TableWriter::field(std::string_view text) {
  next();
  if (text_ == TableText::kOneLine) {
    append_on_one_line(out_, text);
  } else {
    append_field(out_, text, delimiter_);
  }
  return *this;
}

TableWriter& TableWriter::field(double number) {
  if (!std::isfinite(number)) return empty_field();
  // Whole numbers with an exponent are shorter, but hard to read: 1.75e+09 of a time since 1970.
  if (std::abs(number) < kMostWhole && number == std::trunc(number) && !std::signbit(number)) {
    return count(static_cast<std::uint64_t>(number));
  }
  append_exact(next(), number);
  return *this;
}

TableWriter& TableWriter::count(std::uint64_t number) {
  append_exact(next(), number);
  return *this;
}

}  // namespace beespace::io
