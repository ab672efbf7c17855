// Where there is no library that reads the zone data of the system: UTC and offsets only.
#include "io/units/time_zone.hpp"

namespace beespace::io {

const void* TimeZone::find_named(const std::string& /*name*/, std::string& why) {
  why = "this program was built without zone data, so that it knows UTC and offsets only";
  return nullptr;
}

std::string TimeZone::offset_of_local(std::int64_t /*local_s*/, std::int64_t& offset_s) const {
  offset_s = offset_s_;
  return {};
}

std::int64_t TimeZone::offset_at(std::int64_t /*since_1970_s*/) const {
  return offset_s_;
}

}  // namespace beespace::io
