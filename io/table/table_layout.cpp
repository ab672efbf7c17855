#include "io/table/table_layout.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/column_names.hpp"
#include "io/table/delimiter.hpp"
#include "io/table/fields.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/record_problems.hpp"
#include "io/table/title_lines.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::size_t kSampleLines = 16;
constexpr std::size_t kSampleBytes = std::size_t{1} << 16;

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
    // The first one whole; of others no halves.
    const bool taken = lines.empty() || line.text.size() <= kSampleBytes;
    const bool says_something =
        !is_blank_line(line.text) && !has_comment_sign(line.text) && !is_ruler(line.text);
    if (taken && says_something) lines.push_back(line.text);
    offset = line.next;
  }
  return lines;
}

// The fields of a line and what they look like.
struct LineFields {
  std::vector<std::string> fields = {};
  std::vector<ColumnContent> contents = {};

  [[nodiscard]] bool has_number() const {
    return std::find(contents.begin(), contents.end(), ColumnContent::kNumber) != contents.end();
  }
};

ColumnContent content_of_field(std::string_view text) {
  text = without_padding(text);
  if (looks_numeric(text)) return ColumnContent::kNumber;
  const std::string lower = lower_case(text);
  for (const std::string_view nothing :
       {"", "n/a", "#n/a", "na", "null", "none", "nil", "-", "--", ".", "?"}) {
    if (lower == nothing) return ColumnContent::kUnknown;
  }
  return ColumnContent::kText;
}

Result<LineFields> read_fields(std::string_view line, char delimiter) {
  LineFields found;
  Field field;
  FieldCursor cursor(line, delimiter);
  while (cursor.next(field)) {
    found.fields.push_back(unquoted(field));
    found.contents.push_back(content_of_field(field.text));
  }
  if (!cursor.problem().empty()) {
    Error error{ErrorCode::kMalformedRecord,
                std::string(cursor.problem()) + ": " + excerpt(line) +
                    "; correct the line, a record may not span several lines",
                {}};
    error.location.column = found.fields.size() + 1;
    return error;
  }
  return found;
}

// What most of the lines from `first` on have in common: how many columns, and what they hold.
std::vector<ColumnContent> look_at_records(const std::vector<std::string_view>& lines,
                                           std::size_t first, char delimiter) {
  std::vector<LineFields> records;
  for (std::size_t i = first; i < lines.size(); ++i) {
    auto record = read_fields(lines[i], delimiter);
    if (record) records.push_back(std::move(record).value());
  }
  std::size_t columns = 0;
  std::ptrdiff_t most = 0;
  for (const LineFields& record : records) {
    const std::size_t fields = record.fields.size();
    const auto alike = std::count_if(records.begin(), records.end(), [fields](const auto& other) {
      return other.fields.size() == fields;
    });
    if (alike > most) {
      most = alike;
      columns = fields;
    }
  }
  std::vector<ColumnContent> contents(columns, ColumnContent::kUnknown);
  for (const LineFields& record : records) {
    if (record.fields.size() != columns) continue;
    for (std::size_t i = 0; i < columns; ++i) {
      if (contents[i] != ColumnContent::kNumber && record.contents[i] != ColumnContent::kUnknown) {
        contents[i] = record.contents[i];
      }
    }
  }
  return contents;
}

bool is_value_like(const std::string& field) {
  const std::string_view text = without_padding(field);
  if (content_of_field(text) == ColumnContent::kUnknown) return true;
  const std::size_t digit = text.find_first_not_of("+-.");
  return digit != std::string_view::npos && text[digit] >= '0' && text[digit] <= '9';
}

// Whether a first line without any number is a damaged record rather than names. A name that is
// known, or a comment sign, makes it a header.
std::optional<std::size_t> damaged_value(const LineFields& line) {
  for (const std::string& name : line.fields) {
    if (content_of_field(name) == ColumnContent::kUnknown) continue;
    const ColumnMeaning word = read_column_name(position_columns(), name);
    if (word.role != Role::kNone || word.says_position) return std::nullopt;
  }
  const auto begin = line.fields.begin();
  const auto full = std::find_if(begin, line.fields.end(), [](const std::string& field) {
    return !without_padding(field).empty() && is_value_like(field);
  });
  if (full != line.fields.end()) return static_cast<std::size_t>(full - begin);
  if (std::all_of(begin, line.fields.end(), is_value_like)) return 0;
  return std::nullopt;
}

Error no_points(bool header) {
  return {ErrorCode::kNoPoints,
          header ? "there is a header and no record after it; at least one point is needed"
                 : "the input is empty; at least one point is needed",
          {}};
}

