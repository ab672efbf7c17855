// What can be wrong with a record of a text table, in sentences. The errors have their column, but
// no line, record or source yet.
#pragma once

#include "io/bytes/number.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

Error at_column(ErrorCode code, std::string message, std::size_t column);

// kMissingColumn, of a table as a whole.
Error missing_column(std::string message);

// kMalformedRecord: beyond the limit of fields.hpp.
Error long_line(std::string_view line);
// The same of a line whose end has not been read yet, and is not looked for: what follows it could
// only be guessed.
Error line_without_end(std::string_view beginning);

// kMalformedRecord: it begins with "#", and is_comment() does not hold.
Error comment_or_record(std::string_view line);

// What is wrong with the line as a whole, after a FieldCursor went through it: `count` fields, and
// its problem(). Errors: kUnsupportedFormat (NUL bytes), kMalformedRecord, kColumnCount.
std::optional<Error> record_problem(std::string_view line, const TableLayout& layout,
                                    std::size_t count, std::string_view cursor_problem);

// kMalformedRecord: the line is another header than that of the table, or the same written
// otherwise; what follows may have other columns. Nothing where it is none.
std::optional<Error> other_header_problem(std::string_view line, const TableLayout& layout);

// What is to be said where the header came again so often.
std::string repeated_headers_note(std::uint64_t count);

// Why the text of a field, without padding, is not the number that `name` needs. Of numbers that
// are too small, `least` says which are not: "3.9e-121 m to 2.6e+120 m".
Error number_problem(NumberKind kind, std::string_view text, std::string_view name,
                     std::string_view least, std::size_t column);

}  // namespace beespace::io
