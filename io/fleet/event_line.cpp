#include "io/fleet/event_line.hpp"

#include <cstdint>

namespace beespace::io {

Result<std::optional<EventLine>> EventLines::read(std::string_view line) {
  if (line.size() > kLongest) {
    return Error{ErrorCode::kMalformedRecord,
                 "the line has more than " + std::to_string(kLongest) +
                     " bytes, which no message has; is the input text, an object a line?",
                 {}};
  }
  if (line.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return std::optional<EventLine>();
  }
  // The parser reads beyond the end; what lies there does not matter.
  padded_.reserve(line.size() + JsonParser::kPadding);
  padded_.assign(line);
  EventLine read;
  const std::string_view problem = parser_.parse_padded(padded_, read.object);
  if (!problem.empty()) {
    Error error = json_syntax_error(line, problem, "each object must be whole in one line");
    error.location.line.reset();
    return error;
  }
  if (!read.object.is_object()) {
    return Error{ErrorCode::kUnsupportedFormat,
                 "this line is " + std::string(json_kind(read.object)) +
                     ", not an object; write one object a line",
                 {}};
  }
  const auto event = json_member(read.object, "event");
  if (!event || !event->get(read.event)) read.event = {};
  return std::optional(read);
}

bool read_fleet_id(JsonElement element, std::string& id) {
  std::string_view text;
  if (element.get(text)) {
    id = text;
    return !id.empty() && id.size() <= kLongestFleetId;
  }
  if (std::uint64_t number = 0; element.get(number)) {
    id = std::to_string(number);
    return true;
  }
  std::int64_t number = 0;
  if (!element.get(number)) return false;
  id = std::to_string(number);
  return true;
}

}  // namespace beespace::io
