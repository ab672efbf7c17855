// A JSON text, parsed, and what is wrong with its values in words.
#pragma once

#include "io/json/json_value.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

class JsonDocument {
 public:
  // Errors: kNoPoints (empty), kTruncated, kCorrupt with line and column; with `source` as place.
  static Result<JsonDocument> parse(std::string_view text, std::string source);

  [[nodiscard]] JsonElement root() const { return root_; }

 private:
  JsonDocument() = default;

  JsonParser parser_;  // holds what root_ and its parts point to
  JsonElement root_;
};

// Why a text is no JSON, with line and column: kCorrupt; or kTruncated, where `if_cut_off` is the
// advice. `problem` is what the parser says of it.
Error json_syntax_error(std::string_view text, std::string_view problem,
                        std::string_view if_cut_off);

// Member `key` of an object; nothing where there is none, or it is null.
std::optional<JsonElement> json_member(JsonElement object, std::string_view key);

// An object that has one of these members twice, which no two readers take alike. Error without
// place: kMalformedRecord.
std::optional<Error> json_twice(JsonElement object, std::initializer_list<std::string_view> keys);

// "a number", "a string", ...; what stands there instead of what is wanted.
std::string_view json_kind(JsonElement element);

// A number that motion can be computed with; false when it is not.
bool read_json(JsonElement element, double& value);
// An array of three such numbers; false when it is not.
bool read_json(JsonElement element, Point& point);

// Why read_json() said false; `path` names the value in the message ("points[3]"). Errors:
// kNotANumber, kOutsideDomain, of points kColumnCount too; without place.
Error json_number_problem(JsonElement element, const std::string& path);
Error json_point_problem(JsonElement element, const std::string& path);

}  // namespace beespace::io
