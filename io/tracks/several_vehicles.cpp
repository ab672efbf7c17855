#include "io/tracks/several_vehicles.hpp"

#include "io/bytes/characters.hpp"
#include "io/problems/excerpt.hpp"
#include "io/table/column_names.hpp"
#include "io/tracks/long_table_recipe.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// Axes of places, each beside those that it may stand with.
enum class Axis : std::uint8_t { kNone, kX, kY, kZ, kLongitude, kLatitude };

Axis axis_of(std::string_view word) {
  if (word == "x") return Axis::kX;
  if (word == "y") return Axis::kY;
  if (word == "z") return Axis::kZ;
  if (is_one_of("lon lng long longitude", word)) return Axis::kLongitude;
  if (is_one_of("lat latitude", word)) return Axis::kLatitude;
  return Axis::kNone;
}

// What is not where a vehicle is, or is where the same one is.
bool names_something_else(std::string_view word) {
  return is_one_of(
      "set plan planned expected goal target want wanted desired des cmd command commanded ref "
      "reference setpoint sp home "
      "origin start end takeoff launch land base pref preferred next last prev previous waypoint "
      "wp vel velocity speed v vs acc accel acceleration gyro mag magnetometer q quat quaternion "
      "orient orientation rot rotation ang angular angle euler att attitude roll pitch yaw force "
      "torque thrust wind err error std stdev sd sigma cov covariance var variance noise bias "
      "offset min max mean dir direction heading look gaze twist size scale width height image "
      "img px pixel pixels screen utm rel relative delta diff gps gnss rtk est estimate "
      "estimated "
      "filtered smooth smoothed kalman ekf truth true gt measured meas obs observed imu raw fused "
      "linear angular odom odometry mocap vicon local global centroid wcentroid pcentroid head "
      "tail thorax "
      "abdomen nose body map amcl slam geom ecef enu ned display normal",
      word);
}

bool says_nothing(std::string_view word) {
  return is_one_of(
      "pos position pose point coord coordinate location m cm mm km ft deg degree degrees rad "
      "metre metres meter meters in field",
      word);
}

struct Named {
  Axis axis = Axis::kNone;
  std::string whose;  // empty: not said
};

// "rad s^-1" of "b_w_RS_S_x [rad s^-1]", "m/s" of "x (m/s)".
bool has_unit_of_no_length(std::string_view name) {
  const std::size_t begins = name.find_first_of("[(");
  if (begins == std::string_view::npos) return false;
  const std::vector<std::string> words = split_words(name.substr(begins));
  return std::any_of(words.begin(), words.end(), [](const std::string& word) {
    return is_one_of("s s2 sec ms h min rad hz mps", word);
  });
}

// "follower" of "follower_x", "2" of "x2" and "x_2 [m]"; no axis where the name is no such one.
Named read(std::string_view name) {
  Named named;
  if (has_unit_of_no_length(name)) return named;
  for (std::string word : split_words(name)) {
    const std::size_t digits = word.find_last_not_of("0123456789") + 1;
    Axis axis = axis_of(word);
    std::string number;
    if (axis == Axis::kNone && digits > 0 && digits < word.size()) {
      axis = axis_of(word.substr(0, digits));
      if (axis != Axis::kNone) number = word.substr(digits);
    }
    if (axis != Axis::kNone && named.axis != Axis::kNone) return {};
    if (axis != Axis::kNone) {
      named.axis = axis;
      word = number;
    }
    if (names_something_else(word)) return {};
    if (word.empty() || says_nothing(word)) continue;
    named.whose += (named.whose.empty() ? "" : "_") + word;
  }
  return named;
}

std::vector<std::string_view> parts_of_path(std::string_view name) {
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t ends = std::min(name.find('/', at), name.size());
    if (ends > at) parts.push_back(name.substr(at, ends - at));
    at = ends + 1;
  }
  return parts;
}

// The frame of a transform's parent, where others are placed in it, too.
bool is_frame_of_all(std::string_view frame) {
  return is_one_of("map world earth odom mocap vicon optitrack qualisys global", lower_case(frame));
}

