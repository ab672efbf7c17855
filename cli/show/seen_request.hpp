// What pages, pictures and map files are asked for: the separation that counts, and how to read.
#pragma once

#include "cli/command_line/command.hpp"
#include "cli/input/moving_options.hpp"

#include <beespace/geodesy.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <string>

namespace beespace::cli {

// As typed, before it is checked.
struct SeenOptions {
  MovingOptions moving;  // but --max-results and --csv
  std::string max_gap;
  std::string tolerance = "0.001";
};

struct SeenRequest {
  MovingRequest moving;
  std::optional<double> max_gap_s = {};  // absent: from the data
  double tolerance_m = 0.001;
  // Where east, north and up of geographic positions are 0; otherwise below the middle of all.
  std::optional<GeographicPosition> origin = {};
};

// FILES and what --help says of reading and of the separation.
void add_seen_options(Command& command, SeenOptions& options);

Result<SeenRequest> seen_request(const char* command, const SeenOptions& options);

}  // namespace beespace::cli
