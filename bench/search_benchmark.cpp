// How fast the search is, as a multiple of reading its input.
//
// The floor is a plain scalar loop that sums all input doubles in order. Every search prints
// `floors`: its time divided by the floor's on the same points in the same run, so that figures
// from noisy or different machines can be compared. Answers are checked before anything is timed.
#include <beespace/beespace.hpp>

#include "scenes/swarm_scenes.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace {

using beespace::Point;
using beespace::PointId;

struct Scene {
  const char* name;
  std::size_t size;
  std::function<std::vector<Point>(std::size_t)> make;
  double threshold_m;
  double bar;  // floors: at most, on one core; 0 where nothing is promised yet

  [[nodiscard]] const std::vector<Point>& points() const {
    if (points_.empty()) points_ = make(size);
    return points_;
  }

 private:
  mutable std::vector<Point> points_ = {};

 public:
  Scene(const char* scene_name, std::size_t scene_size,
        std::function<std::vector<Point>(std::size_t)> maker, double threshold, double most_floors)
      : name(scene_name),
        size(scene_size),
        make(std::move(maker)),
        threshold_m(threshold),
        bar(most_floors) {}
};

auto box(double x, double y, double z) {
  return [=](std::size_t size) { return beespace::scenes::uniform_box(size, {x, y, z}, 1); };
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {
      {"uniform_2_neighbours", 1'000'000, box(12'800, 12'800, 12'800), 100.0, 40.0},
      {"dense_1150_neighbours", 1'000'000, box(3'300, 2'300, 480), 100.0, 6.0},
      {"dense_1_neighbour", 1'000'000, box(3'300, 2'300, 480), 10.0, 0.0},
      {"sparse_0.02_neighbours", 150'000, box(66'000, 46'000, 9'600), 100.0, 32.0},
      {"clusters", 1'000'000,
       [](std::size_t size) {
         return beespace::scenes::gaussian_clusters(size, 1'000, 200.0, 100'000.0, 1);
       },
       20.0, 0.0},
  };
  return all;
}

double sum_in_order(const std::vector<Point>& points) {
  const double* values = &points.front().x;
  double sum = 0.0;
  for (std::size_t i = 0; i < 3 * points.size(); ++i) sum += values[i];
  return sum;
}

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double floor_seconds(const std::vector<Point>& points) {
  constexpr int kWarmUps = 20;
  std::vector<double> times;
  for (int run = -kWarmUps; run < 31; ++run) {
    const double start = cpu_seconds();
    double sum = sum_in_order(points);
    benchmark::DoNotOptimize(sum);
    if (run >= 0) times.push_back(cpu_seconds() - start);
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

// A sample of the points against all others, by brute force.
void check_answer(const Scene& scene) {
  const std::vector<Point>& points = scene.points();
  const std::vector<PointId> found = *beespace::find_at_risk(points, {scene.threshold_m});
  const std::size_t step = points.size() / 300;
  for (std::size_t i = 0; i < points.size(); i += step) {
    bool at_risk = false;
    for (std::size_t j = 0; j < points.size() && !at_risk; ++j) {
      at_risk = i != j && beespace::distance(points[i], points[j]) < scene.threshold_m;
    }
    if (std::binary_search(found.begin(), found.end(), static_cast<PointId>(i)) == at_risk)
      continue;
    std::fprintf(stderr, "%s: wrong answer for point %zu\n", scene.name, i);
    std::exit(1);
  }
}

void report(benchmark::State& state, const Scene& scene, double floor) {
  const auto size = static_cast<double>(scene.size);
  state.counters["floors"] = benchmark::Counter(
      floor, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["per_point"] = benchmark::Counter(
      size, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  if (scene.bar > 0.0) state.counters["bar"] = scene.bar;
}

void read_floor(benchmark::State& state, const Scene& scene) {
  const std::vector<Point>& points = scene.points();
  for (auto _ : state) {
    double sum = sum_in_order(points);
    benchmark::DoNotOptimize(sum);
  }
  report(state, scene, floor_seconds(points));
}

void at_risk(benchmark::State& state, const Scene& scene) {
  const std::vector<Point>& points = scene.points();
  const auto threads = static_cast<unsigned>(state.range(0));
  const double floor = floor_seconds(points);
  for (auto _ : state) {
    auto found = beespace::find_at_risk(points, {scene.threshold_m, false, threads});
    benchmark::DoNotOptimize(found);
  }
  report(state, scene, floor);
}

void closest_pair(benchmark::State& state, const Scene& scene) {
  const std::vector<Point>& points = scene.points();
  const double floor = floor_seconds(points);
  for (auto _ : state) {
    auto found = beespace::find_closest_pair(points);
    benchmark::DoNotOptimize(found);
  }
  report(state, scene, floor);
}

void nearest(benchmark::State& state, const Scene& scene) {
  const std::vector<Point>& points = scene.points();
  const double floor = floor_seconds(points);
  for (auto _ : state) {
    auto found = beespace::find_nearest_within(points, {scene.threshold_m});
    benchmark::DoNotOptimize(found);
  }
  report(state, scene, floor);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const Scene& scene : scenes()) {
    const std::string name = scene.name;
    benchmark::RegisterBenchmark(("read_floor/" + name).c_str(), read_floor, scene);
    benchmark::RegisterBenchmark(("at_risk/" + name).c_str(), at_risk, scene)->Arg(1);
    benchmark::RegisterBenchmark(("at_risk/" + name).c_str(), at_risk, scene)
        ->Arg(2)
        ->UseRealTime();
    benchmark::RegisterBenchmark(("closest_pair/" + name).c_str(), closest_pair, scene);
    benchmark::RegisterBenchmark(("nearest/" + name).c_str(), nearest, scene)->Iterations(1);
  }
  for (const Scene& scene : scenes()) check_answer(scene);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
