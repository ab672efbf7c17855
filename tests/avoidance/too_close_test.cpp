// Bees that are too close already are named, their distance does not shrink, and no other bee is
// affected.
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

// The pairs whose stopping segments are closer than the threshold, and how close they are.
std::map<Pair, double> pairs_too_close(const Flock& flock) {
  std::map<Pair, double> pairs;
  for (PointId i = 0; i < flock.size(); ++i) {
    for (PointId j = i + 1; j < flock.size(); ++j) {
      const auto apart = static_cast<double>(flock.ways_apart(i, j));
      if (apart < flock.options.threshold_m) pairs[{i, j}] = apart;
    }
  }
  return pairs;
}

// A flock in which some have lost the threshold, or are about to.
Flock flock_with_some_too_close(std::uint64_t seed) {
  Flock flock = test::random_flock(14, seed);
  RandomStream random(seed);
  const double threshold_m = flock.options.threshold_m;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    if (bee % 4 != 0) continue;
    Mover& mover = flock.movers[bee];
    if (bee % 8 == 0) {
      const auto [x, y, z] = scenes::random_direction(random);
      const Point& p = flock.movers[(bee + 1) % flock.size()].position;
      const double far = threshold_m * random.uniform(0.1, 0.9);
      mover.position = {p.x + far * x, p.y + far * y, p.z + far * z};
    } else {
      mover.velocity = test::random_velocity(random, flock.limits[bee].max_speed_mps);
    }
  }
  return flock;
}

void expect_named(const Flock& flock, const Advised& advised,
                  const std::map<Pair, double>& too_close) {
  std::vector<Pair> expected;
  std::set<PointId> not_certified;
  for (const auto& [pair, apart] : too_close) {
    expected.push_back(pair);
    not_certified.insert({pair.first, pair.second});
  }
  ASSERT_EQ(test::pairs_of(advised.too_close), expected);
  for (PointId bee = 0; bee < flock.size(); ++bee) {
    ASSERT_EQ(advised.advice[bee].certified, not_certified.count(bee) == 0) << "bee " << bee;
  }
}

// No pair is closer than its stopping segments were, and only pairs that were too close are.
void expect_no_worse(const Verdict& verdict, const std::map<Pair, double>& too_close,
                     double tolerance_m) {
  for (const Loss& loss : verdict.first_losses) {
    const auto before = too_close.find(loss.pair);
    ASSERT_NE(before, too_close.end())
        << loss.pair.first << " and " << loss.pair.second << " at " << loss.closest_m;
    ASSERT_GE(loss.closest_m, before->second - tolerance_m);
  }
}

TEST(TooClose, IsNamedGetsNoWorseAndOthersAreNotAffected) {
  int seen = 0;
  for (int start = 0; start < (test::kSanitized ? 4 : 30); ++start) {
    const auto seed = static_cast<std::uint64_t>(3000 + start);
    SCOPED_TRACE("start " + std::to_string(seed));
    Flock flock = flock_with_some_too_close(seed);
    const std::map<Pair, double> at_first = pairs_too_close(flock);
    seen += at_first.empty() ? 0 : 1;
    const double tolerance_m = 1e-6 * flock.options.threshold_m + 1e-8;
    RandomStream random(seed);
    Adviser adviser;
    Advised advised;
    std::map<Pair, double> before = at_first;
    for (int step = 0; step < 100; ++step) {
      std::vector<Velocity> wishes;
      for (const FlightLimits& limits : flock.limits) {
        wishes.push_back(test::random_velocity(random, 2.0 * limits.max_speed_mps));
      }
      const Flock asked = flock;
      const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
      if (step == 0) {
        ASSERT_NO_FATAL_FAILURE(expect_named(asked, advised, before));
      }
      ASSERT_NO_FATAL_FAILURE(expect_no_worse(verdict, before, tolerance_m)) << "step " << step;
      std::map<Pair, double> after = pairs_too_close(flock);
      for (const auto& [pair, apart] : after) {
        ASSERT_TRUE(before.count(pair) != 0) << "step " << step;
        ASSERT_GE(apart, before[pair] - tolerance_m) << "step " << step;
      }
      before = std::move(after);
    }
  }
  EXPECT_GT(seen, test::kSanitized ? 2 : 20);
}

TEST(TooClose, BeesThatPreferToSeparateDoAndAreCertifiedAgain) {
  for (const double acceleration : {test::kNoLimit, 2.0}) {
    SCOPED_TRACE(acceleration);
    Flock flock;
    flock.options.threshold_m = 5.0;
    flock.limits.assign(3, {10.0, acceleration});
    flock.movers = {{{0, 0, 0}, {}}, {{2, 0, 0}, {}}, {{100, 0, 0}, {}}};
    Adviser adviser;
    Advised advised;
    const std::vector<Velocity> wishes = {{-5, 0, 0}, {5, 0, 0}, {0, 0, 0}};
    test::fly_a_step(flock, adviser, wishes, advised);
    EXPECT_EQ(test::pairs_of(advised.too_close), (std::vector<Pair>{{0, 1}}));
    EXPECT_FALSE(advised.advice[0].certified);
    EXPECT_FALSE(advised.advice[1].certified);
    EXPECT_TRUE(advised.advice[2].certified);
    for (int step = 0; step < 100; ++step) test::fly_a_step(flock, adviser, wishes, advised);
    EXPECT_TRUE(test::all_certified(advised));
    EXPECT_GT(test::distance_of(flock.movers[0].position, flock.movers[1].position), 5.0);
  }
}

TEST(TooClose, TheThresholdIsTheLimit) {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.limits.assign(2, {10.0, test::kNoLimit});
  const auto are_certified = [&](double apart_m) {
    flock.movers = {{{0, 0, 0}, {}}, {{apart_m, 0, 0}, {}}};
    const auto advised =
        advise(flock.movers, std::vector<Velocity>(2), flock.limits, flock.options);
    EXPECT_TRUE(advised);
    return test::all_certified(*advised);
  };
  EXPECT_TRUE(are_certified(5.000001));
  EXPECT_FALSE(are_certified(4.999999));
  flock.options.uncertainty_m = 0.25;  // of each
  EXPECT_TRUE(are_certified(5.500001));
  EXPECT_FALSE(are_certified(5.499999));
}

// At one place, on one line, one behind the other: nothing is undefined, and each gets finite
// advice.
TEST(TooClose, BeesAtOnePlaceGetFiniteAdvice) {
  for (const double acceleration : {test::kNoLimit, 2.0}) {
    Flock flock;
    flock.limits.assign(6, {10.0, acceleration});
    const Mover standing{{1, 2, 3}, {}};
    const Mover flying{{1, 2, 3}, {4, 0, 0}};
    flock.movers = {
        standing, standing, flying, flying, {{1, 2, 3}, {-4, 0, 0}}, {{1, 2, 3}, {0, 4, 0}}};
    Advised advised;
    Adviser adviser;
    const std::vector<Velocity> wishes = {{1, 0, 0},  {0, 0, 0}, {4, 0, 0},
                                          {-4, 0, 0}, {0, 0, 9}, {0, -20, 0}};
    for (int step = 0; step < 50; ++step) test::fly_a_step(flock, adviser, wishes, advised);
    ASSERT_EQ(advised.advice.size(), 6U);
  }
}

}  // namespace
}  // namespace beespace
