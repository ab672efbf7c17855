// Tables of poses as tools of ROS write them: which columns hold what, by their names or, where
// `ros2 topic echo --csv` writes no header, by what poses must look like.
#pragma once

#include "io/table/table_layout.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct RosTable {
  std::vector<std::string> names;  // of the columns; those of the header, where there is one
  std::string columns;             // as --columns says them
  std::optional<std::size_t> axes_name = {};  // "frame_id"
  std::optional<std::size_t> child = {};     // "child_frame_id", or "topic": whose pose a record is
  std::optional<std::size_t> recorded = {};  // the time of recording, beside that of the header
  std::string note;
};

// The column of words, of any table, that says in which frame of reference each position is.
std::optional<std::size_t> find_axes_name(const TableLayout& table);

// `text` are records of the table. Nothing where it is of another kind, or, where the position is
// not said (`free`), where it has several.
std::optional<RosTable> find_ros_table(std::string_view text, const TableLayout& table, bool free);

// Whether the column is the altitude of sensor_msgs/NavSatFix, which is above the WGS84 ellipsoid
// by definition of the message.
bool is_altitude_of_fix(const TableLayout& table, std::size_t column);

// Of JSON, to whose objects an id of their own may be added: that tells whose pose it is.
void prefer_own_id(const TableLayout& table, std::optional<RosTable>& ros);

}  // namespace beespace::io
