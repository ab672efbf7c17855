// Columns that say which study, trial, video or day a record is of, within which names of bees are
// unique.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <string>

namespace beespace::io {

// Fills in such columns, and says so; the time and the id are there already.
void settle_sets(const Header& header, TrackLayout& layout);

// Fills in the columns that say of which scene a place is (names_scene()), where it may have an
// origin of its own: in pixels, mm or the like, unless --crs metres says that there is one.
void settle_scenes(const Header& header, const RecordingOptions& options, TrackLayout& layout);

// Of the trials that times may begin again with, and of scenes: which column tells them, "column 1
// 'trial'"; and how the records of one are taken out of a text, up to its name.
std::string columns_of_trials(const TrackLayout& layout);
std::string filter_of_trials(const TrackLayout& layout);
std::string columns_of_scenes(const TrackLayout& layout);
std::string filter_of_scenes(const TrackLayout& layout);

}  // namespace beespace::io
