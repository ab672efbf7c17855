// Tables whose header, or whose order of columns, names no position: what they are instead, and
// what to type.
#pragma once

#include "io/table/column_choice.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether the columns behind a position are the colours that a drone has there: red, green, blue.
bool names_colours(const TableLayout& table);

// A position must have names: it is not taken from the order of the columns.
std::optional<Error> nameless_position(std::string_view text, const Header& header);

// What is wrong with the time, and, so that it is asked for at once, with the position.
Error with_position_problem(Error time, std::string_view text, const Header& header);

}  // namespace beespace::io
