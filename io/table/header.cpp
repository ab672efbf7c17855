// What a header says: each name by the schema, and by the source that the table is of.
#include "io/bytes/characters.hpp"
#include "io/table/column_choice.hpp"
#include "io/table/column_names.hpp"
#include "io/table/header_words.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/table_sources.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

// Whether it is "device_id" beside "time_utc_usec", as PX4's vehicle_gps_position has it: that of
// a chip, the same in all drones.
bool is_of_a_chip(const std::string& name, const std::vector<std::string>& names) {
  return plain_name(name) == "device_id" &&
         std::any_of(names.begin(), names.end(),
                     [](const std::string& other) { return plain_name(other) == "time_utc_usec"; });
}

}  // namespace

Header::Header(const ColumnSchema& schema, const ColumnOptions& options, const TableLayout& table,
               const ColumnsByRole& overrides)
    : schema_(schema),
      options_(options),
      table_(table),
      overrides_(overrides),
      source_(source_of(table.names)) {
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    ColumnMeaning& meaning = meanings_.emplace_back(meaning_of(i));
    for (std::size_t role = index_of(Role::kId); role < kRoles; ++role) {
      if (overrides[role] != i) continue;
      meaning = {};
      meaning.role = static_cast<Role>(role);
    }
    by_role_[index_of(meaning.role)].push_back(i);
  }
  if (!schema.strict) prefer_plain_coordinates();
}

// By its name, and by the source that it is of.
ColumnMeaning Header::meaning_of(std::size_t column) const {
  if (is_of_a_quaternion(column)) return {};
  if (is_of_a_chip(table_.names[column], table_.names)) return {};
  if (source_ != nullptr && source_->no_id == plain_name(table_.names[column])) return {};
  ColumnMeaning meaning = read_column_name(schema_, table_.names[column]);
  if (meaning.role == Role::kNone && is_flight_level(column)) {
    meaning.role = Role::kHeight;
    meaning.unit = Unit::kFlightLevel;
    meaning.datum = HeightDatum::kPressure;
  }
  if (source_ == nullptr) return meaning;
  const KnownColumn* const known = source_->find(table_.names[column]);
  if (known != nullptr) meaning.datum = known->datum;
  // "altitudeAMSL"
  if (known != nullptr && known->role == Role::kHeight && meaning.role == Role::kNone) {
    meaning.role = Role::kHeight;
  }
  if (known != nullptr && known->role != Role::kHeight && schema_.reads(known->role)) {
    meaning.role = known->role;
    // Of OpenSky; animals are filmed from a zero of their own.
    meaning.since_1970 = known->role == Role::kTime && source_->since_1970;
    if (known->role == Role::kTime) meaning.unit = known->unit;
    if (known->role == Role::kX || known->role == Role::kY) {
      meaning.frame = Frame::kMetres;
      meaning.says_length = true;
    }
  }
  if (!source_->of_animals) return meaning;
  // Of several the one that is meant. An event is one record.
  const auto first = source_->first(meaning.role, table_.names);
  const bool other =
      first ? *first != column
            : meaning.role == Role::kId && plain_name(table_.names[column]) == "event_id";
  return other && meaning.role != Role::kHeight ? ColumnMeaning() : meaning;
}

// Whether it is the height: beside one that is finer it is passed over.
bool Header::is_flight_level(std::size_t column) const {
  const std::string& name = table_.names[column];
  if (!schema_.reads(Role::kHeight) || !names_flight_level(name)) return false;
  const bool in_short = plain_name(name) == "fl";
  bool of_aircraft = !in_short;
  for (std::size_t i = 0; i < table_.names.size(); ++i) {
    if (i == column) continue;
    const Role role = read_column_name(schema_, table_.names[i]).role;
    if (role == Role::kHeight || role == Role::kZ) return false;
    of_aircraft = of_aircraft || speaks_of_aviation(table_.names[i]);
  }
  return of_aircraft;
}

// Whether it is "q_RS_x" beside "q_RS_w": an attitude, as EuRoC's tables have it.
bool Header::is_of_a_quaternion(std::size_t column) const {
  std::string name = plain_name(table_.names[column]);
  const std::size_t size = name.size();
  if (size < 3 || name[size - 2] != '_' || name[size - 1] < 'x' || name[size - 1] > 'z')
    return false;
  name.back() = 'w';
  return std::any_of(table_.names.begin(), table_.names.end(),
                     [&name](const std::string& other) { return plain_name(other) == name; });
}

// Where a coordinate comes several times, the one that can be read is meant, the one without "uav"
// before its name, the height of the wanted kind, and the one in metres.
void Header::prefer_plain_coordinates() {
  const bool pressure_wanted = options_.heights == HeightSource::kPressure ||
                               options_.heights == HeightSource::kRatherPressure;
  const auto leave_out = [this](std::vector<std::size_t>& columns, const auto& worse) {
    const auto is_worse = [this, &worse](std::size_t column) { return worse(meanings_[column]); };
    if (std::all_of(columns.begin(), columns.end(), is_worse)) return;
    columns.erase(std::remove_if(columns.begin(), columns.end(), is_worse), columns.end());
  };
  for (std::size_t role = index_of(Role::kLongitude); role <= index_of(Role::kZ); ++role) {
    auto& columns = by_role_[role];
    const auto is_empty = [this](std::size_t column) {
      return column < table_.contents.size() && table_.contents[column] == ColumnContent::kUnknown;
    };
    if (!std::all_of(columns.begin(), columns.end(), is_empty)) std::erase_if(columns, is_empty);
    leave_out(columns, [](const ColumnMeaning& of) { return !of.foreign_unit.empty(); });
    leave_out(columns, [](const ColumnMeaning& of) { return !of.prefix.empty(); });
    leave_out(columns, [pressure_wanted](const ColumnMeaning& of) {
      return (of.datum == HeightDatum::kPressure) != pressure_wanted;
    });
    // Longitude and latitude are of the ellipsoid.
    const bool ellipsoid = std::any_of(columns.begin(), columns.end(), [this](std::size_t column) {
      return meanings_[column].datum == HeightDatum::kEllipsoid;
    });
    if (ellipsoid) {
      leave_out(columns,
                [](const ColumnMeaning& of) { return of.datum == HeightDatum::kMeanSeaLevel; });
    }
    leave_out(columns, [](const ColumnMeaning& of) {
      return of.unit != Unit::kUnstated && of.unit != Unit::kMetre;
    });
  }
}

ColumnMeaning Header::stated(std::size_t column) const {
  if (column >= table_.names.size()) return {};
  return read_column_name(schema_, table_.names[column]);
}

}  // namespace beespace::io
