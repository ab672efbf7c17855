// What the live swarm is told by `watch` and by `replay --report events`.
#pragma once

#include "cli/command_line/command.hpp"

#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <algorithm>
#include <string>

namespace beespace::cli {

// As typed, before it is checked; empty where the default holds.
struct LiveOptions {
  std::string horizon;
  std::string leave_factor;
  std::string look_every;
};

struct LiveRequest {
  double horizon_s;
  double leave_factor;
  double look_every_s;
};

inline constexpr double kDefaultMaxAge_s = 5.0;

// No clock that is believed may make others stale.
constexpr double default_max_skew_s(double max_age_s) {
  return std::min(2.0, 0.5 * max_age_s);
}

void add_live_options(Command& command, LiveOptions& options, const char* group);

Result<LiveRequest> live_request(const char* command, const LiveOptions& options);

}  // namespace beespace::cli