// "robot1" of "/tf/map/robot1/base_link/translation/x" as PlotJuggler writes transforms: that of a
// frame of all to one of the vehicle; nothing where it is another one, as that to a camera.
Named read_transform(const std::vector<std::string_view>& parts, std::size_t tf) {
  constexpr std::size_t kBehindChild = 2;  // "translation", "x"
  const std::size_t child = tf + 2;
  if (parts.size() < child + 1 + kBehindChild) return {};
  const std::size_t ends = parts.size() - kBehindChild;
  if (!is_frame_of_all(parts[tf + 1]) || parts[ends] != "translation") return {};
  if (is_one_of("odom map", lower_case(parts[ends - 1]))) return {};
  Named named;
  named.whose = tf > 0 ? parts.front() : parts[child];
  const std::vector<std::string> words = split_words(named.whose);
  if (std::any_of(words.begin(), words.end(), names_something_else)) return {};
  named.axis = axis_of(parts.back());
  return named;
}

// "/r1/odom/pose/pose/position/x" as PlotJuggler writes it: of topic /r1/..., the vehicle's name
// space; the same vehicle may tell of where it is in several ways.
Named read_path(std::string_view name) {
  const std::vector<std::string_view> parts = parts_of_path(name);
  const auto tf = std::find(parts.begin(), parts.end(), "tf");
  if (tf - parts.begin() <= 1 && tf != parts.end()) {
    return read_transform(parts, static_cast<std::size_t>(tf - parts.begin()));
  }
  const std::size_t ends = name.find('/', 1);
  if (ends == std::string_view::npos) return {};
  const std::string whose(name.substr(1, ends - 1));
  const std::vector<std::string> first = split_words(whose);
  if (whose.empty() || std::any_of(first.begin(), first.end(), names_something_else)) return {};
  Named named;
  for (const std::string& word : split_words(name.substr(ends))) {
    const Axis axis = axis_of(word);
    if (axis != Axis::kNone && named.axis != Axis::kNone) return {};
    if (axis != Axis::kNone) named.axis = axis;
    const bool how =
        is_one_of("odom odometry local global mocap vicon gps gnss filtered raw", word);
    if (axis == Axis::kNone && !how && names_something_else(word)) return {};
  }
  named.whose = whose;
  return named;
}

// Columns of one vehicle.
struct Set {
  std::string whose;
  std::size_t time = 0;  // the how manieth of those of whom the same is said
  std::array<std::optional<std::size_t>, 6> columns = {};

  [[nodiscard]] const std::optional<std::size_t>& at(Axis axis) const {
    return columns[static_cast<std::size_t>(axis)];
  }
  [[nodiscard]] bool has(Axis one, Axis other) const { return at(one) && at(other); }
};

std::vector<Set> sets_of(const std::vector<std::string>& names) {
  std::vector<Set> sets;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const Named named = names[i].starts_with('/') ? read_path(names[i]) : read(names[i]);
    if (named.axis == Axis::kNone) continue;
    // A name that comes again is of another one.
    const auto time = static_cast<std::size_t>(
        std::count(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]));
    auto set = std::find_if(sets.begin(), sets.end(), [&](const Set& known) {
      return known.whose == named.whose && known.time == time;
    });
    if (set == sets.end()) set = sets.insert(set, Set{named.whose, time, {}});
    auto& column = set->columns[static_cast<std::size_t>(named.axis)];
    if (!column) column = i;
  }
  return sets;
}

std::string columns_option(const Set& set, Axis first, Axis second) {
  const auto number = [&set](Axis axis) { return std::to_string(*set.at(axis) + 1); };
  const bool degrees = first == Axis::kLongitude;
  std::string text = "--columns ";
  text.append(degrees ? "lon=" : "x=").append(number(first));
  text.append(degrees ? ",lat=" : ",y=").append(number(second));
  if (!degrees && set.at(Axis::kZ)) text.append(",z=").append(number(Axis::kZ));
  return text;
}

// "latitude_x" and "latitude_y", "longitude_x" and "longitude_y": as pandas merges two tables, and
// not x and y of something.
bool are_merged_pairs(const std::vector<std::string>& names) {
  constexpr std::string_view kFirst = "_x";
  bool longitudes = false;
  bool latitudes = false;
  for (const std::string& name : names) {
    if (!name.ends_with(kFirst)) continue;
    const std::string stem = name.substr(0, name.size() - kFirst.size());
    if (std::find(names.begin(), names.end(), stem + "_y") == names.end()) continue;
    longitudes = longitudes || axis_of(stem) == Axis::kLongitude;
    latitudes = latitudes || axis_of(stem) == Axis::kLatitude;
  }
  return longitudes && latitudes;
}

