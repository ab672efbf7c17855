// What `beespace simulate` is asked for, once its options are known to make sense.
#pragma once

#include "cli/output/swarm_output.hpp"
#include "cli/simulate/simulate_command.hpp"
#include "sim/closed_loop.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::cli {

struct SimulateRequest {
  std::string scenario;
  bool from_file = false;  // the scenario is a file of starts and goals, or "-"
  std::size_t bees = 0;    // of a file not known yet
  double spacing_m = 0.0;
  std::uint64_t seed = 1;
  sim::LoopOptions loop;  // the limits are those of who has none of its own
  bool speed_given = false;
  bool acceleration_given = false;
  std::string obstacles;  // a file, or "-"; empty: none but the scenario's
  std::uint64_t most_steps = 0;
  std::string output;  // empty: the recording is not written
  SwarmFormat format;
  bool json = false;
  bool fail_on_risk = false;
  bool quiet = false;
};

// Rounding may take a little from a distance: who begins at exactly the threshold would lose it.
inline constexpr double kRoom = 1.0 + 1e-6;

// Errors: kInvalidThreshold, kInvalidArgument.
Result<SimulateRequest> simulate_request(const SimulateOptions& options);

// kInvalidArgument, with the way to the help of simulate.
Error simulate_error(std::string message);

}  // namespace beespace::cli
