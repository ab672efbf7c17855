// Columns that say on which side of the equator, and of Greenwich, degrees without a sign are:
// "N/S" and "E/W", as loggers write them.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

using Sides = std::array<std::optional<std::size_t>, 2>;  // of longitude, of latitude

// By their names and first values; `text` is all of the table, as table.data_offset counts.
Sides find_sides(std::string_view text, const TableLayout& table);

// Of longitude (0) or latitude (1): gives `degrees` the sign that the side says. What is wrong, as
// a sentence; nothing when all is well.
std::string take_side(std::size_t axis, std::string_view side, double& degrees);

// The first record, if any, that is in the south or west by such a column: for what reads none.
// `text` begins with a record. Errors: kMalformedRecord, with line from 1 and column.
std::optional<Error> southern_or_western(std::string_view text, const TableLayout& table,
                                         const Sides& sides);

}  // namespace beespace::io
