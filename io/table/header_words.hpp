// Words of headers, each a list: those of aviation, of what records are sorted by, and of what is
// measured beside places.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// Whether a column is one that tables of aircraft have and others do not: "icao24", "squawk".
bool speaks_of_aviation(std::string_view name);

// The first columns that do, at most three: "'icao24' and 'groundspeed'"; empty where none does.
std::string words_of_aviation(const std::vector<std::string>& names);

// Whether it says which study, trial or video a record is of, within which ids are unique.
bool names_set(std::string_view column);
// Whether it says which session or run a record is of, as numbers of time begin again with each.
bool names_session(std::string_view column);
// Whether it says in which zone eastings and northings are counted.
bool names_zone(std::string_view column);
// Of sets: places beside each other, which have one clock.
bool names_arena(std::string_view column);
// Whether it says in front of which camera, on which side of a comb or in which arena a place is:
// each may have an origin of its own, and who is in one does not meet who is in another.
bool names_scene(std::string_view column);

// Whether a name speaks of something that is measured beside places and is none: "speed",
// "likelihood", "temperature".
bool names_other_quantity(std::string_view name);

}  // namespace beespace::io
