#include "io/tracks/listed_places.hpp"

#include "io/table/column_names.hpp"
#include "io/tracks/places_in_one.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

// A name that jq takes behind a point.
bool is_key_of_jq(std::string_view name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  });
}

// The first of a list that is an object.
std::optional<JsonMap> first_object(JsonElement value) {
  JsonArray list;
  JsonMap object;
  if (!value.get(list) || list.size() == 0 || !(*list.begin()).get(object)) return std::nullopt;
  return object;
}

// Messages of poses as Gazebo writes them, {"header": ..., "pose": [{"name": "x500_1",
// "position": {...}}]}; what is 0 is not there.
bool is_of_gazebo(JsonMap moment) {
  JsonElement header;
  JsonElement pose;
  JsonElement name;
  if (!moment.get("header", header) || !header.is_object() || !moment.get("pose", pose)) {
    return false;
  }
  const auto first = first_object(pose);
  return first && first->get("name", name);
}

ListedPlaces places_of_gazebo() {
  return {
      ".pose as $all | (.header.stamp | (.sec // 0 | tonumber) + (.nsec // 0) / 1e9) as $t | "
      ".pose[] | select(.name as $n | [$all[] | select(.name == $n)] | length == 1) | "
      "select(.name != \"ground_plane\") | {id: .name, time_s: $t, x: (.position.x // 0), y: "
      "(.position.y // 0), z: (.position.z // 0)}",
      "these are poses of Gazebo, all of one time in one object",
      "; names that several have, as links of models do, are left out, and so is the ground: "
      "what else stands for no vehicle (buildings, markers) is to be left out, too, as by | "
      "select(.id | startswith(\"x500\")) behind it"};
}

bool is_place(std::string_view key, JsonElement value) {
  return is_one_of("position pos xyz location coordinates translation", plain_name(key)) &&
         (value.is_object() || value.kind() == JsonKind::kArray);
}

// Brings the place in `key` up, out of an array, or an object.
std::string place_brought_up(std::string_view key, JsonElement value) {
  const std::string at = "." + std::string(key);
  std::string program = " | . + ";
  if (value.is_object()) {
    program += at;
  } else {
    program.append("{x: ").append(at).append("[0], y: ").append(at).append("[1], z: ");
    program.append(at).append("[2]}");
  }
  return program.append(" | del(").append(at).append(")");
}

// What makes records of such a list, once it is one; nothing where its objects have no place.
std::optional<std::string> records_of(JsonMap first) {
  std::vector<std::string_view> keys;
  for (const auto [key, value] : first) keys.push_back(key);
  if (keys_name_position(keys)) return std::string();
  for (const auto [key, value] : first) {
    if (is_key_of_jq(key) && is_place(key, value)) return place_brought_up(key, value);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ListedPlaces> listed_places(JsonMap moment) {
  if (is_of_gazebo(moment)) return places_of_gazebo();
  std::string_view time;
  for (const auto [key, value] : moment) {
    if (time.empty() && is_one_of("t time timestamp", plain_name(key))) time = key;
  }
  for (const auto [key, value] : moment) {
    if (!is_key_of_jq(key)) continue;
    const auto first = first_object(value);
    if (!first) continue;
    const auto rest = records_of(*first);
    if (!rest) continue;
    ListedPlaces found;
    found.program.append(". as $all | .").append(key).append("[] | ($all | del(.").append(key);
    found.program.append(")) + .").append(*rest);
    found.what.append("'").append(key).append("' is a list of all that is somewhere at one time");
    if (!time.empty()) {
      found.more.append("; and in which unit is '").append(time);
      found.more += "'? Say it, with that file, with --time-unit s, ms, us or ns";
    }
    return found;
  }
  return std::nullopt;
}

}  // namespace beespace::io
