// Clocks that differ by too little to be disbelieved, and by enough to matter: a bee that flies
// 15 m/s is 20 m from where a clock that is 1.5 s ahead puts it.
//
// A report is behind the time of the swarm by its lag. That of the fastest report of some seconds,
// the same ones for all, is what the clock, or the way, of its bee adds: as much for each, where
// all clocks are right. Who differs from the middle one of all by more than the limit, twice in a
// row, is named. Whether its clock is ahead or the reports of the others take longer cannot be
// told, so its reports stay as they are; there is no promise that includes it.
//
// Reports in the order of their times have no lag: then nothing is known of their clocks.
#pragma once

#include <beespace/swarm.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace beespace::analysis {

class ClockLags {
 public:
  explicit ClockLags(double limit_s) : limit_s_(limit_s) {}

  struct Told {
    AgentId bee;
    double ahead_s;  // of the middle one; behind where that is negative
    bool right;      // no more
  };

  // A report that was believed, at that time of the swarm.
  void take(AgentId id, double time_s, double now_s, std::vector<Told>& told);

  // A bee that is there no longer; all of them, as time begins anew.
  void forget(AgentId id);
  void clear();

  // How many bees have been named.
  [[nodiscard]] std::uint64_t named() const { return named_; }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  struct Bee {
    double last_s = kNever;   // as reported
    double least_s = kNone;   // the least lag of these seconds,
    std::uint32_t count = 0;  // and of how many reports
    bool differs = false;     // as the seconds before said, of which there must be two in a row
    bool named = false;
  };

  void judge(std::vector<Told>& told);

  double limit_s_;
  std::vector<Bee> bees_;     // by id
  std::vector<double> lags_;  // while judging
  double began_s_ = kNone;    // of these seconds, by the time of the swarm
  std::uint64_t named_ = 0;
};

}  // namespace beespace::analysis
