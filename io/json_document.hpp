// A JSON text, parsed, and what is wrong with its values in words.
#pragma once

#include "io/byte_source.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <simdjson.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

using JsonElement = simdjson::dom::element;

class JsonDocument {
 public:
  // Errors: kNoPoints (empty), kTruncated, kCorrupt with line and column; with `source` as place.
  static Result<JsonDocument> parse(std::string_view text, std::string source);

  [[nodiscard]] JsonElement root() const { return root_; }

 private:
  JsonDocument() = default;

  std::unique_ptr<simdjson::dom::parser> parser_;  // holds what root_ and its parts point to
  JsonElement root_;
};

// Member `key` of an object; nothing where there is none, or it is null.
std::optional<JsonElement> json_member(JsonElement object, std::string_view key);

// "a number", "a string", ...; what stands there instead of what is wanted.
std::string_view json_kind(JsonElement element);

// A number that motion can be computed with; `path` names it in messages ("points[3][0]"). Errors:
// kNotANumber, kOutsideDomain; without place.
Result<double> json_number(JsonElement element, const std::string& path);

// An array of x, y, z. Errors: kColumnCount too.
Result<Point> json_point(JsonElement element, const std::string& path);

}  // namespace beespace::io
