// The searches that take whole boxes of points at once, forced onto every scene, also where a
// search would not choose them.
#include "search/group_search.hpp"
#include "search/pair_search.hpp"
#include "search/search_domain.hpp"
#include "tests/support/rounds.hpp"
#include "tests/support/search_scenes.hpp"
#include "tests/support/two_set_scenes.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/crew.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace beespace::search {
namespace {

using Crowds = TuningOverrides::Crowds;

struct Case {
  Crowds crowds;
  unsigned threads;
  cpu::InstructionSet instruction_set = cpu::best_instruction_set();
};

std::vector<Case> cases() {
  if (test::kSanitized) return {{Crowds::kAlways, 3}, {Crowds::kNever, 2}};
  std::vector<Case> all;
  for (const unsigned threads : {1U, 2U, 3U, 8U}) all.push_back({Crowds::kAlways, threads});
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (cpu::is_available(set)) all.push_back({Crowds::kAlways, 1, set});
  }
  all.push_back({Crowds::kNever, 2});
  all.push_back({Crowds::kAutomatic, 1});
  return all;
}

// Threads and memory that are reused, as an Engine does.
class Searches {
 public:
  explicit Searches(const Case& chosen) : crew_(chosen.threads) {
    tuning_.crowds = chosen.crowds;
    tuning_.instruction_set = chosen.instruction_set;
  }

  IdRows groups(const PointsView& points, const SearchOptions& options) {
    IdRows groups;
    const Result<SearchDomain> domain = SearchDomain::of(points, with_);
    find_conflict_groups(*domain, options, with_, tuning_, groups);
    return groups;
  }
  std::vector<std::uint32_t> counts(const PointsView& points, const SearchOptions& options) {
    return counts_in(SearchDomain::of(points, with_), options);
  }
  std::vector<std::uint32_t> counts(const PointsView& points, const PointsView& others,
                                    const SearchOptions& options) {
    return counts_in(SearchDomain::of(points, others, with_), options);
  }

 private:
  std::vector<std::uint32_t> counts_in(const Result<SearchDomain>& domain,
                                       const SearchOptions& options) {
    std::vector<std::uint32_t> counts;
    count_neighbors(*domain, options, with_, tuning_, counts);
    return counts;
  }

  ThreadCrew crew_;
  core::Memory memory_;
  core::Resources with_{crew_, memory_};
  TuningOverrides tuning_;
};

std::vector<Point> every_place_times(const std::vector<Point>& places, std::size_t times) {
  std::vector<Point> points;
  for (std::size_t k = 0; k < times; ++k) points.insert(points.end(), places.begin(), places.end());
  return points;
}

// Two clumps, each far smaller than the resolution of a lattice, about the threshold apart.
std::vector<Point> two_tiny_clumps(std::size_t size, double threshold) {
  test::SceneMaker make(3);
  const double width = 0x1p-45 * threshold;
  std::vector<Point> points = make.box(size, {0, 0, 0}, {width, width, width});
  for (std::size_t i = 0; i < size; i += 2) points[i].x += threshold;
  return points;
}

std::vector<test::SearchScene> crowded_scenes() {
  std::vector<test::SearchScene> scenes = test::search_scenes();
  for (const test::SearchScene& scene : test::crowd_scenes()) {
    for (const double factor : {0.125, 0.5, 4.0}) {
      scenes.push_back({scene.name + " times " + std::to_string(factor), scene.points,
                        factor * scene.threshold_m});
    }
  }
  test::SceneMaker make(5);
  const std::vector<Point> box = make.box(3000, {0, 0, 0}, {900, 700, 100});
  for (const double threshold : {40.0, 100.0, 250.0, 800.0}) {
    scenes.push_back({"Box " + std::to_string(threshold), box, threshold});
  }
  // Cells, leaves and boxes whose corners are exactly the threshold apart.
  const std::vector<Point> lattice = test::integer_lattice(13, 0.5, {-3, -3, -3});
  for (const double threshold : {0.5, 1.5, 2.5, std::sqrt(3.0), 6.0}) {
    scenes.push_back({"Lattice " + std::to_string(threshold), lattice, threshold});
  }
  scenes.push_back(
      {"LatticeOfTwins", every_place_times(test::integer_lattice(5, 1.0, {}), 30), 1.0});
  scenes.push_back({"Sphere", test::integer_sphere(25), 25.0});
  scenes.push_back({"TinyClumps", two_tiny_clumps(1500, 1.0), 1.0});
  if (!test::kSanitized) return scenes;
  std::vector<test::SearchScene> some;
  for (std::size_t i = 0; i < scenes.size(); i += 4) some.push_back(std::move(scenes[i]));
  return some;
}

