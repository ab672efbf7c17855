// Where no column is known to hold the id: whether one that is not understood does, as its values
// explain why the one bee that the file would be goes to and fro.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// `layout` is chosen but for its id, and `text` are records of it. Errors: kMissingColumn.
std::optional<Error> unclear_id(std::string_view text, const Header& header,
                                const TrackLayout& layout);

}  // namespace beespace::io
