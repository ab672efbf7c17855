// Predictions of an Engine are those of the functions of the same name, frame after frame: of any
// size, about anything, in whatever order, with threads of its own or lent ones.
#include "tests/motion/recorded/conflict_lists.hpp"
#include "tests/support/mover_scenes.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/crew.hpp>
#include <beespace/engine.hpp>
#include <beespace/predict_conflicts.hpp>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace {
namespace {

using test::Conflicts;
using test::Shape;

// Answers are written over those to another question.
struct Asked {
  Conflicts conflicts;
  std::vector<Pair> pairs;

  void expect_as_functions_say(Engine& engine, const MoversView& movers,
                               const PredictOptions& options) {
    const Conflicts expected = *predict_conflicts(movers, options);
    ASSERT_TRUE(engine.predict_pairs(movers, options, pairs));
    test::expect_same(pairs, test::pairs_of(expected));
    test::expect_same(*predict_pairs(movers, options), pairs);
    ASSERT_TRUE(engine.predict_conflicts(movers, options, conflicts));
    test::expect_same(conflicts, expected);
  }
};

TEST(PredictionEngine, AnswersAsTheFunctionsDoSceneAfterScene) {
  Engine alone;
  ThreadCrew crew(3);
  Engine lent(crew);
  Asked asked;
  for (const test::MoverScene& scene : test::mover_scenes()) {
    test::for_each_question([&](Shape shape, bool inclusive) {
      if (testing::Test::HasFatalFailure()) return;
      SCOPED_TRACE(scene.name + ", " + name_of(shape) + (inclusive ? ", inclusive" : ", strict"));
      const PredictOptions options = scene.options(shape, inclusive);
      asked.expect_as_functions_say(alone, scene.view(shape), options);
      asked.expect_as_functions_say(lent, scene.view(shape), options);
    });
  }
}

// Frames that grow and shrink, with some searches of snapshots in between.
TEST(PredictionEngine, ServesFramesOfAnySizeInTurn) {
  test::SceneMaker make(31);
  const std::size_t most = test::kSanitized ? 3000 : 30'000;
  const std::vector<Mover> movers = test::flying(make, most, {5000, 5000, 500}, 10);
  Engine engine;
  Asked asked;
  std::size_t found = 0;
  for (const std::size_t size :
       {most / 2, most, std::size_t{0}, std::size_t{3}, most / 7, most, std::size_t{1}, most / 3}) {
    for (const unsigned threads : {1U, 2U}) {
      SCOPED_TRACE(std::to_string(size) + " movers, threads: " + std::to_string(threads));
      const std::vector<Mover> some(movers.begin(),
                                    movers.begin() + static_cast<std::ptrdiff_t>(size));
      PredictOptions options = test::MoverScene{"", {}, 12, 5, 6}.options(Shape::kSphere, false);
      options.threads = threads;
      asked.expect_as_functions_say(engine, some, options);
      found += asked.pairs.size();
      options.vertical_m = 4.0;
      options.horizon_s = 0.2;
      asked.expect_as_functions_say(engine, some, options);
      const MoversView view(some);
      ASSERT_TRUE(engine.find_pairs(view.positions(), {20.0}, asked.pairs));
    }
  }
  EXPECT_GT(found, test::kSanitized ? 20U : most / 10);
}

// After an error the engine answers on.
TEST(PredictionEngine, AnswersAfterARefusal) {
  test::SceneMaker make(32);
  const std::vector<Mover> movers = test::flying(make, 300, {800, 800, 200}, 12);
  Engine engine;
  Asked asked;
  PredictOptions options = test::MoverScene{"", {}, 25, 10, 30}.options(Shape::kSphere, false);
  for (int round = 0; round < 3; ++round) {
    options.max_results = 3;
    EXPECT_FALSE(engine.predict_pairs(movers, options, asked.pairs));
    EXPECT_FALSE(engine.predict_conflicts(movers, options, asked.conflicts));
    options.max_results = PredictOptions().max_results;
    asked.expect_as_functions_say(engine, movers, options);
    EXPECT_GT(asked.pairs.size(), 20U);
  }
}

}  // namespace
}  // namespace beespace
