// What `beespace simulate` is asked for.
#pragma once

#include "cli/console/exit_code.hpp"
#include "cli/output/swarm_output.hpp"
#include "sim/closed_loop.hpp"
#include "sim/fleet_options.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::cli {

struct SimulateRequest {
  std::string scenario;
  bool from_file = false;   // the scenario is a file of starts and goals, or "-"
  std::size_t bees = 1000;  // of a file not known yet
  double spacing_m = 0.0;
  std::uint64_t seed = 1;
  // The limits are those of each bee that has none of its own.
  sim::LoopOptions loop{.limits = {10.0, 5.0},
                        .advice = {.threshold_m = 5.0, .clearance_m = 1.0, .threads = 0}};
  bool speed_given = false;
  bool acceleration_given = false;
  std::string obstacles;  // a file, or "-"; empty: none but the scenario's
  std::uint64_t most_steps = 1000;
  std::string output;  // empty: the recording is not written
  SwarmFormat format;
  // Flown by commands, its truth apart; where it is not, the rest is not used.
  bool has_fleet = false;
  sim::FleetOptions fleet;
  double noise_m = 0.05;
  std::uint64_t latency = 0;
  std::uint64_t longest_loss = 8;
  std::uint64_t command_delay = 2;
  std::uint64_t intruders = 0;
  std::string nominal;  // empty: the nominal flight is not written
  SwarmFormat nominal_format;
  std::string fleet_log;  // empty: what the planner says is not written
  bool json = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

// Rounding may take a little from a distance: who begins at exactly the threshold would lose it.
inline constexpr double kRoom = 1.0 + 1e-6;

Result<ExitCode> run_simulate(const SimulateRequest& request);

// kInvalidArgument, with the way to the help of simulate.
Error simulate_error(std::string message);

}  // namespace beespace::cli
