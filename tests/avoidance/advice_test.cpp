// What advice promises besides separation: kinds, limits, preferred velocities, reproducibility.
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

std::vector<Velocity> random_wishes(const Flock& flock, double most, std::uint64_t seed) {
  RandomStream random(seed);
  std::vector<Velocity> wishes;
  for (const FlightLimits& limits : flock.limits) {
    wishes.push_back(test::random_velocity(random, most * limits.max_speed_mps));
  }
  return wishes;
}

Advised advised_of(const Flock& flock, const std::vector<Velocity>& wishes) {
  auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  EXPECT_TRUE(advised) << advised.error().message;
  return *std::move(advised);
}

void expect_same(const Advised& a, const Advised& b) {
  EXPECT_EQ(a.advice, b.advice);
  EXPECT_EQ(a.too_close, b.too_close);
}

// Enough bees for several threads, dense, some of them too close.
Flock crowd(std::size_t size, std::uint64_t seed) {
  RandomStream random(seed);
  Flock flock;
  const double side_m = 12.0 * std::cbrt(static_cast<double>(size));
  for (std::size_t bee = 0; bee < size; ++bee) {
    const auto at = [&] { return random.uniform(0.0, side_m); };
    flock.movers.push_back({{at(), at(), at()}, test::random_velocity(random, 4.0)});
    flock.limits.push_back({random.uniform(4.0, 10.0),
                            random.index(4) == 0 ? test::kNoLimit : random.uniform(10.0, 40.0)});
  }
  return flock;
}

TEST(Advice, OfNoneAndOfOne) {
  const auto of_none = advise({}, {}, std::vector<FlightLimits>(1), {.threshold_m = 5.0});
  ASSERT_TRUE(of_none);
  EXPECT_TRUE(of_none->advice.empty());
  EXPECT_TRUE(of_none->too_close.empty());
  EXPECT_TRUE(advise({}, {}, {}, {.threshold_m = 5.0}));  // individual limits, of no bees
  Flock flock;
  flock.movers = {{{1, 2, 3}, {}}};
  flock.limits = {{10.0, test::kNoLimit}};
  const Advice as_wished = test::certified({4, 5, 6});
  EXPECT_EQ(advised_of(flock, {{4, 5, 6}}).advice, (std::vector<Advice>{as_wished}));
}

// The reachable velocity that is nearest to the preferred one, after this is shortened to the
// greatest speed.
Velocity reachable(const Mover& mover, const Velocity& wish, const FlightLimits& limits,
                   double step_s) {
  const double speed = test::length_of(wish);
  const Velocity slow =
      speed > limits.max_speed_mps ? test::scaled(wish, limits.max_speed_mps / speed) : wish;
  const Velocity& v = mover.velocity;
  const double change = test::length_of_change(v, slow);
  const double most = limits.max_acceleration_mps2 * step_s;
  if (!(change > most)) return slow;
  const double share = most / change;
  return {v.x + (slow.x - v.x) * share, v.y + (slow.y - v.y) * share, v.z + (slow.z - v.z) * share};
}

