// A scene at a glance, for those who wait for a page or a picture of it.
#pragma once

#include "analysis/scene/scene.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/show/scene_loading.hpp"

#include <string>

namespace beespace::cli {

// The thresholds are said as the request has them, too.
void append_scene(std::string& out, const analysis::Scene& scene, const MovingRequest& request);

// Where it went, and how long it took.
void append_written(std::string& out, const std::string& output, const SceneTimings& timings);

}  // namespace beespace::cli
