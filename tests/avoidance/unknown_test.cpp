// Bees of which only a ball is known: they hover, may fly, or chase. How long bees that do as
// advised are clear of them.
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

Flock two_in_a_line() {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.movers = {{{0, 0, 0}, {8, 0, 0}}, {{0, 300, 0}, {}}};
  flock.limits = {{10.0, 5.0}, {10.0, 5.0}};
  return flock;
}

Advised ask(const Flock& flock, const std::vector<Velocity>& wishes) {
  auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
  EXPECT_TRUE(advised);
  return advised ? *advised : Advised{};
}

TEST(Unknown, OneThatHoversIsAvoidedForEver) {
  Flock flock = two_in_a_line();
  const std::vector<UnknownAgent> unknown = {{{40, 0.5, 0}, 3.0, 0.0, {}}};
  flock.options.unknown = unknown;
  const auto map = ObstacleMap::of({Sphere{unknown[0].center, unknown[0].radius_m}});
  Adviser adviser;
  Advised advised;
  double farthest_x = 0.0;
  for (int step = 0; step < 300; ++step) {
    const Point& p = flock.movers[0].position;
    const Verdict verdict = [&] {
      Flock checked = flock;
      checked.options.obstacles = nullptr;
      const std::vector<Velocity> wishes = {test::towards(p, {100, 0, 0}, 10.0), {}};
      const Verdict found = test::fly_a_step(flock, adviser, wishes, advised);
      checked.options.obstacles = &*map;
      checked.options.clearance_m = checked.options.threshold_m;
      EXPECT_EQ(test::verdict_of_step(checked, flock.movers).clearance_losses, 0U);
      return found;
    }();
    EXPECT_TRUE(verdict.holds());
    EXPECT_TRUE(test::all_certified(advised)) << "step " << step;
    EXPECT_EQ(advised.advice[0].clear_of_unknown_s, test::kNoLimit);
    EXPECT_TRUE(advised.near_unknown.empty());
    farthest_x = std::max(farthest_x, flock.movers[0].position.x);
    if (HasFailure()) return;
  }
  EXPECT_GT(farthest_x, 90.0);
}

TEST(Unknown, OneThatMayFlyIsClearForAsLongAsItTakesToGetThere) {
  Flock flock = two_in_a_line();
  flock.movers[0].velocity = {};
  flock.options.unknown_horizon_s = 4.0;
  // Its ball is 55 m from the first bee: 5 m are the threshold, and 25 s it takes to fly the rest.
  std::vector<UnknownAgent> unknown = {{{60, 0, 0}, 5.0, 2.0, {}}};
  flock.options.unknown = unknown;
  Advised advised = ask(flock, {{}, {}});
  EXPECT_TRUE(advised.advice[0].certified);
  EXPECT_EQ(advised.advice[0].clear_of_unknown_s, 4.0);  // what was asked for
  EXPECT_EQ(advised.advice[1].clear_of_unknown_s, 4.0);
  EXPECT_TRUE(advised.near_unknown.empty());
  flock.options.unknown_horizon_s = 30.0;
  advised = ask(flock, {{}, {}});
  EXPECT_FALSE(advised.advice[0].certified);
  EXPECT_FALSE(advised.advice[0].clear_of_unknown);
  EXPECT_TRUE(advised.advice[0].keeps_apart);
  EXPECT_NEAR(advised.advice[0].clear_of_unknown_s, 25.0, 1e-6);
  EXPECT_LT(advised.advice[0].clear_of_unknown_s, 25.0);
  EXPECT_LT(advised.advice[0].velocity.x, 0.0);  // away from the ball
  EXPECT_EQ(advised.advice[0].kind, AdviceKind::kDeflected);
  EXPECT_TRUE(advised.advice[1].certified);
  ASSERT_EQ(advised.near_unknown.size(), 1U);
  EXPECT_EQ(advised.near_unknown[0].agent, 0U);
  EXPECT_EQ(advised.near_unknown[0].unknown, 0U);
  EXPECT_NEAR(advised.near_unknown[0].gap_m, 55.0, 1e-9);
  EXPECT_EQ(advised.near_unknown[0].clear_s, advised.advice[0].clear_of_unknown_s);
  // It is too close already, or may be.
  for (const double radius_m : {55.5, 60.0, 1e6}) {
    unknown[0].radius_m = radius_m;
    advised = ask(flock, {{}, {}});
    EXPECT_FALSE(advised.advice[0].certified);
    EXPECT_EQ(advised.advice[0].clear_of_unknown_s, 0.0);
  }
}

