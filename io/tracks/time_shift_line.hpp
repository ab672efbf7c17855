// What to type to set the clock of one file.
#pragma once

#include "io/tracks/track_layout.hpp"

#include <string>

namespace beespace::io {

// A line of awk that adds to the times of a table, with FILE for its name; empty where it is not
// split by one character. The layout has a time.
std::string time_shift_line(const TrackLayout& layout);

}  // namespace beespace::io
