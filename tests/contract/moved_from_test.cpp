// What has been moved from can be destroyed and assigned to, and what was moved to goes on.
#include <beespace/beespace.hpp>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace beespace {
namespace {

const std::vector<Point> kPoints = {{0, 0, 0}, {1, 0, 0}, {50, 0, 0}};

// Moves back and forth; each object that was left behind is destroyed or assigned to. `works` asks
// something of an object and compares the answer.
template <class Object, class Make, class Works>
void expect_moves(Make&& make, Works&& works) {
  Object first = make();
  works(first);
  Object second = std::move(first);
  works(second);
  first = std::move(second);  // to one that was moved from
  works(first);
  second = make();  // likewise, by a new one
  works(second);
  Object third = std::move(second);
  second = std::move(third);
  Object fourth = std::move(third);  // of one that was moved from
  fourth = std::move(second);
  works(fourth);
  third = std::move(first);
  works(third);
  std::vector<Object> many;
  for (int i = 0; i < 5; ++i) many.push_back(make());  // moves as it grows
  for (Object& each : many) works(each);
}

TEST(MovedFrom, EngineIsSafeToDestroyAndAssign) {
  expect_moves<Engine>([] { return Engine(); },
                       [](Engine& engine) {
                         std::vector<PointId> at_risk;
                         ASSERT_TRUE(engine.find_at_risk(kPoints, {.threshold_m = 2.0}, at_risk));
                         EXPECT_EQ(at_risk, (std::vector<PointId>{0, 1}));
                       });
}

TEST(MovedFrom, IndexIsSafeToDestroyAndAssign) {
  expect_moves<Index>([] { return Index::build(kPoints).value(); },
                      [](Index& index) {
                        const auto near = index.k_nearest({49, 0, 0}, 1);
                        ASSERT_TRUE(near);
                        ASSERT_EQ(near->size(), 1U);
                        EXPECT_EQ(near->front().id, 2U);
                      });
}

TEST(MovedFrom, AdviserIsSafeToDestroyAndAssign) {
  expect_moves<Adviser>([] { return Adviser(); },
                        [](Adviser& adviser) {
                          const std::vector<Mover> movers = {{{0, 0, 0}, {}}, {{90, 0, 0}, {}}};
                          const std::vector<Velocity> preferred = {{1, 0, 0}, {0, 1, 0}};
                          const std::vector<FlightLimits> limits = {{}};
                          Advised advised;
                          ASSERT_TRUE(adviser.advise(movers, preferred, limits,
                                                     {.threshold_m = 2.0, .step_s = 1.0}, advised));
                          ASSERT_EQ(advised.advice.size(), 2U);
                          EXPECT_EQ(advised.advice[0].velocity, preferred[0]);
                        });
}

TEST(MovedFrom, SwarmIsSafeToDestroyAndAssign) {
  expect_moves<Swarm>([] { return Swarm({.threshold_m = 2.0}); },
                      [](Swarm& swarm) {
                        ASSERT_TRUE(swarm.update({.id = 7, .time_s = 0, .position = {1, 2, 3}}));
                        ASSERT_EQ(swarm.movers(0.0).size(), 1U);
                        EXPECT_EQ(swarm.movers(0.0).front().id, 7U);
                      });
}

TEST(MovedFrom, VerifierIsSafeToDestroyAndAssign) {
  expect_moves<Verifier>([] { return Verifier({.threshold_m = 2.0}); },
                         [](Verifier& verifier) {
                           static double time_s = 0.0;
                           const std::vector<Mover> movers = {{{0, 0, 0}, {}}, {{1, 0, 0}, {}}};
                           ASSERT_TRUE(verifier.add(time_s += 1.0, movers));
                           ASSERT_TRUE(verifier.add(time_s += 1.0, movers));
                           EXPECT_FALSE(verifier.verdict().holds());
                         });
}

TEST(MovedFrom, ResultIsSafeToDestroyAndAssign) {
  expect_moves<Result<std::vector<int>>>(
      [] {
        return Result<std::vector<int>>(std::vector<int>{1, 2});
      },
      [](const Result<std::vector<int>>& result) {
        ASSERT_TRUE(result);
        EXPECT_EQ(*result, (std::vector<int>{1, 2}));
      });
  expect_moves<Result<std::vector<int>>>(
      [] {
        return Result<std::vector<int>>(Error{ErrorCode::kInvalidArgument, "why", {}});
      },
      [](const Result<std::vector<int>>& result) {
        ASSERT_FALSE(result);
        EXPECT_EQ(result.error().message, "why");
      });
}

}  // namespace
}  // namespace beespace
