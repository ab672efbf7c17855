// Latitude and longitude in one column, "48.0,2.0", as Flightradar24 exports flights.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

// The column that seems to hold both, whatever the others are.
std::optional<std::size_t> column_of_joined_place(const TableLayout& table);

// That column in a table of Flightradar24, unless the caller names columns of a position.
std::optional<std::size_t> joined_place_of(const Header& header);

// The position of such a table: the axes of longitude and latitude are that column. Errors: those
// of settle_coordinate_units().
Result<ColumnChoice> choose_joined_place(const Header& header, std::size_t column);

struct JoinedPlace {
  std::string_view latitude;
  std::string_view longitude;  // nothing where there is no comma
};

JoinedPlace split_place(std::string_view text);

}  // namespace beespace::io
