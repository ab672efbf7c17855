#include "cli/console/error_json.hpp"

namespace beespace::cli {

void write_error(io::JsonWriter& json, const Error& error) {
  const std::string& source = error.location.source;
  json.begin_object().member("code", to_string(error.code)).member("message", error.message);
  json.member("file", io::known_if<std::string_view>(!source.empty(), source));
  json.member("line", error.location.line).member("column", error.location.column);
  json.member("record", error.location.record);
  json.end();
}

std::string error_as_json(const Error& error) {
  std::string out;
  io::JsonWriter json(out);
  json.begin_object();
  write_error(json.key("error"), error);
  json.end();
  return out + '\n';
}

}  // namespace beespace::cli
