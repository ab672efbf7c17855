// What to type where a header names no position: the columns that it does name, and those of
// numbers that may be the position.
#pragma once

#include "io/table/column_choice.hpp"

#include <string>

namespace beespace::io {

// "id=1,time=8,x=2,y=3,z=4", or "id=1,time=2,x=3,y=4"; of degrees "lon=...,lat=..." instead. Empty
// where fewer than two columns may be a coordinate.
std::string offered_columns(const Header& header, bool degrees);

}  // namespace beespace::io
