// The page of `report` and `view`, made of what they are to read.
#pragma once

#include "analysis/scene/build_page.hpp"
#include "analysis/scene/scene.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/show/report_command.hpp"
#include "cli/show/scene_loading.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

struct LoadedPage {
  std::vector<analysis::Scene> scenes;  // one, or before and after
  analysis::Page page;
  SceneTimings timings;  // until here
};

// Errors: kInvalidArgument, with the way to the help of `command`, where standard input is to be
// read twice, and where analysis::build_page refuses; those of loading.
Result<LoadedPage> load_page(const char* command, const ReportRequest& request,
                             ProgressBar& progress);

}  // namespace beespace::cli
