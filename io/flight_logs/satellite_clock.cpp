#include "io/flight_logs/satellite_clock.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace beespace::io {
namespace {

// A receiver says the same time within tens of milliseconds, as far as the drone heeds it at once.
constexpr std::uint64_t kSurelyOneClockMicros = 100'000;
constexpr std::uint64_t kMostSpreadMicros = 1'000'000;

// GPS counts no leap seconds: how many came since it began, from when on. Source: IERS Bulletin C.
struct Leap {
  std::int64_t since_s;  // UTC
  std::int64_t seconds;
};
constexpr std::array<Leap, 3> kLeaps = {
    {{1'483'228'800, 18}, {1'435'708'800, 17}, {1'341'100'800, 16}}};
constexpr std::int64_t kGpsBegan_s = 315'964'800;  // 6 January 1980

std::string milliseconds_text(std::uint64_t micros) {
  return std::to_string((micros + 500) / 1000) + " ms";
}

}  // namespace

std::optional<SatelliteClock> satellite_clock(std::vector<std::int64_t> ahead) {
  if (ahead.empty()) return std::nullopt;
  std::sort(ahead.begin(), ahead.end());
  const std::size_t outside = ahead.size() / 20;  // at each end
  SatelliteClock clock;
  clock.ahead_micros = ahead[ahead.size() / 2];
  clock.spread_micros =
      static_cast<std::uint64_t>(ahead[ahead.size() - 1 - outside] - ahead[outside]);
  clock.samples = ahead.size();
  return clock;
}

std::optional<std::int64_t> utc_of_gps(double week, double milliseconds) {
  constexpr double kMostWeeks = 10'000.0;  // the year 2171
  constexpr std::int64_t kWeek_s = 604'800;
  constexpr std::int64_t kWeek_ms = kWeek_s * 1000;
  const bool is_time = week >= 0.0 && week < kMostWeeks && milliseconds >= 0.0 &&
                       milliseconds < static_cast<double>(kWeek_ms);
  if (!is_time) return std::nullopt;
  const std::int64_t gps_ms = (kGpsBegan_s + static_cast<std::int64_t>(week) * kWeek_s) * 1000 +
                              static_cast<std::int64_t>(milliseconds);
  for (const Leap& leap : kLeaps) {
    const std::int64_t utc_ms = gps_ms - leap.seconds * 1000;
    if (utc_ms >= leap.since_s * 1000) return utc_ms * 1000;
  }
  return std::nullopt;
}

std::optional<Error> contradiction(const SatelliteClock& clock, std::string_view log) {
  if (clock.spread_micros <= kMostSpreadMicros) return std::nullopt;
  return Error{ErrorCode::kInvalidArgument,
               "the times of GPS in this " + std::string(log) + " contradict its own clock by " +
                   milliseconds_text(clock.spread_micros) +
                   ", so that it shares no clock with other inputs; read it alone, or leave it "
                   "out",
               {}};
}

void tell_clock(const std::optional<SatelliteClock>& clock, RecordingAssembly& assembly) {
  const std::string& name = assembly.source_name();
  if (!clock) {
    assembly.note("in " + name +
                  " times are seconds since the drone was switched on: there is no time of GPS");
    return;
  }
  assembly.set_by_gps(clock->samples, clock->spread_micros);
  if (!assembly.has_several() || clock->spread_micros <= kSurelyOneClockMicros) return;
  assembly.note("so it may be that much off from the clocks of other inputs: " + name);
  assembly.doubt_times(1);
}

}  // namespace beespace::io