// The line without the "#" that some programs put before the names.
std::string_view without_comment_sign(std::string_view line) {
  return has_comment_sign(line) ? without_padding(without_padding(line).substr(1)) : line;
}

// Whether it has as many columns as a record, two or all of them numbers.
bool has_columns_of_record(std::string_view line, const TableLayout& layout) {
  const std::size_t most = std::min<std::size_t>(2, layout.columns);
  for (const std::string_view text : {line, without_comment_sign(line)}) {
    const FieldCount count = count_fields(text, layout.delimiter);
    if (count.fields == layout.columns && count.numeric >= most) return true;
  }
  return false;
}

Error at_line(Error error, std::uint64_t line) {
  error.location.line = line;
  return error;
}

Error comment_error(std::string_view line, std::string_view why) {
  return {ErrorCode::kMalformedRecord,
          "a comment line: " + excerpt(line) + " " + std::string(why) +
              ", or remove it (where it names the columns: # x y z)",
          {}};
}

// A comment before the table.
struct Comment {
  std::string_view text;
  std::uint64_t line = 0;  // 1-based
};

// Whether some of its words say a position, whatever stands between them.
bool names_columns(std::string_view comment) {
  return std::any_of(std::begin(kDelimiters), std::end(kDelimiters), [comment](char delimiter) {
    return header_names(comment, delimiter).has_value();
  });
}

// The comment that names the columns of records that have so many, in `header`, or none does.
std::optional<Error> find_header(const std::vector<Comment>& comments, TableLayout& layout) {
  bool found = false;
  std::optional<Comment> other;
  for (const Comment& comment : comments) {
    const std::string_view names = without_comment_sign(comment.text);
    auto fields = read_fields(names, layout.delimiter);
    if (!fields || fields->has_number() || fields->fields.size() != layout.contents.size()) {
      if (!other && names_columns(comment.text)) other = comment;
      continue;
    }
    if (found) {
      Error error =
          comment_error(comment.text, "may name the columns, and so may one before it; remove one");
      error.location.line = comment.line;
      return error;
    }
    found = true;
    layout.header = names;
    layout.names = std::move(fields->fields);
  }
  if (found || !other) return std::nullopt;
  Error error = comment_error(other->text,
                              "seems to name the columns, but not as many as there "
                              "are; correct it");
  error.location.line = other->line;
  return error;
}

