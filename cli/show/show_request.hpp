// What `report`, `plot`, `export` and `view` are all asked for.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "cli/input/moving_options.hpp"

#include <optional>

namespace beespace::cli {

struct ShowRequest {
  MovingRequest moving;
  std::optional<double> max_gap_s = {};  // absent: from the data
  double tolerance_m = 0.001;
  std::optional<double> horizon_s = {};  // absent: as usual of what it is of
};

// What it says of the scene itself.
analysis::SceneRequest scene_request(const ShowRequest& request);

// FILES and what --help says of reading and of the separation.
void add_scene_options(Command& command, ShowRequest& request);
// --json of what has no answer in it.
void add_error_json_option(Command& command, MovingRequest& moving);
void add_scene_risk_option(Command& command, MovingRequest& moving);

}  // namespace beespace::cli
