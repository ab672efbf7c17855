// What `report`, `plot`, `export` and `view` are all asked for.
#pragma once

#include "analysis/scene/scene_request.hpp"
#include "cli/command_line/command.hpp"
#include "cli/input/moving_options.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// As typed, before it is checked.
struct SceneOptions {
  MovingOptions moving;  // but --max-results and --csv
  std::string max_gap;
  std::string tolerance = "0.001";
};

// Checked: what is shown, and where it goes.
struct ShowRequest {
  std::vector<std::string> inputs;
  analysis::SceneRequest scene;
  std::string output;
  bool fail_on_risk = false;
  bool quiet = false;
};

// FILES and what --help says of reading and of the separation.
void add_scene_options(Command& command, SceneOptions& options);

Result<ShowRequest> show_request(const char* command, const SceneOptions& options);

}  // namespace beespace::cli
