// A line of messages: an object of JSON, and what its 'event' says that it is.
#pragma once

#include "io/json/json_document.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {

struct EventLine {
  JsonElement object;
  std::string_view event;  // empty: it has none
};

class EventLines {
 public:
  // Longer lines are refused. A command of the most states and ancestors has some 10 kB.
  static constexpr std::size_t kLongest = std::size_t{1} << 18;

  // A line, without its end. Nothing where it is blank. What it returns holds until the next call.
  // Errors have no place.
  Result<std::optional<EventLine>> read(std::string_view line);

 private:
  JsonParser parser_;
  std::string padded_;
};

// An id: a text that is not too long, or a whole number. False where it is neither.
inline constexpr std::size_t kLongestFleetId = 64;
bool read_fleet_id(JsonElement element, std::string& id);

}  // namespace beespace::io