TEST(Unknown, OfSeveralTheFirstToArriveCounts) {
  Flock flock = two_in_a_line();
  flock.movers[0].velocity = {};
  flock.options.unknown_horizon_s = 30.0;
  const std::vector<UnknownAgent> unknown = {
      {{60, 0, 0}, 5.0, 2.0, {}}, {{0, 0, 40}, 5.0, 0.0, {}}, {{0, -60, 0}, 5.0, 5.0, {}}};
  flock.options.unknown = unknown;
  const Advised advised = ask(flock, {{}, {}});
  EXPECT_NEAR(advised.advice[0].clear_of_unknown_s, 10.0, 1e-6);
  ASSERT_EQ(advised.near_unknown.size(), 2U);
  EXPECT_EQ(advised.near_unknown[0].unknown, 0U);
  EXPECT_EQ(advised.near_unknown[1].unknown, 2U);
}

// A ball that contains all bees helps no bee, and no bee loses its advice because of it.
TEST(Unknown, AnyBallHasAnAnswer) {
  for (const double radius_m : {0.0, 1.0, 1e9, kLargestInMotion}) {
    for (const double growth : {0.0, kSmallestInMotion, 1.0, kLargestInMotion}) {
      for (const double horizon_s : {kSmallestInMotion, 1.0, kLargestInMotion}) {
        for (const Point& center :
             {Point{}, Point{8, 0, 0}, Point{kLargestInMotion, 0, -kLargestInMotion}}) {
          SCOPED_TRACE(testing::Message()
                       << radius_m << ' ' << growth << ' ' << horizon_s << ' ' << center.x);
          Flock flock = two_in_a_line();
          const std::vector<UnknownAgent> unknown = {{center, radius_m, growth, {}}};
          flock.options.unknown = unknown;
          flock.options.unknown_horizon_s = horizon_s;
          const Advised advised = ask(flock, {{1, 0, 0}, {0, 1, 0}});
          ASSERT_EQ(advised.advice.size(), 2U);
          test::expect_within_limits(flock, advised.advice);
          for (const Advice& advice : advised.advice) {
            EXPECT_TRUE(advice.keeps_apart);
            EXPECT_GE(advice.clear_of_unknown_s, 0.0);
            EXPECT_EQ(advice.certified, advice.clear_of_unknown);
          }
        }
      }
    }
  }
}

// A bee's position within a step.
long double from_middle(const Mover& before, const Velocity& next, bool at_once, double step_s,
                        double share, const Point& middle) {
  const auto at = [&](double p, double v, double w, double m) {
    const long double t = static_cast<long double>(share) * static_cast<long double>(step_s);
    const long double first = at_once ? w : v;
    const long double bend = at_once ? 0.0L
                                     : (static_cast<long double>(w) - static_cast<long double>(v)) /
                                           (2.0L * static_cast<long double>(step_s));
    return static_cast<long double>(p) - static_cast<long double>(m) + first * t + bend * t * t;
  };
  const auto& [p, v] = before;
  const long double x = at(p.x, v.x, next.x, middle.x);
  const long double y = at(p.y, v.y, next.y, middle.y);
  const long double z = at(p.z, v.z, next.z, middle.z);
  return std::sqrt(x * x + y * y + z * z);
}

