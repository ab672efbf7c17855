#include "analysis/live/look_times.hpp"

#include <cmath>

namespace beespace::analysis {
namespace {

// Integers of doubles are exact below.
constexpr double kMostCounted = 0x1p53;

}  // namespace

LookTimes::LookTimes(double step_s) : step_s_(step_s) {
  double parts = 1.0;
  for (int decimals = 0; decimals <= 9; ++decimals, parts *= 10.0) {
    const double whole = std::round(step_s * parts);
    if (whole < 1.0 || whole >= kMostCounted || whole / parts != step_s) continue;
    parts_ = parts;
    step_in_parts_ = whole;
    return;
  }
}

double LookTimes::at(std::int64_t number) const {
  const auto count = static_cast<double>(number);
  // One division of integers rounds as reading the decimals does.
  const double whole = count * step_in_parts_;
  if (parts_ > 0.0 && std::abs(whole) < kMostCounted) return whole / parts_;
  return count * step_s_;
}

std::optional<std::int64_t> LookTimes::last_before(double time_s) const {
  const double about = std::floor(time_s / step_s_);
  if (!(std::abs(about) < 0.25 * kMostCounted)) return std::nullopt;
  // The quotient is rounded: at most a few beside.
  auto number = static_cast<std::int64_t>(about);
  while (at(number + 1) < time_s) ++number;
  while (!(at(number) < time_s)) --number;
  return number;
}

}  // namespace beespace::analysis
