// The fast way through a text table: lines of three plain decimals and nothing else.
//
// One pass finds the numbers, the delimiters and the line ends; there is no separate search for
// newlines. It gives the same doubles as read_record(), and leaves every line that is not plain
// (exponents, quotes, blanks, errors) to that. Single-threaded; allocates only for `points`.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <vector>

namespace beespace::io {

// Reading one line touches at most this many bytes from its start.
inline constexpr std::size_t kPlainLineReach = 128;

// Whether the table has three columns, each a coordinate.
bool has_plain_lines(const TableLayout& layout);

// Appends the points of plain lines from `begin`, the start of a line, until a line that is not
// plain or that starts at or behind `stop`; returns the start of that line. Every line appended is
// one record. `stop + kPlainLineReach` must be readable.
const char* read_plain_lines(const char* begin, const char* stop, const TableLayout& layout,
                             std::vector<Point>& points);

// One line; false when it is not plain. `begin + kPlainLineReach` must be readable.
bool read_plain_line(const char* begin, const TableLayout& layout, Point& point);

}  // namespace beespace::io
