#include "io/tracks/long_table_recipe.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/your_threshold.hpp"
#include "io/table/column_names.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace beespace::io {
namespace {

// The column of the time, or else that of the pictures.
std::optional<std::size_t> time_column(const TableLayout& table) {
  for (const Role role : {Role::kTime, Role::kFrame}) {
    for (std::size_t i = 0; i < table.names.size(); ++i) {
      if (read_column_name(track_columns(), table.names[i]).role == role) return i;
    }
  }
  return std::nullopt;
}

// "mm" of "r1_x [mm]"; "" where it names no unit.
std::string unit_named(std::string_view name) {
  for (const std::string& word : split_words(name)) {
    if (is_one_of("m cm mm km ft", word)) return word;
  }
  return {};
}

// "p("r1",2,3,4)", with columns counted from 1.
std::string call_of(const VehicleColumns& vehicle) {
  std::string call = "p(";
  if (vehicle.named_by) {
    call.append("$").append(std::to_string(*vehicle.named_by + 1));
  } else {
    call.append("\"").append(vehicle.name).append("\"");
  }
  call.append(",").append(std::to_string(vehicle.x + 1));
  call.append(",").append(std::to_string(vehicle.y + 1));
  if (vehicle.z) call += "," + std::to_string(*vehicle.z + 1);
  return call + ")";
}

// The name that the time has in the long table.
std::string time_name(const std::string& named) {
  if (named == "%time") return "time_ns";  // of rostopic
  return means_itself_in_awk(named) ? named : "time";
}

// What is asked at once otherwise, and what nothing in the long table says.
std::string replay_options(const std::string& time) {
  std::string options = " ";
  options += kYourThreshold;
  const ColumnMeaning meaning = read_column_name(track_columns(), time);
  if (meaning.role == Role::kFrame) return options + " --fps N (how many pictures a second has)";
  const bool unit_is_known = meaning.unit != Unit::kUnstated || meaning.since_1970;
  return unit_is_known ? options
                       : options + " --time-unit s; where '" + time +
                             "' is not in seconds, the unit is ms, us or ns";
}

}  // namespace

bool means_itself_in_awk(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-' || c == '.' || c == ' ';
  });
}

std::string long_table_recipe(const TableLayout& table,
                              const std::vector<VehicleColumns>& vehicles) {
  constexpr std::size_t kMostVehicles = 40;
  const auto time = time_column(table);
  const bool splits = table.delimiter == ',' || table.delimiter == ';' || table.delimiter == '\t';
  if (!time || !splits || vehicles.size() > kMostVehicles) return {};
  const bool high = vehicles.front().z.has_value();
  const std::string unit = unit_named(table.names[vehicles.front().x]);
  for (const VehicleColumns& vehicle : vehicles) {
    const bool fits = vehicle.z.has_value() == high && means_itself_in_awk(vehicle.name) &&
                      unit_named(table.names[vehicle.x]) == unit;
    if (!fits) return {};
  }
  const std::string end = unit.empty() ? "" : "_" + unit;
  const std::string& named = table.names[*time];
  std::string text = "awk -F'";
  text += table.delimiter == '\t' ? std::string("\\t") : std::string(1, table.delimiter);
  // Carriage returns would be part of the last column.
  text += "' '{sub(/\\r$/,\"\")}";
  const bool ground = std::any_of(vehicles.begin(), vehicles.end(),
                                  [](const VehicleColumns& of) { return of.named_by.has_value(); });
  // Then it is asked about when it is read, as it is where frames are said.
  const bool own = std::any_of(vehicles.begin(), vehicles.end(),
                               [](const VehicleColumns& of) { return of.own_origin; });
  text += std::string("function p(i,a,b") + (high ? ",c" : "") + "){if($a!=\"\"" +
          (ground ? "&&i!=\"ground_plane\"" : "") + ")print $" + std::to_string(*time + 1) +
          "\",\"i\",\"$a\",\"$b" + (high ? "\",\"$c" : "") + (own ? "\",odom\"" : "") + "}";
  text += "NR==" + std::to_string(table.lines_before) + "{print \"" + time_name(named) + ",id,x" +
          end + ",y" + end + (high ? ",z" + end : "") + (own ? ",header.frame_id" : "") + "\"}NR>" +
          std::to_string(table.lines_before) + "{";
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    text += (i == 0 ? "" : ";") + call_of(vehicles[i]);
  }
  return text + "}' FILE > long.csv, and then beespace replay long.csv" +
         replay_options(time_name(named));
}

}  // namespace beespace::io
