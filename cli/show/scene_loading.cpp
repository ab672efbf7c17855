#include "cli/show/scene_loading.hpp"

#include "analysis/scene/load_scene.hpp"
#include "cli/console/stopwatch.hpp"

#include <utility>

namespace beespace::cli {

Result<std::vector<analysis::Scene>> load_scenes(
    const std::vector<std::vector<std::string>>& inputs, const analysis::SceneRequest& request,
    ProgressBar& progress, SceneTimings& timings) {
  Stopwatch watch;
  double* part = &timings.read_s;  // what the time that passes is counted as
  const auto entered = [&](analysis::SceneStage stage) {
    *part += watch.lap();
    const bool reading = stage == analysis::SceneStage::kReading;
    part = reading ? &timings.read_s : &timings.find_s;
    progress.enter_stage(reading ? ProgressBar::kReading : "searching");
  };
  auto scenes = analysis::load_scenes(inputs, request, {&progress.reading(), entered});
  *part += watch.lap();
  return scenes;
}

Result<analysis::Scene> load_scene(const std::vector<std::string>& inputs,
                                   const analysis::SceneRequest& request, ProgressBar& progress,
                                   SceneTimings& timings) {
  auto scenes = load_scenes({inputs}, request, progress, timings);
  if (!scenes) return std::move(scenes).error();
  return std::move(scenes->front());
}

}  // namespace beespace::cli
