#include "io/tracks/ros_table.hpp"

#include "io/bytes/characters.hpp"
#include "io/bytes/number.hpp"
#include "io/points/record_reading.hpp"
#include "io/table/column_names.hpp"
#include "io/table/fields.hpp"
#include "io/table/record_walk.hpp"
#include "io/tracks/track_columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace beespace::io {
namespace {

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};

std::string columns_text(const std::array<std::size_t, 3>& axes) {
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text.append(i == 0 ? "" : ",").append(kAxes[i]).append("=").append(std::to_string(axes[i] + 1));
  }
  return text;
}

// ---- With a header ------------------------------------------------------------------------------

using Words = std::vector<std::string>;

bool has(const Words& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// "header.stamp.secs", "field.header.stamp": no other source has such a column.
bool is_header_stamp(const Words& words) {
  return has(words, "header") && has(words, "stamp");
}

// "frame_id" of the header, not that of a child.
bool is_axes_name(const Words& words) {
  return words.size() >= 2 && words[words.size() - 2] == "frame" && words.back() == "id" &&
         !has(words, "child");
}

bool is_child_name(const Words& words) {
  return words.size() >= 3 && words[words.size() - 3] == "child" &&
         words[words.size() - 2] == "frame" && words.back() == "id";
}

// "Time" of bagpy, "%time" of rostopic.
bool is_time_of_recording(const Words& words) {
  return words.size() == 1 && words[0] == "time";
}

// "pose.position" of "pose.position.x"; nothing of other columns.
std::optional<Words> position_before(Words words, std::string_view axis) {
  if (words.size() < 2 || words.back() != axis) return std::nullopt;
  words.pop_back();
  if (!is_one_of("position point translation", words.back())) return std::nullopt;
  return words;
}

// What tells robots apart whose messages are in one table.
bool is_name_of_robot(const Words& words) {
  return words.size() == 1 && is_one_of("topic namespace ns", words[0]);
}

bool has_several(std::string_view text, const TableLayout& table, std::size_t column) {
  std::optional<std::string_view> first;
  RecordWalk walk(text, table.data_offset, table);
  while (walk.next()) {
    const auto name = without_padding(field_at(walk.record(), table.delimiter, column).text);
    if (first && name != *first) return true;
    first = name;
  }
  return false;
}

std::optional<RosTable> by_names(std::string_view text, const TableLayout& table, bool free) {
  RosTable found;
  found.names = table.names;
  std::array<std::vector<std::size_t>, 3> axes;
  std::array<Words, 3> before;
  bool stamped = false;
  for (std::size_t column = 0; column < table.names.size(); ++column) {
    const Words words = split_words(table.names[column]);
    stamped = stamped || is_header_stamp(words);
    if (!found.recorded && is_time_of_recording(words)) found.recorded = column;
    if (!found.axes_name && is_axes_name(words)) found.axes_name = column;
    if (!found.child && is_child_name(words)) found.child = column;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      auto place = position_before(words, kAxes[axis]);
      if (!place) continue;
      axes[axis].push_back(column);
      before[axis] = *std::move(place);
    }
  }
  const bool one = std::all_of(axes.begin(), axes.end(),
                               [](const auto& columns) { return columns.size() == 1; });
  // Of tables that pandas wrote: the time is what rows are called by.
  const bool of_pose = one && before[0].front() == "pose" && !table.contents.empty() &&
                       table.contents[0] == ColumnContent::kText;
  if (!stamped && (found.axes_name || of_pose) && !found.recorded && table.names[0].empty()) {
    found.names[0] = "header.stamp";
    stamped = true;
  }
  const bool clear = one && before[0] == before[1] && before[1] == before[2];
  if (!stamped || (free && !clear)) return std::nullopt;
  for (std::size_t column = 0; column < table.names.size(); ++column) {
    if (!is_name_of_robot(split_words(table.names[column]))) continue;
    if (has_several(text, table, column)) found.child = column;
  }
  if (clear) found.columns = columns_text({axes[0][0], axes[1][0], axes[2][0]});
  found.note =
      "this is taken for a table of a topic of ROS: positions in metres; orientations, and "
      "velocities, which are along the robot's own axes, are not read";
  return found;
}

// ---- Without ------------------------------------------------------------------------------------

enum class Content : std::uint8_t { kPose, kPoint, kSatellites };

// The messages whose places are stamped: how many columns, and how many names of frames stand
// behind the two of the time.
struct Message {
  std::string_view name;
  std::size_t columns;
  std::size_t frames;
  Content content = Content::kPose;
};

constexpr std::array<Message, 6> kMessages = {{
    {"geometry_msgs/PoseStamped", 10, 1},
    {"geometry_msgs/TransformStamped", 11, 2},
    {"geometry_msgs/PoseWithCovarianceStamped", 46, 1},
    {"nav_msgs/Odometry", 89, 2},
    {"geometry_msgs/PointStamped", 6, 1, Content::kPoint},
    {"sensor_msgs/NavSatFix", 18, 1, Content::kSatellites},
}};

bool is_whole(double value, double below) {
  return value == std::floor(value) && value >= 0.0 && value < below;
}

