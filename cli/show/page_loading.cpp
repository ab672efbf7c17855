#include "cli/show/page_loading.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/console/stopwatch.hpp"
#include "cli/input/obstacle_file.hpp"

#include <beespace/obstacle.hpp>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace beespace::cli {
namespace {

// What stands in the way, in the metres of the swarms.
Status draw(const ObstacleMap& obstacles, std::vector<analysis::Scene>& scenes) {
  for (analysis::Scene& scene : scenes) {
    report::SwarmFacts& swarm = analysis::swarm_of(scene);
    if (swarm.origin) {
      return Error{ErrorCode::kUnknownFrame,
                   "obstacles are in metres, and '" + swarm.title +
                       "' is in degrees; give it in metres, or leave --obstacles out",
                   {}};
    }
    swarm.obstacles.assign(obstacles.obstacles().begin(), obstacles.obstacles().end());
    swarm.notes.emplace_back(
        "obstacles are drawn, and nothing is said of them: whether bees keep clear, 'beespace "
        "verify --obstacles' says");
  }
  return std::monostate{};
}

}  // namespace

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
  std::optional<ObstacleMap> obstacles;
  if (!request.obstacles.empty()) {
    auto map = load_obstacle_map(request.obstacles);
    if (!map) return std::move(map).error();
    obstacles = *std::move(map);
  }
  analysis::SceneRequest scene = scene_request(request.show);
  scene.fleet_log = request.fleet_log;
  LoadedPage loaded;
  auto scenes = load_scenes(all, scene, progress, loaded.timings);
  if (!scenes) return std::move(scenes).error();
  loaded.scenes = *std::move(scenes);
  if (obstacles) {
    if (Status good = draw(*obstacles, loaded.scenes); !good) return good.error();
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
