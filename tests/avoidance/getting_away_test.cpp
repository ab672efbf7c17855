// Bees that are too close and prefer to stand separate as fast as they can.
#include "tests/avoidance/flock.hpp"
#include "tests/avoidance/intruder.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

// The number of steps until all are certified; -1 if that takes more than `most`. Meanwhile no two
// stopping segments come closer than they were, or than the threshold.
int steps_to_part(Flock& flock, int most) {
  const std::vector<Velocity> idle(flock.size());
  const auto threshold_m = static_cast<long double>(flock.options.threshold_m);
  Adviser adviser;
  Advised advised;
  for (int step = 0; step <= most; ++step) {
    const Flock before = flock;
    test::fly_a_step(flock, adviser, idle, advised);
    if (test::all_certified(advised)) return step;
    for (std::size_t i = 0; i < flock.size(); ++i) {
      for (std::size_t j = i + 1; j < flock.size(); ++j) {
        const long double was = std::min(threshold_m, before.ways_apart(i, j));
        const long double is = flock.ways_apart(i, j);
        EXPECT_GE(is, was - 1e-9L * threshold_m) << i << ", " << j;
        if (is < was - 1e-9L * threshold_m) return -1;
      }
    }
  }
  return -1;
}

// Each flies half of the missing distance, from rest to rest.
double seconds_apart(const FlightLimits& limits, double missing_m) {
  const double each_m = 0.5 * missing_m;
  const double a = limits.max_acceleration_mps2;
  return each_m / limits.max_speed_mps +
         (std::isinf(a) ? 0.0
                        : std::min(2.0 * std::sqrt(each_m / a),
                                   limits.max_speed_mps / a + each_m / limits.max_speed_mps));
}

TEST(GettingAway, TwoPartInAboutTheTimeThatItTakes) {
  RandomStream random(1);
  double slowest = 0.0;
  for (int round = 0; round < test::rounds(2'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Flock flock;
    const double threshold_m = test::log_uniform(random, 0.01, 1000.0);
    flock.options.threshold_m = threshold_m;
    flock.options.step_s = test::log_uniform(random, 0.01, 1.0);
    const double speed = threshold_m * test::log_uniform(random, 0.02, 5.0);
    flock.limits.assign(
        2, {speed,
            random.index(3) == 0 ? test::kNoLimit : speed * test::log_uniform(random, 0.05, 20.0)});
    const auto [x, y, z] = scenes::random_direction(random);
    const double far_m = threshold_m * (random.index(10) == 0 ? 0.0 : random.uniform());
    flock.movers = {{{0, 0, 0}, {}}, {{far_m * x, far_m * y, far_m * z}, {}}};
    const double takes_s = seconds_apart(flock.limits[0], threshold_m - far_m);
    const double step_s = flock.options.step_s;
    const int steps = steps_to_part(flock, 40 + static_cast<int>(3.0 * takes_s / step_s));
    ASSERT_GE(steps, 1) << far_m / threshold_m << " thresholds apart, in " << takes_s << " s";
    // Each step takes half of the last nanometre.
    slowest = std::max(slowest, (steps - 30) * step_s / takes_s);
  }
  EXPECT_LT(slowest, 2.0);
}

// `count` bees in a ball that has room for few.
Flock crowd_of(std::size_t count, double acceleration, RandomStream& random) {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.limits.assign(count, {10.0, acceleration});
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = [&] { return random.uniform(-3.0, 3.0); };
    flock.movers.push_back({{at(), at(), at()}, {}});
  }
  return flock;
}

TEST(GettingAway, ManyPart) {
  RandomStream random(2);
  for (int round = 0; round < (test::kSanitized ? 4 : 40); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double acceleration = round % 2 == 0 ? test::kNoLimit : 4.0;
    Flock flock = crowd_of(2 + random.index(19), acceleration, random);
    const int steps = steps_to_part(flock, 400);
    EXPECT_GE(steps, 1) << flock.size() << " bees";
  }
}

// On one line, in one plane, at one place: only their ids tell them where to go.
TEST(GettingAway, BeesOnOneLineOrAtOnePlaceSeparate) {
  for (const double acceleration : {test::kNoLimit, 4.0}) {
    for (const double spacing_m : {0.0, 1.0, 4.9}) {
      for (const std::size_t count :
           {std::size_t{2}, std::size_t{3}, std::size_t{4}, std::size_t{9}}) {
        for (const bool level : {false, true}) {
          SCOPED_TRACE(testing::Message() << count << " bees, " << spacing_m << " m apart, "
                                          << acceleration << " m/s^2" << (level ? ", level" : ""));
          Flock flock;
          flock.limits.assign(count, {10.0, acceleration});
          for (std::size_t i = 0; i < count; ++i) {
            const double far_m = spacing_m * static_cast<double>(i);
            flock.movers.push_back({level ? Point{far_m, 0, 7} : Point{1, 2, far_m}, {}});
          }
          EXPECT_GE(steps_to_part(flock, 600), 1);
        }
      }
    }
  }
}

