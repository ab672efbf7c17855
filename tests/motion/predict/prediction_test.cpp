// The search of predictions: for every instruction set, number of threads and length of step, bit
// for bit the brute force's answer, which is checked in fractions.
#include "motion/predict/prediction.hpp"

#include "base/pair_order.hpp"

#include "tests/motion/recorded/conflict_lists.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/mover_scenes.hpp"
#include "tests/support/own_resources.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/predict_conflicts.hpp>

#include <gtest/gtest.h>

#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace beespace::motion {
namespace {

using test::Conflicts;
using test::expect_same;
using Pairs = std::vector<Pair>;

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

// What is predicted, in full and as pairs.
struct Answer {
  Status full;
  Status of_pairs;
  const Conflicts& conflicts;
  const Pairs& pairs;
};

class EveryWay {
 public:
  // Calls check(answer) for every way to predict. Answers are written over those to what was asked
  // before.
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
  Answer answer(const Way& way, const MoversView& movers, const PredictOptions& options) {
    PredictionTuning tuning;
    tuning.search.instruction_set = way.set;
    tuning.step_s = way.step_s;
    test::OwnResources& own = way.threads == 1 ? one_ : way.threads == 2 ? two_ : five_;
    own.memory.start_call();
    Status full = predict(movers, options, own.with, conflicts_, tuning);
    own.memory.start_call();
    Status of_pairs = predict_pairs(movers, options, own.with, pairs_, tuning);
    return {std::move(full), std::move(of_pairs), conflicts_, pairs_};
  }

