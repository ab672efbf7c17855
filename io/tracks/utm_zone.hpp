// The column of the UTM zone beside eastings and northings, which can be compared within one zone
// only.
#pragma once

#include "io/table/table_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

// Of a table whose position is chosen; nothing where it is no easting and northing.
std::optional<std::size_t> find_utm_zone(std::string_view text, const TableLayout& table);

// The same text for the same coordinates: a number, and the hemisphere, as far as that is clear.
// "32N", "32 n", "32T" and "32U" are one; "32S" may be one of the north or of the south.
std::string utm_zone_of(std::string_view text);

// Of the records of `text`, lines of that table behind its header, one that is of another zone than
// `zone`, which is that of the first record if it is not known yet. Errors: kUnknownFrame, with
// line and record counted from the beginning of the text, and column.
std::optional<Error> other_zone(std::string_view text, const TableLayout& table, std::size_t column,
                                std::optional<std::string>& zone);

}  // namespace beespace::io
