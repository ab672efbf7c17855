// The answers beyond memory are those of the reference, whatever the cells.
#include "out_of_core/search_cells.hpp"

#include "out_of_core/nearest_question.hpp"
#include "out_of_core/questions.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/engine.hpp>
#include <beespace/out_of_core.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace beespace::out_of_core {
namespace {

std::string folder() {
  return std::filesystem::temp_directory_path().string();
}

struct Scene {
  std::string name;
  std::vector<Point> points;
  SearchOptions options;
  std::vector<double> heights = {};  // apart from the positions, or none

  [[nodiscard]] PointsView view() const { return PointsView(points).with_heights(heights); }
};

SearchOptions within(double threshold, bool inclusive = false) {
  SearchOptions options{.threshold_m = threshold};
  options.inclusive = inclusive;
  return options;
}

SearchOptions in_cylinder(double threshold, double vertical, bool inclusive = false) {
  SearchOptions options = within(threshold, inclusive);
  options.vertical_m = vertical;
  return options;
}

// Cylinders of heights that are z, and of heights apart from positions in space.
void add_cylinders(std::vector<Scene>& all, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto numbers = [&](std::size_t count, double most) {
    std::vector<double> made(count);
    for (double& number : made) number = most * unit(random);
    return made;
  };
  const auto uniform = [&](std::size_t count, double x, double y, double z) {
    std::vector<Point> points(count);
    for (Point& point : points) point = {x * unit(random), y * unit(random), z * unit(random)};
    return points;
  };
  all.push_back({"cylinder, flat", uniform(1500, 30, 30, 5), in_cylinder(2.0, 0.25)});
  all.push_back({"cylinder, tall", uniform(1000, 20, 20, 60), in_cylinder(0.5, 20.0)});

  // Neighbours at both thresholds, and an ulp to either side of each.
  std::vector<Point> lattice;
  std::vector<Point> level;
  std::vector<double> heights;
  for (int x = 0; x < 8; ++x) {
    for (int y = 0; y < 8; ++y) {
      for (int step = 0; step < 5; ++step) {
        lattice.push_back({3.0 * x, 3.0 * y, 2.0 * step});
        // In a plane that stands upright, so that z is horizontal.
        level.push_back({100.0, 3.0 * x, 3.0 * y});
        heights.push_back(2.0 * step);
      }
    }
  }
  const auto beside = [](double number, int ulps) {
    return ulps == 0 ? number : std::nextafter(number, ulps < 0 ? 0.0 : 2.0 * number);
  };
  for (const int across : {-1, 0, 1}) {
    for (const int up : {-1, 0, 1}) {
      const SearchOptions options = in_cylinder(beside(3.0, across), beside(2.0, up), across == 0);
      all.push_back({"lattice of cylinders", lattice, options});
      all.push_back({"lattice of heights apart", level, options, heights});
    }
  }

  all.push_back(
      {"heights apart", uniform(900, 20, 20, 20), in_cylinder(2.0, 0.25), numbers(900, 1.0)});
  auto feet = in_cylinder(2.0, 500.0);
  feet.height_unit_m = 0.3048;
  all.push_back({"heights in feet", uniform(700, 15, 15, 15), feet, numbers(700, 3000.0)});
  // A crowd in pieces, of which a few have nothing at their own height in their own piece.
  all.push_back({"one place, heights apart", std::vector<Point>(600, {7, 7, 7}),
                 in_cylinder(1.0, 0.5), numbers(600, 500.0)});
}

std::vector<Scene> scenes() {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::normal_distribution<double> normal;
  const auto uniform = [&](std::size_t count, double x, double y, double z) {
    std::vector<Point> points(count);
    for (Point& point : points) point = {x * unit(random), y * unit(random), z * unit(random)};
    return points;
  };
  std::vector<Scene> all;
  all.push_back({"none", {}, within(1.0)});
  all.push_back({"one", {{1, 2, 3}}, within(1.0)});
  all.push_back({"uniform", uniform(700, 15, 15, 15), within(1.0)});
  all.push_back({"dense", uniform(600, 20, 20, 20), within(5.0)});
  all.push_back({"threshold beyond all", uniform(300, 1, 1, 1), within(50.0)});
  all.push_back({"plane", uniform(1500, 60, 60, 0), within(1.0)});
  all.push_back({"line", uniform(1500, 1000, 0, 0), within(0.5)});
  all.push_back({"one place", std::vector<Point>(700, {7, 7, 7}), within(1.0)});

  auto clusters = uniform(300, 1000, 1000, 1000);
  for (int cluster = 0; cluster < 3; ++cluster) {
    const Point middle = clusters[static_cast<std::size_t>(cluster)];
    const double size = std::pow(10.0, cluster - 2);
    for (int count = 0; count < 300; ++count) {
      clusters.push_back({middle.x + size * normal(random), middle.y + size * normal(random),
                          middle.z + size * normal(random)});
    }
  }
  std::shuffle(clusters.begin(), clusters.end(), random);
  all.push_back({"clusters", clusters, within(1.0)});

  // All neighbours exactly at the threshold, those across borders too; each place twice.
  std::vector<Point> lattice;
  for (int x = 0; x < 10; ++x) {
    for (int y = 0; y < 10; ++y) {
      for (int z = 0; z < 4; ++z) lattice.push_back({3.0 * x, 3.0 * y, 3.0 * z});
    }
  }
  std::shuffle(lattice.begin(), lattice.end(), random);
  all.push_back({"lattice", lattice, within(3.0)});
  all.push_back({"lattice, inclusive", lattice, within(3.0, true)});
  all.push_back({"lattice, an ulp more", lattice, within(std::nextafter(3.0, 4.0))});
  auto twice = lattice;
  twice.insert(twice.end(), lattice.begin(), lattice.end());
  all.push_back({"lattice, twice", twice, within(3.0)});

  add_cylinders(all, random);

  // Far from the origin, a few ulps apart.
  auto far_off = uniform(800, 40, 40, 40);
  for (Point& point : far_off) {
    point = {std::floor(point.x) + 0x1p52, std::floor(point.y) - 0x1p52, std::floor(point.z)};
  }
  all.push_back({"far off", far_off, within(2.0)});
  return all;
}

struct Searched {
  std::vector<PointId> at_risk;
  std::vector<Pair> pairs;
  std::vector<std::uint32_t> counts;
  std::optional<ClosestPair> closest;
  NearestRows nearest;
  NearestRows four_nearest;
  OutOfCoreFacts facts;
};

PointId narrow(LargeId id) {
  return static_cast<PointId>(id);
}

double straight_line(const Scene& scene, LargeId first, LargeId second) {
  const Point& a = scene.points[first];
  const Point& b = scene.points[second];
  if (scene.heights.empty()) return distance(a, b);
  const double x = a.x - b.x;
  const double y = a.y - b.y;
  const double z = a.z - b.z;
  const double up = (scene.heights[first] - scene.heights[second]) * scene.options.height_unit_m;
  return std::sqrt(x * x + y * y + z * z + up * up);
}

// By cells of at most `cell` points, in batches of a quarter of that.
Searched search(const Scene& scene, std::size_t cell, unsigned threads, bool on_disk) {
  const Plan plan = {std::max<std::size_t>(1, cell / 4), cell, 100'000, 5};
  const std::string temporary = folder();
  ThreadCrew crew(threads);
  const std::function<void(const OutOfCoreProgress&)> silent;
  const std::stop_token never;
  const Workplace at = {plan, temporary, crew, never, silent};
  StoredPoints points;
  if (on_disk) {
    EXPECT_TRUE(points.copy(scene.view(), temporary, plan.batch));
  } else {
    EXPECT_TRUE(points.refer(scene.view()));
  }
  const bool heights = points.have_heights();
  SearchOptions options = scene.options;
  options.threads = threads;
  Engine engine;
  Searched found;
  found.counts.assign(scene.points.size(), 0xFFFFFFFFU);

  const LargeIdVisitor see_ids = [&](std::span<const LargeId> ids) {
    EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
    for (const LargeId id : ids) found.at_risk.push_back(narrow(id));
  };
  AtRiskQuestion at_risk(engine, options, see_ids);
  EXPECT_TRUE(search_cells(points, reach_of(options, heights), at, at_risk, found.facts));

  const LargePairVisitor see_pairs = [&](std::span<const LargePair> pairs,
                                         std::span<const double> distances_m) {
    ASSERT_EQ(pairs.size(), distances_m.size());
    for (std::size_t index = 0; index < pairs.size(); ++index) {
      const auto [first, second] = pairs[index];
      found.pairs.push_back({narrow(first), narrow(second)});
      EXPECT_EQ(distances_m[index], straight_line(scene, first, second));
    }
  };
  PairsQuestion pairs(engine, options, plan.pairs, see_pairs);
  EXPECT_TRUE(search_cells(points, reach_of(options, heights), at, pairs, found.facts));

  const LargeCountVisitor see_counts = [&](std::span<const LargeId> ids,
                                           std::span<const std::uint64_t> counts) {
    for (std::size_t index = 0; index < ids.size(); ++index) {
      EXPECT_EQ(found.counts[ids[index]], 0xFFFFFFFFU) << "told twice";
      found.counts[ids[index]] = static_cast<std::uint32_t>(counts[index]);
    }
  };
  CountQuestion counts(engine, options, see_counts);
  EXPECT_TRUE(search_cells(points, reach_of(options, heights), at, counts, found.facts));

  // The order of cells is no promise; that nothing comes twice is one.
  std::sort(found.at_risk.begin(), found.at_risk.end());
  std::sort(found.pairs.begin(), found.pairs.end());
  if (heights) return found;

  const RunOptions run(threads);
  const auto reach = reach_of_closest_pair(points, run, at);
  EXPECT_TRUE(reach);
  ClosestPairQuestion closest(engine, run);
  EXPECT_TRUE(search_cells(points, *reach, at, closest, found.facts));
  if (const auto pair = closest.closest()) {
    found.closest = {narrow(pair->pair.first), narrow(pair->pair.second), pair->distance_m};
  }

  for (const std::size_t k : {std::size_t{1}, std::size_t{4}}) {
    const std::size_t size = scene.points.size();
    NearestRows& rows = k == 1 ? found.nearest : found.four_nearest;
    if (size < 2) continue;
    rows.length = std::min(k, size - 1);
    rows.entries.assign(size * rows.length, {});
    const LargeNearestVisitor see_rows = [&](std::span<const LargeId> ids,
                                             std::span<const LargeNearest> entries) {
      ASSERT_EQ(entries.size(), ids.size() * rows.length);
      for (std::size_t entry = 0; entry < entries.size(); ++entry) {
        Nearest& to = rows.entries[ids[entry / rows.length] * rows.length + entry % rows.length];
        EXPECT_EQ(to.id, Nearest::kNone) << "told twice";
        to = {narrow(entries[entry].id), entries[entry].distance_m};
      }
    };
    const auto near = reach_of_nearest(points, rows.length, run, at);
    EXPECT_TRUE(near);
    // With few that wait at a time, and with halos that are too narrow for most.
    const double halo = threads == 3 ? near->front() : near->front() / 4;
    const NearestQuestion::Setting setting = {run, rows.length, halo, cell / 2 + 1, 100};
    NearestQuestion nearest(engine, setting, see_rows);
    EXPECT_TRUE(search_cells(points, {halo, halo, halo}, at, nearest, found.facts));
  }
  return found;
}

TEST(SearchCells, AnswersAreThoseOfTheReference) {
  std::uint64_t most_cells = 0;
  std::uint64_t most_crowded = 0;
  std::size_t number = 0;
  for (const Scene& scene : scenes()) {
    const auto at_risk = brute_force::find_at_risk(scene.view(), scene.options);
    const auto pairs = brute_force::find_pairs(scene.view(), scene.options);
    const auto counts = brute_force::count_neighbors(scene.view(), scene.options);
    const auto closest = brute_force::find_closest_pair(scene.points);
    const auto nearest = brute_force::find_k_nearest(scene.points, 1);
    const auto four_nearest = brute_force::find_k_nearest(scene.points, 4);
    std::vector<std::size_t> cells = {60, 400, 100'000};
    if (scene.points.size() <= 800) cells.push_back(8);
    // Sanitizers take a minute for each second: with them cells of one size a scene, in turn.
    if (test::kSanitized) cells = {cells[number++ % cells.size()]};
    for (const std::size_t cell : cells) {
      for (const unsigned threads : {1U, 3U}) {
        if (test::kSanitized && threads == 1) continue;
        SCOPED_TRACE(scene.name + ", cells of " + std::to_string(cell) + ", threads " +
                     std::to_string(threads));
        const Searched found = search(scene, cell, threads, threads == 3);
        EXPECT_EQ(found.at_risk, *at_risk);
        EXPECT_EQ(found.pairs, *pairs);
        EXPECT_EQ(found.counts, *counts);
        most_cells = std::max(most_cells, found.facts.cells);
        most_crowded = std::max(most_crowded, found.facts.crowded_cells);
        if (!scene.heights.empty()) continue;
        EXPECT_EQ(found.closest, *closest);
        EXPECT_EQ(found.nearest, *nearest);
        EXPECT_EQ(found.four_nearest, *four_nearest);
      }
    }
  }
  // All ways were taken.
  EXPECT_GT(most_cells, 100U);
  EXPECT_GT(most_crowded, 5U);
}

TEST(OutOfCore, SaysWhatWasCut) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0.0, 60.0);
  std::vector<Point> points(200'000);
  for (Point& point : points) point = {place(random), place(random), place(random)};
  OutOfCore search({.memory_bytes = std::uint64_t{16} << 20U, .folder = folder()});
  // In parts, on the disk and where they are.
  ASSERT_TRUE(search.add(std::vector<Point>(points.begin(), points.begin() + 70'000)));
  ASSERT_TRUE(search.refer(std::span(points).subspan(70'000, 60'000)));
  ASSERT_TRUE(search.add(std::vector<Point>(points.begin() + 130'000, points.end())));
  EXPECT_EQ(search.size(), points.size());

  std::vector<PointId> found;
  const auto see = [&](std::span<const LargeId> ids) {
    for (const LargeId id : ids) found.push_back(narrow(id));
  };
  ASSERT_TRUE(search.find_at_risk({.threshold_m = 1.0}, see));
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found, *find_at_risk(points, {.threshold_m = 1.0}));
  EXPECT_GE(search.facts().cells, 3U);
  EXPECT_EQ(search.facts().crowded_cells, 0U);
  EXPECT_GT(search.facts().copies, 0U);
  EXPECT_LT(search.facts().copies, points.size() / 5);
}

// In parts, on the disk and where they are; with a memory that makes cells of it.
TEST(OutOfCore, HeightsApartAreThoseOfASearchInMemory) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(0.0, 60.0);
  std::vector<Point> points(200'000);
  std::vector<double> heights(points.size());
  for (Point& point : points) point = {place(random), place(random), place(random)};
  for (double& height : heights) height = 10.0 * place(random);
  const PointsView all = PointsView(points).with_heights(heights);
  SearchOptions options = in_cylinder(2.0, 40.0);
  options.height_unit_m = 0.3048;

  OutOfCore search({.memory_bytes = std::uint64_t{32} << 20U, .folder = folder(), .threads = 2});
  ASSERT_TRUE(search.add(part_of(all, 0, 70'000)));
  ASSERT_TRUE(search.refer(part_of(all, 70'000, 60'000)));
  ASSERT_TRUE(search.add(part_of(all, 130'000, 70'000)));

  std::vector<PointId> at_risk;
  ASSERT_TRUE(search.find_at_risk(options, [&](std::span<const LargeId> ids) {
    for (const LargeId id : ids) at_risk.push_back(narrow(id));
  }));
  std::sort(at_risk.begin(), at_risk.end());
  EXPECT_EQ(at_risk, *find_at_risk(all, options));
  EXPECT_GT(at_risk.size(), 1000U);
  EXPECT_LT(at_risk.size(), points.size() - 1000U);
  EXPECT_GE(search.facts().cells, 2U);

  std::vector<Pair> pairs;
  ASSERT_TRUE(search.visit_pairs(options, [&](std::span<const LargePair> seen, auto) {
    for (const LargePair& pair : seen) pairs.push_back({narrow(pair.first), narrow(pair.second)});
  }));
  std::sort(pairs.begin(), pairs.end());
  EXPECT_EQ(pairs, *find_pairs(all, options));

  std::vector<std::uint32_t> counts(points.size(), 0xFFFFFFFFU);
  ASSERT_TRUE(search.count_neighbors(
      options, [&](std::span<const LargeId> ids, std::span<const std::uint64_t> seen) {
        for (std::size_t index = 0; index < ids.size(); ++index) {
          counts[ids[index]] = static_cast<std::uint32_t>(seen[index]);
        }
      }));
  EXPECT_EQ(counts, *count_neighbors(all, options));
}

TEST(OutOfCore, TellsHowFarItIs) {
  std::vector<Point> points(100'000);
  for (std::size_t index = 0; index < points.size(); ++index) {
    points[index] = {static_cast<double>(index), 0, 0};
  }
  std::map<OutOfCoreProgress::Phase, std::uint64_t> last;
  OutOfCoreOptions options{.memory_bytes = std::uint64_t{16} << 20U, .folder = folder()};
  options.progress = [&](const OutOfCoreProgress& progress) {
    EXPECT_EQ(progress.of, points.size());
    EXPECT_GE(progress.done, last[progress.phase]);
    last[progress.phase] = progress.done;
  };
  OutOfCore search(options);
  ASSERT_TRUE(search.refer(points));
  ASSERT_TRUE(search.find_at_risk({.threshold_m = 1.0}, [](auto) {}));
  EXPECT_EQ(last[OutOfCoreProgress::Phase::kSearching], points.size());
  EXPECT_GT(last[OutOfCoreProgress::Phase::kDistributing], 0U);
}

}  // namespace
}  // namespace beespace::out_of_core
