// How often each bee reports, so that it is seen who has fallen silent when the input ends, long
// before it is stale.
#pragma once

#include <beespace/swarm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace beespace::analysis {

class ReportIntervals {
 public:
  // So many usual intervals are a silence, as a gap of a recording is.
  static constexpr double kSilentFactor = 5.0;

  // By one clock for all; a time that goes back counts as the last one.
  void take(AgentId bee, double time_s);
  void forget(AgentId bee);
  void clear() { bees_.clear(); }

  // How many were last heard of more than kSilentFactor of their usual intervals before `now_s`,
  // but no more than `max_age_s`. By less than the usual interval of the bee that was heard last it
  // is not known when the input ends.
  [[nodiscard]] std::size_t silent(double now_s, double max_age_s) const;

 private:
  static constexpr std::size_t kKept = 8;

  struct Bee {
    std::optional<double> last_s = {};
    std::array<float, kKept> intervals_s = {};  // the last ones, in a ring
    std::size_t intervals = 0;                  // of all time
  };

  // The lower median of those that are kept; nothing of one report.
  static std::optional<double> usual_s(const Bee& bee);

  std::vector<Bee> bees_;  // by number
  AgentId latest_ = 0;
};

}  // namespace beespace::analysis
