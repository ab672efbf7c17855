#include "cli/show/page_loading.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/show/shown_obstacles.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {

Result<LoadedPage> load_page(const char* command, const ReportRequest& request,
                             ProgressBar& progress) {
  if (const Status has = analysis::check_has_page(); !has) {
    return usage_error(command, has.error().message);
  }
  const std::vector<std::string>& inputs = request.show.moving.inputs;
  std::vector<std::vector<std::string>> all{inputs};
  if (!request.compare.empty()) all.push_back({request.compare});
  std::vector<std::string> read = inputs;
  read.insert(read.end(), {request.compare, request.fleet_log, request.obstacles});
  if (std::count(read.begin(), read.end(), "-") > 1) {
    return usage_error(command, "standard input can be read once");
  }
  const auto obstacles = load_shown_obstacles(request.obstacles);
  if (!obstacles) return obstacles.error();
  analysis::SceneRequest scene = scene_request(request.show);
  scene.fleet_log = request.fleet_log;
  LoadedPage loaded;
  auto scenes = load_scenes(all, scene, progress, loaded.timings);
  if (!scenes) return std::move(scenes).error();
  loaded.scenes = *std::move(scenes);
  for (analysis::Scene& of : loaded.scenes) {
    if (Status good = show_obstacles(*obstacles, of); !good) return good.error();
  }
  progress.enter_stage("writing");
  Stopwatch watch;
  auto page = analysis::build_page(loaded.scenes);
  if (!page) return usage_error(command, page.error().message);
  loaded.page = *std::move(page);
  loaded.timings.write_s = watch.lap();
  return loaded;
}

}  // namespace beespace::cli
