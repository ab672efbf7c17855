// Columns that say which study, trial, video or day a record is of, within which names of bees are
// unique.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <string>

namespace beespace::io {

// Fills in such columns, and says so; the time and the id are there already.
void settle_sets(const Header& header, TrackLayout& layout);

// Of the trials that times may begin again with: which column tells them, "column 1 'trial'"; and
// how the records of one are taken out of a text, up to its name.
std::string columns_of_trials(const TrackLayout& layout);
std::string filter_of_trials(const TrackLayout& layout);

}  // namespace beespace::io
