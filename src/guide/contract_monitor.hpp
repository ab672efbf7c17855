// Whether one agent keeps the contract of its figures, as far as its reports tell.
//
// A report says how far the agent was from its nominal path, to within the error of reports. While
// the figures hold, it is never farther from it than the radius of its tube, and that deviation
// changes no faster than what carries it off and what corrects it, together. What contradicts this
// names the agent, so no agent is named that keeps its figures. (A velocity that is reported names
// no agent: the figures do not say how exact it is.)
//
// Deviations are those from the branch that the report says it is on. They go on from one branch
// to the next, since an agent changes branches only where both lead the same way.
#pragma once

#include "base/vector3.hpp"

#include <beespace/command.hpp>
#include <beespace/fleet.hpp>
#include <beespace/guide.hpp>
#include <beespace/point.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace beespace::guide {

// Without memory of its own beyond a few deviations.
class ContractMonitor {
 public:
  // Of no agent.
  ContractMonitor() = default;
  // Of an agent that joins: its contract is kept. The figures are those of its tube.
  ContractMonitor(const FleetFigures& figures, const LinkFigures& link, const Tube& tube);

  // Takes a report, `age_s` after its stamp; `nominal` is where the agent should have been then, on
  // the branch that it says. In any order, any number of times.
  void take(const Point& nominal, const AgentReport& report, double age_s);
  // So long ago, in seconds, is the stamp of the newest report (or the moment since when some are
  // due). On the ground an agent is out of its contract where that is too long: nothing corrects
  // it. On board it is doubted until it reports again.
  void check_silence(double silent_s);
  // It is out of its contract, for a reason that others found.
  void name(ContractReason reason);

  // An agent that is out stays out, until it joins anew.
  [[nodiscard]] Contract contract() const { return contract_; }
  [[nodiscard]] ContractReason reason() const { return reason_; }
  // Of the newest report, in metres; 0 before the first.
  [[nodiscard]] double deviation_m() const { return deviation_m_; }

 private:
  struct Measured {
    Tick tick = 0;
    double after_s = 0.0;
    core::Vector3 deviation;
  };
  // Deviations that are kept: the k-th is between about 2^(k-1) and 2^k reports old.
  static constexpr std::size_t kKept = 8;

  [[nodiscard]] double seconds_between(const Measured& a, const Measured& b) const;
  [[nodiscard]] bool is_too_fast(const Measured& now, double spare_m) const;
  [[nodiscard]] bool is_newest(const Measured& now) const;
  void keep(const Measured& now);

  double period_s_ = 0.0;
  double out_m_ = 0.0;  // beyond: named
  double tube_m_ = 0.0;
  double error_m_ = 0.0;  // of a report
  double clock_s_ = 0.0;
  double clock_m_ = 0.0;
  double rate_mps_ = 0.0;   // how fast a deviation changes at most
  double longest_s_ = 0.0;  // without a report
  bool is_on_ground_loop_ = false;

  Contract contract_ = Contract::kKept;
  ContractReason reason_ = ContractReason::kNone;
  double deviation_m_ = 0.0;

  std::array<Measured, kKept> kept_;  // the newest first
  bool has_reported_ = false;
  std::uint32_t taken_ = 0;
};

}  // namespace beespace::guide
