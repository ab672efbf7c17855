// The scenes of `beespace generate` in which bees fly: a snapshot with velocities, or a recording.
#pragma once

#include "cli/generate/generate_command.hpp"
#include "io/bytes/atomic_output.hpp"
#include "scenes/recorded_flights.hpp"

#include <beespace/mover.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::cli {

bool is_moving_scene(std::string_view scene);

struct MovingSwarm {
  std::vector<Mover> movers;                 // at time 0
  std::optional<scenes::FixTimes> recorded;  // absent: a snapshot
  std::uint64_t seed = 1;
};

// Errors: kInvalidArgument.
Result<MovingSwarm> make_moving_swarm(const GenerateRequest& request);

// Whether the format holds more than positions. Error: kInvalidArgument.
Status check_moving_format(SwarmFormat format, const std::string& scene);

// Commits the output. Errors: kWriteFailed.
Status write_moving_swarm(const MovingSwarm& swarm, SwarmFormat format, io::AtomicOutput& output);

}  // namespace beespace::cli
