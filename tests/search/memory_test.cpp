// Working memory is bounded by the number of points and of results. Measured as the peak of the
// process's resident memory beyond the input, the answer included.
#include <beespace/at_risk.hpp>
#include <beespace/conflict_groups.hpp>
#include <beespace/nearest.hpp>
#include <beespace/neighbors.hpp>
#include <beespace/pairs.hpp>

#include "scenes/swarm_scenes.hpp"
#include "tests/support/process_memory.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <malloc.h>

#include <cstdint>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace beespace {
namespace {

constexpr std::size_t kSize = 2'000'000;

struct Scene {
  const char* name;
  std::vector<Point> points;
  double threshold_m;
};

std::vector<Point> on_a_line() {
  std::vector<Point> points = scenes::uniform_box(kSize, {1e8, 0, 0}, 1);
  for (Point& p : points) p.y = p.z = 5.0;
  return points;
}

std::vector<Point> clump_and_outlier() {
  std::vector<Point> points = scenes::uniform_box(kSize, {3'000, 3'000, 3'000}, 1);
  points.back() = {1e12, 1e12, 1e12};
  return points;
}

std::vector<Scene> even_scenes() {
  return {
      {"uniform, two neighbours", scenes::uniform_box(kSize, {16'127, 16'127, 16'127}, 1), 100.0},
      {"dense box, one neighbour", scenes::uniform_box(kSize, {4'158, 2'898, 605}, 1), 10.0},
      {"sparse: every point in a row of its own", scenes::uniform_box(kSize, {1e6, 1e6, 1e6}, 1),
       100.0},
      {"clusters", scenes::gaussian_clusters(kSize, 1'000, 200.0, 100'000.0, 1), 20.0}};
}

std::vector<Scene> hostile_scenes() {
  return {{"dense box, a thousand neighbours", scenes::uniform_box(kSize, {4'158, 2'898, 605}, 1),
           100.0},
          {"a line", on_a_line(), 100.0},
          {"all in one cell", scenes::uniform_box(kSize, {1, 1, 1}, 1), 100.0},
          {"all at one place", std::vector<Point>(kSize, Point{3, 3, 3}), 1.0},
          {"a clump and an outlier", clump_and_outlier(), 30.0}};
}

// Runs ask(options), which returns the number of results, and returns the memory that it took.
struct Measured {
  double bytes = 0.0;
  double results = 0.0;
};

template <class Ask>
Measured measured(const Scene& scene, unsigned threads, Ask&& ask) {
  malloc_trim(0);  // or memory kept from the run before would be used again, unseen
  EXPECT_TRUE(test::reset_peak());
  const std::uint64_t before = *test::status_bytes("VmRSS:");
  const std::size_t results = ask(scene.points, SearchOptions{scene.threshold_m, false, threads});
  const std::uint64_t peak = *test::status_bytes("VmHWM:");
  EXPECT_GE(peak, before);
  return {static_cast<double>(peak - before), static_cast<double>(results)};
}

class WorkingMemory : public testing::Test {
 protected:
  void SetUp() override {
    if (test::kSanitized) GTEST_SKIP() << "a sanitizer's shadow memory would be measured";
    if (!test::reset_peak())
      GTEST_SKIP() << "this system does not tell the peak of resident memory";
  }
};

void expect_little_for_at_risk(const std::vector<Scene>& scenes, unsigned threads) {
  for (const Scene& scene : scenes) {
    const Measured took = measured(scene, threads, [](const auto& points, const auto& options) {
      return find_at_risk(points, options).value().size();
    });
    EXPECT_LE(took.bytes / kSize, 40.0) << scene.name;
    EXPECT_GE(took.bytes / kSize, 1.0) << "not even the marks were measured";
  }
}

TEST_F(WorkingMemory, ForPointsAtRiskIsAtMost40BytesAPoint) {
  expect_little_for_at_risk(even_scenes(), 2);
}

TEST_F(WorkingMemory, ForPointsAtRiskIsAtMost40BytesAPointOfHostileScenesToo) {
  expect_little_for_at_risk(hostile_scenes(), 1);
}

// Couples far apart on every axis: none is alone, and half as many stretches as points lie on each.
// It takes 57 bytes; what was freed while an axis was sorted stays resident.
TEST_F(WorkingMemory, ForPointsAtRiskIsAtMost72BytesAPointSpreadBeyondAllCells) {
  std::vector<Point> points = scenes::uniform_box(kSize, {1e9, 1e9, 1e9}, 2);
  for (std::size_t i = 1; i < kSize; i += 2) {
    points[i] = {points[i - 1].x + 0.5, points[i - 1].y, points[i - 1].z};
  }
  const Measured took = measured({"couples", points, 1.0}, 1, [](auto& p, const auto& options) {
    return find_at_risk(p, options).value().size();
  });
  EXPECT_EQ(took.results, kSize);
  EXPECT_LE(took.bytes / kSize, 72.0);
  EXPECT_GE(took.bytes / kSize, 40.0) << "not even the grid was measured";
}

struct Question {
  const char* name;
  std::function<std::size_t(const PointsView&, const SearchOptions&)> ask;
  double bytes_a_point;
  double bytes_a_result;
};

// The answer's own memory is part of it.
TEST_F(WorkingMemory, GrowsWithPointsAndResultsOnly) {
  const PairVisitor all = [](std::span<const Pair>) { return true; };
  const Question questions[] = {
      {"pairs", [](auto p, auto& o) { return find_pairs(p, o).value().size(); }, 40, 16},
      {"visit", [all](auto p, auto& o) { return visit_pairs(p, o, all) ? 0U : 1U; }, 40, 0},
      {"neighbours", [](auto p, auto& o) { return find_neighbors(p, o).value().ids.size(); }, 48,
       12},
      {"counts", [](auto p, auto& o) { return count_neighbors(p, o).value().empty() ? 1U : 0U; },
       44, 0},
      {"groups", [](auto p, auto& o) { return find_conflict_groups(p, o).value().size(); }, 56, 0},
      {"nearest", [](auto p, auto& o) { return find_nearest(p, o.threads) ? 0U : 1U; }, 104, 0},
      {"within", [](auto p, auto& o) { return find_nearest_within(p, o) ? 0U : 1U; }, 60, 0},
      {"closest", [](auto p, auto& o) { return find_closest_pair(p, o.threads) ? 0U : 1U; }, 40,
       0}};
  const Scene scene = even_scenes().front();
  for (const Question& question : questions) {
    const Measured took = measured(scene, 1, question.ask);
    EXPECT_LE(took.bytes / kSize,
              question.bytes_a_point + question.bytes_a_result * took.results / kSize)
        << question.name;
  }
}

}  // namespace
}  // namespace beespace
