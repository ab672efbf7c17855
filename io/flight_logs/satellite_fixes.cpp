#include "io/flight_logs/satellite_fixes.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace beespace::io {

void SatelliteFixes::take(std::uint8_t receiver, std::uint64_t micros, bool has_fix) {
  reports_.push_back({micros, receiver, has_fix});
}

void SatelliteFixes::settle() {
  std::stable_sort(reports_.begin(), reports_.end(),
                   [](const Report& a, const Report& b) { return a.micros < b.micros; });
  std::map<std::uint8_t, bool> have_fix;
  bool had_fix = false;
  bool lost = false;
  for (const Report& report : reports_) {
    have_fix[report.receiver] = report.has_fix;
    had_fix = had_fix || report.has_fix;
    const bool none = had_fix && std::none_of(have_fix.begin(), have_fix.end(),
                                              [](const auto& of) { return of.second; });
    if (none != lost) changes_.push_back({report.micros, none});
    lost = none;
  }
  reports_.clear();
}

bool SatelliteFixes::lost_at(std::uint64_t micros) const {
  const auto later =
      std::upper_bound(changes_.begin(), changes_.end(), micros,
                       [](std::uint64_t at, const Change& change) { return at < change.micros; });
  return later != changes_.begin() && std::prev(later)->lost;
}

}  // namespace beespace::io
