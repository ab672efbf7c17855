// Time zones by name, "UTC" or "Europe/Madrid", from the zone data of the system (the folder that
// TZDIR names, or /usr/share/zoneinfo), and offsets from UTC that do not change, "+01:00".
#pragma once

#include "io/units/zone_data.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace beespace::io {

class TimeZone {
 public:
  // Errors: kInvalidArgument for a name that is no zone, or not of this system.
  static Result<TimeZone> find(std::string_view name);
  static TimeZone utc() { return TimeZone("UTC", nullptr, 0); }

  [[nodiscard]] const std::string& name() const { return name_; }

  // How many seconds clocks there are ahead of UTC when they show a local time, in seconds since
  // 1970-01-01 00:00:00 on them. What is wrong, as a sentence, where they show it twice or never,
  // or where how they are turned is not known any more; nothing when all is well.
  [[nodiscard]] std::string offset_of_local(std::int64_t local_s, std::int64_t& offset_s) const;
  // By how much later clocks there show that local time again; 0 where they do not.
  [[nodiscard]] std::int64_t shown_again_after(std::int64_t local_s) const;
  // Whether clocks there are turned.
  [[nodiscard]] bool is_turned() const { return zone_ != nullptr; }
  // The offset at an instant, in seconds since 1970 (UTC).
  [[nodiscard]] std::int64_t offset_at(std::int64_t since_1970_s) const;

 private:
  TimeZone(std::string name, std::shared_ptr<const ZoneData> zone, std::int64_t offset_s)
      : name_(std::move(name)), zone_(std::move(zone)), offset_s_(offset_s) {}

  std::string name_;
  std::shared_ptr<const ZoneData> zone_;  // null: the offset is always the same
  std::int64_t offset_s_;                 // without a zone
};

// "+02:00" of 7,200 s; "Z" of 0.
std::string offset_text(std::int64_t offset_s);

}  // namespace beespace::io
