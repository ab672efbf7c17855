#include "io/json/json_document.hpp"

#include "io/frames/track_domain.hpp"
#include "io/json/json_fault.hpp"
#include "io/problems/excerpt.hpp"

#include <array>
#include <utility>

namespace beespace::io {

Error json_syntax_error(std::string_view text, std::string_view problem,
                        std::string_view if_cut_off) {
  Error error{ErrorCode::kCorrupt, {}, {}};
  const JsonFault fault = find_json_fault(text);
  if (!fault.found) {
    error.message = "this JSON cannot be read: " + std::string(problem) + "; correct it";
    return error;
  }
  error.location.line = fault.line;
  error.location.column = fault.column;
  if (fault.at_end) {
    error.code = ErrorCode::kTruncated;
    error.message = "the JSON ends too early (" + fault.what + "); " + std::string(if_cut_off);
  } else {
    error.message = "this is no JSON: " + fault.what + "; correct it";
  }
  return error;
}

Result<JsonDocument> JsonDocument::parse(std::string_view text, std::string source) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Error{ErrorCode::kNoPoints, "the input is empty", {std::move(source)}};
  }
  JsonDocument document;
  const std::string_view problem = document.parser_.parse(text, document.root_);
  if (problem.empty()) return document;
  Error error =
      json_syntax_error(text, problem, "the file is incomplete, copy or download it again");
  error.location.source = std::move(source);
  return error;
}

std::optional<JsonElement> json_member(JsonElement object, std::string_view key) {
  JsonMap members;
  JsonElement found;
  if (!object.get(members)) return std::nullopt;
  if (!members.get(key, found) || found.is_null()) return std::nullopt;
  return found;
}

std::optional<Error> json_twice(JsonElement object, std::initializer_list<std::string_view> keys) {
  JsonMap members;
  if (!object.get(members)) return std::nullopt;
  for (const std::string_view key : keys) {
    std::size_t count = 0;
    for (const auto member : members) {
      if (member.key == key) ++count;
    }
    if (count > 1) {
      return Error{ErrorCode::kMalformedRecord,
                   excerpt(key) + " is there " + (count == 2 ? "twice" : "several times") +
                       " in one object; keep one",
                   {}};
    }
  }
  return std::nullopt;
}

std::string_view json_kind(JsonElement element) {
  switch (element.kind()) {
    case JsonKind::kArray:
      return "an array";
    case JsonKind::kObject:
      return "an object";
    case JsonKind::kText:
      return "a string";
    case JsonKind::kFlag:
      return "true or false";
    case JsonKind::kNull:
      return "null";
    case JsonKind::kNumber:
      break;
  }
  return "a number";
}

bool read_json(JsonElement element, double& value) {
  return element.get(value) && in_motion_domain(value);
}

bool read_json(JsonElement element, Point& point) {
  JsonArray items;
  if (!element.get(items) || items.size() != 3) return false;
  std::array<double, 3> values = {};
  std::size_t axis = 0;
  for (const JsonElement item : items) {
    if (!read_json(item, values[axis++])) return false;
  }
  point = {values[0], values[1], values[2]};
  return true;
}

Error json_number_problem(JsonElement element, const std::string& path) {
  double value = 0.0;
  if (element.get(value)) {
    return {ErrorCode::kOutsideDomain,
            path + " cannot be computed with exactly; use 0, or a size of " +
                std::string(kMotionDomain),
            {}};
  }
  return {ErrorCode::kNotANumber,
          path + " is " + std::string(json_kind(element)) + " where a number should be; correct it",
          {}};
}

Error json_point_problem(JsonElement element, const std::string& path) {
  JsonArray items;
  const bool array = element.get(items);
  if (!array || items.size() != 3) {
    return {ErrorCode::kColumnCount,
            path + " is " + std::string(json_kind(element)) +
                (array ? " of " + std::to_string(items.size()) + " values" : "") +
                " where a position [x, y, z] should be; correct it",
            {}};
  }
  std::size_t axis = 0;
  for (const JsonElement item : items) {
    double value = 0.0;
    const std::string name = path + "[" + std::to_string(axis++) + "]";
    if (!read_json(item, value)) return json_number_problem(item, name);
  }
  return {ErrorCode::kNotANumber, path + " is no position; correct it", {}};
}

}  // namespace beespace::io
