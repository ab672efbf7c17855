// What a file of zone data (TZif, RFC 9636) says of the clocks of a zone: its listed changes, and
// the rule behind them (as POSIX writes it in TZ), however few the file lists.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

struct ZoneData {
  struct Change {
    std::int64_t at_s;      // since 1970 (UTC)
    std::int64_t offset_s;  // from then on, ahead of UTC
  };

  std::int64_t first_offset_s = 0;   // before the first change
  std::vector<Change> changes = {};  // ascending; those of the rule are among them, for 400 years
  // From here on all is as 400 years before, after which the calendar repeats itself.
  std::optional<std::int64_t> repeats_from_s = {};
  // Behind the last change it is not known what comes.
  bool ends = false;
};

// Nothing where it is no such file, or one whose seconds are not those of UTC ("right").
std::optional<ZoneData> parse_zone_data(std::string_view file);

// At an instant, since 1970 (UTC). Behind the end, as before it.
std::int64_t offset_at(const ZoneData& zone, std::int64_t since_1970_s);

// What clocks there show: once, twice or never.
struct LocalTime {
  enum class Shown : std::uint8_t { kOnce, kTwice, kNever, kUnknown };

  Shown shown = Shown::kOnce;
  std::int64_t offset_s = 0;  // once: ahead of UTC; twice: the first time; never: before it
  std::int64_t later_s = 0;   // twice: the second time; never: after it
};

// `local_s` is since 1970-01-01 00:00:00 on these clocks.
LocalTime local_time(const ZoneData& zone, std::int64_t local_s);

}  // namespace beespace::io
