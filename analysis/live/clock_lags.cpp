#include "analysis/live/clock_lags.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace beespace::analysis {
namespace {

// Of so many reports, within so long, one is not delayed.
constexpr std::uint32_t kReports = 3;
constexpr double kSpan_s = 4.0;
// It must be so much nearer to be right again.
constexpr double kRightShare = 0.5;
// What is told is rounded: more is not known.
constexpr double kPerSecond = 1000.0;

}  // namespace

void ClockLags::take(AgentId id, double time_s, double now_s, std::vector<Told>& told) {
  began_s_ = std::min(began_s_, now_s);
  if (now_s - began_s_ >= kSpan_s) {
    judge(told);
    began_s_ = now_s;
  }
  if (id >= bees_.size()) bees_.resize(std::max<std::size_t>(id + 1, 2 * bees_.size()));
  Bee& bee = bees_[id];
  if (time_s == bee.last_s) return;  // the same again
  bee.last_s = time_s;
  ++bee.count;
  bee.least_s = std::min(bee.least_s, std::max(0.0, now_s - time_s));
}

void ClockLags::judge(std::vector<Told>& told) {
  lags_.clear();
  for (const Bee& bee : bees_) {
    if (bee.count >= kReports) lags_.push_back(bee.least_s);
  }
  const bool any = lags_.size() > 1;
  const auto middle =
      lags_.begin() + (any ? static_cast<std::ptrdiff_t>((lags_.size() - 1) / 2) : 0);
  if (any) std::nth_element(lags_.begin(), middle, lags_.end());
  for (AgentId id = 0; id < bees_.size(); ++id) {
    Bee& bee = bees_[id];
    const double lag_s = std::exchange(bee.least_s, kNone);
    if (std::exchange(bee.count, 0) < kReports || !any) continue;
    const double ahead_s = std::round((*middle - lag_s) * kPerSecond) / kPerSecond;
    const bool is_off = std::abs(ahead_s) > (bee.named ? kRightShare : 1.0) * limit_s_;
    // Once may be since a bee has joined in the meantime, and took the time of the swarm along.
    const bool twice = std::exchange(bee.differs, is_off) == is_off;
    if (is_off == bee.named || !twice) continue;
    bee.named = is_off;
    if (is_off) ++named_;
    told.push_back({id, ahead_s, !is_off});
  }
}

void ClockLags::forget(AgentId id) {
  if (id < bees_.size()) bees_[id] = {};
}

void ClockLags::clear() {
  bees_.clear();
  began_s_ = kNone;
}

}  // namespace beespace::analysis