TEST(Advice, ABeeThatIsAloneGetsTheNearestToItsWish) {
  RandomStream random(1);
  Flock flock;
  for (int bee = 0; bee < test::rounds(2'000); ++bee) {
    const double speed = random.uniform(0.1, 20.0);
    flock.limits.push_back(
        {speed, random.index(3) == 0 ? test::kNoLimit : test::log_uniform(random, 0.1, 1000.0)});
    flock.movers.push_back(
        {{1e4 * static_cast<double>(bee), 0.0, 0.0}, test::random_velocity(random, speed)});
  }
  for (const double most : {1.0, 10.0}) {
    const std::vector<Velocity> wishes = random_wishes(flock, most, 2);
    const Advised advised = advised_of(flock, wishes);
    EXPECT_TRUE(test::all_certified(advised));
    test::expect_within_limits(flock, advised.advice);
    for (std::size_t bee = 0; bee < flock.size(); ++bee) {
      const Velocity expected =
          reachable(flock.movers[bee], wishes[bee], flock.limits[bee], flock.options.step_s);
      const Advice& advice = advised.advice[bee];
      ASSERT_EQ(advice.kind, AdviceKind::kAsPreferred);
      ASSERT_LE(test::length_of_change(advice.velocity, expected),
                1e-12 * flock.limits[bee].max_speed_mps);
      if (most > 1.0 || !flock.at_once(bee)) continue;
      ASSERT_EQ(advice.velocity, wishes[bee]);
    }
  }
}

// A bee gets its preferred velocity where that hinders no other bee; the others get another one.
TEST(Advice, TheKindSaysWhetherTheWishIsGranted) {
  std::size_t wished = 0;
  std::size_t deflected = 0;
  for (std::uint64_t seed = 10; seed < 20; ++seed) {
    const Flock flock = test::random_flock(20, seed);
    const std::vector<Velocity> wishes = random_wishes(flock, 1.0, seed);
    const Advised advised = advised_of(flock, wishes);
    for (std::size_t bee = 0; bee < flock.size(); ++bee) {
      const Velocity expected =
          reachable(flock.movers[bee], wishes[bee], flock.limits[bee], flock.options.step_s);
      const double off = test::length_of_change(advised.advice[bee].velocity, expected);
      const bool is_granted = off <= 1e-12 * flock.limits[bee].max_speed_mps;
      ASSERT_EQ(advised.advice[bee].kind == AdviceKind::kAsPreferred, is_granted) << "bee " << bee;
      ++(is_granted ? wished : deflected);
    }
  }
  EXPECT_GT(wished, 10U);
  EXPECT_GT(deflected, 10U);
}

// Two bees face each other at rest. Each may use half of the distance beyond the threshold.
TEST(Advice, TwoFaceToFaceShareTheDistanceBetweenThem) {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.options.step_s = 1.0;
  flock.limits.assign(2, {10.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {}}, {{7, 0, 0}, {}}};
  // Each prefers less than its half: neither hinders the other.
  Advised advised = advised_of(flock, {{0.99, 0, 0}, {-0.99, 0, 0}});
  EXPECT_EQ(advised.advice[0], test::certified({0.99, 0, 0}));
  EXPECT_EQ(advised.advice[1], test::certified({-0.99, 0, 0}));
  // More: neither flies beyond its half, and both fly on.
  advised = advised_of(flock, {{1.01, 0, 0}, {-1.6, 0, 0}});
  for (const std::size_t bee : {std::size_t{0}, std::size_t{1}}) {
    EXPECT_EQ(advised.advice[bee].kind, AdviceKind::kDeflected);
    EXPECT_LE(std::abs(advised.advice[bee].velocity.x), 1.0);
    EXPECT_GT(std::abs(advised.advice[bee].velocity.x), 0.99);
  }
  // Much more: a bee that gets too little of it turns right, within its own half.
  advised = advised_of(flock, {{10, 0, 0}, {-10, 0, 0}});
  EXPECT_LE(advised.advice[0].velocity.x, 1.0);
  EXPECT_LT(advised.advice[0].velocity.y, -1.0);
  EXPECT_GE(advised.advice[1].velocity.x, -1.0);
  EXPECT_GT(advised.advice[1].velocity.y, 1.0);
  // Away from each other, at any speed.
  advised = advised_of(flock, {{-10, 0, 0}, {10, 0, 0}});
  EXPECT_EQ(advised.advice[0].kind, AdviceKind::kAsPreferred);
  EXPECT_EQ(advised.advice[1].kind, AdviceKind::kAsPreferred);
}

TEST(Advice, IsTheSameWithEveryNumberOfThreads) {
  Flock flock = crowd(17'000, 5);
  const std::vector<Velocity> wishes = random_wishes(flock, 2.0, 6);
  const Advised alone = advised_of(flock, wishes);
  const std::vector<Pair> pairs = test::pairs_of(alone.too_close);
  EXPECT_GT(pairs.size(), 100U);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
  test::expect_within_limits(flock, alone.advice);
  Adviser adviser;
  for (const unsigned threads : {2U, 5U, 1U, 3U, 0U}) {
    SCOPED_TRACE(threads);
    flock.options.threads = threads;
    expect_same(advised_of(flock, wishes), alone);
    Advised again;
    ASSERT_TRUE(adviser.advise(flock.movers, wishes, flock.limits, flock.options, again));
    expect_same(again, alone);
  }
}

// Large and small flocks in turn, with refusals in between; one Adviser and one Advised.
TEST(Advice, DependsNotOnEarlierCalls) {
  Adviser adviser;
  Advised advised;
  for (std::uint64_t seed = 30; seed < 40; ++seed) {
    Flock flock = seed % 3 == 0 ? crowd(test::kSanitized ? 200 : 2'500, seed)
                                : test::random_flock(3 + seed % 7, seed);
    flock.options.threads = 1 + static_cast<unsigned>(seed % 4);
    const std::vector<Velocity> wishes = random_wishes(flock, 3.0, seed);
    ASSERT_TRUE(adviser.advise(flock.movers, wishes, flock.limits, flock.options, advised));
    expect_same(advised, advised_of(flock, wishes));
    EXPECT_FALSE(adviser.advise(flock.movers, {}, flock.limits, flock.options, advised));
    Adviser moved = std::move(adviser);
    adviser = std::move(moved);
  }
  ASSERT_TRUE(adviser.advise({}, {}, {}, {.threshold_m = 5.0}, advised));
  expect_same(advised, {});
}

TEST(Advice, OneSetOfLimitsIsThatOfAll) {
  Flock flock = crowd(300, 8);
  flock.limits.assign(flock.size(), {6.0, 5.0});
  const std::vector<Velocity> wishes = random_wishes(flock, 1.5, 9);
  const Advised of_each = advised_of(flock, wishes);
  flock.limits.resize(1);
  expect_same(advised_of(flock, wishes), of_each);
}

// With other ids the same bees get their preferred velocities, and the others get the same advice
// except for rounding. (Where segments are parallel, or several velocities are equally good, the
// lower id decides; random flocks have no such case.)
TEST(Advice, DependsOnIdsOnlyWhereNothingElseDecides) {
  for (std::uint64_t seed = 50; seed < 62; ++seed) {
    SCOPED_TRACE(seed);
    const Flock flock = test::random_flock(20, seed);
    const std::vector<Velocity> wishes = random_wishes(flock, 2.0, seed);
    const Advised advised = advised_of(flock, wishes);
    Flock backward = flock;
    std::reverse(backward.movers.begin(), backward.movers.end());
    std::reverse(backward.limits.begin(), backward.limits.end());
    const std::vector<Velocity> backward_wishes(wishes.rbegin(), wishes.rend());
    const Advised other = advised_of(backward, backward_wishes);
    for (std::size_t bee = 0; bee < flock.size(); ++bee) {
      const Advice& a = advised.advice[bee];
      const Advice& b = other.advice[flock.size() - 1 - bee];
      ASSERT_EQ(a.kind == AdviceKind::kAsPreferred, b.kind == AdviceKind::kAsPreferred);
      ASSERT_EQ(a.certified, b.certified);
      // Rounding decides whether the last attempts succeed: a thousandth of the change.
      ASSERT_LE(test::length_of_change(a.velocity, b.velocity),
                2e-3 * flock.limits[bee].max_speed_mps)
          << "bee " << bee;
    }
  }
}

TEST(Advice, ABeeThatIsTooFastBrakesAsHardAsItCan) {
  Flock flock;
  flock.movers = {{{0, 0, 0}, {12, 0, 0}}};
  flock.limits = {{10.0, 5.0}};
  const Advised advised = advised_of(flock, {{0, 12, 0}});
  EXPECT_EQ(advised.advice[0].velocity, (Velocity{11.5, 0, 0}));
  EXPECT_TRUE(advised.advice[0].certified);
}

// A bee that cannot fly stands. A bee that prefers to stand may, if its neighbours leave it room.
TEST(Advice, StandingIsAsWished) {
  Flock flock;
  flock.movers = {{{0, 0, 0}, {}}, {{5.1, 0, 0}, {}}, {{0, 5.1, 0}, {}}};
  for (const double acceleration : {test::kNoLimit, 3.0}) {
    for (const double speed : {0.0, 10.0}) {
      flock.limits.assign(3, {speed, acceleration});
      const Advised advised = advised_of(flock, std::vector<Velocity>(3));
      const Advice standing = test::certified({});
      EXPECT_EQ(advised.advice, (std::vector<Advice>(3, standing)));
    }
  }
}

// Positions of neighbours are not copied to where the bees' are: views of any layout work.
TEST(Advice, OfSeparateArraysIsThatOfMovers) {
  const Flock flock = crowd(200, 70);
  std::vector<double> numbers[6];
  for (const auto& [p, v] : flock.movers) {
    std::size_t at = 0;
    for (const double number : {p.x, p.y, p.z, v.x, v.y, v.z}) numbers[at++].push_back(number);
  }
  const MoversView view(PointsView::separate(numbers[0], numbers[1], numbers[2]),
                        PointsView::separate(numbers[3], numbers[4], numbers[5]));
  const std::vector<Velocity> wishes = random_wishes(flock, 2.0, 71);
  const auto advised = advise(view, wishes, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  expect_same(*advised, advised_of(flock, wishes));
}

}  // namespace
}  // namespace beespace
