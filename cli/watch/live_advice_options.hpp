// What `watch` is told about advice.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/watch/live_advice.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string>

namespace beespace::cli {

// As typed, before it is checked; empty where the default holds.
struct LiveAdviceOptions {
  bool wanted = false;
  std::string max_speed;
  std::string max_acceleration;
  std::string uncertainty;
  std::string step;
};

void add_live_advice_options(Command& command, LiveAdviceOptions& options, const char* group);

// How the swarm is looked at beside.
struct LiveLooks {
  double threshold_m;
  bool vertical;
  double look_every_s;
  double max_age_s;
  unsigned threads;
};

// Nothing where no advice is wanted. Errors: kInvalidArgument, also for what makes no sense without
// advice, or with it.
Result<std::optional<LiveAdviceRequest>> live_advice_request(const char* command,
                                                             const LiveAdviceOptions& options,
                                                             const LiveLooks& looks);

}  // namespace beespace::cli