// In hostile flights: a bee that was once told that it is clear for some time is clear for that
// time, whatever it prefers and is told later, also if it gets no more advice and brakes. No two
// bees lose separation.
TEST(Unknown, APromiseHoldsUntilItEnds) {
  std::uint64_t checked = 0;
  std::uint64_t finite = 0;
  for (int start = 0; start < (test::kSanitized ? 3 : 50); ++start) {
    const std::uint64_t seed = 9300U + static_cast<unsigned>(start);
    SCOPED_TRACE("start " + std::to_string(seed));
    RandomStream random(seed);
    Flock flock = test::random_flock(20, seed);
    if (flock.size() < 5) continue;
    const double threshold_m = flock.options.threshold_m;
    const double step_s = flock.options.step_s;
    const double speed = flock.limits[0].max_speed_mps;
    std::vector<UnknownAgent> unknown;
    for (int k = 0; k < 3; ++k) {
      const auto [x, y, z] = scenes::random_direction(random);
      const double far_m = threshold_m * random.uniform(2.0, 15.0);
      const Point& p =
          flock.movers[random.index(static_cast<std::uint32_t>(flock.size()))].position;
      unknown.push_back({{p.x + x * far_m, p.y + y * far_m, p.z + z * far_m},
                         threshold_m * random.uniform(0.0, 2.0),
                         k == 0 ? 0.0 : speed * random.uniform(0.01, 1.0),
                         {}});
    }
    flock.options.unknown_horizon_s = step_s * random.uniform(1.0, 60.0);
    const std::size_t bees = flock.size();
    // For each bee and ball: until when the bee is clear.
    std::vector<double> until_s(bees * unknown.size(), 0.0);
    const std::vector<UnknownAgent> at_first = unknown;
    Adviser adviser;
    Advised advised;
    const int last_advice = 30 + static_cast<int>(random.index(60));
    for (int step = 0; step < 140; ++step) {
      const double now_s = step * step_s;
      for (std::size_t k = 0; k < unknown.size(); ++k) {
        unknown[k].radius_m = at_first[k].radius_m + at_first[k].growth_mps * now_s;
      }
      flock.options.unknown = unknown;
      const Flock before = flock;
      if (step < last_advice) {
        std::vector<Velocity> wishes;
        for (std::size_t bee = 0; bee < bees; ++bee) {
          const Point& to =
              unknown[random.index(static_cast<std::uint32_t>(unknown.size()))].center;
          const double most = flock.limits[bee].max_speed_mps;
          wishes.push_back(random.index(2) == 0
                               ? test::towards(flock.movers[bee].position, to, most)
                               : test::random_velocity(random, most));
        }
        const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
        ASSERT_EQ(verdict.losses, 0U);
        ASSERT_TRUE(test::all_keep_apart(advised));
        for (std::size_t bee = 0; bee < bees; ++bee) {
          for (std::size_t k = 0; k < unknown.size(); ++k) {
            double clear_s =
                unknown[k].growth_mps > 0.0 ? flock.options.unknown_horizon_s : test::kNoLimit;
            for (const NearUnknown& near : advised.near_unknown) {
              if (near.agent == bee && near.unknown == k) clear_s = near.clear_s;
            }
            ASSERT_GE(clear_s, advised.advice[bee].clear_of_unknown_s);
            double& until = until_s[bee * unknown.size() + k];
            if (clear_s > 0.0) until = std::max(until, now_s + clear_s);
          }
        }
      } else {
        for (std::size_t bee = 0; bee < bees; ++bee) {
          const double change = flock.limits[bee].max_acceleration_mps2 * step_s;
          Mover& mover = flock.movers[bee];
          const double fast = test::length_of(mover.velocity);
          const Velocity next =
              fast > change ? test::scaled(mover.velocity, (fast - change) / fast) : Velocity{};
          mover = test::flown(mover, next, flock.at_once(bee), step_s);
        }
      }
      for (std::size_t bee = 0; bee < bees; ++bee) {
        for (std::size_t k = 0; k < unknown.size(); ++k) {
          for (const double share : {0.0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1.0}) {
            const double at_s = now_s + share * step_s;
            const double until = until_s[bee * unknown.size() + k];
            if (!(at_s < until)) continue;
            const double radius_m = at_first[k].radius_m + at_first[k].growth_mps * at_s;
            const long double far_m =
                from_middle(before.movers[bee], flock.movers[bee].velocity, flock.at_once(bee),
                            step_s, share, unknown[k].center);
            ASSERT_GE(far_m, static_cast<long double>(threshold_m + radius_m))
                << "bee " << bee << " ball " << k << " step " << step << " until " << until;
            ++checked;
            if (std::isfinite(until)) ++finite;
          }
        }
      }
    }
  }
  EXPECT_GT(checked, test::kSanitized ? 1000U : 100000U);
  EXPECT_GT(finite, test::kSanitized ? 500U : 50000U);
}

}  // namespace
}  // namespace beespace
