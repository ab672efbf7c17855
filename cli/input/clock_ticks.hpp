// Ticks by the clock of this machine: periods since 1970 (UTC), so that those of all machines whose
// clocks agree are the same.
#pragma once

#include <beespace/command.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace beespace::cli {

struct ClockTick {
  Tick tick = 0;
  double after_s = 0.0;  // since it began
};

inline ClockTick clock_tick(double period_s) {
  const std::chrono::duration<double> now = std::chrono::system_clock::now().time_since_epoch();
  const double tick = std::floor(now.count() / period_s);
  return {static_cast<Tick>(tick), std::max(0.0, now.count() - tick * period_s)};
}

// Until the next one begins: 1 or more.
inline int next_tick_in_ms(double period_s) {
  constexpr double kMost_ms = 60'000.0;
  const double left_s = period_s - clock_tick(period_s).after_s;
  return static_cast<int>(std::clamp(std::ceil(1000.0 * left_s), 1.0, kMost_ms));
}

}  // namespace beespace::cli
