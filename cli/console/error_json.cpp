#include "cli/console/error_json.hpp"

#include "io/json/json_text.hpp"

#include <cstdint>
#include <optional>

namespace beespace::cli {
namespace {

void append_optional(std::string& out, std::string_view key,
                     const std::optional<std::uint64_t>& value) {
  out += ", \"";
  out += key;
  out += "\": " + (value ? std::to_string(*value) : std::string("null"));
}

}  // namespace

void append_error_members(std::string& out, const Error& error) {
  out += "\"code\": " + io::json_string(to_string(error.code));
  out += ", \"message\": " + io::json_string(error.message);
  out += ", \"file\": " + (error.location.source.empty() ? std::string("null")
                                                         : io::json_string(error.location.source));
  append_optional(out, "line", error.location.line);
  append_optional(out, "column", error.location.column);
  append_optional(out, "record", error.location.record);
}

std::string error_as_json(const Error& error) {
  std::string out = "{\"error\": {";
  append_error_members(out, error);
  return out + "}}\n";
}

}  // namespace beespace::cli
