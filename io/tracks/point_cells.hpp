// Tables in which a place is one cell, as R's sf and move2 and GIS programs write them: "POINT
// (9.07 47.7)", or "c(9.07, 47.7)" in quotes.
#pragma once

#include "io/bytes/byte_source.hpp"

#include <optional>
#include <string_view>

namespace beespace::io {

// What is noted of an input that was read so.
constexpr std::string_view kTakenFromPoints =
    "places are points in one cell, of which the first number is x, the second y";

// The same table with columns x, y, and z where points have three numbers, instead of the one that
// has points; in its place an empty one has as many empty cells. Nothing where there is no such
// column.
std::optional<Bytes> with_split_points(std::string_view text);

}  // namespace beespace::io
