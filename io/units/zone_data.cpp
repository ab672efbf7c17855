// The zone data of the system, by the library 'date' of Howard Hinnant: GCC 12's own has none.
#include "io/units/time_zone.hpp"

#include <date/tz.h>

#include <chrono>
#include <exception>
#include <fstream>
#include <iterator>

namespace beespace::io {
namespace {

const date::time_zone& of(const void* zone) {
  return *static_cast<const date::time_zone*>(zone);
}

// Whether clocks there are turned for ever by a rule, which a zone's file has in its last line: a
// comma stands before its dates. Where that cannot be read, they may be.
bool follows_a_rule(const std::string& name) {
  std::ifstream file("/usr/share/zoneinfo/" + name, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (bytes.size() < 2 || bytes.back() != '\n') return true;
  const std::size_t begin = bytes.rfind('\n', bytes.size() - 2);
  return begin == std::string::npos || bytes.find(',', begin) != std::string::npos;
}

// Whether no change follows that is in the file one by one. The library takes the last of them to
// hold for ever.
bool is_after_the_last(const date::sys_info& info) {
  return info.end >= date::sys_days(date::year(3000) / 1 / 1);
}

std::string instant_there(const date::sys_info& info) {
  return offset_text(info.offset.count());
}

}  // namespace

const void* TimeZone::find_named(const std::string& name, std::string& why) {
  try {
    return date::locate_zone(name);
  } catch (const std::exception&) {
    why = "the zone data of this system has none of that name";
    return nullptr;
  }
}

std::string TimeZone::offset_of_local(std::int64_t local_s, std::int64_t& offset_s) const {
  offset_s = offset_s_;
  if (zone_ == nullptr) return {};
  const auto info = of(zone_).get_info(date::local_seconds(std::chrono::seconds(local_s)));
  offset_s = info.first.offset.count();
  const std::string before = instant_there(info.first);
  const std::string after = instant_there(info.second);
  if (is_after_the_last(info.first) && follows_a_rule(name_)) {
    return "how clocks of " + name_ +
           " are turned so late is not known: the zone data list no change from then on; write the "
           "offset behind it, as in +02:00";
  }
  if (info.result == date::local_info::ambiguous) {
    return "clocks of " + name_ + " show it twice, as they are turned back from " + before +
           " to " + after + "; write " + before + " or " + after +
           " behind it, or, if this clock is never turned, say --time-zone " + before + " or " +
           after;
  }
  if (info.result == date::local_info::nonexistent) {
    return "clocks of " + name_ + " never show it, as they are turned forward from " + before +
           " to " + after + "; correct it, or, if this clock is never turned, say --time-zone " +
           before + " or " + after;
  }
  return {};
}

std::int64_t TimeZone::offset_at(std::int64_t since_1970_s) const {
  if (zone_ == nullptr) return offset_s_;
  return of(zone_).get_info(date::sys_seconds(std::chrono::seconds(since_1970_s))).offset.count();
}

}  // namespace beespace::io
