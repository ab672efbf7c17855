// Tables of known sources, told by their whole header: what it says of units without naming them.
// They are data (table_sources.cpp).
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

}  // namespace beespace::io
