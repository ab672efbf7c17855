// Two columns of one time: dates to the second, and what counts on from record to record in smaller
// steps, as "datetime(utc)" and "time(millisecond)" of Airdata. Where both go on alike, the second
// one counts from a moment that the first one tells.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

// The time by both, of the records in `text`; nothing where they do not go on alike, where the
// dates are no instants, or where these tell the time as well.
std::optional<TimeChoice> find_fine_time(std::string_view text, const Header& header,
                                         std::size_t dated, std::size_t numbers,
                                         const RecordingOptions& options);

}  // namespace beespace::io
