// Fences, planar motion, agents that hold, and planes that are remembered.
#include "tests/avoidance/claimed_flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::ClaimedFlock;

TEST(Fences, AreKeptWithClearanceAndTube) {
  ClaimedFlock flock;
  flock.limits = {10.0, 5.0};
  flock.options.threshold_m = 1.0;
  flock.options.clearance_m = 0.5;
  const std::vector<Fence> fences = {{{1.0, 0.0, 0.0}, -20.0},
                                     {{-0.6, 0.8, 0.0}, -20.0},
                                     {{0.0, -1.0, 0.0}, -20.0},
                                     {{0.0, 0.0, 1.0}, -5.0},
                                     {{0.0, 0.0, -1.0}, -5.0}};
  flock.options.fences = fences;
  for (int k = 0; k < 6; ++k) flock.add({3.0 * k - 7.0, 0.0, 0.0}, 2, {.tube_m = 0.3});
  RandomStream random(5);
  Adviser adviser;
  Advised advised;
  std::vector<Velocity> wishes(6);
  double least = 1e9;
  for (int tick = 0; tick < test::rounds(2000); ++tick) {
    for (Velocity& wish : wishes) {
      if (random.index(40) == 0) wish = test::random_velocity(random, 15.0);
    }
    flock.prepare();
    ASSERT_TRUE(adviser.advise(flock.movers, wishes, {&flock.limits, 1}, flock.options, advised));
    ASSERT_TRUE(advised.near_fence.empty() && test::all_keep_apart(advised)) << "tick " << tick;
    flock.advance(advised.advice, random);
    for (const auto& agent : flock.agents) {
      const Point& p = agent.path.states.front().position;
      for (const Fence& fence : fences) {
        const auto& n = fence.inward;
        least = std::min(least, n.x * p.x + n.y * p.y + n.z * p.z - fence.offset_m);
      }
    }
  }
  EXPECT_GE(least, 0.8);
  EXPECT_LT(least, 0.9);
}

// One that is too close already is named, and comes back.
TEST(Fences, OneOutsideIsNamedAndComesBack) {
  const std::vector<Fence> fences = {{{1.0, 0.0, 0.0}, 0.0}};
  std::vector<Mover> movers = {{{-3.0, 0.0, 0.0}, {}}};
  AdviseOptions options{.threshold_m = 5.0, .fences = fences, .clearance_m = 1.0};
  const std::vector<FlightLimits> limits = {{5.0, 5.0}};
  for (int step = 0; step < 100; ++step) {
    const auto advised = advise(movers, std::vector<Velocity>(1), limits, options);
    ASSERT_TRUE(advised);
    if (step == 0) {
      EXPECT_EQ(advised->near_fence, (std::vector<NearFence>{{0, 0, -3.0}}));
      EXPECT_FALSE(advised->advice[0].keeps_apart);
    }
    movers[0] = test::flown(movers[0], advised->advice[0].velocity, false, options.step_s);
  }
  EXPECT_GE(movers[0].position.x, 0.999);
}

TEST(Fences, ThatCannotBeUsedAreErrors) {
  const std::vector<Mover> movers(1);
  const auto refused = [&](const Fence& fence, double clearance_m) {
    const std::vector<Fence> fences = {{}, fence};
    AdviseOptions options{.threshold_m = 5.0, .fences = fences, .clearance_m = clearance_m};
    const auto advised =
        advise(movers, std::vector<Velocity>(1), std::vector<FlightLimits>(1), options);
    return advised ? std::string() : advised.error().message;
  };
  EXPECT_EQ(refused({{0, 0, 1}, 0.0}, 1.0), "");
  EXPECT_EQ(refused({{0, 0, 2}, 0.0}, 1.0),
            "fence 1: the direction inwards is of length 2; give one of length 1");
  EXPECT_NE(refused({{0, 0, 1}, std::nan("")}, 1.0), "");
  EXPECT_NE(refused({{0, 0, std::nan("")}, 0.0}, 1.0), "");
  EXPECT_EQ(refused({{0, 0, 1}, 0.0}, std::nan("")),
            "there are fences, and the clearance from them is not given (or is not a number); say "
            "in metres how close is too close");
}

TEST(Planar, VelocitiesAreHorizontalAndOneOfAnotherHeightIsRefused) {
  std::vector<Mover> movers = {
      {{0, 0, 2}, {1, 0, 0}}, {{9, 0, 2}, {-1, 0, 0}}, {{40, 0, 3}, {}}, {{60, 0, 2}, {0, 0, 1}}};
  AdviseOptions options{.threshold_m = 5.0, .planar = true};
  const std::vector<Velocity> wishes = {{5, 0, 3}, {-5, 0, -3}, {}, {}};
  const auto advised = advise(movers, wishes, std::vector<FlightLimits>{{5.0, 5.0}}, options);
  ASSERT_TRUE(advised);
  ASSERT_EQ(advised->refused.size(), 2U);
  EXPECT_EQ(advised->refused[0].index, 2U);
  EXPECT_EQ(advised->refused[0].error.message,
            "the motion is planar, and the height is 3 m where most have 2 m; give all the same "
            "height");
  EXPECT_EQ(advised->refused[1].error.message,
            "the motion is planar, and the vertical velocity is 1 m/s; give 0");
  for (const PointId bee : {0U, 1U}) EXPECT_EQ(advised->advice[bee].velocity.z, 0.0);
}

// The other one gets all of the free space.
TEST(Holds, OneThatHoldsBrakesAndLeavesTheFreeSpaceToOthers) {
  const std::vector<Mover> movers = {{{0, 0, 0}, {}}, {{8, 0, 0}, {}}};
  std::vector<Claim> claims(2);
  AdviseOptions options{.threshold_m = 5.0, .step_s = 1.0, .claims = claims};
  const std::vector<Velocity> wishes = {{10, 0, 0}, {-10, 0, 0}};
  const std::vector<FlightLimits> limits = {{10.0, test::kNoLimit}};
  const auto both = advise(movers, wishes, limits, options);
  claims[1].holds = true;
  const auto one = advise(movers, wishes, limits, options);
  ASSERT_TRUE(both && one);
  EXPECT_NEAR(both->advice[0].velocity.x, 1.5, 1e-3);
  EXPECT_NEAR(one->advice[0].velocity.x, 3.0, 1e-3);
  EXPECT_EQ(one->advice[1].kind, AdviceKind::kBraking);
  EXPECT_TRUE(test::all_certified(*one));
}

// docs/prevention.md: the direction of the closest points certifies no ellipsoid here.
TEST(Shapes, AnEllipsoidIsCertifiedWhereTheClosestPointsDoNotDoIt) {
  const std::vector<Mover> movers = {{{4.9, 0, 9}, {}}, {{0, 0, 0}, {}}};
  AdviseOptions options{.threshold_m = 5.0, .separation = {SeparationShape::kEllipsoid, 3.0}};
  const std::vector<FlightLimits> limits = {{10.0, 5.0}};
  const auto advised = advise(movers, std::vector<Velocity>(2), limits, options);
  ASSERT_TRUE(advised);
  EXPECT_TRUE(test::all_certified(*advised));
  // The horizontal semi-axis at which the two touch: sqrt(4.9^2 + 3^2) = 5.745.
  options.threshold_m = 5.74;
  EXPECT_TRUE(test::all_certified(*advise(movers, std::vector<Velocity>(2), limits, options)));
  options.threshold_m = 5.75;
  EXPECT_FALSE(test::all_certified(*advise(movers, std::vector<Velocity>(2), limits, options)));
}

}  // namespace
}  // namespace beespace
