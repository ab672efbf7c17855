// Longitude and latitude as whole numbers of 1e-7 degrees: so MAVLink and PX4 have them;
// they look like metres.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether the first records can have nothing else in the columns of the position: whole numbers,
// some of them beyond all degrees.
bool are_scaled_degrees(std::string_view text, const TableLayout& table,
                        const ColumnChoice& position);

// What is to be said of them.
inline constexpr std::string_view kScaledDegreesNote =
    "longitude and latitude are whole numbers of 1e-7 degrees, as MAVLink and PX4 have them: their "
    "size tells";

// That such columns, by their names too, are to be taken for metres.
std::optional<Error> scaled_degrees_as_metres(std::string_view text, const TableLayout& table,
                                              const ColumnChoice& position);

// Of heights beside them, in whole numbers whose unit is not named: they are in millimetres
// where the header is that of a message that has them so. Errors: kInvalidArgument, with column,
// where the unit must be said.
std::optional<Error> settle_heights_beside(std::string_view text, const TableLayout& table,
                                           ColumnChoice& position);

// An error about units, which names those of aviation, with what MAVLink has for its aircraft.
Error with_millimetres(Error error, std::string_view text, const Header& header);

}  // namespace beespace::io
