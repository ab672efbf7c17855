// One contract: every method, instruction set, cell table, folding and crew gives the ids that
// brute force gives, on every scene, strictly and inclusively.
#include "core/bounds.hpp"
#include <beespace/crew.hpp>
#include "search/at_risk_search.hpp"
#include "tests/support/search_scenes.hpp"

#include <beespace/at_risk.hpp>
#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace {
namespace {

using Method = search::Choices::Method;

struct Case {
  std::string name;
  search::Choices choices;
  unsigned threads;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&](const std::string& name, const search::Choices& choices, unsigned threads) {
    all.push_back({name, choices, threads});
  };
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (!cpu::is_available(set)) continue;
    search::Choices choices;
    choices.method = Method::kSweep;
    choices.instruction_set = set;
    for (const unsigned threads : {1U, 2U, 3U, 8U}) {
      const std::string name = cpu::name_of(set) + std::to_string(threads);
      add("Sweep_" + name, choices, threads);
    }
    choices.fold_beyond_cells = 4;
    add(std::string("SweepFolded_") + cpu::name_of(set), choices, 2);
  }
  for (const core::CellTable table : {core::CellTable::kDense, core::CellTable::kHashed}) {
    const std::string name = table == core::CellTable::kDense ? "Dense" : "Hashed";
    for (const unsigned threads : {1U, 2U, 5U}) {
      search::Choices choices;
      choices.cell_table = table;
      choices.method = Method::kProveThenSweep;
      add("ProveThenSweep" + name + std::to_string(threads), choices, threads);
      choices.method = Method::kProveThenLook;
      add("ProveThenLook" + name + std::to_string(threads), choices, threads);
    }
  }
  add("Automatic1", {}, 1);
  add("Automatic4", {}, 4);
  return all;
}

class AtRiskContract : public testing::TestWithParam<Case> {};

TEST_P(AtRiskContract, EqualsBruteForceOnEveryScene) {
  const Case& param = GetParam();
  ThreadCrew crew(param.threads);
  for (const test::SearchScene& scene : test::search_scenes()) {
    for (const bool inclusive : {false, true}) {
      SCOPED_TRACE(scene.name + (inclusive ? " inclusive" : " strict"));
      const SearchOptions options{scene.threshold_m, inclusive, 1};
      const auto expected = brute_force::find_at_risk(scene.points, options);
      ASSERT_TRUE(expected.has_value());
      const auto bounds = core::measure(scene.points, crew);
      ASSERT_TRUE(bounds.has_value());
      EXPECT_EQ(search::at_risk_ids(scene.points, *bounds, options, crew, param.choices),
                *expected);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Everything, AtRiskContract, testing::ValuesIn(cases()),
                         [](const auto& test_case) { return test_case.param.name; });

TEST(AtRiskContractCases, EveryKernelOfThisProcessorIsTested) {
  std::size_t sets = 0;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    sets += cpu::is_available(set) ? 1U : 0U;
  }
  std::size_t tested = 0;
  for (const Case& one : cases()) tested += one.name.rfind("SweepFolded_", 0) == 0 ? 1U : 0U;
  EXPECT_EQ(tested, sets);
  EXPECT_GE(sets, 1U);
}

// Larger than one crew member's minimum, so that threads really share the work.
TEST(AtRisk, SameAnswerForOneToEightThreads) {
  test::SceneMaker make(7);
  for (const double threshold : {30.0, 68.0, 400.0}) {
    const std::vector<Point> points = make.box(100'000, {0, 0, 0}, {4000, 4000, 4000});
    const auto one = find_at_risk(points, {threshold, false, 1});
    ASSERT_TRUE(one.has_value());
    for (unsigned threads = 2; threads <= 8; ++threads) {
      EXPECT_EQ(*find_at_risk(points, {threshold, false, threads}), *one) << threads;
    }
  }
}

TEST(AtRisk, EqualsBruteForceOnManyRandomSwarms) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    test::SceneMaker make(seed);
    const double side = make.between(1.0, 1000.0);
    const std::vector<Point> points =
        make.box(150, {-side, -side, 0.0}, {side, side, make.between(0.0, side)});
    const SearchOptions options{make.between(0.001, 0.4) * side, seed % 2 == 0, seed % 3};
    EXPECT_EQ(*find_at_risk(points, options), *brute_force::find_at_risk(points, options)) << seed;
  }
}

}  // namespace
}  // namespace beespace
