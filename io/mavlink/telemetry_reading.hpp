// A telemetry log of MAVLink -> the bees of a recording, one a system.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Into the source that `assembly` has begun, whose path is `path`. Positions on the Earth (message
// 33) are taken where there are any and metres are not asked for, otherwise local ones (message
// 32). Errors have the record: the frame, counted from 0.
std::optional<Error> read_telemetry(std::string_view bytes, std::string_view path,
                                    RecordingAssembly& assembly);

}  // namespace beespace::io