TEST(CrowdSearches, AgreeWithBruteForceOnEveryScene) {
  for (const test::SearchScene& scene : crowded_scenes()) {
    for (const bool inclusive : {false, true}) {
      const SearchOptions options{scene.threshold_m, inclusive};
      const IdRows groups = *brute_force::find_conflict_groups(scene.points, options);
      const std::vector<std::uint32_t> counts =
          *brute_force::count_neighbors(scene.points, options);
      for (const Case& chosen : cases()) {
        SCOPED_TRACE(testing::Message()
                     << scene.name << (inclusive ? " inclusive " : " strict ") << chosen.threads
                     << " threads " << cpu::name_of(chosen.instruction_set));
        Searches searches(chosen);
        const IdRows found = searches.groups(scene.points, options);
        ASSERT_EQ(found.offsets, groups.offsets);
        ASSERT_EQ(found.ids, groups.ids);
        ASSERT_EQ(searches.counts(scene.points, options), counts);
      }
    }
  }
}

TEST(CrowdSearches, CountBetweenTwoSetsAsBruteForceDoes) {
  for (const test::SearchScene& scene : crowded_scenes()) {
    for (const test::Split how : test::kSplits) {
      const test::TwoSets sets = test::split(scene.points, how);
      const SearchOptions options{scene.threshold_m, how == test::Split::kHalves};
      const std::vector<std::uint32_t> counts =
          *brute_force::count_neighbors_between(sets.points, sets.others, options);
      for (const Case& chosen : cases()) {
        SCOPED_TRACE(testing::Message()
                     << scene.name << ' ' << test::name_of(how) << ' ' << chosen.threads
                     << " threads " << cpu::name_of(chosen.instruction_set));
        ASSERT_EQ(Searches(chosen).counts(sets.points, sets.others, options), counts);
      }
    }
  }
}

// A quadratic search would look at 40,000,000,000 pairs.
TEST(CrowdSearches, AreNotQuadraticInDuplicates) {
  constexpr std::size_t kTimes = 1600;
  const std::vector<Point> places = test::integer_lattice(5, 1.0, {2, 2, 2});
  const std::vector<Point> points = every_place_times(places, kTimes);
  for (const bool inclusive : {false, true}) {
    const SearchOptions options{1.0, inclusive};
    const std::vector<std::uint32_t> of_places = *brute_force::count_neighbors(places, options);
    const IdRows groups_of_places = *brute_force::find_conflict_groups(places, options);
    for (const unsigned threads : {1U, 4U}) {
      Searches searches({Crowds::kAutomatic, threads});
      const std::vector<std::uint32_t> counts = searches.counts(points, options);
      for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_EQ(counts[i], (of_places[i % places.size()] + 1) * kTimes - 1);
      }
      const IdRows groups = searches.groups(points, options);
      ASSERT_EQ(groups.ids.size(), points.size());
      // Strictly, only twins are closer than the spacing; inclusively, all hang together.
      ASSERT_EQ(groups.size(), inclusive ? 1 : places.size());
      ASSERT_EQ(groups_of_places.size(), inclusive ? 1 : 0);
    }
  }
}

// All points of a crowd are near each other, whatever lies far away.
TEST(CrowdSearches, AreNotQuadraticInAClump) {
  test::SceneMaker make(9);
  std::vector<Point> points = make.box(150'000, {0, 0, 0}, {0.5, 0.5, 0.5});
  for (const double away : {1e3, 1e9, 1e12}) {
    points.push_back({away, 0, 0});
    Searches searches({Crowds::kAutomatic, 2});
    std::vector<std::uint32_t> expected(points.size(),
                                        static_cast<std::uint32_t>(points.size() - 2));
    expected.back() = 0;
    ASSERT_EQ(searches.counts(points, {1.0}), expected);
    const IdRows groups = searches.groups(points, {1.0});
    ASSERT_EQ(groups.offsets, (std::vector<std::uint64_t>{0, points.size() - 1}));
    points.pop_back();
  }
}

}  // namespace
}  // namespace beespace::search
