// What `beespace simulate` is asked for, once its options are known to make sense.
#pragma once

#include "cli/simulate_command.hpp"
#include "cli/swarm_output.hpp"
#include "scenes/missions.hpp"
#include "sim/closed_loop.hpp"

#include <beespace/result.hpp>

#include <cstddef>
#include <cstdint>
#include <string>

namespace beespace::cli {

struct SimulateRequest {
  std::string scenario;
  std::size_t bees = 0;
  double spacing_m = 0.0;
  std::uint64_t seed = 1;
  sim::LoopOptions loop;
  std::uint64_t most_steps = 0;
  std::string output;  // empty: the recording is not written
  SwarmFormat format;
  bool json = false;
  bool fail_on_risk = false;
  bool quiet = false;

  // Whether bees change their velocities at once.
  [[nodiscard]] bool at_once() const;
};

// Errors: kInvalidThreshold, kInvalidArgument.
Result<SimulateRequest> simulate_request(const SimulateOptions& options);

// Where everybody starts and wants to go. Error: kInvalidArgument where two of these places are
// closer than the threshold.
Result<scenes::Mission> mission_of(const SimulateRequest& request);

}  // namespace beespace::cli
