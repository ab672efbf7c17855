// What a fleet of a simulation is told, what it really is, and what goes wrong.
#pragma once

#include "sim/channel.hpp"
#include "sim/true_agent.hpp"

#include <beespace/advise.hpp>
#include <beespace/fleet.hpp>
#include <beespace/result.hpp>
#include <beespace/separation.hpp>

#include <cstdint>
#include <vector>

namespace beespace::sim {

// Faults of the planner's or the agents' program, put in on purpose: a test of the harness is that
// it finds each of them.
struct LoopFaults {
  bool no_tubes = false;          // what is kept free lacks the tubes of both
  bool figures_withheld = false;  // the Guide is told that nothing deviates
  bool reports_ignored = false;   // reports say that each agent is where it should be
  bool floors_ticks = false;      // ticks are floors of times
};

// Latencies of channels are in ticks here.
struct FleetOptions {
  double threshold_m = 5.0;
  Separation separation = {};
  FlightLimits limits{10.0, 5.0};  // what motors can do, reserves included
  LinkFigures link{.period_s = 0.1, .command_delay = 2, .longest_loss = 0};
  LoopPlace place = LoopPlace::kOnboard;
  double correction_mps2 = 1.0;  // reserves
  double correction_mps = 1.0;

  int instants = 5;     // in a tick
  int loop_period = 1;  // on board, in instants
  int loop_delay = 1;   // the same
  // Where all is ideal no tube is needed, and none is kept.
  AgentErrors errors = {};
  ChannelErrors commands = {};
  ChannelErrors reports = {};  // and acknowledgements

  double weak_share = 0.0;  // of the agents: which have this strength
  double weak_strength = 0.5;
  double silent_share = 0.0;  // of the agents: which fall silent, at a time between these
  double silent_from_s = 2.0;
  double silent_to_s = 10.0;
  bool silent_are_told = false;  // they do not fall silent, but are told to stop at that time
  double joins_per_s = 0.0;      // above zero: so many join, the first of them at the start
  std::size_t intruders = 0;
  double intruder_speed_mps = 8.0;
  double intruder_error_m = 0.0;
  double least_radius_m = 0.0;
  double most_radius_m = 0.0;
  std::vector<Fence> fences = {};
  double clearance_m = 1.0;
  bool planar = false;

  double arrived_m = 1.0;
  std::uint64_t seed = 1;
  unsigned threads = 1;
  LoopFaults faults = {};
};

// What an operator would state of such a fleet: bounds of all that is wrong with it.
FleetFigures stated_figures(const FleetOptions& options);

// The tube that follows.
Result<Tube> stated_tube(const FleetOptions& options);

// The same fleet with nothing wrong, planned with the same limits and threshold_m + 2 `wider_m`.
FleetOptions ideal_of(const FleetOptions& options, double wider_m);

}  // namespace beespace::sim
