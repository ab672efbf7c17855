// PX4's local positions as tables: metres north, east and down of a place on the Earth that each
// record names, and that is another one for each drone. They are brought to longitude and latitude.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/tracks/track_layout.hpp"
#include "io/tracks/track_record.hpp"

#include <optional>
#include <string_view>

namespace beespace::io {

// Sets the columns in which each record says whether the drone knows its place, in degrees or not,
// and its height.
void settle_known_places(TrackLayout& layout);

// Where it is told; nothing where the table is of another kind.
std::optional<LocalOrigin> local_origin_of(const TrackLayout& layout);

// Sets `layout.local_origin`, and what follows from it, where the table is one and the caller does
// not say that all count from one place.
void settle_local_origin(const RecordingOptions& options, TrackLayout& layout);

// A record that was read, and has no place where its origin is not known.
void bring_to_degrees(std::string_view line, const TrackLayout& layout, TrackRecord& record);

}  // namespace beespace::io
