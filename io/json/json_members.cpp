#include "io/json/json_members.hpp"

#include "io/problems/excerpt.hpp"

#include <algorithm>
#include <utility>

namespace beespace::io {

JsonMembers::JsonMembers(JsonElement object, std::string path, std::string what,
                         const std::vector<std::string_view>& known)
    : object_(object), path_(std::move(path)), what_(std::move(what)) {
  check_names(known);
}

void JsonMembers::check_names(const std::vector<std::string_view>& known) {
  JsonMap members;
  if (!object_.get(members)) {
    return fail({ErrorCode::kMalformedRecord,
                 path_ + " is " + std::string(json_kind(object_)) + " where " + what_ +
                     " should be, in { }; correct it",
                 {}});
  }
  std::vector<std::string_view> met;
  for (const auto member : members) {
    const std::string_view key = member.key;
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      std::string list;
      for (const std::string_view name : known) list.append(list.empty() ? "" : ", ").append(name);
      return fail({ErrorCode::kUnsupportedFormat,
                   path_ + " has a member " + excerpt(key) + " that is not known; " + what_ +
                       " has " + list,
                   {}});
    }
    if (std::find(met.begin(), met.end(), key) != met.end()) {
      return fail({ErrorCode::kMalformedRecord,
                   path_ + " has two members " + excerpt(key) + "; keep one",
                   {}});
    }
    met.push_back(key);
  }
}

std::string JsonMembers::path_of(std::string_view key) const {
  return (path_.empty() ? "" : path_ + ".") + std::string(key);
}

void JsonMembers::fail(Error error) {
  if (!error_) error_ = std::move(error);
}

std::optional<JsonElement> JsonMembers::element(std::string_view key) {
  const auto found = json_member(object_, key);
  if (!found) {
    fail({ErrorCode::kMissingColumn,
          path_ + " has no " + std::string(key) + ", which " + what_ + " needs; add it",
          {}});
  }
  return found;
}

double JsonMembers::number(std::string_view key) {
  double value = 0.0;
  const auto found = element(key);
  if (found && !read_json(*found, value)) fail(json_number_problem(*found, path_of(key)));
  return value;
}

double JsonMembers::number_or(std::string_view key, double otherwise) {
  return json_member(object_, key) ? number(key) : otherwise;
}

Point JsonMembers::point(std::string_view key) {
  Point point;
  const auto found = element(key);
  if (found && !read_json(*found, point)) fail(json_point_problem(*found, path_of(key)));
  return point;
}

}  // namespace beespace::io
