#include "guide/contract_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace beespace::guide {

namespace {

// More than what rounding can do to a difference of two places: of each coordinate half a unit in
// the last place of either, and of the difference.
double rounding_of(const Point& a, const Point& b) {
  const double largest = std::max(
      {std::abs(a.x), std::abs(a.y), std::abs(a.z), std::abs(b.x), std::abs(b.y), std::abs(b.z)});
  return 0x1p-48 * largest;
}

// The same for a sum of a few terms.
constexpr double kRoundedUp = 1.0 + 0x1p-40;

}  // namespace

ContractMonitor::ContractMonitor(const FleetFigures& figures, const LinkFigures& link,
                                 const Tube& tube)
    : period_s_(link.period_s),
      out_m_((tube.radius_m + figures.report_error_m) * kRoundedUp),
      tube_m_(tube.radius_m),
      error_m_(figures.report_error_m),
      clock_s_(figures.clock_error_s),
      clock_m_(tube.clock_m),
      rate_mps_((figures.deviation_mps + figures.correction_mps) * kRoundedUp),
      longest_s_(
          (figures.report_age_s + link.longest_loss * link.period_s + figures.clock_error_s) *
          kRoundedUp),
      is_on_ground_loop_(figures.loop == LoopPlace::kGround) {
}

void ContractMonitor::take(const Point& nominal, const AgentReport& report, double age_s) {
  const Measured now{report.tick, report.after_s,
                     core::vector_of(report.position) - core::vector_of(nominal)};
  const double spare_m = rounding_of(nominal, report.position);
  const double off_m = core::length(now.deviation);
  const bool newest = is_newest(now);
  if (newest) deviation_m_ = off_m;
  if (contract_ == Contract::kOut) return;
  // A late report tells as much of what was as one in time, and of what is, less than the newest.
  if (!(off_m <= out_m_ + spare_m)) return name(ContractReason::kDeviation);
  if (is_too_fast(now, spare_m)) return name(ContractReason::kRate);
  if (!newest) return;
  keep(now);
  const bool may_be_out = off_m + error_m_ + rate_mps_ * std::max(0.0, age_s) > tube_m_ + spare_m;
  contract_ = may_be_out ? Contract::kDoubted : Contract::kKept;
  reason_ = may_be_out ? ContractReason::kDeviation : ContractReason::kNone;
}

void ContractMonitor::check_silence(double silent_s) {
  if (contract_ == Contract::kOut || silent_s <= longest_s_) return;
  if (is_on_ground_loop_) return name(ContractReason::kSilent);
  contract_ = Contract::kDoubted;
  reason_ = ContractReason::kSilent;
}

void ContractMonitor::name(ContractReason reason) {
  if (contract_ == Contract::kOut) return;  // the first reason is the one that tells most
  contract_ = Contract::kOut;
  reason_ = reason;
}

double ContractMonitor::seconds_between(const Measured& a, const Measured& b) const {
  return std::abs(static_cast<double>(a.tick - b.tick) * period_s_ + (a.after_s - b.after_s));
}

// Two reports are each off by the error of reports; and by what the clock of either may be wrong.
bool ContractMonitor::is_too_fast(const Measured& now, double spare_m) const {
  if (!has_reported_) return false;
  for (const Measured& before : kept_) {
    const double changed_m = core::length(now.deviation - before.deviation);
    const double lasted_s = seconds_between(now, before) + 2.0 * clock_s_;
    const double most_m = rate_mps_ * lasted_s + 2.0 * (error_m_ + clock_m_);
    if (!(changed_m <= most_m * kRoundedUp + 4.0 * spare_m)) return true;
  }
  return false;
}

bool ContractMonitor::is_newest(const Measured& now) const {
  if (!has_reported_) return true;
  const Measured& last = kept_.front();
  return now.tick > last.tick || (now.tick == last.tick && now.after_s > last.after_s);
}

// The k-th place is passed on at each 2^(k-1)-th report: so those that are kept reach far back, and
// lie the closer together the newer they are.
void ContractMonitor::keep(const Measured& now) {
  if (!has_reported_) kept_.fill(now);
  has_reported_ = true;
  for (std::size_t k = kKept - 1; k > 0; --k) {
    if (taken_ % (std::uint32_t{1} << (k - 1)) == 0) kept_[k] = kept_[k - 1];
  }
  kept_.front() = now;
  ++taken_;
}

}  // namespace beespace::guide
