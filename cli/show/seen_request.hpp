// What pages, pictures and map files are asked for: the separation that counts, and how to read.
#pragma once

#include "cli/input/moving_options.hpp"

#include <beespace/geodesy.hpp>

#include <optional>

namespace beespace::cli {

struct SeenRequest {
  MovingRequest moving;
  std::optional<double> max_gap_s = {};  // absent: from the data
  double tolerance_m = 0.001;
  // Where east, north and up of geographic positions are 0; otherwise below the middle of all.
  std::optional<GeographicPosition> origin = {};
};

// FILES and what --help says of reading and of the separation.
void add_seen_options(Command& command, SeenRequest& request);
// --json of what has no answer in it.
void add_error_json_option(Command& command, MovingRequest& moving);
void add_seen_risk_option(Command& command, MovingRequest& moving);

}  // namespace beespace::cli
