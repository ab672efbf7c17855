#include "io/tracks/scaled_degrees.hpp"

#include "io/bytes/number.hpp"
#include "io/table/column_names.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/record_problems.hpp"
#include "io/tracks/first_fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

namespace beespace::io {
namespace {

// The greatest of the first numbers; nothing where one of them is not whole.
std::optional<double> greatest_whole(std::string_view text, const TableLayout& table,
                                     std::size_t column) {
  const FirstFields fields = first_fields(text, table, column);
  if (fields.empty()) return std::nullopt;
  double greatest = 0.0;
  for (const std::string_view field : fields.texts) {
    double value = 0.0;
    if (parse_number(field, value) != NumberKind::kNumber || value != std::floor(value)) {
      return std::nullopt;
    }
    greatest = std::max(greatest, std::abs(value));
  }
  return greatest;
}

// GLOBAL_POSITION_INT, GPS_RAW_INT and UTM_GLOBAL_POSITION of MAVLink, vehicle_gps_position of
// PX4: a column that others with such degrees have not.
std::optional<std::size_t> column_of_millimetres(const TableLayout& table) {
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const std::string name = plain_name(table.names[i]);
    if (name.ends_with("relative_alt") || name.ends_with("alt_ellipsoid")) return i;
  }
  return std::nullopt;
}

}  // namespace

bool are_scaled_degrees(std::string_view text, const TableLayout& table,
                        const ColumnChoice& position) {
  constexpr double kBeyondDegrees = 10'000.0;
  const auto longitude = greatest_whole(text, table, position.axes[0]);
  const auto latitude = greatest_whole(text, table, position.axes[1]);
  return longitude && latitude && std::max(*longitude, *latitude) > kBeyondDegrees &&
         *longitude <= 360.0 * kScaledPerDegree && *latitude <= 90.0 * kScaledPerDegree;
}

std::optional<Error> scaled_degrees_as_metres(std::string_view text, const TableLayout& table,
                                              const ColumnChoice& position) {
  if (position.axes[0] >= table.names.size()) return std::nullopt;
  const Role role = read_column_name(position_columns(), table.names[position.axes[0]]).role;
  const bool named = role == Role::kLongitude || role == Role::kLatitude;
  if (!named || !are_scaled_degrees(text, table, position)) return std::nullopt;
  return Error{ErrorCode::kUnknownFrame,
               column_text(table, position.axes[0]) +
                   " is no coordinate in metres: its name and its size say that it has whole "
                   "numbers of 1e-7 degrees; leave --crs metres, x and y out",
               {}};
}

std::optional<Error> settle_heights_beside(std::string_view text, const TableLayout& table,
                                           ColumnChoice& position) {
  if (position.dimensions < 3 || position.units_taken.empty()) return std::nullopt;
  UnitTaken& taken = position.units_taken.back();
  const bool said =
      taken.evidence == UnitEvidence::kNamed || taken.evidence == UnitEvidence::kAsked;
  if (said || !greatest_whole(text, table, position.axes[2])) return std::nullopt;
  if (const auto witness = column_of_millimetres(table)) {
    taken.unit = Unit::kMillimetre;
    taken.evidence = UnitEvidence::kSource;
    taken.reason = "whole numbers beside those of 1e-7 degrees, with " +
                   column_text(table, *witness) + ", as MAVLink and PX4 have them";
    position.units[2] = Unit::kMillimetre;
    return std::nullopt;
  }
  return at_column(ErrorCode::kInvalidArgument,
                   column_text(table, position.axes[2]) +
                       " holds the height, in whole numbers beside those of 1e-7 degrees, but in "
                       "which unit? Most messages of MAVLink and PX4 have millimetres there, some "
                       "metres; say it with --units height=mm or height=m",
                   position.axes[2]);
}

Error with_millimetres(Error error, std::string_view text, const Header& header) {
  if (error.code != ErrorCode::kInvalidArgument) return error;
  if (!header.has(Role::kLongitude) || !header.has(Role::kLatitude)) return error;
  ColumnChoice position;
  position.axes = {header.columns(Role::kLongitude).front(),
                   header.columns(Role::kLatitude).front(), 0};
  if (are_scaled_degrees(text, header.table(), position)) {
    error.message +=
        "; beside whole numbers of 1e-7 degrees, as MAVLink has them, heights are mostly in mm: "
        "--units height=mm";
  }
  return error;
}

}  // namespace beespace::io