// Takes the first line as the header, where it is one, or a comment before it.
std::optional<Error> read_header_line(const std::vector<std::string_view>& samples,
                                      const std::vector<Comment>& comments, const Line& line,
                                      bool skip_bad, TableLayout& layout) {
  auto first = read_fields(line.text, layout.delimiter);
  if (!first) return first.error();
  if (first->has_number()) return find_header(comments, layout);
  if (const auto damaged = damaged_value(first.value())) {
    if (skip_bad) return find_header(comments, layout);
    Error error{ErrorCode::kNotANumber,
                excerpt(first->fields[*damaged]) +
                    " is neither a number nor the name of a column; correct the line, or put a "
                    "header before it",
                {}};
    error.location.column = *damaged + 1;
    return error;
  }
  std::vector<ColumnContent> contents = look_at_records(samples, 1, layout.delimiter);
  const std::size_t count = first->fields.size();
  layout.header = line.text;
  layout.names = std::move(first->fields);
  layout.data_offset = line.next;
  layout.lines_before += 1;
  contents.resize(count, ColumnContent::kUnknown);
  layout.contents = std::move(contents);
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<std::string>> header_names(std::string_view line, char delimiter) {
  auto fields = read_fields(without_comment_sign(line), delimiter);
  if (!fields || fields->has_number() || damaged_value(fields.value())) return std::nullopt;
  std::size_t positions = 0;
  for (std::string& name : fields->fields) {
    name = std::string(without_padding(name));
    const ColumnMeaning word = read_column_name(position_columns(), name);
    const bool id = word.role == Role::kId;
    if (word.says_position || (word.role != Role::kNone && !id)) ++positions;
  }
  if (positions < 2) return std::nullopt;
  return std::move(fields->fields);
}

bool is_ruler(std::string_view line) {
  const std::string_view text = without_padding(line);
  constexpr std::size_t kShortest = 3;
  return text.size() >= kShortest && text.front() == '+' && text.back() == '+' &&
         text.find_first_not_of("+-=") == std::string_view::npos;
}

bool has_comment_sign(std::string_view line) {
  const std::string_view text = without_padding(line);
  return !text.empty() && text.front() == '#';
}

// What could be a record that somebody does not want, or an id, is for the reader of records to
// refuse.
bool is_comment(std::string_view line, const TableLayout& layout) {
  if (is_ruler(line)) return true;
  if (!has_comment_sign(line)) return false;
  if (has_columns_of_record(line, layout)) return false;
  const std::string_view text = without_comment_sign(line);
  const auto has_number = [text](char delimiter) {
    const FieldCount count = count_fields(text, delimiter);
    return count.fields > 1 && count.numeric > 0;
  };
  if (has_number(',') || has_number(';') || has_number('\t')) return false;
  if (layout.delimiter != ' ') return !has_number(layout.delimiter);
  // Words of people are apart by blanks, too.
  const FieldCount count = count_fields(text, ' ');
  return count.numeric < 2 || 2 * count.numeric < count.fields;
}

std::optional<Error> no_record_problem(std::string_view text, const TableLayout& layout) {
  for (std::size_t offset = layout.data_offset; offset < text.size();) {
    const Line line = line_at(text, offset, layout.line_end);
    if (!is_blank_line(line.text) && !is_comment(line.text, layout)) return std::nullopt;
    offset = line.next;
  }
  return no_points(true);
}

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

Error at_first_line(Error error, const TableLayout& table) {
  if (error.location.line) return error;
  if (error.code != ErrorCode::kInvalidArgument || error.location.column) {
    error.location.line = table.lines_before + (table.header.empty() ? 1 : 0);
  }
  return error;
}

Result<TableLayout> find_table(std::string_view text, bool skip_bad) {
  TableLayout layout;
  layout.line_end = find_line_end(text);
  std::size_t offset = 0;
  Line line{{}, 0};
  std::vector<Comment> comments;
  std::optional<char> named;  // the delimiter
  while (true) {
    if (offset >= text.size()) return no_points(!comments.empty());
    line = line_at(text, offset, layout.line_end);
    const bool comment = has_comment_sign(line.text);
    if (comment) comments.push_back({line.text, layout.lines_before + 1});
    if (line.text.size() > kLongestLine) {
      return at_line(long_line(line.text), layout.lines_before + 1);
    }
    if (!comment && !is_blank_line(line.text) && !is_ruler(line.text)) {
      auto excel = named ? Result<std::optional<char>>(std::optional<char>())
                         : delimiter_named_by(line.text);
      if (!excel) return at_line(std::move(excel).error(), layout.lines_before + 1);
      if (!*excel) break;
      named = *excel;
    }
    offset = line.next;
    ++layout.lines_before;
  }
  const auto pass_over = [&](const TitleLines& titles) {
    if (titles.lines == 0) return;
    layout.notes.push_back("what stands above the header is passed over: " + excerpt(titles.first));
    layout.lines_before += titles.lines;
    layout.titles_say_utc = titles.says_utc;
    offset = titles.offset;
    line = line_at(text, offset, layout.line_end);
  };
  pass_over(titles_by_their_word(text, offset, layout));
  auto samples = sample_lines(text, offset, layout.line_end);
  layout.delimiter = named ? *named : find_delimiter(samples);
  layout.contents = look_at_records(samples, 0, layout.delimiter);
  const auto titles = titles_above(text, offset, layout);
  if (!titles) {
    Error error = titles.error();
    *error.location.line += layout.lines_before;
    return error;
  }
  pass_over(*titles);
  if (titles->lines > 0) samples = sample_lines(text, offset, layout.line_end);
  layout.data_offset = offset;
  const std::uint64_t line_number = layout.lines_before + 1;
  if (auto error = read_header_line(samples, comments, line, skip_bad, layout)) {
    if (error->code != ErrorCode::kInvalidArgument && !error->location.line) {
      error->location.line = line_number;
    }
    return *std::move(error);
  }
  layout.columns = layout.contents.size();
  const bool header_behind = layout.header.data() == line.text.data();
  for (const Comment& comment : comments) {
    if (header_behind || !has_columns_of_record(comment.text, layout)) continue;
    Error error = without_advice(comment_or_record(comment.text));
    error.location.line = comment.line;
    return error;
  }
  return layout;
}

Result<TableLayout> find_layout(std::string_view text, const ColumnOptions& options) {
  auto layout = find_table(text, options.skip_bad);
  if (!layout) return layout;
  auto choice = choose_columns(*layout, options);
  if (!choice) return at_first_line(std::move(choice).error(), *layout);
  layout->choice = std::move(choice).value();
  if (auto error = no_record_problem(text, *layout)) return *std::move(error);
  return layout;
}

}  // namespace beespace::io
