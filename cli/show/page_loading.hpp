// The page of `report` and `view`, made of what they are to read.
#pragma once

#include "analysis/scene/build_page.hpp"
#include "analysis/scene/scene.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/show/scene_loading.hpp"
#include "cli/show/show_request.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct LoadedPage {
  std::vector<analysis::Scene> scenes;  // one, or before and after
  analysis::Page page;
  SceneTimings timings;  // until here
};

// `compare` is the file to show beside, or nothing. Errors: kInvalidArgument, with the way to the
// help of `command`, where standard input is to be read twice, and where analysis::build_page
// refuses; those of loading.
Result<LoadedPage> load_page(const char* command, const ShowRequest& request,
                             const std::string& compare, ProgressBar& progress);

}  // namespace beespace::cli
