// Loads scenes with a progress bar, and measures how long that takes.
#pragma once

#include "analysis/scene/scene.hpp"
#include "analysis/scene/scene_request.hpp"
#include "cli/console/progress_bar.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// How long each part took, of all that is shown.
struct SceneTimings {
  double read_s = 0.0;
  double find_s = 0.0;
  double write_s = 0.0;  // making what is written, too
};

// As analysis::load_scene and analysis::load_scenes. Adds to `timings` how long it reads and finds.
Result<analysis::Scene> load_scene(const std::vector<std::string>& inputs,
                                   const analysis::SceneRequest& request, ProgressBar& progress,
                                   SceneTimings& timings);
Result<std::vector<analysis::Scene>> load_scenes(
    const std::vector<std::vector<std::string>>& inputs, const analysis::SceneRequest& request,
    ProgressBar& progress, SceneTimings& timings);

}  // namespace beespace::cli
