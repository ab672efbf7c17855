#include "io/table/record_problems.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/skipped_records.hpp"
#include "io/table/fields.hpp"

#include <utility>

namespace beespace::io {
namespace {

Error count_error(std::size_t count, const TableLayout& layout, std::string_view line) {
  return {ErrorCode::kColumnCount,
          std::to_string(count) + (count == 1 ? " column" : " columns") + " where the " +
              (layout.header.empty() ? "table" : "header") + " has " +
              std::to_string(layout.columns) + ": " + excerpt(line) + "; correct it" +
              std::string(kOrLeaveOut),
          {}};
}

}  // namespace

Error missing_column(std::string message) {
  return {ErrorCode::kMissingColumn, std::move(message), {}};
}

Error at_column(ErrorCode code, std::string message, std::size_t column) {
  Error error{code, std::move(message), {}};
  error.location.column = column + 1;
  return error;
}

Error long_line(std::string_view line) {
  return {ErrorCode::kMalformedRecord,
          "a line of " + std::to_string(line.size()) + " bytes, beginning with " + excerpt(line) +
              ", is too long for a record (the limit is 1 MiB)",
          {}};
}

Error line_without_end(std::string_view beginning) {
  return {ErrorCode::kMalformedRecord,
          "a line that begins with " + excerpt(beginning) +
              " is too long for a record (the limit is 1 MiB); with --memory such a line is not "
              "left out: correct it, or take it away",
          {}};
}

Error comment_or_record(std::string_view line) {
  return {ErrorCode::kMalformedRecord,
          "a comment, or a record? " + excerpt(line) +
              " begins with # and has numbers as a record has; remove it, or let no id begin with "
              "#" +
              std::string(kOrLeaveOut),
          {}};
}

std::optional<Error> record_problem(std::string_view line, const TableLayout& layout,
                                    std::size_t count, std::string_view cursor_problem) {
  if (line.find('\0') != std::string_view::npos) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "a NUL byte stands in this line: " + excerpt(line) +
                     "; this is no text table, or it is damaged",
                 {}};
  }
  if (has_comment_sign(line)) return comment_or_record(line);
  if (!cursor_problem.empty()) {
    return at_column(ErrorCode::kMalformedRecord,
                     std::string(cursor_problem) + ": " + excerpt(line) +
                         "; correct the line, a record may not span several lines",
                     count);
  }
  if (count != layout.columns) return count_error(count, layout, line);
  return std::nullopt;
}

std::optional<Error> other_header_problem(std::string_view line, const TableLayout& layout) {
  if (layout.header.empty() || !header_names(line, layout.delimiter)) return std::nullopt;
  return Error{ErrorCode::kMalformedRecord,
               "another header, " + excerpt(line) + ", than " + excerpt(layout.header) +
                   " before: read tables of different columns each for itself, or take this line "
                   "out if the columns are the same",
               {}};
}

std::string repeated_headers_note(std::uint64_t count) {
  return (count == 1 ? std::string("1 line is the header again and is passed over")
                     : std::to_string(count) + " lines are the header again and are passed over") +
         ", as where tables were joined";
}

Error number_problem(NumberKind kind, std::string_view text, std::string_view name,
                     std::string_view least, std::size_t column) {
  const std::string role = " (" + std::string(name) + "); ";
  if (kind == NumberKind::kNotFinite) {
    return at_column(
        ErrorCode::kNotFinite,
        excerpt(text) + " is no position" + role + "correct it" + std::string(kOrLeaveOut), column);
  }
  if (kind == NumberKind::kTooLarge) {
    return at_column(ErrorCode::kNotFinite,
                     excerpt(text) + " is too large for a number" + role + "correct it", column);
  }
  if (kind == NumberKind::kTooSmall) {
    return at_column(
        ErrorCode::kOutsideDomain,
        excerpt(text) + " is too small for a number" + role + "use 0, or " + std::string(least),
        column);
  }
  if (text.empty()) {
    return at_column(ErrorCode::kNotANumber,
                     "the field is empty where a number should be" + role + "fill it in" +
                         std::string(kOrLeaveOut),
                     column);
  }
  const bool comma = text.find(',') != std::string_view::npos;
  return at_column(ErrorCode::kNotANumber,
                   excerpt(text) + " is not a number" + role +
                       (comma ? std::string("write decimals with a point, not with a comma")
                              : "correct it" + std::string(kOrLeaveOut)),
                   column);
}

}  // namespace beespace::io
