// A log of PX4 (ULog) -> the bee of a recording.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Into the source that `assembly` has begun, whose path is `path` and names the bee. Longitude and
// latitude are taken where there are any and metres are not asked for: those of
// vehicle_global_position, otherwise of vehicle_local_position with its reference. Times are UTC by
// GPS, otherwise since the drone was switched on, which no other input can be compared with.
std::optional<Error> read_flight(std::string_view bytes, std::string_view path,
                                 RecordingAssembly& assembly);

}  // namespace beespace::io
