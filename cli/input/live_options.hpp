// What the live swarm is told by `watch` and by `replay --report events`.
#pragma once

#include <algorithm>

namespace beespace::cli {

class Command;

struct LiveRequest {
  double horizon_s = 10.0;
  double leave_factor = 1.1;
  double look_every_s = 0.1;
};

inline constexpr double kDefaultMaxAge_s = 5.0;

// No clock that is believed may make others stale.
constexpr double default_max_skew_s(double max_age_s) {
  return std::min(2.0, 0.5 * max_age_s);
}

void add_live_options(Command& command, LiveRequest& request);

}  // namespace beespace::cli
