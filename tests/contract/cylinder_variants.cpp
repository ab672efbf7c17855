#include "tests/contract/cylinder_variants.hpp"

#include "tests/contract/backward_crew.hpp"

#include "base/memory.hpp"
#include "search/cylinder_search.hpp"

#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace beespace::test {
namespace {

using search::TuningOverrides;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// "The root of the sum of the squares", each step rounded.
double line_of(const CylinderScene& scene, std::size_t i, std::size_t j) {
  const bool two = scene.two_sets;
  const Point& p = scene.points[i];
  const Point& q = two ? scene.others[j] : scene.points[j];
  const double x = p.x - q.x;
  const double y = p.y - q.y;
  if (!scene.apart()) return std::sqrt(x * x + y * y + (p.z - q.z) * (p.z - q.z));
  const double z = p.z - q.z;
  const double up =
      (scene.heights[i] - (two ? scene.other_heights : scene.heights)[j]) * scene.height_unit_m;
  return std::sqrt(x * x + y * y + z * z + up * up);
}

Answers expected(const CylinderScene& scene, const ExactCylinders& exact, bool inclusive) {
  const auto rows = exact.rows(inclusive);
  std::vector<PointId> at_risk;
  std::vector<std::uint32_t> counts;
  std::vector<Pair> pairs;
  IdRows neighbors;
  neighbors.offsets.push_back(0);
  std::vector<Nearest> nearest(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto id = static_cast<PointId>(i);
    if (!rows[i].empty()) at_risk.push_back(id);
    counts.push_back(static_cast<std::uint32_t>(rows[i].size()));
    for (const PointId j : rows[i]) {
      if (scene.two_sets || id < j) pairs.push_back({id, j});
    }
    neighbors.ids.insert(neighbors.ids.end(), rows[i].begin(), rows[i].end());
    neighbors.offsets.push_back(neighbors.ids.size());
    if (const auto j = exact.nearest(i, rows[i])) nearest[i] = {*j, line_of(scene, i, *j)};
  }
  Answers answers = {{"at risk", flat(at_risk)},
                     {"counts", flat(counts)},
                     {"pairs", flat(pairs)},
                     {"neighbours", flat(neighbors)},
                     {"nearest", flat(nearest)}};
  if (scene.two_sets) return answers;
  // Flood fill.
  IdRows groups;
  groups.offsets.push_back(0);
  std::vector<bool> seen(rows.size());
  for (PointId first = 0; first < rows.size(); ++first) {
    if (seen[first] || rows[first].empty()) continue;
    std::vector<PointId> group = {first};
    seen[first] = true;
    for (std::size_t k = 0; k < group.size(); ++k) {
      for (const PointId j : rows[group[k]]) {
        if (!seen[j]) group.push_back(j);
        seen[j] = true;
      }
    }
    std::sort(group.begin(), group.end());
    groups.ids.insert(groups.ids.end(), group.begin(), group.end());
    groups.offsets.push_back(groups.ids.size());
  }
  answers["groups"] = flat(groups);
  answers["visited pairs"] = answers["pairs"];
  return answers;
}

Answer visited(const Result<bool>& all, std::vector<Pair> pairs) {
  if (!all || !*all) return {0, 0, 0};
  std::sort(pairs.begin(), pairs.end());
  return flat(pairs);
}

PairVisitor into(std::vector<Pair>& pairs) {
  return [&pairs](std::span<const Pair> batch) {
    pairs.insert(pairs.end(), batch.begin(), batch.end());
    return true;
  };
}

Answers by_brute_force(const CylinderScene& scene, const SearchOptions& options) {
  namespace brute = brute_force;
  const PointsView points = scene.view();
  if (scene.two_sets) {
    const PointsView others = scene.other_view();
    return {{"at risk", flat(brute::find_at_risk_between(points, others, options))},
            {"counts", flat(brute::count_neighbors_between(points, others, options))},
            {"pairs", flat(brute::find_pairs_between(points, others, options))},
            {"neighbours", flat(brute::find_neighbors_between(points, others, options))},
            {"nearest", flat(brute::find_nearest_within_between(points, others, options))}};
  }
  return {{"at risk", flat(brute::find_at_risk(points, options))},
          {"counts", flat(brute::count_neighbors(points, options))},
          {"pairs", flat(brute::find_pairs(points, options))},
          {"neighbours", flat(brute::find_neighbors(points, options))},
          {"groups", flat(brute::find_conflict_groups(points, options))},
          {"nearest", flat(brute::find_nearest_within(points, options))}};
}

// With the method forced.
Answers by_method(const CylinderScene& scene, const SearchOptions& options,
                  TuningOverrides::Crowds crowds, unsigned workers) {
  BackwardCrew crew(workers);
  core::Memory memory;
  const core::Resources with{crew, memory};
  TuningOverrides tuning;
  tuning.crowds = crowds;
  const PointsView points = scene.view();
  const PointsView others = scene.other_view();
  const search::CylinderSearch search(points, scene.two_sets ? &others : nullptr, options, with,
                                      tuning);
  std::vector<PointId> ids;
  std::vector<std::uint32_t> counts;
  std::vector<Pair> pairs;
  std::vector<Pair> seen;
  std::vector<Nearest> nearest;
  IdRows neighbors;
  IdRows groups;
  search::PairVector pair_answer(pairs);
  search::RowVectors row_answer(neighbors, points.size());
  Answers answers = {{"at risk", flat_if(search.find_at_risk(ids), ids)},
                     {"counts", flat_if(search.count_neighbors(counts), counts)},
                     {"pairs", flat_if(search.find_pairs(pair_answer), pairs)},
                     {"neighbours", flat_if(search.find_neighbors(row_answer), neighbors)},
                     {"nearest", flat_if(search.find_nearest(nearest), nearest)}};
  if (scene.two_sets) return answers;
  answers["groups"] = flat_if(search.find_groups(groups), groups);
  const auto all = search.visit_pairs(into(seen));
  answers["visited pairs"] = visited(all, seen);
  return answers;
}

}  // namespace

