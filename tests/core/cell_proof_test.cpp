#include "core/cell_proof.hpp"

#include "core/exact_distance.hpp"
#include "core/look_around.hpp"
#include "cpu/thread_crew.hpp"
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

TEST_P(CellProofs, ProveOnlyWhatIsTrueAndNameTheRest) {
  cpu::ThreadCrew crew(GetParam().threads);
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const auto true_ids = *brute_force::find_at_risk(scene.points, {scene.threshold_m});
    Buffer<std::uint8_t> at_risk(scene.points.size());
    const CellProof proof = prove_by_cells(scene.points, *measure(scene.points, crew),
                                           scene.threshold_m, crew, at_risk, GetParam().table);
    std::vector<PointId> alone;
    for (PointId id = 0; id < scene.points.size(); ++id) {
      if (at_risk[id] == 0) alone.push_back(id);
      const bool truly = std::binary_search(true_ids.begin(), true_ids.end(), id);
      if (at_risk[id] != 0) {
        ASSERT_TRUE(truly) << id;
      }
    }
    EXPECT_EQ(proof.alone, alone);
  }
}

TEST_P(CellProofs, SurroundingsHoldEverybodyNearThoseAlone) {
  cpu::ThreadCrew crew(GetParam().threads);
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const Bounds bounds = *measure(scene.points, crew);
    Buffer<std::uint8_t> at_risk(scene.points.size());
    const CellProof proof =
        prove_by_cells(scene.points, bounds, scene.threshold_m, crew, at_risk, GetParam().table);
    const Lattice lattice(scene.points, bounds, scene.threshold_m);
    const std::vector<PointId> by_hash = surroundings(scene.points, lattice, proof.alone, crew);
    const ProximityTest near(scene.threshold_m, true);
    for (const PointId lonely : proof.alone) {
      for (PointId id = 0; id < scene.points.size(); ++id) {
        if (!near(scene.points[lonely], scene.points[id])) continue;
        ASSERT_TRUE(std::binary_search(by_hash.begin(), by_hash.end(), id));
        if (!proof.around) continue;
        ASSERT_TRUE(std::binary_search(proof.around->begin(), proof.around->end(), id));
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

TEST(CellProof, SettlesACrowdAndFindsItsEdgeCheaply) {
  test::SceneMaker make(8);
  std::vector<Point> points = make.box(200'000, {0, 0, 0}, {100, 100, 100});
  points.push_back({100.9, 50, 50});  // in a cell of its own, beyond the edge
  Crew alone;
  Buffer<std::uint8_t> at_risk(points.size());
  const CellProof proof =
      prove_by_cells(points, *measure(points, alone), 10.0, alone, at_risk, CellTable::kDense);
  EXPECT_LT(proof.alone.size(), 50U);
  ASSERT_TRUE(proof.around.has_value());
  EXPECT_LT(proof.around->size(), points.size() / 2);
}

}  // namespace
}  // namespace beespace::core
