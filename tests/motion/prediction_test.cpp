// The search of predictions: for every instruction set, number of threads and length of step, bit
// for bit what brute force says, which says what fractions say.
#include "motion/prediction.hpp"

#include "tests/motion/conflict_lists.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/mover_scenes.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <sstream>

namespace beespace::motion {
namespace {

using test::Conflicts;
using test::expect_same;

// One way to run the search.
struct Way {
  cpu::InstructionSet set;
  unsigned threads;
  std::optional<double> step_s;
};

std::string name_of(const Way& way) {
  std::ostringstream name;
  name << cpu::name_of(way.set) << ", " << way.threads << " threads, step ";
  if (way.step_s) {
    name << *way.step_s << " s";
  } else {
    name << "chosen";
  }
  return name.str();
}

// Chosen, one step for all, steps that end at the edges of encounters, and many that fit nothing.
std::vector<std::optional<double>> steps_of(const test::MoverScene& scene) {
  if (scene.horizon_s == 0.0) return {std::nullopt, 1e-9};
  const double rhythm = std::min(test::kStepOfEdges_s, scene.horizon_s / 8.0);
  if (test::kSanitized) return {std::nullopt, std::max(rhythm, scene.horizon_s / 9.0)};
  return {std::nullopt, 1e9 * scene.horizon_s, std::max(rhythm, scene.horizon_s / 30.0),
          scene.horizon_s / 41.3};
}

std::vector<cpu::InstructionSet> available_sets() {
  std::vector<cpu::InstructionSet> sets;
  for (const cpu::InstructionSet set : cpu::kInstructionSets) {
    if (cpu::is_available(set)) sets.push_back(set);
  }
  return sets;
}

using test::Shape;

class EveryWay {
 public:
  // Calls check(answer) for every way to predict.
  template <class Check>
  void for_each(const test::MoverScene& scene, Shape shape, const PredictOptions& options,
                Check&& check) {
    for (const std::optional<double>& step : steps_of(scene)) {
      for (const cpu::InstructionSet set : available_sets()) {
        for (const unsigned threads : {1U, 2U, 5U}) {
          // All kernels, all numbers of threads, and not every two of them.
          const bool often = set == cpu::best_instruction_set() && !step;
          if (threads > 1 && !often) continue;
          const Way way{set, threads, step};
          SCOPED_TRACE(name_of(way) + ", " + name_of(shape) +
                       (options.inclusive ? ", inclusive" : ", strict"));
          check(answer(way, scene.view(shape), options));
          if (testing::Test::HasFatalFailure()) return;
        }
      }
    }
  }

 private:
  Result<Conflicts> answer(const Way& way, const MoversView& movers,
                           const PredictOptions& options) {
    PredictionChoices choices;
    choices.search.instruction_set = way.set;
    choices.step_s = way.step_s;
    test::OwnResources& own = way.threads == 1 ? one_ : way.threads == 2 ? two_ : five_;
    own.memory.start_call();
    return predict(movers, options, own.with, choices);
  }

