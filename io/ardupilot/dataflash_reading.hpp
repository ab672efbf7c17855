// A DataFlash log of ArduPilot (.bin) -> the bee of a recording.
#pragma once

#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Into the source that `assembly` has begun, whose path is `path` and names the bee. Positions are
// those of POS: longitude, latitude, height above mean sea level. Times are UTC by GPS, otherwise
// since the vehicle was switched on, which no other input can be compared with.
std::optional<Error> read_dataflash(std::string_view bytes, std::string_view path,
                                    RecordingAssembly& assembly);

}  // namespace beespace::io
