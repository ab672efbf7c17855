// A table with columns for each animal and a row for each picture, as idtracker.ai writes it:
// time,x1,y1,x2,y2,... (its older versions: seconds, or no time at all, then rows are frames), and
// AnimalTA: Frame;Time;X_Arena0_Ind0;Y_Arena0_Ind0;...
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether a table has such a header, of two animals or more. `text` has no byte-order mark.
bool is_wide_table(std::string_view text);

// Into the source that `assembly` has begun. Animals are called by their numbers, or as
// "Arena0_Ind1". Errors have the line, and say the coordinate.
std::optional<Error> read_wide_table(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
