// One line of a text table -> one point, in every notation that is allowed, or what is wrong.
#pragma once

#include "io/table/fields.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// `line` has no line end. The error has its column, but no line, record or source yet.
// Errors: kMalformedRecord, kUnsupportedFormat (NUL bytes), kColumnCount, kNotANumber, kNotFinite.
std::optional<Error> read_record(std::string_view line, const TableLayout& layout, Point& point);

// Field `column` (0-based) of the line; empty when there is none.
Field field_at(std::string_view line, char delimiter, std::size_t column);

}  // namespace beespace::io
