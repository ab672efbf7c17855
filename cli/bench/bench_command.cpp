#include "cli/bench/bench_command.hpp"

#include "cli/bench/bench_check.hpp"
#include "cli/bench/bench_question.hpp"
#include "cli/bench/bench_result.hpp"
#include "cli/bench/bench_timing.hpp"
#include "cli/console/progress_bar.hpp"
#include "cli/console/standard_output.hpp"
#include "cli/console/terminal.hpp"
#include "io/bytes/number_text.hpp"

#include <beespace/crew.hpp>

namespace beespace::cli {
namespace {

// All answers about the scene, by one engine.
Status ask_everything(Engine& engine, const BenchScene& scene, const std::vector<Point>& points,
                      BenchAnswers& answers) {
  for (const BenchQuestion& question : bench_questions()) {
    if (!is_asked(question, scene)) continue;
    Status asked = question.ask(engine, points, scene.threshold_m, answers);
    if (!asked) return asked;
  }
  return Status(std::monostate());
}

// The two engines: of one thread, and of all.
struct Engines {
  explicit Engines(unsigned threads) : crew(threads), one(alone), all(crew) {}

  Crew alone;
  ThreadCrew crew;
  Engine one;
  Engine all;
};

Status check(Engines& engines, const BenchScene& scene, const std::vector<Point>& points) {
  for (Engine* engine : {&engines.one, &engines.all}) {
    BenchAnswers answers;
    Status asked = ask_everything(*engine, scene, points, answers);
    if (!asked) return asked;
    const std::string wrong = disagreement(points, scene, answers);
    if (wrong.empty()) continue;
    return Error{ErrorCode::kCorrupt,
                 std::string("a wrong answer in the scene '") + scene.name + "': " + wrong +
                     "; this is a defect of beespace, please report it",
                 {}};
  }
  return Status(std::monostate());
}

Result<BenchSceneResult> measure(Engines& engines, const BenchScene& scene, std::size_t count) {
  const std::vector<Point> points = scene.make(count);
  const Status right = check(engines, scene, points);
  if (!right) return right.error();
  BenchSceneResult result{&scene, 0.0, {}};
  ReadFloor floor(points);
  BenchAnswers answers;
  for (const BenchQuestion& question : bench_questions()) {
    BenchFigure figure{question.name, {}, {}};
    const auto seconds = [&](Engine& engine) {
      const auto ask = [&] {
        // The same call succeeded a moment ago.
        static_cast<void>(question.ask(engine, points, scene.threshold_m, answers));
      };
      return median_seconds(ask, floor);
    };
    if (is_asked(question, scene)) {
      figure.one_thread_s = seconds(engines.one);
      if (engines.crew.size() > 1) figure.all_threads_s = seconds(engines.all);
    }
    result.figures.push_back(figure);
  }
  result.read_floor_s = floor.median_seconds();
  return result;
}

}  // namespace

Result<ExitCode> run_bench(const BenchRequest& request) {
  Engines engines(static_cast<unsigned>(request.threads));
  const BenchRun run{request.points, engines.crew.size()};

  const bool is_table = !request.json;
  ExitCode written = is_table ? print(bench_head(run)) : ExitCode::kFine;
  std::vector<BenchSceneResult> results;
  for (const BenchScene& scene : bench_scenes()) {
    if (written != ExitCode::kFine) return written;
    ProgressBar progress(!request.quiet);
    progress.enter_stage(scene.name);
    auto result = measure(engines, scene, run.points);
    progress.finish();
    if (!result) return std::move(result).error();
    if (is_table) written = print(bench_rows(run, *result));
    results.push_back(*std::move(result));
  }
  if (request.json) written = print(bench_json(run, results));
  if (written == ExitCode::kFine && is_table && !request.quiet) say(bench_foot());
  return written;
}

}  // namespace beespace::cli
