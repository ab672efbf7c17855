#include "io/json/json_document.hpp"

#include "io/frames/track_domain.hpp"
#include "io/json/json_fault.hpp"
#include "io/problems/excerpt.hpp"

#include <array>
#include <utility>

namespace beespace::io {
namespace {

Error syntax_error(std::string_view text, simdjson::error_code code, std::string source) {
  Error error{ErrorCode::kCorrupt, {}, {std::move(source)}};
  const JsonFault fault = find_json_fault(text);
  if (!fault.found) {
    error.message =
        "this JSON cannot be read: " + std::string(simdjson::error_message(code)) + "; correct it";
    return error;
  }
  error.place.line = fault.line;
  error.place.column = fault.column;
  if (fault.at_end) {
    error.code = ErrorCode::kTruncated;
    error.message = "the JSON ends too early (" + fault.what +
                    "); the file is incomplete, copy or download it again";
  } else {
    error.message = "this is no JSON: " + fault.what + "; correct it";
  }
  return error;
}

}  // namespace

Result<JsonDocument> JsonDocument::parse(std::string_view text, std::string source) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Error{ErrorCode::kNoPoints, "the input is empty", {std::move(source)}};
  }
  JsonDocument document;
  document.parser_ = std::make_unique<simdjson::dom::parser>();
  const simdjson::error_code code =
      document.parser_->parse(text.data(), text.size(), true).get(document.root_);
  if (code == simdjson::MEMALLOC) throw std::bad_alloc();
  if (code != simdjson::SUCCESS) return syntax_error(text, code, std::move(source));
  return document;
}

std::optional<JsonElement> json_member(JsonElement object, std::string_view key) {
  simdjson::dom::object members;
  JsonElement found;
  if (object.get(members) != simdjson::SUCCESS) return std::nullopt;
  if (members.at_key(key).get(found) != simdjson::SUCCESS || found.is_null()) return std::nullopt;
  return found;
}

std::optional<Error> json_twice(JsonElement object, std::initializer_list<std::string_view> keys) {
  simdjson::dom::object members;
  if (object.get(members) != simdjson::SUCCESS) return std::nullopt;
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
  switch (element.type()) {
    case simdjson::dom::element_type::ARRAY:
      return "an array";
    case simdjson::dom::element_type::OBJECT:
      return "an object";
    case simdjson::dom::element_type::STRING:
      return "a string";
    case simdjson::dom::element_type::BOOL:
      return "true or false";
    case simdjson::dom::element_type::NULL_VALUE:
      return "null";
    default:
      return "a number";
  }
}

bool read_json(JsonElement element, double& value) {
  return element.get(value) == simdjson::SUCCESS && in_motion_domain(value);
}

bool read_json(JsonElement element, Point& point) {
  simdjson::dom::array items;
  if (element.get(items) != simdjson::SUCCESS || items.size() != 3) return false;
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
  if (element.get(value) == simdjson::SUCCESS) {
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
  simdjson::dom::array items;
  const bool array = element.get(items) == simdjson::SUCCESS;
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
