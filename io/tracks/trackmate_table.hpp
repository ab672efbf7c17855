// Tables of spots as TrackMate (Fiji) writes them: a header, perhaps two more rows of names and one
// of units, and then a row a spot. A spot is where a track is in a picture; its own label is no
// animal.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// `text` has no byte-order mark.
bool is_trackmate_table(std::string_view text);

// Into the source that `assembly` has begun. Errors have the line.
std::optional<Error> read_trackmate_table(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