double one_ulp_above(double value) {
  return std::nextafter(value, kInfinity);
}

double one_ulp_below(double value) {
  return std::nextafter(value, -kInfinity);
}

Answers by_functions(const CylinderScene& scene, const SearchOptions& options) {
  const PointsView points = scene.view();
  if (scene.two_sets) {
    const PointsView others = scene.other_view();
    return {{"at risk", flat(find_at_risk_between(points, others, options))},
            {"counts", flat(count_neighbors_between(points, others, options))},
            {"pairs", flat(find_pairs_between(points, others, options))},
            {"neighbours", flat(find_neighbors_between(points, others, options))},
            {"nearest", flat(find_nearest_within_between(points, others, options))}};
  }
  std::vector<Pair> seen;
  const auto all = visit_pairs(points, options, into(seen));
  return {{"at risk", flat(find_at_risk(points, options))},
          {"counts", flat(count_neighbors(points, options))},
          {"pairs", flat(find_pairs(points, options))},
          {"visited pairs", visited(all, seen)},
          {"neighbours", flat(find_neighbors(points, options))},
          {"groups", flat(find_conflict_groups(points, options))},
          {"nearest", flat(find_nearest_within(points, options))}};
}

void expect_same(const Answers& answers, const Answers& right, const std::string& variant) {
  for (const auto& [question, answer] : answers) {
    EXPECT_EQ(answer, right.at(question)) << variant << ": " << question;
  }
}

std::size_t check(const CylinderScene& scene, bool inclusive, const std::string& name) {
  SCOPED_TRACE(name + (inclusive ? ", inclusive" : ", strict"));
  const ExactCylinders exact(scene);
  const Answers right = expected(scene, exact, inclusive);
  expect_same(by_brute_force(scene, scene.options(inclusive)), right, "brute force");
  for (const unsigned threads : {1U, 3U}) {
    const SearchOptions options = scene.options(inclusive, threads);
    expect_same(by_functions(scene, options), right, "functions");
    expect_same(by_method(scene, options, TuningOverrides::Crowds::kNever, threads), right, "rows");
    expect_same(by_method(scene, options, TuningOverrides::Crowds::kAlways, threads), right,
                "tree");
  }
  return right.at("pairs").size();
}

namespace {

// The same scene with its thresholds an ulp either side.
std::size_t check_around(CylinderScene scene, const std::string& name) {
  std::size_t pairs = 0;
  const double threshold = scene.threshold_m;
  const double vertical = scene.vertical_m;
  for (const double wide : {one_ulp_below(threshold), threshold, one_ulp_above(threshold)}) {
    for (const double high : {one_ulp_below(vertical), vertical, one_ulp_above(vertical)}) {
      scene.threshold_m = wide;
      scene.vertical_m = high;
      for (const bool inclusive : {false, true}) pairs += check(scene, inclusive, name);
    }
  }
  return pairs;
}

}  // namespace

CylinderScene apart(CylinderScene scene, double unit) {
  const auto move = [](std::vector<Point>& points, std::vector<double>& heights) {
    for (Point& p : points) {
      heights.push_back(p.z);
      p.z = 0.0;
      std::swap(p.x, p.z);
    }
  };
  move(scene.points, scene.heights);
  if (scene.two_sets) move(scene.others, scene.other_heights);
  scene.height_unit_m = unit;
  return scene;
}

CylinderScene in_two_sets(CylinderScene scene) {
  scene.two_sets = true;
  std::vector<Point> all = std::move(scene.points);
  scene.points.clear();
  for (std::size_t i = 0; i < all.size(); ++i) {
    (i % 3 == 0 ? scene.others : scene.points).push_back(all[i]);
  }
  return scene;
}

std::size_t check_all_forms(const CylinderScene& scene, const std::string& name) {
  std::size_t pairs = check_around(scene, name);
  pairs += check_around(apart(scene, 1.0), name + ", heights apart");
  pairs += check_around(in_two_sets(scene), name + ", two sets");
  pairs += check_around(apart(in_two_sets(scene), 0.3048), name + ", two sets, heights apart");
  return pairs;
}

}  // namespace beespace::test
