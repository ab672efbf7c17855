// The column of a table in which what found the places says how far off each may be.
#pragma once

#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

namespace beespace::io {

// "eobs:horizontal-accuracy-estimate", "location-error-numerical", "hAcc", "3D_Error [m]",
// "accuracy": of places on the Earth, in metres where no unit is said. Once the layout knows where
// the position is.
void settle_accuracy(const Header& header, TrackLayout& layout);

}  // namespace beespace::io
