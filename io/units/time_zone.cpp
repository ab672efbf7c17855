#include "io/units/time_zone.hpp"

#include "io/problems/excerpt.hpp"
#include "io/units/iso_time.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>
#include <utility>

namespace beespace::io {
namespace {

// Of a place, without leading out of the folder of zone data.
bool may_be_zone(std::string_view name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_+-/").find(c) != std::string_view::npos;
  };
  return !name.empty() && name.front() != '/' && std::all_of(name.begin(), name.end(), fits);
}

// Of a named zone; null where the system has none of that name, of which `why` tells.
std::shared_ptr<const ZoneData> find_named(const std::string& name, std::string& why) {
  const char* const set = std::getenv("TZDIR");
  const std::string folder = set != nullptr && *set != '\0' ? set : "/usr/share/zoneinfo";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) {
    why = "this system has no zone data in " + folder + " (package tzdata)";
    return nullptr;
  }
  const std::string path = folder + "/" + name;
  why = "the zone data of this system has none of that name";
  if (!may_be_zone(name) || !std::filesystem::is_regular_file(path, ignored)) return nullptr;
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  auto data = parse_zone_data(bytes);
  if (!data) {
    why = path + " is no zone data that can be read";
    return nullptr;
  }
  return std::make_shared<const ZoneData>(*std::move(data));
}

}  // namespace

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
  auto zone = find_named(std::string(name), why);
  if (zone == nullptr) {
    return Error{ErrorCode::kInvalidArgument,
                 excerpt(name) + " is no time zone: " + why +
                     "; write UTC, a place as in Europe/Madrid, or an offset as in +02:00",
                 {}};
  }
  return TimeZone(std::string(name), std::move(zone), 0);
}

std::string TimeZone::offset_of_local(std::int64_t local_s, std::int64_t& offset_s) const {
  offset_s = offset_s_;
  if (zone_ == nullptr) return {};
  const LocalTime there = local_time(*zone_, local_s);
  offset_s = there.offset_s;
  const std::string before = offset_text(there.offset_s);
  const std::string after = offset_text(there.later_s);
  switch (there.shown) {
    case LocalTime::Shown::kUnknown:
      return "how clocks of " + name_ +
             " are turned so late is not known: the zone data list no change from then on, and "
             "have no rule; write the offset behind it, as in +02:00";
    case LocalTime::Shown::kTwice:
      return "clocks of " + name_ + " show it twice, as they are turned back from " + before +
             " to " + after + "; write " + before + " or " + after +
             " behind it, or, if this clock is never turned, say --time-zone " + before + " or " +
             after;
    case LocalTime::Shown::kNever:
      return "clocks of " + name_ + " never show it, as they are turned forward from " + before +
             " to " + after + "; correct it, or, if this clock is never turned, say --time-zone " +
             before + " or " + after;
    case LocalTime::Shown::kOnce:
      break;
  }
  return {};
}

std::int64_t TimeZone::shown_again_after(std::int64_t local_s) const {
  if (zone_ == nullptr) return 0;
  const LocalTime there = local_time(*zone_, local_s);
  return there.shown == LocalTime::Shown::kTwice ? there.offset_s - there.later_s : 0;
}

std::int64_t TimeZone::offset_at(std::int64_t since_1970_s) const {
  return zone_ == nullptr ? offset_s_ : io::offset_at(*zone_, since_1970_s);
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
