// The closed loop: bees fly a mission step after step, as advised or at their preferred velocities.
//
// Each bee prefers to fly straight to its goal, as fast as it can, and to stop there. Units:
// metres, seconds.
#pragma once

#include "scenes/missions.hpp"

#include <beespace/advise.hpp>
#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace beespace::sim {

// As advise() says, by its method; or at preferred velocities.
enum class Method : std::uint8_t { kNone, kCertified, kOrca, kMvp };

struct LoopOptions {
  Method method = Method::kCertified;
  FlightLimits limits;  // of all bees, where the mission has none
  // Its threshold and step are those of every method. The obstacles are those of the mission.
  AdviseOptions advice = {};
  double arrived_m = 1.0;  // a bee so near to its goal has arrived
};

// One bee's way so far.
struct Flight {
  double shortest_m = 0.0;  // from the start straight to the goal
  double flown_m = 0.0;     // until it arrived, and the rest of the way straight
  std::optional<double> arrived_s = {};
  double stuck_s = 0.0;  // not there, and slower than a twentieth of its greatest speed
  std::optional<double> stuck_since_s = {};  // of a bee that is stuck now
};

class ClosedLoop {
 public:
  // All bees stand at their starts at time 0.
  ClosedLoop(scenes::Mission mission, const LoopOptions& options);

  // Flies on for a step. Errors: as ObstacleMap::of and Adviser::advise.
  Status step();

  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] const std::vector<Mover>& movers() const { return movers_; }
  [[nodiscard]] const std::vector<Flight>& flights() const { return flights_; }
  [[nodiscard]] std::size_t arrived() const { return arrived_; }
  // Null for none.
  [[nodiscard]] const ObstacleMap* obstacles() const;
  // Of the last step.
  [[nodiscard]] const Advised& advised() const { return advised_; }
  // Seconds of the processor's clock that advice has taken so far.
  [[nodiscard]] double advising_s() const { return advising_s_; }

 private:
  [[nodiscard]] const FlightLimits& limits_of(std::size_t bee) const {
    return limits_[limits_.size() == 1 ? 0 : bee];
  }
  [[nodiscard]] Velocity as_it_likes(std::size_t bee) const;
  Status take_advice();
  void look_at(std::size_t bee);
  void fly(std::size_t bee, const Velocity& next);

  scenes::Mission mission_;
  LoopOptions options_;
  std::vector<FlightLimits> limits_;  // one for all or for each
  Result<ObstacleMap> obstacles_;
  std::uint64_t steps_ = 0;
  double time_s_ = 0.0;
  std::vector<Mover> movers_;
  std::vector<Flight> flights_;
  std::size_t arrived_ = 0;
  std::vector<Velocity> wishes_;
  Adviser adviser_;
  Advised advised_;
  double advising_s_ = 0.0;
};

}  // namespace beespace::sim
