// One mission, flown, watched and written down.
#pragma once

#include "cli/console/progress_bar.hpp"
#include "cli/output/swarm_output.hpp"
#include "cli/simulate/simulate_mission.hpp"
#include "cli/simulate/simulate_request.hpp"
#include "cli/simulate/simulate_watch.hpp"
#include "io/bytes/atomic_output.hpp"
#include "sim/closed_loop.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>
#include <beespace/verify.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace beespace::cli {

// How the flight went, beside what the loop, the verdict and the watch know.
struct FlightFigures {
  std::uint64_t steps = 0;
  std::uint64_t steps_with_losses = 0;
  std::uint64_t uncertified_pairs = 0;  // counted anew in each step, as all that follows
  std::uint64_t uncertified_at_obstacles = 0;
  bool landed = false;   // all have arrived and stand
  double total_s = 0.0;  // how long it took, checks included
};

// Of all bees together.
struct FlightOutcome {
  std::optional<double> path_ratio;  // of those that have flown and arrived: the mean
  double stuck_s = 0.0;              // the mean
  std::optional<double> advice_us;   // a bee a step
  // Who is stuck at the end, for a second and more, the longest first; and for how long that one.
  std::vector<PointId> stuck;
  double longest_stuck_s = 0.0;
};

class SimulatedFlight {
 public:
  // `request` and `output`, null for no recording, must outlive it.
  SimulatedFlight(const SimulateRequest& request, MissionToFly mission, io::AtomicOutput* output);
  SimulatedFlight(const SimulatedFlight&) = delete;  // the verifier looks at the loop's obstacles
  SimulatedFlight& operator=(const SimulatedFlight&) = delete;
  ~SimulatedFlight() = default;

  // To the end, or until the output takes no more.
  Status fly(ProgressBar& progress);

  [[nodiscard]] const SimulateRequest& request() const { return request_; }
  [[nodiscard]] const sim::ClosedLoop& loop() const { return loop_; }
  [[nodiscard]] const Verdict& verdict() const { return verifier_.verdict(); }
  [[nodiscard]] const WatchFigures& watched() const { return watch_.figures(); }
  [[nodiscard]] const FlightFigures& figures() const { return figures_; }
  [[nodiscard]] FlightOutcome outcome() const;
  [[nodiscard]] const FlightNames& names() const { return names_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

  [[nodiscard]] std::uint64_t breaches() const { return verdict().breaches + watched().breaches; }
  // No bee came too close to another or to an obstacle, or flew as it cannot.
  [[nodiscard]] bool holds() const;
  // Whether each has limits of its own, and whether velocities change at once.
  [[nodiscard]] bool has_own_limits() const { return !limits_.empty(); }
  [[nodiscard]] bool at_once() const;

 private:
  [[nodiscard]] VerifyOptions verify_options() const;
  Status see();
  [[nodiscard]] bool have_landed() const;
  [[nodiscard]] double share_done() const;
  [[nodiscard]] double stuck_for(PointId bee) const;
  [[nodiscard]] std::vector<PointId> stuck() const;

  const SimulateRequest& request_;
  std::vector<FlightLimits> limits_;  // of each, or none
  FlightNames names_;
  std::vector<std::string> notes_;
  sim::ClosedLoop loop_;
  Verifier verifier_;
  SimulateWatch watch_;
  io::AtomicOutput* output_;
  std::optional<FlightWriter> writer_;
  FlightFigures figures_;
};

}  // namespace beespace::cli
