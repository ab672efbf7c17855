// What `beespace watch` is asked for.
#pragma once

#include "analysis/live/live_feed.hpp"
#include "cli/console/exit_code.hpp"
#include "cli/input/separation.hpp"
#include "cli/watch/live_advice.hpp"
#include "io/recording/recording_options.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/result.hpp>
#include <beespace/swarm.hpp>

#include <optional>
#include <string>

namespace beespace::cli {

struct WatchRequest {
  std::string input;
  io::RecordingOptions lines;
  SwarmOptions swarm{.threshold_m = 100.0};
  // Those of `swarm` as typed, and what stands for both.
  std::optional<io::StatedLength> threshold;
  std::optional<io::StatedLength> vertical;
  const UsualSeparation* separation = nullptr;
  analysis::LiveTimes times = {};
  bool by_arrival = false;                  // the time of a report is when it came
  std::optional<double> speed;              // times that of the clock of the reports
  std::optional<double> rate;               // reports a second
  std::optional<LiveAdviceRequest> advice;  // where it is wanted
  bool fail_on_risk = false;
  bool quiet = false;
};

Result<ExitCode> run_watch(const WatchRequest& request);

}  // namespace beespace::cli
