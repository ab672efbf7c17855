#include "analysis/live/report_intervals.hpp"

#include <algorithm>

namespace beespace::analysis {

void ReportIntervals::take(AgentId bee, double time_s) {
  if (bee >= bees_.size()) bees_.resize(bee + 1);
  Bee& known = bees_[bee];
  latest_ = bee;
  // Several of one moment are one.
  if (known.last_s && time_s > *known.last_s) {
    known.intervals_s[known.intervals % kKept] = static_cast<float>(time_s - *known.last_s);
    ++known.intervals;
  }
  if (!known.last_s || time_s > *known.last_s) known.last_s = time_s;
}

void ReportIntervals::forget(AgentId bee) {
  if (bee < bees_.size()) bees_[bee] = {};
}

std::optional<double> ReportIntervals::usual_s(const Bee& bee) {
  if (bee.intervals == 0) return std::nullopt;
  auto kept = bee.intervals_s;
  const auto end = kept.begin() + static_cast<std::ptrdiff_t>(std::min(bee.intervals, kept.size()));
  const auto middle = kept.begin() + (end - kept.begin() - 1) / 2;
  std::nth_element(kept.begin(), middle, end);
  return static_cast<double>(*middle);
}

std::size_t ReportIntervals::silent(double now_s, double max_age_s) const {
  if (bees_.empty()) return 0;
  const double open_s = usual_s(bees_[latest_]).value_or(0.0);
  return static_cast<std::size_t>(std::count_if(bees_.begin(), bees_.end(), [&](const Bee& bee) {
    const auto interval_s = usual_s(bee);
    if (!interval_s) return false;
    const double silent_s = now_s - *bee.last_s;
    return silent_s > std::max(kSilentFactor * *interval_s, open_s) && silent_s <= max_age_s;
  }));
}

}  // namespace beespace::analysis
