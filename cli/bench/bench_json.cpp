#include "cli/bench/bench_result.hpp"
#include "io/bytes/number_text.hpp"
#include "io/json/json_text.hpp"

#include <beespace/version.hpp>

namespace beespace::cli {
namespace {

// One question by one number of threads.
void append_figure(std::string& out, const BenchFigure& figure, unsigned threads, double seconds,
                   const BenchSceneResult& scene, std::size_t points) {
  out += std::string("{\"question\": ") + io::json_string(figure.question);
  out += ", \"threads\": " + std::to_string(threads);
  out += ", \"ns_per_point\": " + io::exact(seconds * 1e9 / static_cast<double>(points));
  out += ", \"floors\": " + io::exact(seconds / scene.read_floor_s) + '}';
}

void append_scene(std::string& out, const BenchSceneResult& scene, const BenchRun& run) {
  out += "{\"scene\": " + io::json_string(scene.scene->name);
  out += ", \"threshold_m\": " + io::exact(scene.scene->threshold_m);
  out += ", \"floor_ns_per_point\": " +
         io::exact(scene.read_floor_s * 1e9 / static_cast<double>(run.points));
  out += ", \"results\": [";
  const char* separator = "\n      ";
  for (const BenchFigure& figure : scene.figures) {
    if (figure.one_thread_s) {
      append_figure(out += separator, figure, 1, *figure.one_thread_s, scene, run.points);
      separator = ",\n      ";
    }
    if (figure.all_threads_s) {
      append_figure(out += separator, figure, run.threads, *figure.all_threads_s, scene,
                    run.points);
      separator = ",\n      ";
    }
  }
  out += "]}";
}

}  // namespace

std::string bench_json(const BenchRun& run, const std::vector<BenchSceneResult>& results) {
  std::string out = "{\n  \"version\": " + io::json_string(version());
  out += ",\n  \"points\": " + std::to_string(run.points);
  out += ",\n  \"threads\": " + std::to_string(run.threads);
  out += ",\n  \"scenes\": [";
  for (std::size_t i = 0; i < results.size(); ++i) {
    out += i == 0 ? "\n    " : ",\n    ";
    append_scene(out, results[i], run);
  }
  return out + "]\n}\n";
}

}  // namespace beespace::cli
