// What tables of animals have beside other tables of fixes: places that are not known in every
// picture, outliers that are marked, and tags that are on no animal.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

namespace beespace::io {

// Fills in what is told of fixes that are not of aircraft; the time, the position and the id are
// there already.
void settle_animals(const Header& header, TrackLayout& layout);

}  // namespace beespace::io
