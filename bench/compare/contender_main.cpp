// Runs one contender on one question about one file of points, in a process of its own, and prints
// the result as a line of JSON.
//
//   compare_NAME describe [VARIANT]
//   compare_NAME ask QUESTION POINTS THRESHOLD_M REFERENCE [VARIANT]
//   compare_NAME keep QUESTION POINTS THRESHOLD_M REFERENCE [VARIANT]
//
// `ask` compares the first answer with the reference file, `keep` writes that file. Only then is
// anything timed: each run builds and answers from nothing. A pass of the read floor follows each,
// so that it finds the points as the next run would: what the run used itself has evicted them from
// the caches.
#include "bench/compare/contender.hpp"
#include "bench/compare/cost_meters.hpp"
#include "bench/compare/fail.hpp"
#include "bench/compare/machine_floors.hpp"
#include "bench/compare/point_file.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace beespace::compare {
namespace {

constexpr const char* kArithmeticNames[] = {"exact", "float64", "float32", "approximate"};

void print_description(const Description& description) {
  std::string questions;
  for (const Question question : description.questions) {
    if (!questions.empty()) questions += ", ";
    questions += '"' + std::string(name_of(question)) + '"';
  }
  std::printf(
      "{\"name\": \"%s\", \"version\": \"%s\", \"arithmetic\": \"%s\", \"use\": \"%s\", "
      "\"questions\": [%s]}\n",
      description.name.c_str(), description.version.c_str(),
      kArithmeticNames[static_cast<std::size_t>(description.arithmetic)], description.use.c_str(),
      questions.c_str());
}

// The first run warms up and is checked. Short runs are repeated more often, since they vary more;
// slow contenders are not repeated.
int timed_runs(double first_run_ms) {
  if (first_run_ms < 10.0) return 31;
  if (first_run_ms < 100.0) return 9;
  if (first_run_ms < 1'000.0) return 5;
  if (first_run_ms < 4'000.0) return 3;
  return first_run_ms < 8'000.0 ? 1 : 0;
}

// A contender that is too slow to be repeated still gets passes of the read floor.
constexpr std::size_t kLeastReadPasses = 3;

struct Times {
  std::vector<double> cpu_ms;
  std::vector<double> wall_ms;

  void add(const Stopwatch& watch) {
    cpu_ms.push_back(watch.cpu_ms());
    wall_ms.push_back(watch.wall_ms());
  }
};

std::string json_list(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) {
    char number[32];
    std::snprintf(number, sizeof number, "%s%.4f", text.empty() ? "" : ", ", value);
    text += number;
  }
  return "[" + text + "]";
}

struct Task {
  bool keeps = false;
  Question question = Question::kAtRisk;
  std::vector<Point> points;
  double threshold_m = 0.0;
  std::string reference;
};

void run(Contender& contender, const Task& task) {
  Times times;
  const MemoryMeter memory;
  const Stopwatch first;
  Answer answer = contender.answer(task.question, task.points, task.threshold_m);
  times.add(first);
  const double peak_mb = memory.peak_mb();

  const std::uint64_t found = size_of(answer, task.question);
  Difference wrong;
  if (task.keeps) {
    keep_reference(task.reference, task.question, answer);
  } else {
    wrong = difference_from_reference(task.reference, task.question, task.points, answer);
  }
  contender.take_back(std::exchange(answer, {}));

  const int runs = timed_runs(times.cpu_ms.front());
  if (runs > 0) times = {};
  std::vector<double> read_passes_ms;
  for (int i = 0; i < runs; ++i) {
    const Stopwatch watch;
    answer = contender.answer(task.question, task.points, task.threshold_m);
    times.add(watch);
    contender.take_back(std::exchange(answer, {}));
    read_passes_ms.push_back(read_pass_ms(task.points));
  }
  while (read_passes_ms.size() < kLeastReadPasses) {
    read_passes_ms.push_back(read_pass_ms(task.points));
  }
  std::printf(
      "{\"points\": %zu, \"threshold_m\": %.17g, \"found\": %llu, \"spurious\": %llu, "
      "\"missed\": %llu, \"cpu_ms\": %s, \"wall_ms\": %s, \"peak_mb\": %.1f, "
      "\"read_floor_ms\": %.4f, \"warm_read_floor_ms\": %.4f}\n",
      task.points.size(), task.threshold_m, static_cast<unsigned long long>(found),
      static_cast<unsigned long long>(wrong.spurious),
      static_cast<unsigned long long>(wrong.missed), json_list(times.cpu_ms).c_str(),
      json_list(times.wall_ms).c_str(), peak_mb, median(std::move(read_passes_ms)),
      warm_read_floor_ms(task.points));
}

}  // namespace
}  // namespace beespace::compare

int main(int argc, char** argv) {
  using namespace beespace::compare;
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const std::string mode = arguments.empty() ? "" : arguments[0];
  const bool describes = mode == "describe";
  const std::size_t variant = describes ? 1 : 5;
  if (!(describes || mode == "ask" || mode == "keep") || arguments.size() < variant) {
    fail("usage: describe [VARIANT] | ask|keep QUESTION POINTS THRESHOLD_M REFERENCE [VARIANT]");
  }
  const auto contender =
      make_contender(arguments.size() > variant ? arguments[variant] : std::string());
  if (describes) {
    print_description(contender->description());
    return 0;
  }
  const auto question = question_named(arguments[1]);
  if (!question) fail("no such question: " + arguments[1]);
  run(*contender, {mode == "keep", *question, read_points(arguments[2]),
                   std::atof(arguments[3].c_str()), arguments[4]});
  return 0;
}