// While two bees are too close, the bees around them keep their separation.
TEST(GettingAway, OthersAreNotPushed) {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.limits.assign(4, {10.0, 3.0});
  flock.movers = {{{0, 0, 0}, {}}, {{2, 0, 0}, {}}, {{7.5, 0, 0}, {}}, {{-5.5, 0, 0}, {}}};
  Adviser adviser;
  Advised advised;
  const std::vector<Velocity> idle(4);
  for (int step = 0; step < 200; ++step) {
    const Verdict verdict = test::fly_a_step(flock, adviser, idle, advised);
    for (const Loss& loss : verdict.first_losses) EXPECT_EQ(loss.pair, (Pair{0, 1}));
    EXPECT_TRUE(advised.advice[2].certified);
    EXPECT_TRUE(advised.advice[3].certified);
    if (test::all_certified(advised)) return;
  }
  ADD_FAILURE() << "they did not part";
}

// When two straight flights reach the threshold; infinite if never.
double clear_s(const Mover& a, const Mover& b, double threshold_m) {
  const test::LongVector p = test::long_of(b.position) - test::long_of(a.position);
  const test::LongVector v = test::long_of(b.velocity) - test::long_of(a.velocity);
  const auto far = static_cast<long double>(threshold_m);
  const long double vv = test::dot(v, v);
  const long double pv = test::dot(p, v);
  const long double beyond = test::dot(p, p) - far * far;
  if (!(vv > 0.0L)) return beyond < 0.0L ? test::kNoLimit : 0.0;
  const long double squared = pv * pv - vv * beyond;
  if (squared <= 0.0L) return 0.0;
  return std::max(0.0, static_cast<double>((-pv + std::sqrt(squared)) / vv));
}

TEST(GettingAway, TheTimeToClearAndTheGapAreReported) {
  RandomStream random(3);
  int later = 0;
  int at_once = 0;
  for (int round = 0; round < test::rounds(3'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Flock flock;
    flock.options.threshold_m = 5.0;
    flock.options.uncertainty_m = round % 3 == 0 ? 0.5 : 0.0;
    const double asked_m = 5.0 + 2.0 * flock.options.uncertainty_m;
    flock.limits.assign(2, {10.0, round % 2 == 0 ? test::kNoLimit : 3.0});
    const auto [x, y, z] = scenes::random_direction(random);
    const double far_m = random.uniform(0.0, 15.0);
    flock.movers = {{{0, 0, 0}, test::random_velocity(random, 10.0)},
                    {{far_m * x, far_m * y, far_m * z}, test::random_velocity(random, 10.0)}};
    const std::vector<Velocity> wishes = {test::random_velocity(random, 10.0), {}};
    const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
    ASSERT_TRUE(advised);
    const auto apart = static_cast<double>(flock.ways_apart(0, 1));
    if (std::abs(apart - asked_m) < 1e-5) continue;
    ASSERT_EQ(advised->too_close.size(), apart < asked_m ? 1U : 0U);
    if (apart > asked_m) continue;
    const TooClose& close = advised->too_close[0];
    if (apart > 1e-6) {
      EXPECT_NEAR(close.gap_m, apart, 1e-8);
    } else {
      EXPECT_LE(close.gap_m, 1e-8);
    }
    const double step_s = flock.at_once(0) ? 0.0 : flock.options.step_s;
    std::vector<Mover> next;
    for (PointId bee = 0; bee < 2; ++bee) {
      next.push_back(test::after_step(flock.movers[bee], advised->advice[bee].velocity,
                                      flock.at_once(bee), step_s));
    }
    const double after_s = clear_s(next[0], next[1], asked_m);
    if (after_s > 0.0) {
      EXPECT_NEAR(close.clear_s, step_s + after_s, 1e-9 * (1.0 + step_s + after_s));
    } else {
      EXPECT_LE(close.clear_s, step_s);  // within the step, on the way to other velocities
    }
    ++(after_s > 0.0 ? later : at_once);
  }
  EXPECT_GT(later, test::rounds(3'000) / 4);
  EXPECT_GT(at_once, test::rounds(3'000) / 60);
}

// The simplest case: 2 m apart, asked to take half of the missing 3 m each. They fly 1.5 m in a
// step of a second.
TEST(GettingAway, TwoBeesAsComputedByHand) {
  Flock flock;
  flock.options.step_s = 1.0;
  flock.limits.assign(2, {10.0, test::kNoLimit});
  flock.movers = {{{0, 0, 0}, {}}, {{0, 2, 0}, {}}};
  const std::vector<Velocity> idle(2);
  auto advised = advise(flock.movers, idle, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  EXPECT_EQ(test::pairs_of(advised->too_close), (std::vector<Pair>{{0, 1}}));
  EXPECT_NEAR(advised->too_close[0].gap_m, 2.0, 1e-12);
  EXPECT_NEAR(advised->too_close[0].clear_s, 1.0, 1e-5);
  EXPECT_NEAR(advised->advice[0].velocity.y, -1.5, 1e-5);
  EXPECT_NEAR(advised->advice[1].velocity.y, 1.5, 1e-5);
  EXPECT_EQ(advised->advice[0].kind, AdviceKind::kDeflected);
  // They are as fast as they can be, which is not enough.
  flock.limits.assign(2, {0.5, test::kNoLimit});
  advised = advise(flock.movers, idle, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  EXPECT_NEAR(advised->too_close[0].clear_s, 3.0, 0.02);
  // A bee that cannot fly stays.
  flock.limits.assign(2, {0.0, 3.0});
  advised = advise(flock.movers, idle, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  EXPECT_EQ(advised->too_close[0].clear_s, test::kNoLimit);
  EXPECT_EQ(advised->advice[0].velocity, Velocity{});
}

}  // namespace
}  // namespace beespace
