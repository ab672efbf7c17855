// Recordings of AirSim (airsim_rec.txt): metres north, east and down, of each vehicle from where it
// began.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Of such a table: turns the axes of the layout, whose columns the caller has not said. Errors:
// kUnknownFrame for several vehicles, unless the caller says that all count from one place.
std::optional<Error> settle_airsim(std::string_view text, const RecordingOptions& options,
                                   TrackLayout& layout);

}  // namespace beespace::io
