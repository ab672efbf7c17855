// A file of BaseStation messages -> the bees of a recording.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether the first line that is not blank is such a message.
bool is_base_station(std::string_view bytes);

// Into the source that `assembly` has begun. Errors have line and column.
std::optional<Error> read_base_station(std::string_view bytes, RecordingAssembly& assembly);

}  // namespace beespace::io
