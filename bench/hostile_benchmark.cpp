// How fast the searches are on adversarial inputs: all points in one cell, on a line, at one place,
// in a clump beside a far outlier, closer together than the threshold, in a plane, on a lattice at
// the threshold itself.
//
// Every figure is also given per point and, where pairs are the answer, per pair: these must not
// grow with the number of points. Pairs are asked for in swarms small enough to write them down, of
// three sizes. Answers are checked before anything is timed.
#include <beespace/beespace.hpp>

#include "scenes/swarm_scenes.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <numeric>
#include <span>
#include <string>
#include <vector>

namespace {

using beespace::Engine;
using beespace::Point;

constexpr std::size_t kMany = 1'000'000;
constexpr std::int64_t kFew = 5'000;  // all pairs of four times as many are 1.6 GB

struct Scene {
  std::string name;
  std::function<std::vector<Point>(std::size_t)> make;
  double threshold_m;
};

std::vector<Point> box(std::size_t size, double x, double y, double z) {
  return beespace::scenes::uniform_box(size, {x, y, z}, 1);
}

// Half a threshold wide, and one point `away` from it.
Scene clump_and_outlier(const char* name, double away) {
  return {name,
          [away](std::size_t size) {
            std::vector<Point> points = box(size, 0.5, 0.5, 0.5);
            points.back().x = away;
            return points;
          },
          1.0};
}

std::vector<Point> thousand_places(std::size_t size) {
  const std::vector<Point> places = box(1000, 1000.0, 1000.0, 1000.0);
  std::vector<Point> points(size);
  for (std::size_t i = 0; i < size; ++i) points[i] = places[i * 7919 % places.size()];
  return points;
}

// With as many neighbours for any size: the box grows with it.
std::vector<Point> evenly(std::size_t size, double side_of_many, std::size_t axes) {
  const double side =
      side_of_many * std::pow(static_cast<double>(size) / static_cast<double>(kMany),
                              1.0 / static_cast<double>(axes));
  return box(size, side, axes > 1 ? side : 0.0, axes > 2 ? side : 0.0);
}

std::vector<Point> lattice(std::size_t size) {
  const auto side = static_cast<std::size_t>(std::ceil(std::cbrt(static_cast<double>(size))));
  std::vector<Point> points(size);
  for (std::size_t i = 0; i < size; ++i) {
    points[i] = {7.0 * static_cast<double>(i % side), 7.0 * static_cast<double>(i / side % side),
                 7.0 * static_cast<double>(i / (side * side))};
  }
  return points;
}

const std::vector<Scene>& scenes() {
  static const std::vector<Scene> all = {
      {"one_cell", [](std::size_t size) { return box(size, 50.0, 50.0, 50.0); }, 100.0},
      {"line", [](std::size_t size) { return evenly(size, 1'000'000.0, 1); }, 1.0},
      {"crowded_line", [](std::size_t size) { return box(size, 3'000.0, 0.0, 0.0); }, 10.0},
      {"one_place",
       [](std::size_t size) {
         return std::vector<Point>(size, {1, 2, 3});
       },
       1.0},
      {"thousand_places", thousand_places, 100.0},
      clump_and_outlier("outlier_1e3", 1e3),
      clump_and_outlier("outlier_1e6", 1e6),
      clump_and_outlier("outlier_1e9", 1e9),
      clump_and_outlier("outlier_1e12", 1e12),
      {"threshold_above_box", [](std::size_t size) { return box(size, 3'300, 2'300, 480); }, 1e4},
      {"plane", [](std::size_t size) { return evenly(size, 12'500.0, 2); }, 10.0},
      {"space", [](std::size_t size) { return evenly(size, 12'800.0, 3); }, 100.0},
      {"lattice_at_threshold", lattice, 7.0},
  };
  return all;
}

[[noreturn]] void fail(const Scene& scene, const char* question) {
  std::fprintf(stderr, "%s: wrong %s\n", scene.name.c_str(), question);
  std::exit(1);
}

// The answers to all questions for a small swarm against brute force, and for a large one against
// each other.
void check(const Scene& scene) {
  const std::vector<Point> few = scene.make(3000);
  const beespace::SearchOptions options{scene.threshold_m};
  namespace brute_force = beespace::brute_force;
  if (*find_at_risk(few, options) != *brute_force::find_at_risk(few, options)) {
    fail(scene, "points at risk");
  }
  if (*count_neighbors(few, options) != *brute_force::count_neighbors(few, options)) {
    fail(scene, "counts");
  }
  if (!(*find_conflict_groups(few, options) == *brute_force::find_conflict_groups(few, options))) {
    fail(scene, "groups");
  }
  if (!(*find_nearest(few) == *brute_force::find_nearest(few))) fail(scene, "nearest");
  if (*find_pairs(few, options) != *brute_force::find_pairs(few, options)) fail(scene, "pairs");

  const std::vector<Point> many = scene.make(kMany);
  const std::vector<beespace::PointId> at_risk = *find_at_risk(many, options);
  const std::vector<std::uint32_t> counts = *count_neighbors(many, options);
  const beespace::IdRows groups = *find_conflict_groups(many, options);
  std::vector<beespace::PointId> counted;
  for (beespace::PointId id = 0; id < counts.size(); ++id) {
    if (counts[id] != 0) counted.push_back(id);
  }
  if (counted != at_risk) fail(scene, "counts of many");
  if (groups.ids.size() != at_risk.size()) fail(scene, "groups of many");
}

void report(benchmark::State& state, const char* name, double things) {
  state.counters[name] = benchmark::Counter(
      things, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// ask(engine, points, threshold) for many points.
template <class Ask>
void time_points(const Scene& scene, const char* question, Ask ask) {
  benchmark::RegisterBenchmark((std::string(question) + "/" + scene.name).c_str(),
                               [scene, ask](benchmark::State& state) mutable {
                                 const std::vector<Point> points = scene.make(kMany);
                                 Engine engine;
                                 ask(engine, points, scene.threshold_m);
                                 for (auto _ : state) ask(engine, points, scene.threshold_m);
                                 report(state, "per_point", static_cast<double>(points.size()));
                               })
      ->Unit(benchmark::kMillisecond);
}

// ask(engine, points, threshold) returns how many pairs it has seen, of `size` points and more.
template <class Ask>
void time_pairs(const Scene& scene, const char* question, std::int64_t size, Ask ask) {
  benchmark::RegisterBenchmark(
      (std::string(question) + "/" + scene.name).c_str(),
      [scene, ask](benchmark::State& state) mutable {
        const std::vector<Point> points = scene.make(static_cast<std::size_t>(state.range(0)));
        Engine engine;
        std::size_t pairs = ask(engine, points, scene.threshold_m);
        for (auto _ : state) pairs = ask(engine, points, scene.threshold_m);
        report(state, "per_point", static_cast<double>(points.size()));
        report(state, "per_pair_or_point", static_cast<double>(points.size() + pairs));
      })
      ->Arg(size)
      ->Arg(2 * size)
      ->Arg(4 * size)
      ->Unit(benchmark::kMillisecond);
}

template <class Status>
void require(const Status& status) {
  if (!status) std::exit(1);
}

void register_scene(const Scene& scene) {
  using Points = std::vector<Point>;
  time_points(scene, "at_risk",
              [ids = std::vector<beespace::PointId>()](Engine& engine, const Points& points,
                                                       double threshold) mutable {
                require(engine.find_at_risk(points, {threshold}, ids));
              });
  time_points(scene, "counts",
              [counts = std::vector<std::uint32_t>()](Engine& engine, const Points& points,
                                                      double threshold) mutable {
                require(engine.count_neighbors(points, {threshold}, counts));
              });
  time_points(scene, "groups",
              [groups = beespace::IdRows()](Engine& engine, const Points& points,
                                            double threshold) mutable {
                require(engine.find_conflict_groups(points, {threshold}, groups));
              });
  time_points(scene, "nearest",
              [nearest = std::vector<beespace::Nearest>()](Engine& engine, const Points& points,
                                                           double) mutable {
                require(engine.find_nearest(points, nearest));
              });
  time_points(scene, "closest_pair", [](Engine& engine, const Points& points, double) {
    require(engine.find_closest_pair(points));
  });
  time_pairs(scene, "pairs", kFew,
             [pairs = std::vector<beespace::Pair>()](Engine& engine, const Points& points,
                                                     double threshold) mutable {
               require(engine.find_pairs(points, {threshold}, pairs));
               return pairs.size();
             });
  time_pairs(
      scene, "visited_pairs", 2 * kFew, [](Engine& engine, const Points& points, double threshold) {
        std::size_t seen = 0;
        require(engine.visit_pairs(points, {threshold}, [&](std::span<const beespace::Pair> batch) {
          seen += batch.size();
          return true;
        }));
        return seen;
      });
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const Scene& scene : scenes()) {
    check(scene);
    register_scene(scene);
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
