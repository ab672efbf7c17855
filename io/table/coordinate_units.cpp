#include "io/table/coordinate_units.hpp"

#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/position_columns.hpp"
#include "io/table/table_sources.hpp"
#include "io/table/unit_choice.hpp"

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

bool is_pixel(std::string_view word) {
  return word == "px" || word == "pixel" || word == "pixels";
}

// What the column's name says of a coordinate, whatever the caller takes it for. One that is not
// understood may name its unit all the same: "posx(cm)".
ColumnMeaning stated(const ColumnSchema& schema, const TableLayout& table, std::size_t column) {
  if (column >= table.names.size()) return {};
  ColumnMeaning meaning = read_column_name(schema, table.names[column]);
  if (meaning.role != Role::kNone && meaning.role <= Role::kZ) return meaning;
  std::vector<std::string> words = split_words(table.names[column]);
  ColumnMeaning last;
  if (names_flight_level(table.names[column])) {
    last.unit = Unit::kFlightLevel;
    last.datum = HeightDatum::kPressure;
  } else if (const auto unit = take_unit(words, Quantity::kLength)) {
    last.unit = *unit;
  } else if (words.size() > 1 && is_pixel(words.back())) {
    last.foreign_unit = words.back();
  }
  return last;
}

// Of what is named: a unit that is not read, or one of length where degrees are.
std::optional<Error> unit_problem(const ColumnSchema& schema, const TableLayout& table,
                                  const ColumnChoice& choice, bool geographic,
                                  bool pixels_are_told) {
  for (std::size_t axis = 0; axis < choice.dimensions && !table.names.empty(); ++axis) {
    const std::size_t column = choice.axes[axis];
    const ColumnMeaning word = stated(schema, table, column);
    std::string unit = word.foreign_unit;
    if (!geographic && is_pixel(unit)) {
      if (pixels_are_told) continue;
      Error error{ErrorCode::kInvalidArgument,
                  "column " + excerpt(table.names[column]) + std::string(kIsInPixels) +
                      ": say how long one is, as in --scale 0.1mm (--scale 1 takes it "
                      "for a metre)",
                  {}};
      error.location.column = column + 1;
      return error;
    }
    if (geographic && axis < 2 && word.unit != Unit::kUnstated) unit = symbol_of(word.unit);
    if (unit.empty()) continue;
    Error error{ErrorCode::kUnsupportedFormat,
                "column " + excerpt(table.names[column]) + " is in '" + unit +
                    "', but longitudes and latitudes are read in degrees, and coordinates as "
                    "lengths; convert it first, or say --crs metres if these are lengths",
                {}};
    error.location.column = column + 1;
    return error;
  }
  return std::nullopt;
}

Error no_override(std::string_view what, const std::string& why) {
  return {ErrorCode::kInvalidArgument,
          "--units " + std::string(what) + "=... is given, but " + why + "; leave it out",
          {}};
}

// Crazyflie logs its estimate in metres, and in millimetres (int16) under the name with a Z.
Unit unit_of_crazyflie(std::string_view name) {
  const std::string plain = plain_name(name);
  if (plain.starts_with("stateestimatez_")) return Unit::kMillimetre;
  return plain.starts_with("stateestimate_") ? Unit::kMetre : Unit::kUnstated;
}

// The unit that the header names: of a known source perhaps behind a name that only its columns
// have, as "X#wcentroid (cm)" of TRex.
Unit named_unit(const ColumnMeaning& word, const KnownColumn* known) {
  if (word.unit != Unit::kUnstated || known == nullptr || known->unit == Unit::kUnstated) {
    return word.unit;
  }
  const std::size_t last = known->name.rfind('_') + 1;  // 0 where there is none
  return known->name.substr(last) == symbol_of(known->unit) ? known->unit : Unit::kUnstated;
}

Error not_in_pixels(const TableLayout& table, std::size_t column, Unit unit) {
  Error error{ErrorCode::kInvalidArgument,
              "column " + excerpt(table.names[column]) + " names its unit, " +
                  std::string(symbol_of(unit)) + ", but --scale is for pixels; leave it out",
              {}};
  error.location.column = column + 1;
  return error;
}

// Says of x, y and z together what holds for all of them.
std::vector<UnitTaken> put_together(const std::vector<UnitTaken>& taken) {
  std::vector<UnitTaken> together;
  for (const UnitTaken& one : taken) {
    if (!together.empty() && together.back().unit == one.unit) {
      std::string& of = together.back().of;
      if (const std::size_t before = of.find(" and "); before != std::string::npos) {
        of.replace(before, 5, ", ");
      }
      of += " and " + one.of;
    } else {
      together.push_back(one);
    }
  }
  return together;
}