  test::OwnResources one_{1};
  test::OwnResources two_{2};
  test::OwnResources five_{5};
};

class Scene : public testing::TestWithParam<test::MoverScene> {};

TEST_P(Scene, IsPredictedAsByBruteForceInEveryWay) {
  EveryWay ways;
  test::for_each_question([&](Shape shape, bool inclusive) {
    if (test::kSanitized && !inclusive) return;
    const PredictOptions options = GetParam().options(shape, inclusive);
    const MoversView movers = GetParam().view(shape);
    const Conflicts expected = *brute_force::predict_conflicts(movers, options);
    ways.for_each(GetParam(), shape, options, [&](const Result<Conflicts>& found) {
      ASSERT_TRUE(found.has_value());
      expect_same(*found, expected);
    });
    expect_same(*predict_conflicts(movers, options), expected);
  });
}

TEST_P(Scene, IsJudgedByBruteForceAsByFractions) {
  const test::MoverScene& scene = GetParam();
  const std::vector<Mover>& movers = scene.movers;
  // Not all are asked about: of those who are said to keep apart, and of a crowd's conflicts, some.
  const std::size_t stride = test::kSanitized ? 101 : 17;
  test::for_each_question([&](Shape shape, bool inclusive) {
    const PredictOptions options = scene.options(shape, inclusive);
    const auto truly_in_conflict = [&](PointId i, PointId j) {
      if (shape != Shape::kHeightsApart) {
        return test::ExactEncounter(movers[i], movers[j], options).in_conflict();
      }
      return test::ExactEncounter(movers[i], {scene.heights_m[i], scene.climbs_mps[i]}, movers[j],
                                  {scene.heights_m[j], scene.climbs_mps[j]}, options)
          .in_conflict();
    };
    const Conflicts found = *brute_force::predict_conflicts(scene.view(shape), options);
    auto next = found.begin();
    for (PointId i = 0; i < movers.size(); ++i) {
      for (PointId j = i + 1; j < movers.size(); ++j) {
        const bool said = next != found.end() && next->first == i && next->second == j;
        if (said) ++next;
        const bool always = said && (found.size() < 2000 || (i + j) % 5 == 0);
        if (!always && (31 * i + j) % stride != 0) continue;
        ASSERT_EQ(said, truly_in_conflict(i, j)) << i << " " << j << ", " << name_of(shape);
      }
    }
    EXPECT_EQ(next, found.end()) << "out of order, or twice";
  });
}

// One more conflict than allowed is an error in every way, as many as allowed are none.
TEST_P(Scene, HasItsResultsCountedInEveryWay) {
  PredictOptions options = GetParam().options(Shape::kSphere, true);
  const std::size_t all = brute_force::predict_conflicts(GetParam().movers, options)->size();
  EveryWay ways;
  options.max_results = all;
  ways.for_each(GetParam(), Shape::kSphere, options, [&](const Result<Conflicts>& found) {
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->size(), all);
  });
  ASSERT_TRUE(brute_force::predict_conflicts(GetParam().movers, options).has_value());
  if (all == 0) return;
  --options.max_results;
  ways.for_each(GetParam(), Shape::kSphere, options, [](const Result<Conflicts>& found) {
    ASSERT_FALSE(found.has_value());
    ASSERT_EQ(found.error().code, ErrorCode::kTooManyResults);
  });
  const auto brute = brute_force::predict_conflicts(GetParam().movers, options);
  ASSERT_FALSE(brute.has_value());
  EXPECT_EQ(brute.error().code, ErrorCode::kTooManyResults);
}

INSTANTIATE_TEST_SUITE_P(Predicted, Scene, testing::ValuesIn(test::mover_scenes()),
                         [](const auto& instance) { return instance.param.name; });

// The comparisons above would be worth little if hardly anybody met, or if everybody did.
TEST(MoverScenes, HaveConflictsAndPairsWithoutAndManyAtTheEdge) {
  if (test::kSanitized) GTEST_SKIP() << "scenes are cut short here";
  std::size_t at_the_edge = 0;
  std::size_t with_heights_apart = 0;
  for (const test::MoverScene& scene : test::mover_scenes()) {
    if (scene.movers.size() < 3) continue;
    SCOPED_TRACE(scene.name);
    const auto count = [&](Shape shape, bool inclusive) {
      return brute_force::predict_conflicts(scene.view(shape), scene.options(shape, inclusive))
          ->size();
    };
    const std::size_t pairs = scene.movers.size() * (scene.movers.size() - 1) / 2;
    EXPECT_TRUE(count(Shape::kSphere, true) < pairs || scene.name == "SphereSwap" ||
                scene.name == "AllAtOnePlace");
    EXPECT_GT(count(Shape::kSphere, true), 20U);
    EXPECT_GT(count(Shape::kCylinder, true), 20U);
    with_heights_apart += count(Shape::kHeightsApart, true);
    test::for_each_question([&](Shape shape, bool inclusive) {
      if (inclusive) at_the_edge += count(shape, true) - count(shape, false);
    });
  }
  EXPECT_GT(with_heights_apart, 2000U);
  EXPECT_GT(at_the_edge, 2500U);
}

}  // namespace
}  // namespace beespace::motion
