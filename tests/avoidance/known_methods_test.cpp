// The methods to compare with keep limits, certify no bee, and do what they are known for.
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

class KnownMethod : public testing::TestWithParam<AdviseMethod> {};

INSTANTIATE_TEST_SUITE_P(Advise, KnownMethod,
                         testing::Values(AdviseMethod::kOrca, AdviseMethod::kMvp),
                         [](const auto& method) {
                           return std::string(method.param == AdviseMethod::kOrca ? "Orca" : "Mvp");
                         });

void expect_no_promises(const Advised& advised) {
  for (const Advice& advice : advised.advice) {
    ASSERT_FALSE(advice.certified);
    ASSERT_TRUE(advice.kind == AdviceKind::kAsPreferred || advice.kind == AdviceKind::kDeflected);
  }
  EXPECT_TRUE(advised.too_close.empty());
  EXPECT_TRUE(advised.near_obstacle.empty());
}

TEST_P(KnownMethod, KeepsLimitsAndPromisesNothing) {
  for (int start = 0; start < (test::kSanitized ? 3 : 20); ++start) {
    const std::uint64_t seed = 9000U + static_cast<unsigned>(start);
    SCOPED_TRACE("start " + std::to_string(seed));
    Flock flock = test::random_flock(24, seed);
    flock.options.method = GetParam();
    // Some bees are in conflict, two at one place.
    flock.movers[1].position = flock.movers[0].position;
    RandomStream random(seed);
    Adviser adviser;
    Advised advised;
    for (int step = 0; step < 40; ++step) {
      std::vector<Velocity> wishes;
      for (const FlightLimits& limits : flock.limits) {
        wishes.push_back(test::random_velocity(random, 3.0 * limits.max_speed_mps));
      }
      flock.options.threads = 1 + static_cast<unsigned>(step % 4);
      const auto alone = advise(flock.movers, wishes, flock.limits, flock.options);
      ASSERT_TRUE(alone);
      // fly_a_step() checks the limits.
      test::fly_a_step(flock, adviser, wishes, advised);
      EXPECT_EQ(advised.advice, alone->advice);
      ASSERT_NO_FATAL_FAILURE(expect_no_promises(advised));
    }
    if (HasFailure()) return;
  }
}

TEST_P(KnownMethod, ThreadsDoNotChangeTheAnswer) {
  RandomStream random(3);
  Flock flock;
  for (int i = 0; i < 17'000; ++i) {
    const auto at = [&] { return random.uniform(0.0, 300.0); };
    flock.movers.push_back({{at(), at(), at()}, test::random_velocity(random, 5.0)});
  }
  flock.limits = {{10.0, 20.0}};
  flock.options.method = GetParam();
  const std::vector<Velocity> wishes(flock.size(), Velocity{3, 4, 0});
  const auto alone = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(alone);
  for (const unsigned threads : {2U, 3U, 4U}) {
    flock.options.threads = threads;
    const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
    ASSERT_TRUE(advised);
    EXPECT_EQ(advised->advice, alone->advice);
  }
}

TEST_P(KnownMethod, ABeeThatIsAloneGetsItsWish) {
  Flock flock;
  flock.options.method = GetParam();
  flock.limits.assign(2, {10.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {}}, {{500, 0, 0}, {}}};
  const std::vector<Velocity> wishes = {{3, 0, 0}, {0, 4, 0}};
  const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  EXPECT_EQ(advised->advice[0], (Advice{{3, 0, 0}, AdviceKind::kAsPreferred, false}));
  EXPECT_EQ(advised->advice[1], (Advice{{0, 4, 0}, AdviceKind::kAsPreferred, false}));
}

// Bees swap places, each flying straight at its goal: the closest distance of any two. All arrive.
double closest_in_swap(Flock flock, AdviseMethod method, int steps) {
  flock.options.method = method;
  std::vector<Point> goals;
  for (const Mover& mover : flock.movers) {
    const auto& [x, y, z] = mover.position;
    goals.push_back({-x, -y, z});
  }
  Adviser adviser;
  Advised advised;
  double closest_m = test::kNoLimit;
  for (int step = 0; step < steps; ++step) {
    std::vector<Velocity> wishes;
    for (std::size_t bee = 0; bee < flock.size(); ++bee) {
      wishes.push_back(*velocity_to_goal(flock.movers[bee].position, goals[bee], flock.limits[bee],
                                         flock.options.step_s));
    }
    const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
    closest_m = std::min(closest_m, verdict.closest_m.value_or(test::kNoLimit));
  }
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    EXPECT_LT(test::distance_of(flock.movers[bee].position, goals[bee]), 1.0) << "bee " << bee;
  }
  return closest_m;
}

