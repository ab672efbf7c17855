// What tables of aircraft have beside other tables of fixes: flights as names, aircraft on the
// ground, and records that say too little.
#pragma once

#include "io/recording/recording_options.hpp"
#include "io/table/column_choice.hpp"
#include "io/tracks/track_layout.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Whether a text says that something is not known, as tables write it.
bool is_unknown(std::string_view text);
// Whether it says yes: "True", "1"; or no.
bool says_yes(std::string_view text);
bool says_no(std::string_view text);

// Whether the column is called as the flight is: "callsign".
bool names_flight(std::string_view column);

// Whether columns are called as those of aircraft that carry people are: by addresses, call signs.
bool name_aircraft(const std::vector<std::string>& columns);
// The same, or its units are nautical miles.
bool tells_of_aircraft(const TrackLayout& layout);

// Fills in what is told of aircraft where the header speaks of them; the position and the id are
// there already.
void settle_aircraft(const Header& header, const RecordingOptions& options, TrackLayout& layout);

}  // namespace beespace::io
