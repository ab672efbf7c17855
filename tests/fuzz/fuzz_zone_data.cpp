// Fuzzes the reader of zone data: files of TZif, their rules, and what clocks show.
//
// Beyond the sanitizers, it checks that changes ascend, that what clocks show once, at some
// instant, they show at that instant, and that the calendar's repeat holds.
#include "io/units/zone_data.hpp"
#include "io/units/zone_rule.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string_view>

namespace beespace::io {
namespace {

void require(bool condition) {
  if (!condition) std::abort();
}

void check(const ZoneData& zone, std::int64_t local_s) {
  for (std::size_t i = 1; i < zone.changes.size(); ++i) {
    require(zone.changes[i - 1].at_s < zone.changes[i].at_s);
  }
  const LocalTime there = local_time(zone, local_s);
  const bool once = there.shown == LocalTime::Shown::kOnce;
  const bool twice = there.shown == LocalTime::Shown::kTwice;
  if (once || twice) require(offset_at(zone, local_s - there.offset_s) == there.offset_s);
  if (twice) require(offset_at(zone, local_s - there.later_s) == there.later_s);
}

}  // namespace
}  // namespace beespace::io

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace beespace::io;
  if (size < 5) return 0;
  std::uint32_t days = 0;
  std::memcpy(&days, data, sizeof days);
  const std::string_view text(reinterpret_cast<const char*>(data) + 5, size - 5);
  static_cast<void>(parse_zone_rule(text));
  // Every year that can be written, from 0000 to 9999.
  const std::int64_t local_s =
      std::int64_t{days % 3'652'425} * 86'400 - 62'167'219'200 + data[4] * 337;
  if (const auto zone = parse_zone_data(text)) check(*zone, local_s);
  return 0;
}
