// Tables of known sources, told by their whole header, and the words of aviation: what a header
// says of units without naming them. Both are data (table_sources.cpp).
#pragma once

#include "io/table/column_schema.hpp"
#include "io/units/heights.hpp"
#include "io/units/units.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// A column of a known source, and what it holds beyond what its name says.
struct KnownColumn {
  std::string_view name;
  Role role = Role::kNone;
  Unit unit = Unit::kUnstated;
  HeightDatum datum = HeightDatum::kUnstated;
  bool needed = true;  // for the source to be told
};

struct TableSource {
  std::string_view name;      // "traffic"
  std::string_view contrary;  // a word that its headers never have; blanks between several
  std::vector<KnownColumn> columns;
  bool in_utc = false;      // dates and times that name no zone
  bool of_animals = false;  // what else it has is neither a place nor an id, nor of aircraft
  bool infinite_is_unknown = false;  // of places
  bool since_1970 = false;           // what its times count from
  bool since_start = false;          // or: since the vehicle of that table was switched on
  // Of heights and speeds whose units its headers leave open: why, as a sentence.
  std::string_view units_differ = {};
  bool ground_at_zero = false;  // of aircraft: heights of 0 are of no one that flies
  bool of_aircraft = false;     // though no column may say so
  std::string_view no_id = {};  // a column that looks like an id, and is one of something else

  // Nothing for columns that say all by themselves. Of several of a role the first one counts.
  [[nodiscard]] const KnownColumn* find(std::string_view column) const;
  // The column that is meant where several may be of that role; nothing where none of those that
  // this source has is there.
  [[nodiscard]] std::optional<std::size_t> first(Role role,
                                                 const std::vector<std::string>& names) const;
};

inline constexpr std::string_view kFlightradar24 = "Flightradar24";
inline constexpr std::string_view kTraffic = "traffic";
inline constexpr std::string_view kQGroundControl = "QGroundControl";

// The source whose documented header this is: all its columns are there, and none that it never
// has. In any case.
const TableSource* source_of(const std::vector<std::string>& names);

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