// Of "name0" beside "pose0", as rostopic writes /gazebo/model_states: what names a vehicle.
std::optional<std::size_t> name_of(const TableLayout& table, const std::string& whose) {
  const std::size_t digits = whose.find_last_not_of("0123456789") + 1;
  if (digits == whose.size()) return std::nullopt;
  const std::string name = "name" + whose.substr(digits);
  for (std::size_t i = 0; i < table.names.size() && i < table.contents.size(); ++i) {
    const std::vector<std::string> words = split_words(table.names[i]);
    if (table.contents[i] == ColumnContent::kText && !words.empty() && words.back() == name) {
      return i;
    }
  }
  return std::nullopt;
}

// Of "/robot1/odom/pose/pose/position/x" as PlotJuggler writes it: places that each robot may count
// from where it was switched on. Frames are not in such a table.
bool is_topic_of_odometry(std::string_view name) {
  if (!name.starts_with('/')) return false;
  bool own = false;
  for (const std::string& word : split_words(name)) {
    if (is_one_of("map global world gps gnss", word)) return false;
    own = own || is_one_of("odom odometry local", word);
  }
  return own;
}

// As awk makes a record for each vehicle of them.
std::string recipe_of(const TableLayout& table, const std::vector<Set>& sets) {
  std::vector<VehicleColumns> vehicles;
  for (const Set& set : sets) {
    if (!set.has(Axis::kX, Axis::kY)) continue;
    std::string name = set.whose.empty() ? std::to_string(vehicles.size() + 1) : set.whose;
    if (set.time > 0) name += "_" + std::to_string(set.time + 1);
    const std::size_t x = *set.at(Axis::kX);
    vehicles.push_back({std::move(name), x, *set.at(Axis::kY), set.at(Axis::kZ),
                        name_of(table, set.whose), is_topic_of_odometry(table.names[x])});
  }
  return long_table_recipe(table, vehicles);
}

}  // namespace

std::optional<Error> several_vehicles(const TableLayout& table) {
  if (are_merged_pairs(table.names)) {
    Error error;
    error.code = ErrorCode::kMissingColumn;
    error.message =
        "this is a table of pairs, with one of the two in the columns that end with _x and the "
        "other in those that end with _y, as closest_point_of_approach of traffic makes them: it "
        "has no more than what was found close there; give the flights themselves, as by "
        "flights.to_csv('flights.csv') of the Traffic that was asked";
    return error;
  }
  const std::vector<Set> sets = sets_of(table.names);
  for (const auto& [first, second] :
       {std::pair(Axis::kX, Axis::kY), std::pair(Axis::kLongitude, Axis::kLatitude)}) {
    const Set* one = nullptr;
    for (const Set& set : sets) {
      if (!set.has(first, second)) continue;
      if (one == nullptr) {
        one = &set;
        continue;
      }
      const auto shown = [&table, x = first, y = second](const Set& of) {
        return excerpt(table.names[*of.at(x)]) + ", " + excerpt(table.names[*of.at(y)]);
      };
      const std::string recipe = first == Axis::kX ? recipe_of(table, sets) : std::string();
      Error error;
      error.code = ErrorCode::kMissingColumn;
      error.message =
          "there are places of several vehicles beside each other: " + shown(*one) + " and " +
          shown(set) +
          "; write a record for each vehicle and time, with its name in a column 'id' (time, id, " +
          (first == Axis::kX ? "x, y, z" : "longitude, latitude, height") + ")" +
          (recipe.empty() ? "" : ", as by " + recipe) +
          "; if the others are no vehicles, say which columns to take, as in " +
          columns_option(*one, first, second);
      return error;
    }
  }
  return std::nullopt;
}

std::optional<Error> downward(const TableLayout& table) {
  const std::vector<std::string>& names = table.names;
  const auto find = [&names](std::string_view words) {
    const auto found = std::find_if(names.begin(), names.end(), [&words](const std::string& name) {
      const auto parts = split_words(name);
      return !parts.empty() && is_one_of(words, parts.front()) && parts.size() <= 2;
    });
    return static_cast<std::size_t>(found - names.begin());
  };
  const std::size_t north = find("north n");
  const std::size_t east = find("east e");
  const std::size_t down = find("down d");
  if (std::max({north, east, down}) >= names.size()) return std::nullopt;
  return Error{
      ErrorCode::kMissingColumn,
      "columns " + excerpt(names[north]) + ", " + excerpt(names[east]) + ", " +
          excerpt(names[down]) +
          " are a place as north, east, down (NED); here x is east, y north and z up: write "
          "a column z that is the negative of " +
          excerpt(names[down]) + ", and say --columns x=" + std::to_string(east + 1) +
          ",y=" + std::to_string(north + 1) + ",z=N with the number of that column",
      {}};
}

}  // namespace beespace::io
