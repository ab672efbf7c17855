// Tables whose numbers have decimal commas, as spreadsheets of many countries write them:
// "7,5;50,25".
#pragma once

#include "io/bytes/byte_source.hpp"

#include <optional>
#include <string_view>

namespace beespace::io {

// A copy of a table with decimal points, byte for byte as long. Nothing where it is not certain
// that commas are decimal: where fields may be separated by them, where a number has a point, or
// where all of them may stand between thousands ("1,250").
std::optional<Bytes> with_decimal_points(std::string_view text);

}  // namespace beespace::io
