// Where no column is known to hold the id: whether one that is not understood does, as its values
// explain why the one bee that the file would be goes to and fro. Where one is known: whether
// another one tells apart what is one bee by it, for the same reason.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string_view>

namespace beespace::io {

// Whether that column is read as nothing else, so that it may be the id.
bool may_hold_ids(const Header& header, const TrackLayout& layout, std::size_t column);

// `layout` is chosen but for its id, and `text` are records of it. Errors: kMissingColumn.
std::optional<Error> unclear_id(std::string_view text, const Header& header,
                                const TrackLayout& layout);

}  // namespace beespace::io
