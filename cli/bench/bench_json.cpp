#include "cli/bench/bench_result.hpp"
#include "io/json/json_writer.hpp"

#include <beespace/version.hpp>

namespace beespace::cli {
namespace {

double ns_per_point(double seconds, const BenchRun& run) {
  return seconds * 1e9 / static_cast<double>(run.points);
}

void write_figures(io::JsonWriter& json, const BenchSceneResult& scene, const BenchRun& run) {
  const auto write = [&](const BenchFigure& figure, unsigned threads,
                         const std::optional<double>& seconds) {
    if (!seconds) return;
    json.begin_object().member("question", figure.question).member("threads", threads);
    json.member("ns_per_point", ns_per_point(*seconds, run));
    json.member("floors", *seconds / scene.read_floor_s);
    json.end();
  };
  for (const BenchFigure& figure : scene.figures) {
    write(figure, 1, figure.one_thread_s);
    write(figure, run.threads, figure.all_threads_s);
  }
}

}  // namespace

std::string bench_json(const BenchRun& run, const std::vector<BenchSceneResult>& results) {
  std::string out;
  io::JsonWriter json(out);
  json.begin_object(io::JsonLayout::kLines);
  json.member("version", version()).member("points", run.points).member("threads", run.threads);
  json.begin_array("scenes", io::JsonLayout::kRows);
  for (const BenchSceneResult& scene : results) {
    json.begin_object();
    json.member("scene", scene.scene->name).member("threshold_m", scene.scene->threshold_m);
    json.member("floor_ns_per_point", ns_per_point(scene.read_floor_s, run));
    json.begin_array("results", io::JsonLayout::kRows);
    write_figures(json, scene, run);
    json.end().end();
  }
  json.end().end();
  return out + '\n';
}

}  // namespace beespace::cli