  test::OwnResources one_{1};
  test::OwnResources two_{2};
  test::OwnResources five_{5};
  Conflicts conflicts_;
  Pairs pairs_;
};

class Scene : public testing::TestWithParam<test::MoverScene> {};

TEST_P(Scene, IsPredictedAsByBruteForceInEveryWay) {
  EveryWay ways;
  test::for_each_question([&](Shape shape, bool inclusive) {
    if (test::kSanitized && !inclusive) return;
    const PredictOptions options = GetParam().options(shape, inclusive);
    const MoversView movers = GetParam().view(shape);
    const Conflicts expected = *brute_force::predict_conflicts(movers, options);
    const Pairs expected_pairs = test::pairs_of(expected);
    ways.for_each(GetParam(), shape, options, [&](const Answer& found) {
      ASSERT_TRUE(found.full.has_value());
      expect_same(found.conflicts, expected);
      ASSERT_TRUE(found.of_pairs.has_value());
      test::expect_same(found.pairs, expected_pairs);
    });
    expect_same(*predict_conflicts(movers, options), expected);
    test::expect_same(*beespace::predict_pairs(movers, options), expected_pairs);
  });
}

TEST_P(Scene, IsJudgedByBruteForceAsByFractions) {
  const test::MoverScene& scene = GetParam();
  const std::vector<Mover>& movers = scene.movers;
  // Fractions check only samples: of the pairs without conflict, and of the conflicts of a crowd.
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

// One conflict more than allowed is an error for every variant; as many as allowed are none,
// however often steps find the same pair.
TEST_P(Scene, HasItsResultsCountedInEveryWay) {
  EveryWay ways;
  for (const Shape shape : {Shape::kSphere, Shape::kCylinder, Shape::kHeightsApart}) {
    if (test::kSanitized && shape != Shape::kSphere) continue;
    PredictOptions options = GetParam().options(shape, true);
    const MoversView movers = GetParam().view(shape);
    const std::size_t all = brute_force::predict_conflicts(movers, options).value().size();
    options.max_results = all;
    ways.for_each(GetParam(), shape, options, [&](const Answer& found) {
      ASSERT_TRUE(found.full.has_value());
      ASSERT_EQ(found.conflicts.size(), all);
      ASSERT_TRUE(found.of_pairs.has_value());
      ASSERT_EQ(found.pairs.size(), all);
    });
    ASSERT_TRUE(brute_force::predict_conflicts(movers, options).has_value());
    if (all == 0) continue;
    --options.max_results;
    ways.for_each(GetParam(), shape, options, [](const Answer& found) {
      ASSERT_FALSE(found.full.has_value());
      ASSERT_EQ(found.full.error().code, ErrorCode::kTooManyResults);
      ASSERT_FALSE(found.of_pairs.has_value());
      ASSERT_EQ(found.of_pairs.error().code, ErrorCode::kTooManyResults);
    });
    const auto brute = brute_force::predict_conflicts(movers, options);
    ASSERT_FALSE(brute.has_value());
    EXPECT_EQ(brute.error().code, ErrorCode::kTooManyResults);
  }
}

INSTANTIATE_TEST_SUITE_P(Predicted, Scene, testing::ValuesIn(test::mover_scenes()),
                         [](const auto& instance) { return instance.param.name; });

// More pairs than fit into a chunk of those found, in one step and in many.
TEST(ManyPairs, ArePredictedAsByBruteForceInEveryWay) {
  if (test::kSanitized) GTEST_SKIP() << "scenes are cut short here";
  test::SceneMaker make(77);
  EveryWay ways;
  for (const Shape shape : {Shape::kSphere, Shape::kCylinder}) {
    const test::MoverScene scene{"", test::flying(make, 400, {110, 110, 110}, 12.0), 100, 80, 2};
    const PredictOptions options = scene.options(shape, false);
    const Conflicts expected = *brute_force::predict_conflicts(scene.movers, options);
    EXPECT_GT(expected.size(), core::kFirstChunk + core::kFirstChunk / 2);
    const Pairs expected_pairs = test::pairs_of(expected);
    ways.for_each(scene, shape, options, [&](const Answer& found) {
      ASSERT_TRUE(found.full.has_value());
      expect_same(found.conflicts, expected);
      ASSERT_TRUE(found.of_pairs.has_value());
      test::expect_same(found.pairs, expected_pairs);
    });
  }
}

// Head-on pairs that are at the threshold at the horizon or at the end of a step, and farthest
// apart in its middle; along a line so long that a unit of the grid is a large part of the reach.
TEST(HeadOnPairs, AreFoundAtTheVeryEndOfTheReach) {
  constexpr double kSpeed = 8.0;
  for (const double length : {1e4, 1e6, 3e7}) {
    for (const double short_of : {0.0, 1e-12, 1e-9}) {
      test::SceneMaker make(78);
      test::MoverScene scene{"", {}, 2.0, 2.0, 1.0};
      for (int i = 0; i < (test::kSanitized ? 30 : 200); ++i) {
        const Point at{make.between(0, length), make.between(0, 90), make.between(0, 90)};
        const double share = i % 4 == 0 ? 1.0 / 30.0 : 1.0;  // of the horizon
        const double apart = (2.0 + 2.0 * kSpeed * share) * (1.0 - short_of);
        scene.movers.push_back({at, {kSpeed, 0, 0}});
        scene.movers.push_back({{at.x + apart, at.y, at.z}, {-kSpeed, 0, 0}});
      }
      const PredictOptions options = scene.options(Shape::kSphere, true);
      const Conflicts expected = *brute_force::predict_conflicts(scene.movers, options);
      EXPECT_GT(expected.size(), scene.movers.size() / 8);
      EveryWay ways;
      ways.for_each(scene, Shape::kSphere, options, [&](const Answer& found) {
        ASSERT_TRUE(found.full.has_value());
        expect_same(found.conflicts, expected);
        ASSERT_TRUE(found.of_pairs.has_value());
        test::expect_same(found.pairs, test::pairs_of(expected));
      });
    }
  }
}

// The fastest mover is in the share of the first worker, or of the last.
TEST(OneFastMover, IsPredictedAsByBruteForceWhereverItIs) {
  test::SceneMaker make(80);
  test::MoverScene scene{"", test::flying(make, 60, {900, 20, 20}, 0.0), 15, 10, 2};
  for (const std::size_t place : {std::size_t{0}, std::size_t{30}, std::size_t{59}}) {
    test::MoverScene with_one = scene;
    with_one.movers[place] = {{0, 10, 10}, {450, 0, 0}};
    const PredictOptions options = with_one.options(Shape::kSphere, false);
    const Conflicts expected = *brute_force::predict_conflicts(with_one.movers, options);
    EXPECT_GT(expected.size(), 20U);
    EveryWay ways;
    ways.for_each(with_one, Shape::kSphere, options, [&](const Answer& found) {
      ASSERT_TRUE(found.full.has_value());
      expect_same(found.conflicts, expected);
      ASSERT_TRUE(found.of_pairs.has_value());
      test::expect_same(found.pairs, test::pairs_of(expected));
    });
  }
}

// A few movers are so fast that a grid for them would have all others in a few cells. They are
// compared with all others one by one instead, and with each other.
TEST(SomeFastMovers, ArePredictedAsByBruteForce) {
  test::SceneMaker make(81);
  const std::size_t size = test::kSanitized ? 300 : 1500;
  test::MoverScene scene{"", test::flying(make, size, {400, 400, 400}, 4.0), 8, 6, 5};
  for (const std::size_t place : {std::size_t{0}, std::size_t{7}, size / 2, size - 1}) {
    scene.movers[place].velocity = {3000.0, place == 7 ? -2000.0 : 1.0, 5.0};
  }
  scene.movers[8] = scene.movers[7];  // two of them fly together
  scene.movers[8].position.z += 3.0;
  const PredictOptions options = scene.options(Shape::kSphere, false);
  const Conflicts expected = *brute_force::predict_conflicts(scene.movers, options);
  EXPECT_GT(expected.size(), test::kSanitized ? 3U : 20U);
  EveryWay ways;
  ways.for_each(scene, Shape::kSphere, options, [&](const Answer& found) {
    ASSERT_TRUE(found.full.has_value());
    expect_same(found.conflicts, expected);
    ASSERT_TRUE(found.of_pairs.has_value());
    test::expect_same(found.pairs, test::pairs_of(expected));
  });
}

// Places along the way are rounded to a hundredth of a length of the lattice, on one axis.
TEST(FineLattice, IsPredictedAsByBruteForceFarAwayOnAnyAxis) {
  for (const Point& far : {Point{1e9 + 0.375, 0, 0}, Point{0, -1e9, 0}, Point{0, 0, 1e9}}) {
    test::SceneMaker make(79);
    const std::size_t size = test::kSanitized ? 50 : 140;
    const test::MoverScene scene{"", test::lattice_flight(make, size, 0x1p-16, far), 0x3p-16,
                                 0x2p-16, 2.5};
    EveryWay ways;
    for (const bool inclusive : {false, true}) {
      const PredictOptions options = scene.options(Shape::kSphere, inclusive);
      const Conflicts expected = *brute_force::predict_conflicts(scene.movers, options);
      EXPECT_GT(expected.size(), test::kSanitized ? size / 2 : size);
      ways.for_each(scene, Shape::kSphere, options, [&](const Answer& found) {
        ASSERT_TRUE(found.full.has_value());
        expect_same(found.conflicts, expected);
        ASSERT_TRUE(found.of_pairs.has_value());
        test::expect_same(found.pairs, test::pairs_of(expected));
      });
    }
  }
}

// The comparisons above mean little if hardly any movers meet, or if all of them do.
TEST(MoverScenes, HaveConflictsAndPairsWithoutAndManyAtTheEdge) {
  if (test::kSanitized) GTEST_SKIP() << "scenes are cut short here";
  std::size_t at_the_edge = 0;
  std::size_t with_heights_apart = 0;
  for (const test::MoverScene& scene : test::mover_scenes()) {
    if (scene.movers.size() < 3) continue;
    SCOPED_TRACE(scene.name);
    const auto count = [&](Shape shape, bool inclusive) {
      return brute_force::predict_conflicts(scene.view(shape), scene.options(shape, inclusive))
          .value()
          .size();
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