// Which unit each coordinate has.
std::optional<Error> settle_units(const ColumnSchema& schema, const TableLayout& table,
                                  const ColumnOptions& options, ColumnChoice& choice) {
  const UnitOverrides& overrides = options.units;
  if (overrides.position != Unit::kUnstated && options.frame == Frame::kAuto &&
      choice.evidence == Frame::kAuto) {
    choice.evidence = Frame::kMetres;
    choice.reason = "--units gives positions a unit of length";
  }
  if (overrides.position != Unit::kUnstated && choice.evidence == Frame::kMetres) {
    choice.naming = Naming::kSure;
  }
  const bool of_crazyflie = choice.axes[0] < table.names.size() &&
                            unit_of_crazyflie(table.names[choice.axes[0]]) != Unit::kUnstated;
  if (of_crazyflie && choice.evidence != Frame::kWgs84) {
    choice.evidence = Frame::kMetres;
    choice.naming = Naming::kSure;
    choice.reason = "stateEstimate of Crazyflie has lengths";
  }
  const Frame frame = options.frame != Frame::kAuto ? options.frame : choice.evidence;
  const bool geographic = frame == Frame::kWgs84;
  const bool pixels = options.pixel.has_value();
  if (auto problem = unit_problem(schema, table, choice, geographic, pixels)) return problem;
  if (pixels && (geographic || overrides.position != Unit::kUnstated)) {
    return Error{ErrorCode::kInvalidArgument,
                 std::string("--scale says how long a pixel is, but ") +
                     (geographic ? "positions are in degrees" : "--units gives positions a unit") +
                     "; leave one of them out",
                 {}};
  }
  if (geographic && overrides.position != Unit::kUnstated) {
    return no_override("position", "positions are in degrees");
  }
  if (options.frame == Frame::kAuto && pixels) {
    choice.evidence = Frame::kMetres;
    choice.naming = Naming::kSure;
    choice.reason = "--scale says how long a pixel is";
  }
  if (choice.dimensions == 2 && overrides.height != Unit::kUnstated) {
    return no_override("height", "there is no height");
  }
  constexpr std::array<const char*, 3> kAxes = {"x", "y", "z"};
  UnitChoice chooser(table.names, overrides);
  std::vector<UnitTaken> taken;
  std::vector<ColumnUnit> units;
  for (std::size_t axis = geographic ? 2 : 0; axis < choice.dimensions; ++axis) {
    const std::size_t column = choice.axes[axis];
    const bool named = column < table.names.size();
    const ColumnMeaning word = stated(schema, table, column);
    const KnownColumn* const known = chooser.source() != nullptr && named
                                         ? chooser.source()->find(table.names[column])
                                         : nullptr;
    Unit in_name = named_unit(word, known);
    if (in_name == Unit::kUnstated && named && !geographic) {
      in_name = unit_of_crazyflie(table.names[column]);
    }
    // What is said of positions is not of a z that names its own unit.
    const bool height =
        axis == 2 && (geographic || word.role == Role::kHeight || in_name != Unit::kUnstated ||
                      overrides.height != Unit::kUnstated);
    if (pixels && !(height && overrides.height != Unit::kUnstated)) {
      if (in_name != Unit::kUnstated) return not_in_pixels(table, column, in_name);
      choice.units[axis] = Unit::kPixel;
      choice.pixel_m = options.pixel->metric;
      taken.push_back({kAxes[axis], Unit::kPixel, UnitEvidence::kAsked,
                       text_of(*options.pixel) + " each, as --scale says"});
      continue;
    }
    const auto unit = chooser.choose(height ? UnitRole::kHeight : UnitRole::kPosition,
                                     geographic ? "heights" : kAxes[axis], column, in_name);
    if (!unit) return unit.error();
    choice.units[axis] = unit->unit;
    if (named) units.push_back({column, unit->unit, unit->evidence});
    taken.push_back(*unit);
    if (axis < 2) continue;
    choice.datum = word.datum;
    if (known != nullptr) choice.datum = known->datum;
    if (named && counts_from_takeoff(table.names[column])) choice.datum = HeightDatum::kHome;
  }
  choice.units_taken = put_together(taken);
  return half_stated(table.names, units);
}

// The caller wants heights of one kind, and these are of the other.
std::optional<Error> datum_problem(const TableLayout& table, const ColumnOptions& options,
                                   const ColumnChoice& choice) {
  const bool pressure = choice.datum == HeightDatum::kPressure;
  const bool wrong =
      (options.heights == HeightSource::kPressure && choice.datum != HeightDatum::kPressure &&
       choice.datum != HeightDatum::kUnstated) ||
      (options.heights == HeightSource::kGeometric && pressure);
  if (!wrong || choice.dimensions < 3) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the heights of column " + excerpt(table.names[choice.axes[2]]) + " are " +
                   (pressure ? "by pressure, but --heights geometric"
                             : "geometric, but --heights pressure") +
                   " is given; leave it out, or name another column with --columns",
               {}};
}

}  // namespace

std::optional<Error> settle_coordinate_units(const ColumnSchema& schema, const TableLayout& table,
                                             const ColumnOptions& options, ColumnChoice& choice) {
  if (auto problem = settle_units(schema, table, options, choice)) return problem;
  return datum_problem(table, options, choice);
}

Point in_metric(const Point& point, const ColumnChoice& choice) {
  const auto metres = [&choice](double value, std::size_t axis) {
    const Unit unit = choice.units[axis];
    if (choice.scaled_degrees && axis < 2) return value / kScaledPerDegree;
    return unit == Unit::kPixel ? value * choice.pixel_m : in_metric(value, unit);
  };
  return {metres(point.x, 0), metres(point.y, 1), metres(point.z, 2)};
}

}  // namespace beespace::io
