#include "io/units/time_zone.hpp"

#include "io/problems/excerpt.hpp"
#include "io/units/iso_time.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace beespace::io {

Result<TimeZone> TimeZone::find(std::string_view name) {
  if (name == "UTC" || name == "Z" || name == "GMT") return utc();
  if (!name.empty() && (name.front() == '+' || name.front() == '-')) {
    int minutes = 0;
    if (const auto problem = parse_offset(name, minutes); !problem.empty()) {
      return Error{ErrorCode::kInvalidArgument,
                   excerpt(name) + " is no offset from UTC; write it as +02:00",
                   {}};
    }
    const std::int64_t offset_s = std::int64_t{minutes} * 60;
    return TimeZone(offset_text(offset_s), nullptr, offset_s);
  }
  std::string why;
  const void* const zone = find_named(std::string(name), why);
  if (zone == nullptr) {
    return Error{ErrorCode::kInvalidArgument,
                 excerpt(name) + " is no time zone: " + why +
                     "; write UTC, a place as in Europe/Madrid, or an offset as in +02:00",
                 {}};
  }
  return TimeZone(std::string(name), zone, 0);
}

std::string offset_text(std::int64_t offset_s) {
  if (offset_s == 0) return "Z";
  const long long size = std::llabs(offset_s);
  std::array<char, 40> text = {};
  int length = std::snprintf(text.data(), text.size(), "%c%02lld:%02lld", offset_s < 0 ? '-' : '+',
                             size / 3600, size / 60 % 60);
  // Before there were zones, places had their own time, to the second.
  if (size % 60 != 0) {
    length += std::snprintf(text.data() + length, text.size() - static_cast<std::size_t>(length),
                            ":%02lld", size % 60);
  }
  return {text.data(), static_cast<std::size_t>(length)};
}

}  // namespace beespace::io
