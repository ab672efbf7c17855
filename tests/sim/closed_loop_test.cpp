// The closed loop: all agents arrive and none loses separation; without advice they do lose it.
#include "sim/closed_loop.hpp"

#include "tests/support/rounds.hpp"

#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::sim {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Outcome {
  Verdict verdict;
  std::size_t bees = 0;
  std::size_t arrived = 0;
  double path_ratio = 0.0;  // of all that arrived: flown by straight
};

// As many steps as are needed, `most` at most.
Outcome fly(const scenes::Mission& mission, const LoopOptions& options, int most) {
  VerifyOptions verify;
  verify.threshold_m = options.advice.threshold_m;
  verify.max_speed_mps = options.limits.max_speed_mps;
  verify.max_acceleration_mps2 = options.limits.max_acceleration_mps2;
  verify.straight = std::isinf(options.limits.max_acceleration_mps2);
  Verifier verifier(verify);
  ClosedLoop loop(mission, options);
  EXPECT_TRUE(verifier.add(loop.time_s(), loop.movers()));
  for (int step = 0; step < most && loop.arrived() < mission.starts.size(); ++step) {
    const Status flown = loop.step();
    EXPECT_TRUE(flown) << flown.error().message;
    const Status added = verifier.add(loop.time_s(), loop.movers());
    EXPECT_TRUE(added) << added.error().message;
    if (!flown || !added) break;
  }
  double flown_m = 0.0;
  double shortest_m = 0.0;
  for (const Flight& flight : loop.flights()) {
    if (!flight.arrived_s) continue;
    flown_m += flight.flown_m;
    shortest_m += flight.shortest_m;
  }
  return {verifier.verdict(), mission.starts.size(), loop.arrived(), flown_m / shortest_m};
}

LoopOptions options_of(Method method, double acceleration) {
  LoopOptions options;
  options.method = method;
  options.limits = {10.0, acceleration};
  options.advice.threshold_m = 5.0;
  options.advice.step_s = 0.1;
  return options;
}

void expect_all_arrive(const Outcome& outcome) {
  EXPECT_EQ(outcome.verdict.losses, 0U);
  EXPECT_EQ(outcome.verdict.breaches, 0U);
  EXPECT_EQ(outcome.arrived, outcome.bees);
}

class Acceleration : public testing::TestWithParam<double> {};

INSTANTIATE_TEST_SUITE_P(ClosedLoop, Acceleration, testing::Values(kInfinity, 5.0),
                         [](const auto& limit) {
                           return std::string(std::isinf(limit.param) ? "AtOnce" : "Limited");
                         });

TEST_P(Acceleration, ARandomSwapArrivesOnNearlyStraightWays) {
  const scenes::Mission mission = scenes::random_swap(test::kSanitized ? 60 : 500, 15.0, 5.5, 1);
  const Outcome outcome = fly(mission, options_of(Method::kCertified, GetParam()), 600);
  expect_all_arrive(outcome);
  EXPECT_GE(outcome.path_ratio, 0.99);
  EXPECT_LT(outcome.path_ratio, 1.1);
  const Outcome careless = fly(mission, options_of(Method::kNone, GetParam()), 600);
  EXPECT_GT(careless.verdict.losses, 0U);
  EXPECT_EQ(careless.verdict.breaches, 0U);
}

TEST_P(Acceleration, ASphereSwapArrives) {
  const scenes::Mission mission = scenes::antipodal_swap(test::kSanitized ? 25 : 200, 15.0, 5.5, 1);
  expect_all_arrive(fly(mission, options_of(Method::kCertified, GetParam()), 1500));
  const Outcome careless = fly(mission, options_of(Method::kNone, GetParam()), 1500);
  EXPECT_GT(careless.verdict.losses, 0U);
  EXPECT_EQ(careless.verdict.breaches, 0U);
}

TEST_P(Acceleration, TwoAgentsHeadOnBothArrive) {
  for (const double distance_m : {20.0, 60.0, 61.7, 200.0}) {
    const scenes::Mission mission = scenes::head_on(distance_m);
    expect_all_arrive(fly(mission, options_of(Method::kCertified, GetParam()), 1000));
    EXPECT_GT(fly(mission, options_of(Method::kNone, GetParam()), 1000).verdict.losses, 0U);
  }
}

// An agent that has arrived may stay for ever.
TEST_P(Acceleration, AnAgentThatHasArrivedGoesOnStanding) {
  const LoopOptions options = options_of(Method::kCertified, GetParam());
  ClosedLoop loop(scenes::head_on(30.0), options);
  for (int step = 0; step < 2'000; ++step) {
    const Status flown = loop.step();
    ASSERT_TRUE(flown) << "step " << step << ": " << flown.error().message;
  }
  EXPECT_EQ(loop.arrived(), 2U);
  EXPECT_NEAR(loop.movers()[0].position.x, 30.0, 1e-6);
  EXPECT_NEAR(loop.movers()[1].position.x, 0.0, 1e-6);
  EXPECT_NEAR(loop.time_s(), 200.0, 1e-9);
}

TEST(ClosedLoop, RecordsTheFlightOfEachAgent) {
  const LoopOptions options = options_of(Method::kCertified, kInfinity);
  // One with 40 m to go, and one that is there.
  ClosedLoop loop({{{0, 0, 0}, {0, 100, 0}}, {{40, 0, 0}, {0.5, 100, 0}}}, options);
  EXPECT_EQ(loop.arrived(), 1U);
  EXPECT_EQ(loop.flights()[1].arrived_s, 0.0);
  EXPECT_EQ(loop.flights()[0].shortest_m, 40.0);
  for (int step = 0; step < 60; ++step) ASSERT_TRUE(loop.step());
  EXPECT_EQ(loop.arrived(), 2U);
  EXPECT_NEAR(loop.flights()[0].arrived_s.value(), 3.9, 0.11);
  EXPECT_NEAR(loop.flights()[0].flown_m, 40.0, 1e-9);
  EXPECT_EQ(loop.flights()[0].stuck_s, 0.0);
  EXPECT_EQ(loop.advised().advice.size(), 2U);
  EXPECT_GT(loop.advising_s(), 0.0);
}

TEST(ClosedLoop, ReturnsTheErrorsOfAdvise) {
  LoopOptions options = options_of(Method::kCertified, kInfinity);
  options.advice.threshold_m = -1.0;
  ClosedLoop loop(scenes::head_on(30.0), options);
  const Status refused = loop.step();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidThreshold);
}

}  // namespace
}  // namespace beespace::sim
