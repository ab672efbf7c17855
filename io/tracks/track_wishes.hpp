// What the caller says of the columns of tracks: those of column_wishes.hpp, and time and velocity.
#pragma once

#include "io/table/column_choice.hpp"

#include <beespace/result.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct TrackWishes {
  std::string position = {};  // what is left for choose_columns(): "lon=3,lat=4,height=5"
  std::optional<std::size_t> id = {};
  std::optional<std::size_t> time = {};
  std::array<std::optional<std::size_t>, 3> velocity = {};  // x or east, y or north, z or up
};

// Errors: kInvalidArgument for what is not understood, kMissingColumn.
Result<TrackWishes> read_track_wishes(std::string_view text, const ColumnsSeen& seen);

}  // namespace beespace::io
