// The zone data of the system, by the library 'date' of Howard Hinnant: GCC 12's own has none.
#include "io/units/time_zone.hpp"

#include <date/tz.h>

#include <chrono>
#include <exception>

namespace beespace::io {
namespace {

const date::time_zone& of(const void* zone) {
  return *static_cast<const date::time_zone*>(zone);
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
