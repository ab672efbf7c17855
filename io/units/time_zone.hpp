// Time zones by name, "UTC" or "Europe/Madrid", from the zone data of the system, and offsets from
// UTC that do not change, "+01:00".
#pragma once

#include <beespace/result.hpp>

#include <cstdint>
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
  // The same at an instant, in seconds since 1970 (UTC).
  [[nodiscard]] std::int64_t offset_at(std::int64_t since_1970_s) const;

 private:
  TimeZone(std::string name, const void* zone, std::int64_t offset_s)
      : name_(std::move(name)), zone_(zone), offset_s_(offset_s) {}

  // Of a named zone; null where this program has none, or the system none of that name, of which
  // `why` tells.
  static const void* find_named(const std::string& name, std::string& why);

  std::string name_;
  const void* zone_;       // null: the offset is always the same
  std::int64_t offset_s_;  // without a zone
};

// "+02:00" of 7,200 s; "Z" of 0.
std::string offset_text(std::int64_t offset_s);

}  // namespace beespace::io
