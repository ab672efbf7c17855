// Tables whose places are not in columns of their own: what to type.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// JSON with "position": [x, y, z], or {"x": x, ...}.
std::optional<Error> place_in_one_value(std::string_view text, const TableLayout& table);

// Columns under two lines of names, as pandas writes them: "agent,A,A,A", "coord,x,y,z".
std::optional<Error> columns_of_pandas(std::string_view text, const TableLayout& table);

}  // namespace beespace::io
