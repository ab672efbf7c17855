// A scene at a glance, for those who wait for a page or a picture of it.
#pragma once

#include "analysis/scene/scene.hpp"
#include "cli/input/moving_options.hpp"
#include "cli/show/scene_loading.hpp"

#include <string>
#include <vector>

namespace beespace::cli {

// The thresholds are said as the request has them, too.
void append_scene(std::string& out, const analysis::Scene& scene, const MovingRequest& request);

// Where it went, and how long it took.
void append_written(std::string& out, const std::string& output, const SceneTimings& timings);

// The address of a page with a scene, where it shows the worst pair; nothing where there is none,
// or two scenes are compared.
void append_worst_link(std::string& out, const std::string& address,
                       const std::vector<analysis::Scene>& scenes);

// The address of a file, for browsers.
std::string file_address(const std::string& path);

}  // namespace beespace::cli
