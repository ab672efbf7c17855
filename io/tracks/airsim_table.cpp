#include "io/tracks/airsim_table.hpp"

#include "io/points/record_reading.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/long_table_recipe.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::array<std::string_view, 3> kPlaceOfAirsim = {"pos_x", "pos_y", "pos_z"};

bool is_airsim_table(const TableLayout& table) {
  const auto has = [&table](std::string_view wanted) {
    return std::any_of(table.names.begin(), table.names.end(),
                       [wanted](const std::string& name) { return plain_name(name) == wanted; });
  };
  return has("q_w") && has("timestamp") && (has("imagefile") || has("vehiclename")) &&
         std::all_of(kPlaceOfAirsim.begin(), kPlaceOfAirsim.end(), has);
}

bool takes_its_place(const TableLayout& table) {
  const ColumnChoice& choice = table.choice;
  if (choice.dimensions != kPlaceOfAirsim.size()) return false;
  for (std::size_t axis = 0; axis < kPlaceOfAirsim.size(); ++axis) {
    const std::size_t column = choice.axes[axis];
    if (column >= table.names.size() || plain_name(table.names[column]) != kPlaceOfAirsim[axis]) {
      return false;
    }
  }
  return true;
}

constexpr std::size_t kMostVehicles = 40;

// The vehicles by their names, as many as are told apart here.
std::vector<std::string> vehicles_of(std::string_view text, const TableLayout& table) {
  std::vector<std::string> found;
  if (!table.choice.id) return found;
  RecordWalk walk(text, table.data_offset, table);
  while (found.size() <= kMostVehicles && walk.next()) {
    std::string name(
        without_padding(field_at(walk.record(), table.delimiter, *table.choice.id).text));
    if (std::find(found.begin(), found.end(), name) == found.end()) {
      found.push_back(std::move(name));
    }
  }
  return found;
}

std::string number_of(std::size_t column) {
  return std::to_string(column + 1);
}

// What awk does with one of them. What is to be filled in is no number and no variable, which awk
// would take for 0.
std::string clause_of(const std::string& vehicle, const ColumnChoice& choice) {
  constexpr std::array<std::string_view, 3> kAdded = {"+=<X>", "+=<Y>", "+=<Z>"};
  std::string clause = "$" + number_of(*choice.id);
  clause.append("==\"").append(vehicle).append("\"{");
  for (std::size_t axis = 0; axis < kAdded.size(); ++axis) {
    clause.append(axis == 0 ? "$" : ";$").append(number_of(choice.axes[axis]));
    clause.append(kAdded[axis]);
  }
  return clause.append("}");
}

Error own_places(const TrackLayout& layout, const std::vector<std::string>& vehicles) {
  const ColumnChoice& choice = layout.table.choice;
  const bool all_told = vehicles.size() <= kMostVehicles &&
                        std::all_of(vehicles.begin(), vehicles.end(), means_itself_in_awk);
  std::string clauses;
  if (all_told) {
    for (const std::string& vehicle : vehicles) clauses += clause_of(vehicle, choice);
  } else {
    clauses = clause_of("NAME", choice);
  }
  return {ErrorCode::kUnknownFrame,
          "AirSim counts the places of each vehicle from where it began, and here are several (" +
              excerpt(vehicles[0]) + ", " + excerpt(vehicles[1]) +
              "): add the X, Y, Z that settings.json has of each to its places, as by "
              "awk -F'\\t' -v OFS='\\t' '" +
              clauses + "1' FILE > common.txt, with these numbers for <X>, <Y> and <Z>" +
              (all_told ? "" : ", and with such a part for each vehicle") +
              ", and read that with --crs metres; or, if all "
              "count from one place already, say --crs metres",
          {}};
}

}  // namespace

std::optional<Error> settle_airsim(std::string_view text, const RecordingOptions& options,
                                   TrackLayout& layout) {
  if (!is_airsim_table(layout.table) || !takes_its_place(layout.table)) return std::nullopt;
  if (options.frame != Frame::kMetres) {
    const std::vector<std::string> vehicles = vehicles_of(text, layout.table);
    if (vehicles.size() > 1) return own_places(layout, vehicles);
  }
  std::swap(layout.table.choice.axes[0], layout.table.choice.axes[1]);
  layout.z_is_down = true;
  layout.notes.emplace_back(
      "this is taken for a recording of AirSim, whose places are metres north, east and down: x is "
      "east, y north and z up here");
  return std::nullopt;
}

}  // namespace beespace::io
