// Columns that say which study, trial, video or day a record is of, within which names of bees are
// unique.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

namespace beespace::io {

// Fills in such columns, and says so; the time and the id are there already.
void settle_sets(const Header& header, TrackLayout& layout);

}  // namespace beespace::io
