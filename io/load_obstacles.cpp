#include "io/load_obstacles.hpp"

#include "io/bytes/byte_source.hpp"
#include "io/bytes/gzip.hpp"
#include "io/json/json_document.hpp"
#include "io/json/json_members.hpp"
#include "io/problems/excerpt.hpp"
#include "io/problems/text_check.hpp"

#include <utility>

namespace beespace::io {
namespace {

constexpr std::string_view kKinds = "sphere, box, ground, cylinder or prism";

// [x, y]
Result<Corner> read_corner(JsonElement element, const std::string& path) {
  JsonArray items;
  const bool array = element.get(items);
  if (!array || items.size() != 2) {
    return Error{ErrorCode::kColumnCount,
                 path + " is " + std::string(json_kind(element)) +
                     (array ? " of " + std::to_string(items.size()) + " values" : "") +
                     " where [x, y] should be; correct it",
                 {}};
  }
  Corner corner;
  std::size_t axis = 0;
  for (const JsonElement item : items) {
    double& value = axis == 0 ? corner.x : corner.y;
    if (!read_json(item, value)) {
      return json_number_problem(item, path + "[" + std::to_string(axis) + "]");
    }
    ++axis;
  }
  return corner;
}

Heights read_heights(JsonMembers& members) {
  Heights heights;
  heights.low_m = members.number_or("low_m", heights.low_m);
  heights.high_m = members.number_or("high_m", heights.high_m);
  return heights;
}

UprightCylinder read_cylinder(JsonMembers& members) {
  UprightCylinder cylinder;
  if (const auto center = members.element("center")) {
    const auto middle = read_corner(*center, members.path_of("center"));
    if (!middle) {
      members.fail(middle.error());
    } else {
      cylinder.x = middle->x;
      cylinder.y = middle->y;
    }
  }
  cylinder.radius_m = members.number("radius_m");
  cylinder.heights = read_heights(members);
  return cylinder;
}

UprightPrism read_prism(JsonMembers& members) {
  UprightPrism prism;
  if (const auto outline = members.element("outline")) {
    const std::string path = members.path_of("outline");
    JsonArray corners;
    if (!outline->get(corners)) {
      members.fail({ErrorCode::kMalformedRecord,
                    path + " is " + std::string(json_kind(*outline)) +
                        " where a list of corners [x, y] should be; correct it",
                    {}});
    } else {
      for (const JsonElement item : corners) {
        const std::string place = path + "[" + std::to_string(prism.outline.size()) + "]";
        const auto corner = read_corner(item, place);
        if (!corner) {
          members.fail(corner.error());
          break;
        }
        prism.outline.push_back(*corner);
      }
    }
  }
  prism.heights = read_heights(members);
  return prism;
}

Result<Obstacle> read_obstacle(JsonElement element, const std::string& path) {
  using Names = std::vector<std::string_view>;
  const auto checked = [](Obstacle obstacle, const JsonMembers& members) -> Result<Obstacle> {
    if (members.error()) return *members.error();
    return obstacle;
  };
  const auto kind = json_member(element, "kind");
  std::string_view word;
  if (!kind || !kind->get(word)) {
    const bool object = element.is_object();
    return Error{object ? ErrorCode::kMissingColumn : ErrorCode::kMalformedRecord,
                 path +
                     (object ? kind ? ".kind is " + std::string(json_kind(*kind)) : " has no kind"
                             : " is " + std::string(json_kind(element)) +
                                   " where an obstacle should be, in { }") +
                     "; say which it is: \"kind\": one of " + std::string(kKinds),
                 {}};
  }
  if (word == "sphere") {
    JsonMembers members(element, path, "a sphere", Names{"kind", "center", "radius_m"});
    const Sphere sphere{members.point("center"), members.number("radius_m")};
    return checked(sphere, members);
  }
  if (word == "box") {
    JsonMembers members(element, path, "a box", Names{"kind", "low", "high"});
    const Box box{members.point("low"), members.point("high")};
    return checked(box, members);
  }
  if (word == "ground") {
    JsonMembers members(element, path, "the ground", Names{"kind", "height_m"});
    const Ground ground{members.number("height_m")};
    return checked(ground, members);
  }
  if (word == "cylinder") {
    JsonMembers members(element, path, "a cylinder",
                        Names{"kind", "center", "radius_m", "low_m", "high_m"});
    return checked(read_cylinder(members), members);
  }
  if (word == "prism") {
    JsonMembers members(element, path, "a prism", Names{"kind", "outline", "low_m", "high_m"});
    return checked(read_prism(members), members);
  }
  return Error{
      ErrorCode::kUnsupportedFormat,
      path + ".kind " + excerpt(word) + " is not known; it is one of " + std::string(kKinds),
      {}};
}

Result<std::vector<Obstacle>> read_obstacles(JsonElement root) {
  JsonMembers members(root, "this document", "a list of obstacles", {"obstacles"});
  const auto list = members.error() ? std::nullopt : members.element("obstacles");
  if (members.error()) return *members.error();
  JsonArray items;
  if (!list->get(items)) {
    return Error{ErrorCode::kMalformedRecord,
                 "obstacles is " + std::string(json_kind(*list)) +
                     " where a list of them should be, in [ ]; correct it",
                 {}};
  }
  std::vector<Obstacle> obstacles;
  for (const JsonElement item : items) {
    auto obstacle = read_obstacle(item, "obstacles[" + std::to_string(obstacles.size()) + "]");
    if (!obstacle) return obstacle.error();
    obstacles.push_back(std::move(obstacle).value());
  }
  return obstacles;
}

Result<std::vector<Obstacle>> load_bytes(Bytes bytes, const std::string& path) {
  const std::string source = source_name(path);
  const auto content = unpacked(std::move(bytes), source);
  if (!content) return content.error();
  const auto document = JsonDocument::parse(without_byte_order_mark(content->view), source);
  if (!document) return document.error();
  auto obstacles = read_obstacles(document->root());
  if (!obstacles) obstacles.error().location.source = source;
  return obstacles;
}

}  // namespace

Result<std::vector<Obstacle>> load_obstacles(const std::string& path) {
  auto bytes = open_bytes(path, nullptr);
  if (!bytes) return bytes.error();
  return load_bytes(std::move(bytes).value(), path);
}

Result<std::vector<Obstacle>> load_obstacles_from_memory(std::string_view content,
                                                         const std::string& name) {
  return load_bytes(copy_of(content), name);
}

}  // namespace beespace::io
