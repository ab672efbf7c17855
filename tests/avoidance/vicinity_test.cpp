// The vicinity has all neighbours that may matter, also those that reach much farther than all
// others.
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

// A cube of bees that hover or fly slowly, so dense that some are too close.
Flock slow_crowd(std::size_t bees, std::uint64_t seed) {
  RandomStream random(seed);
  Flock flock;
  flock.options.threshold_m = 5.0;
  const double side_m = 9.0 * std::cbrt(static_cast<double>(bees));
  const auto at = [&] { return random.uniform(0.0, side_m); };
  for (std::size_t bee = 0; bee < bees; ++bee) {
    flock.movers.push_back({{at(), at(), at()}, test::random_velocity(random, 1.0)});
    flock.limits.push_back({2.0, 5.0});
  }
  return flock;
}

// The pairs whose stopping segments are too close by brute force, except for borderline ones.
std::vector<Pair> pairs_by_brute_force(const Flock& flock) {
  std::vector<Pair> pairs;
  for (PointId i = 0; i < flock.size(); ++i) {
    for (PointId j = i + 1; j < flock.size(); ++j) {
      if (flock.ways_apart(i, j) < flock.options.threshold_m) pairs.push_back({i, j});
    }
  }
  return pairs;
}

TEST(Vicinity, AFewMuchFasterBeesAreComparedWithAllOthers) {
  std::size_t pairs_of_the_fast = 0;
  for (std::uint64_t seed = 1; seed <= (test::kSanitized ? 2U : 8U); ++seed) {
    Flock flock = slow_crowd(test::kSanitized ? 150 : 400, seed);
    // Through the crowd, beside it, and one that could but does not.
    flock.movers[7].velocity = {300.0, 20.0, 10.0};
    flock.movers[120].velocity = {-40.0, 500.0, 3.0};
    flock.movers[40].velocity = {0.0, 0.0, 0.1};
    flock.limits[40] = {800.0, test::kNoLimit};
    const std::vector<Pair> expected = pairs_by_brute_force(flock);
    for (const unsigned threads : {1U, 3U}) {
      flock.options.threads = threads;
      const auto advised =
          advise(flock.movers, std::vector<Velocity>(flock.size()), flock.limits, flock.options);
      ASSERT_TRUE(advised);
      ASSERT_EQ(test::pairs_of(advised->too_close), expected) << "seed " << seed;
    }
    pairs_of_the_fast += static_cast<std::size_t>(
        std::count_if(expected.begin(), expected.end(), [](const Pair& pair) {
          return pair.first == 7 || pair.second == 7 || pair.first == 120 || pair.second == 120;
        }));
  }
  EXPECT_GT(pairs_of_the_fast, test::kSanitized ? 4U : 40U);
}

// 10^40 m: the rounding of its way alone is wider than the swarm.
TEST(Vicinity, ABeeThatReachesFartherThanFloatsHoldMeetsAllOthers) {
  Flock flock = slow_crowd(60, 5);
  constexpr PointId kFast = 7;
  flock.movers[kFast].velocity = {2e5, 20.0, 10.0};
  flock.limits[kFast] = {3e5, 1e-30};
  for (const unsigned threads : {1U, 3U}) {
    flock.options.threads = threads;
    const auto advised =
        advise(flock.movers, std::vector<Velocity>(flock.size()), flock.limits, flock.options);
    ASSERT_TRUE(advised);
    const auto met = std::count_if(advised->too_close.begin(), advised->too_close.end(),
                                   [&](const TooClose& close) {
                                     return close.pair.first == kFast || close.pair.second == kFast;
                                   });
    EXPECT_EQ(static_cast<std::size_t>(met), flock.size() - 1);
  }
}

// A far bee changes nothing for the bees that it cannot meet.
TEST(Vicinity, ABeeThatIsFarAwayChangesNoAdvice) {
  Flock flock = slow_crowd(300, 3);
  RandomStream random(4);
  std::vector<Velocity> wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    wishes.push_back(test::random_velocity(random, 3.0));
  }
  flock.movers[0].position = {1e6, 0.0, 0.0};
  flock.limits[0] = {1000.0, 5.0};
  const auto slow = advise(flock.movers, wishes, flock.limits, flock.options);
  flock.movers[0].velocity = {900.0, 0.0, 0.0};
  const auto fast = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(slow && fast);
  std::size_t deflected = 0;
  for (std::size_t bee = 1; bee < flock.size(); ++bee) {
    const Velocity& a = slow->advice[bee].velocity;
    const Velocity& b = fast->advice[bee].velocity;
    // The allowance for rounding depends on the farthest bee.
    ASSERT_LE(test::length_of_change(a, b), 1e-5) << "bee " << bee;
    deflected += slow->advice[bee].kind == AdviceKind::kDeflected ? 1U : 0U;
  }
  EXPECT_GT(deflected, 20U);
}

}  // namespace
}  // namespace beespace
