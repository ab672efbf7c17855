// Tables of videos in which a column 'track' numbers the animals, as trackers write them: elsewhere
// that is the direction in which an aircraft flies.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// The column, where nothing else is the id, no speed is beside it, and it tells apart the records
// of each moment; a note says so. `text` is all of the table, as table.data_offset counts.
std::optional<std::size_t> track_numbers(std::string_view text, const Header& header,
                                         const std::optional<TimeChoice>& time,
                                         std::vector<std::string>& notes);

}  // namespace beespace::io