// Whether a record has a time, names of frames, a place, and, of poses, an orientation of length
// one. Points alone say little of themselves: their times count from 1970. Receivers say their
// status and service, degrees, and how the nine covariances are known.
bool looks_like(const Message& message, std::string_view line, char delimiter) {
  const auto number = [&](std::size_t column, double& value) {
    const std::string_view text = without_padding(field_at(line, delimiter, column).text);
    return parse_number(text, value) == NumberKind::kNumber;
  };
  double seconds = 0.0;
  double nanoseconds = 0.0;
  if (!number(0, seconds) || !number(1, nanoseconds)) return false;
  if (!is_whole(seconds, 1e10) || !is_whole(nanoseconds, 1e9)) return false;
  double ignored = 0.0;
  for (std::size_t i = 0; i < message.frames; ++i) {
    if (number(2 + i, ignored)) return false;
  }
  if (message.content == Content::kPoint) {
    double place = 0.0;
    return seconds > 5e8 && number(3, place) && number(4, place) && number(5, place);
  }
  if (message.content == Content::kSatellites) {
    double status = 0.0;
    double service = 0.0;
    double latitude = 0.0;
    double longitude = 0.0;
    double known = 0.0;
    if (!number(3, status) || !number(4, service) || !number(17, known)) return false;
    if (!is_whole(status + 2.0, 5.0) || !is_whole(service, 16.0) || !is_whole(known, 4.0)) {
      return false;
    }
    const bool told = number(5, latitude) && number(6, longitude);
    return !told || (std::abs(latitude) <= 90.0 && std::abs(longitude) <= 180.0);
  }
  double length = 0.0;
  for (std::size_t i = 0; i < 7; ++i) {
    double value = 0.0;
    if (!number(2 + message.frames + i, value)) return false;
    if (i >= 3) length += value * value;
  }
  return std::abs(length - 1.0) < 0.02;
}

bool all_look_like(const Message& message, std::string_view text, const TableLayout& table) {
  constexpr int kLookedAt = 16;
  std::size_t offset = table.data_offset;
  int seen = 0;
  while (seen < kLookedAt && offset < text.size()) {
    const Line line = line_at(text, offset, table.line_end);
    offset = line.next;
    if (is_blank_line(line.text) || has_comment_sign(line.text)) continue;
    if (line.text.size() > kLongestLine) return false;
    if (!looks_like(message, line.text, table.delimiter)) return false;
    ++seen;
  }
  return seen > 0;
}

RosTable table_of_satellites(const Message& message) {
  RosTable found;
  found.names = {"header.stamp.sec", "header.stamp.nanosec",
                 "header.frame_id",  "status.status",
                 "status.service",   "latitude",
                 "longitude",        "altitude"};
  while (found.names.size() < message.columns) {
    found.names.push_back("unread." + std::to_string(found.names.size() + 1));
  }
  found.columns = "lon=7,lat=6,height=8";
  found.note = "without a header, this is taken for " + std::string(message.name) +
               " as 'ros2 topic echo --csv' writes it: seconds, nanoseconds, frame, status, "
               "latitude, longitude, altitude";
  return found;
}

RosTable table_of(const Message& message) {
  if (message.content == Content::kSatellites) return table_of_satellites(message);
  RosTable found;
  found.names = {"header.stamp.sec", "header.stamp.nanosec", "header.frame_id"};
  if (message.frames == 2) found.names.emplace_back("child_frame_id");
  const std::size_t first = found.names.size();
  for (const char* const name : {"position.x", "position.y", "position.z", "orientation.x",
                                 "orientation.y", "orientation.z", "orientation.w"}) {
    if (found.names.size() < message.columns) found.names.emplace_back(name);
  }
  while (found.names.size() < message.columns) {
    found.names.push_back("unread." + std::to_string(found.names.size() + 1));
  }
  found.columns = columns_text({first, first + 1, first + 2});
  if (message.frames == 2) found.child = first - 1;
  found.axes_name = 2;
  found.note = "without a header, this is taken for " + std::string(message.name) +
               " as 'ros2 topic echo --csv' writes it: seconds, nanoseconds, frame, position in "
               "metres" +
               (message.content == Content::kPose ? ", orientation" : "");
  return found;
}

std::optional<RosTable> by_content(std::string_view text, const TableLayout& table) {
  for (const Message& message : kMessages) {
    if (table.columns == message.columns && all_look_like(message, text, table)) {
      return table_of(message);
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::size_t> find_axes_name(const TableLayout& table) {
  const auto names_axes = [](const Words& words) {
    if (words.empty() || has(words, "child")) return false;
    if (words.back() == "frameid" || words.back() == "frame") return true;
    return is_axes_name(words);
  };
  for (std::size_t i = 0; i < table.names.size() && i < table.contents.size(); ++i) {
    const Words words = split_words(table.names[i]);
    // Numbers are those of pictures, but for frames of a header of ROS, which may have any name.
    if (table.contents[i] != ColumnContent::kText && !has(words, "header")) continue;
    if (names_axes(words)) return i;
  }
  return std::nullopt;
}

std::optional<RosTable> find_ros_table(std::string_view text, const TableLayout& table, bool free) {
  return table.names.empty() ? by_content(text, table) : by_names(text, table, free);
}

bool is_altitude_of_fix(const TableLayout& table, std::size_t column) {
  if (column >= table.names.size()) return false;
  if (!plain_name(table.names[column]).ends_with("altitude")) return false;
  return std::any_of(table.names.begin(), table.names.end(), [](const std::string& name) {
    const std::string plain = plain_name(name);  // no other table has these
    return plain.ends_with("status_status") || plain.ends_with("position_covariance_type");
  });
}

void prefer_own_id(const TableLayout& table, std::optional<RosTable>& ros) {
  if (!ros) return;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    if (i == ros->child || i == ros->axes_name) continue;
    if (read_column_name(track_columns(), table.names[i]).role == Role::kId) ros->child.reset();
  }
}

}  // namespace beespace::io
