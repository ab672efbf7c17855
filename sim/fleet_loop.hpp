// A fleet that is not exact, flown by a Guide: agents that really fly, channels that lose and
// delay, and a check of true positions.
//
// In a tick: agents look at their clocks, hear what has come and report; the planner hears what has
// come and guides; agents fly, instant after instant, and hear what comes meanwhile.
#pragma once

#include "scenes/missions.hpp"
#include "sim/channel.hpp"
#include "sim/fleet_options.hpp"
#include "sim/nearest_agents.hpp"
#include "sim/true_agent.hpp"
#include "sim/true_clearance.hpp"
#include "sim/true_separation.hpp"

#include <beespace/guide.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace beespace::sim {

// One agent, and what came of it. Times in seconds of the simulation.
struct FleetAgent {
  std::optional<TrueAgent> truth = {};     // none: it has not joined
  std::optional<JoinAnswer> refused = {};  // the last answer by which it could not join
  double radius_m = 0.0;
  bool weak = false;
  std::optional<double> falls_silent_s = {};
  bool silent = false;
  double tube_m = 0.0;
  std::optional<double> arrived_s = {};
  // When it was first out of its tube; when a report said so surely; when the Guide said so.
  std::optional<double> left_tube_s = {};
  std::optional<double> passed_s = {};
  std::optional<double> named_s = {};
  bool doubted = false;
  ContractReason reason = ContractReason::kNone;
};

struct FleetTally {
  std::uint64_t losses = 0;      // a pair and a tick: both in their contracts
  std::uint64_t losses_out = 0;  // of an agent that has left its tube, or is named
  std::uint64_t losses_to_intruders = 0;
  std::uint64_t clearance_losses = 0;      // an agent that keeps its contract and a tick
  std::uint64_t clearance_losses_out = 0;  // as losses_out
  std::uint64_t false_namings = 0;         // of agents that keep their contracts
  std::uint64_t named = 0;
  std::uint64_t doubted = 0;  // of agents that keep them: no false alarm, no naming
  std::uint64_t commands = 0;
  std::uint64_t uncertified = 0;       // an agent and a tick
  std::uint64_t refused_messages = 0;  // by the Guide
  std::uint64_t joins_refused = 0;
  std::uint64_t replies_taken = 0;
  std::uint64_t replies_too_late = 0;
  double largest_deviation_m = 0.0;  // of agents in their contracts
  double guiding_s = 0.0;            // of the processor's clock, in Guide::step
  std::uint64_t guided = 0;          // an agent and a tick
};

class FleetLoop {
 public:
  // All agents stand at their starts; those that do not join later have joined.
  static Result<std::unique_ptr<FleetLoop>> make(scenes::Mission mission,
                                                 const FleetOptions& options);
  FleetLoop(const FleetLoop&) = delete;
  FleetLoop& operator=(const FleetLoop&) = delete;
  ~FleetLoop() = default;

  // Flies for a tick.
  Status step();

  [[nodiscard]] double time_s() const { return seconds(tick_); }
  [[nodiscard]] std::size_t arrived() const { return arrived_; }
  [[nodiscard]] const std::vector<FleetAgent>& agents() const { return agents_; }
  [[nodiscard]] const FleetTally& tally() const { return tally_; }
  [[nodiscard]] const TrueVerdict& verdict() const { return checker_.verdict(); }
  [[nodiscard]] const Guidance& guidance() const { return guidance_; }
  [[nodiscard]] const FleetOptions& options() const { return options_; }
  [[nodiscard]] const ObstacleMap& obstacles() const { return obstacles_; }
  [[nodiscard]] const Tube& tube() const { return tube_; }
  // True flights of the last tick: of each body (intruders, then agents in the order in which they
  // joined) so many instants.
  [[nodiscard]] std::span<const Stretch> stretches() const { return stretches_; }
  [[nodiscard]] std::span<const std::size_t> joined() const { return joined_; }

 private:
  struct IntruderFlight {
    Vector3 position;
    Vector3 velocity;
  };

  FleetLoop(scenes::Mission mission, const FleetOptions& options, const Tube& tube,
            const ObstacleMap& obstacles);
  Status begin();
  [[nodiscard]] GuideOptions guide_options() const;
  void choose_agents();
  void choose_intruders();
  Status join(std::size_t index);
  Status join_more();

  void hear_and_report(std::int64_t instant);
  AgentReport report_of(std::size_t index);
  Status guide();
  void tell_intruders();
  void fall_silent();
  void fly();
  Status judge(double begins_s);
  void judge_pairs(double begins_s);
  Status judge_clearance();
  void look_at_guidance();
  void look_at_agent(const AgentGuidance& told);
  [[nodiscard]] bool is_at_fault(const FleetAgent& agent) const;

  [[nodiscard]] double seconds(Tick tick) const {
    return static_cast<double>(tick) * options_.link.period_s;
  }
  [[nodiscard]] std::int64_t instants(Tick tick) const { return tick * options_.instants; }

  scenes::Mission mission_;
  FleetOptions options_;
  Tube tube_;
  ObstacleMap obstacles_;
  scenes::RandomStream random_;
  std::optional<Guide> guide_;
  Tick tick_ = 0;
  std::vector<FleetAgent> agents_;
  std::vector<std::size_t> joined_;
  std::size_t asked_ = 0;  // agents before this one have joined or wait for another try
  std::vector<std::size_t> waiting_;
  std::vector<IntruderFlight> intruders_;
  Channel<Command> commands_;
  Channel<AgentReport> reports_;
  Channel<Acknowledgement> replies_;
  NearestAgents nearest_;
  std::vector<Vector3> towards_;
  std::vector<Stretch> stretches_;
  std::vector<double> radii_m_;
  TrueSeparation checker_;
  TrueClearance clearance_;
  Guidance guidance_;
  std::size_t arrived_ = 0;
  FleetTally tally_;
};

}  // namespace beespace::sim
