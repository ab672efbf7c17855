// Paths of drones as clever-show plays them on COEX Clover: no header but perhaps a line with the
// name of the drone, then frame, x, y, z [m], yaw, red, green, blue.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/table_layout.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <string_view>

namespace beespace::io {

inline constexpr std::size_t kNoCloverTable = std::string_view::npos;

// Where the first of the records of such a table begins: 0, or behind the line with the name.
// kNoCloverTable for other tables.
std::size_t find_clover_records(std::string_view text);

// `table` has no header. Errors: kInvalidArgument where it is not said how many frames there are in
// a second.
Result<TrackLayout> clover_layout(TableLayout table, std::string_view text,
                                  const RecordingOptions& options, SeenRecords seen);

}  // namespace beespace::io
