// Flights as EUROCONTROL's NEST and DDR2 write them (.so6): a segment a line, in 20 fields with
// blanks between. Each is a straight line from one place to another, at an even speed; places are
// in minutes of arc, heights in flight levels.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

bool is_so6(std::string_view text);

// Into the source that `assembly` has begun. Errors have lines: kMalformedRecord, and those of
// AircraftGathering.
std::optional<Error> read_so6(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
