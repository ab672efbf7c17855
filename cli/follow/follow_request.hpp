// What `beespace follow` is asked for.
#pragma once

#include "cli/console/exit_code.hpp"

#include <beespace/advise.hpp>
#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>

namespace beespace::cli {

struct FollowRequest {
  std::string agent;
  FlightLimits planned;
  double period_s = 0.1;
  double radius_m = 0.0;
  std::optional<Point> start;  // where it joins
  std::string store;           // a file; empty: nothing is remembered
  bool ticks_from_input = false;
  bool simulated = false;  // its reports are its nominal positions
  bool setpoints = false;
  std::uint64_t report_every = 1;
  bool quiet = false;
};

Result<ExitCode> run_follow(const FollowRequest& request);

}  // namespace beespace::cli
