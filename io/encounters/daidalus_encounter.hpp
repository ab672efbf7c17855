// Encounters as DAIDALUS reads and writes them (.daa): a line of names, a line of units, then a row
// for each aircraft at each time, the ownship first.
//
//   NAME lat lon alt trk gs vs time               or   NAME sx sy sz vx vy vz time
//   [none] [deg] [deg] [ft] [deg] [knot] [fpm] [s]
//
// Commas or blanks lie between the values, and need not be the same in all lines; what stands
// behind
// "#" at the begin of a line is a comment.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

bool is_daidalus_encounter(std::string_view text);

// What to do about one without the line of units; nothing where that is there, or it is none.
std::optional<Error> missing_units_of_encounter(std::string_view text);

// Into the source that `assembly` has begun. Errors have line and column.
std::optional<Error> read_daidalus_encounter(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
