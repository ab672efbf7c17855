// What the name of a column says, by a schema: what the column holds, in which unit and frame.
//
// Words are looked for as whole tokens, in any case, in several languages: "lat", "GPS latitude",
// "longitud [deg]", "alt_m", "uav_lat", "Time [msec]", "vel_n_m_s", "goal_x". A name that is not
// understood to its last word has no role, but says whether it has to do with a position.
#pragma once

#include "io/table/column_schema.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct ColumnMeaning {
  Role role = Role::kNone;
  // The frame that this name alone speaks for; kAuto when it does not say.
  Frame frame = Frame::kAuto;
  bool course_format = false;   // a coordinate of a bee, as in the course files
  bool says_length = false;     // with its unit or its kind of frame: "x [m]", "ecef_x"
  bool says_position = false;   // has to do with a position, though no role can be told from it
  bool since_1970 = false;      // of a time: "unix_time_s"
  std::string prefix = {};      // whose coordinate it is: "uav" of "uav_lat"
  Unit unit = Unit::kUnstated;  // "alt_ft", "time_s"
  HeightDatum datum = HeightDatum::kUnstated;  // of a height: "baro_alt"
  std::string foreign_unit = {};               // a unit that is not read: "rad", "min"
};

ColumnMeaning read_column_name(const ColumnSchema& schema, std::string_view name);

// Runs of letters and digits, in lower case; bytes beyond ASCII count as letters.
std::vector<std::string> split_words(std::string_view name);
// These with "_" between them: "status_status" of "status.Status".
std::string plain_name(std::string_view name);

}  // namespace beespace::io