// Not exactly on a ring: there some would wait for each other for ever.
Flock ring(std::size_t count, double radius_m, double acceleration) {
  RandomStream random(4);
  Flock flock;
  flock.limits.assign(count, {10.0, acceleration});
  for (std::size_t bee = 0; bee < count; ++bee) {
    const double turn = 6.283185307179586 * static_cast<double>(bee) / static_cast<double>(count);
    const auto at = [&](double middle) { return middle + random.uniform(-3.0, 3.0); };
    flock.movers.push_back(
        {{at(radius_m * std::cos(turn)), at(radius_m * std::sin(turn)), at(0.0)}, {}});
  }
  return flock;
}

TEST_P(KnownMethod, TwoHeadOnPassEachOther) {
  for (const double acceleration : {test::kNoLimit, 5.0}) {
    const double closest_m = closest_in_swap(ring(2, 40.0, acceleration), GetParam(), 400);
    EXPECT_GT(closest_m, GetParam() == AdviseMethod::kOrca ? 4.9 : 4.0) << acceleration;
  }
}

TEST_P(KnownMethod, ASmallSwapLosesLittle) {
  for (const double acceleration : {test::kNoLimit, 5.0}) {
    const double closest_m = closest_in_swap(ring(5, 40.0, acceleration), GetParam(), 600);
    EXPECT_GT(closest_m, GetParam() == AdviseMethod::kOrca ? 4.0 : 1.5) << acceleration;
  }
}

// Two bees fly straight at each other. Each is told to turn right, by as much as is missing when
// they meet.
TEST_P(KnownMethod, HeadOnEachGoesSideways) {
  Flock flock;
  flock.options.method = GetParam();
  flock.limits.assign(2, {10.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {8, 0, 0}}, {{20, 0, 0}, {-8, 0, 0}}};
  const std::vector<Velocity> wishes = {{8, 0, 0}, {-8, 0, 0}};
  const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  const Velocity& first = advised->advice[0].velocity;
  const Velocity& second = advised->advice[1].velocity;
  EXPECT_LT(first.y, -0.5);
  EXPECT_GT(second.y, 0.5);
  EXPECT_NEAR(first.y, -second.y, 1e-9);
  EXPECT_GT(first.x, 6.0);
  if (GetParam() == AdviseMethod::kMvp) {
    // They meet in 1.25 s; 5 m are missing.
    EXPECT_NEAR(first.y, -4.0, 1e-5);
    EXPECT_NEAR(first.x, 8.0, 1e-12);
  } else {
    // Out of a cone of a sine of 5 / 20, from its axis at 16 m/s: 4 m/s, of which each takes half.
    EXPECT_NEAR(first.x, 8.0 - 2.0 * 0.25, 1e-5);
    EXPECT_NEAR(first.y, -2.0 * std::sqrt(1.0 - 0.25 * 0.25), 1e-5);
  }
}

// A bee that would have to exceed its greatest speed turns as far as it can.
TEST(KnownMethods, OrcaStaysWithinWhatABeeCanFly) {
  Flock flock;
  flock.options.method = AdviseMethod::kOrca;
  flock.limits.assign(2, {8.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {8, 0, 0}}, {{0, -12, 0}, {7.9, 6, 0}}};
  const std::vector<Velocity> wishes = {{8, 0, 0}, {7.9, 6, 0}};
  const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  EXPECT_GT(advised->advice[0].velocity.y, 2.0);
  EXPECT_NEAR(test::length_of(advised->advice[0].velocity), 8.0, 0.1);
}

// These methods ignore obstacles and intruders. Conflicts with intruders are reported all the same.
TEST_P(KnownMethod, KnowsNothingOfObstaclesAndIntruders) {
  Flock flock;
  flock.options.method = GetParam();
  flock.limits.assign(1, {10.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {}}};
  const auto map = ObstacleMap::of({Ground{1.0}, Box{{3, -9, -9}, {4, 9, 9}}});
  ASSERT_TRUE(map);
  const std::vector<Mover> intruders = {{{50, 0, 0}, {-10, 0, 0}}};
  flock.options.obstacles = &*map;
  flock.options.intruders = intruders;
  const std::vector<Velocity> wishes = {{9, 0, 0}};
  const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  EXPECT_EQ(advised->advice[0].velocity, wishes[0]);
  EXPECT_TRUE(advised->near_obstacle.empty());
  EXPECT_EQ(advised->intruder_conflicts.size(), 1U);
}

}  // namespace
}  // namespace beespace
