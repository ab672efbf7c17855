// `beespace fleet`.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/fleet/set_beside_flown.hpp"
#include "cli/input/moving_options.hpp"

#include <optional>
#include <string>

namespace beespace::cli {

struct FleetRequest {
  MovingRequest moving;             // what was flown, and how both inputs are read
  std::string set;                  // the file of what was set
  std::string set_columns;          // of that, as of --columns
  std::optional<double> max_gap_s;  // absent: from the data
  SetOptions beside;                // where and when what was set was to be flown
  std::optional<double> max_deviation_m;
};

Command fleet_command();

Result<ExitCode> run_fleet(const FleetRequest& request);

}  // namespace beespace::cli
