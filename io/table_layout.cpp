#include "io/table_layout.hpp"

#include "io/column_choice.hpp"
#include "io/excerpt.hpp"
#include "io/fields.hpp"
#include "io/number.hpp"

#include <algorithm>
#include <cstring>

namespace beespace::io {
namespace {

constexpr std::size_t kSampleLines = 16;
constexpr std::size_t kSampleBytes = std::size_t{1} << 16;

// "1,5": a number as half of the world writes it.
bool is_decimal_comma(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos || comma + 1 == text.size()) return false;
  std::string point(text);
  point[comma] = '.';
  double value = 0.0;
  return parse_number(point, value) == NumberKind::kNumber;
}

bool looks_numeric(std::string_view text) {
  text = without_padding(text);
  double value = 0.0;
  return parse_number(text, value) != NumberKind::kNotANumber || is_decimal_comma(text);
}

struct FieldCount {
  std::size_t fields = 0;
  std::size_t numeric = 0;
};

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

// The delimiter that makes the most numbers of the first lines; where none does, the first that
// splits the first line. ',' is asked after ';' and tab, since it may also be a decimal comma.
char find_delimiter(const std::vector<std::string_view>& lines) {
  char best = '\0';
  std::size_t most = 0;
  char splitting = '\0';
  for (const char delimiter : {'\t', ';', ',', ' '}) {
    std::size_t numeric = 0;
    for (const auto line : lines) {
      const FieldCount count = count_fields(line, delimiter);
      if (count.fields > 1) numeric += count.numeric;
    }
    if (numeric > most) {
      most = numeric;
      best = delimiter;
    }
    if (splitting == '\0' && count_fields(lines.front(), delimiter).fields > 1) {
      splitting = delimiter;
    }
  }
  if (best != '\0') return best;
  return splitting != '\0' ? splitting : ',';
}

// '\r' only where it stands alone before the first '\n'.
char find_line_end(std::string_view text) {
  const std::string_view head = text.substr(0, kLongestLine + 2);
  const std::size_t newline = head.find('\n');
  if (newline != std::string_view::npos) {
    const std::size_t carriage = head.substr(0, newline).find('\r');
    return carriage == std::string_view::npos || carriage + 1 == newline ? '\n' : '\r';
  }
  return head.find('\r') == std::string_view::npos ? '\n' : '\r';
}

std::vector<std::string_view> sample_lines(std::string_view text, std::size_t offset,
                                           char line_end) {
  std::vector<std::string_view> lines;
  const std::size_t end = std::min(text.size(), offset + kSampleBytes);
  while (offset < end && lines.size() < kSampleLines) {
    const Line line = line_at(text, offset, line_end);
    if (!is_blank_line(line.text.substr(0, kSampleBytes))) {
      lines.push_back(line.text.substr(0, kSampleBytes));
    }
    offset = line.next;
  }
  return lines;
}

// The fields of the first record and what they look like.
struct FirstRecord {
  std::vector<std::string> fields = {};
  std::vector<bool> numeric = {};
};

Result<FirstRecord> read_first_record(std::string_view line, char delimiter) {
  FirstRecord record;
  Field field;
  FieldCursor cursor(line, delimiter);
  while (cursor.next(field)) {
    record.fields.push_back(unquoted(field));
    record.numeric.push_back(looks_numeric(field.text));
  }
  if (!cursor.problem().empty()) {
    Error error{ErrorCode::kMalformedRecord,
                std::string(cursor.problem()) + ": " + excerpt(line) +
                    "; correct the line, a record may not span several lines",
                {}};
    error.place.column = record.fields.size() + 1;
    return error;
  }
  return record;
}

Error no_points(bool header) {
  return {ErrorCode::kNoPoints,
          header ? "there is a header and no record after it; at least one point is needed"
                 : "the input is empty; at least one point is needed",
          {}};
}

bool none(const std::vector<bool>& flags) {
  return std::none_of(flags.begin(), flags.end(), [](bool flag) { return flag; });
}

}  // namespace

std::string_view delimiter_name(char delimiter) {
  switch (delimiter) {
    case ';':
      return "semicolon";
    case '\t':
      return "tab";
    case ' ':
      return "space";
    default:
      return "comma";
  }
}

Line line_at(std::string_view text, std::size_t offset, char line_end) {
  const std::string_view rest = text.substr(offset);
  const void* const found =
      rest.empty() ? nullptr : std::memchr(rest.data(), line_end, rest.size());
  if (found == nullptr) {
    std::string_view line = rest;
    if (line_end == '\n' && !line.empty() && line.back() == '\r') line.remove_suffix(1);
    return {line, text.size()};
  }
  const auto length = static_cast<std::size_t>(static_cast<const char*>(found) - rest.data());
  std::string_view line = rest.substr(0, length);
  if (line_end == '\n' && !line.empty() && line.back() == '\r') line.remove_suffix(1);
  return {line, offset + length + 1};
}

Result<TableLayout> find_layout(std::string_view text, const LoadOptions& options) {
  TableLayout layout;
  layout.line_end = find_line_end(text);
  std::size_t offset = 0;
  Line line{{}, 0};
  while (true) {
    if (offset >= text.size()) return no_points(false);
    line = line_at(text, offset, layout.line_end);
    if (!is_blank_line(line.text)) break;
    offset = line.next;
    ++layout.lines_before;
  }
  const auto placed = [&layout](Error error) {
    if (error.code != ErrorCode::kInvalidArgument) error.place.line = layout.lines_before + 1;
    return error;
  };
  if (line.text.size() > kLongestLine) {
    return placed({ErrorCode::kMalformedRecord,
                   "a line of " + std::to_string(line.text.size()) + " bytes, beginning with " +
                       excerpt(line.text) + ", is too long for a record (the limit is 1 MiB)",
                   {}});
  }
  const auto samples = sample_lines(text, offset, layout.line_end);
  layout.delimiter = find_delimiter(samples);
  const auto first = read_first_record(line.text, layout.delimiter);
  if (!first) return placed(first.error());

  ColumnsSeen seen;
  layout.columns = seen.count = first.value().fields.size();
  layout.data_offset = offset;
  seen.numeric = first.value().numeric;
  const std::uint64_t first_line = layout.lines_before;
  if (none(seen.numeric)) {
    layout.header = line.text;
    layout.names = seen.names = first.value().fields;
    layout.data_offset = line.next;
    layout.lines_before = first_line + 1;
    if (samples.size() > 1) {
      const auto second = read_first_record(samples[1], layout.delimiter);
      if (second) seen.numeric = second.value().numeric;
    }
  }
  auto choice = choose_columns(seen, options);
  if (!choice) {
    Error error = choice.error();
    if (error.code != ErrorCode::kInvalidArgument) error.place.line = first_line + 1;
    return error;
  }
  layout.choice = std::move(choice).value();
  if (text.find_first_not_of(" \t\r\n\v\f", layout.data_offset) == std::string_view::npos) {
    return no_points(true);
  }
  return layout;
}

}  // namespace beespace::io
