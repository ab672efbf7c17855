#include "grid/cell_proof.hpp"

#include "exact/exact_distance.hpp"
#include "grid/neighbor_probe.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace beespace::core {
namespace {

struct Case {
  CellTable table;
  unsigned threads;
};

class CellProofs : public testing::TestWithParam<Case> {};

TEST_P(CellProofs, ProveOnlyWhatIsTrueAndNameTheUndecided) {
  test::OwnResources own(GetParam().threads);
  for (const test::SearchScene& scene : test::search_scenes()) {
    for (const bool inclusive : {false, true}) {
      SCOPED_TRACE(scene.name + (inclusive ? " inclusive" : " strict"));
      const auto true_ids =
          *brute_force::find_at_risk(scene.points, {scene.threshold_m, inclusive});
      const ProximityTest closer(scene.threshold_m, inclusive);
      Buffer<std::uint8_t> at_risk(scene.points.size());
      const Vector<PointId> undecided =
          prove_by_cells(scene.points, *measure(scene.points, own.with), scene.threshold_m, closer,
                         own.with, at_risk, GetParam().table);
      EXPECT_TRUE(std::is_sorted(undecided.begin(), undecided.end()));
      for (PointId id = 0; id < scene.points.size(); ++id) {
        const bool open = std::binary_search(undecided.begin(), undecided.end(), id);
        const bool truly = std::binary_search(true_ids.begin(), true_ids.end(), id);
        if (open) {
          ASSERT_EQ(at_risk[id], 0) << id;
        } else {
          ASSERT_EQ(at_risk[id], truly ? 1 : 0) << id;
        }
      }
    }
  }
}

TEST(Surroundings, HoldAllPointsNearTheQueriedOnes) {
  test::OwnResources own(2);
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const PointsView points(scene.points);
    const Lattice lattice({&points, 1}, *measure(points, own.with), scene.threshold_m, own.memory);
    std::vector<PointId> asked;
    for (PointId id = 0; id < points.size(); id += 50) asked.push_back(id);
    const Vector<PointId> found = surroundings({points, asked}, {points}, lattice, own.with);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    const ProximityTest near(scene.threshold_m, true);
    for (const PointId asker : asked) {
      for (PointId id = 0; id < scene.points.size(); ++id) {
        if (!near(scene.points[asker], scene.points[id])) continue;
        ASSERT_TRUE(std::binary_search(found.begin(), found.end(), id)) << asker << " " << id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, CellProofs,
                         testing::Values(Case{CellTable::kAutomatic, 1}, Case{CellTable::kDense, 3},
                                         Case{CellTable::kHashed, 1}, Case{CellTable::kHashed, 3}),
                         [](const auto& test_case) {
                           const CellTable table = test_case.param.table;
                           const char* name = table == CellTable::kDense    ? "Dense"
                                              : table == CellTable::kHashed ? "Hashed"
                                                                            : "Automatic";
                           return name + std::to_string(test_case.param.threads);
                         });

// A crowd with a rough edge: some points are alone in their cells, in all ways that matter.
TEST(CellProof, SettlesACrowdToTheLastPoint) {
  test::SceneMaker make(8);
  std::vector<Point> points = make.box(200'000, {0, 0, 0}, {100, 100, 100});
  for (const Point& p : make.box(60, {-40, -40, -40}, {140, 140, 140})) points.push_back(p);
  points.push_back({112.0, 50, 50});
  const double threshold = 10.0;
  const ProximityTest closer(threshold, false);
  for (const unsigned threads : {1U, 3U}) {
    test::OwnResources own(threads);
    Buffer<std::uint8_t> at_risk(points.size());
    const Vector<PointId> undecided = prove_by_cells(points, *measure(points, own.with), threshold,
                                                     closer, own.with, at_risk, CellTable::kDense);
    EXPECT_TRUE(undecided.empty());
    std::size_t lonely = 0;
    for (PointId id = 200'000; id < points.size(); ++id) {
      bool truly = false;
      for (PointId other = 0; other < points.size() && !truly; ++other) {
        truly = other != id && closer(points[id], points[other]);
      }
      EXPECT_EQ(at_risk[id], truly ? 1 : 0) << id;
      lonely += truly ? 0U : 1U;
    }
    EXPECT_GT(lonely, 5U);
  }
}

}  // namespace
}  // namespace beespace::core
