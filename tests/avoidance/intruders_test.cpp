// Intruders do not take part: all bees give way to them, and keep apart from each other.
#include "tests/avoidance/flock.hpp"
#include "tests/avoidance/intruder.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

// One bee with a constant preferred velocity, and intruders that fly straight on: the closest
// distance to any of them.
double closest_of_all(Flock& flock, const Velocity& wish, std::vector<Mover> intruders, int steps) {
  Adviser adviser;
  Advised advised;
  double closest_m = test::kNoLimit;
  for (int step = 0; step < steps; ++step) {
    flock.options.intruders = intruders;
    const Mover before = flock.movers[0];
    test::fly_a_step(flock, adviser, {wish}, advised);
    for (const Mover& intruder : intruders) {
      closest_m =
          std::min(closest_m, test::closest_in_step(before, flock.movers[0], intruder,
                                                    flock.at_once(0), flock.options.step_s));
    }
    test::fly_on(intruders, flock.options.step_s);
  }
  return closest_m;
}

// The intruder's position `before_s` seconds before it would meet the bee, which flies straight.
Mover on_course(const Mover& bee, const Velocity& velocity, double before_s) {
  return {test::moved(test::moved(bee.position, bee.velocity, before_s), velocity, -before_s),
          velocity};
}

Flock one_bee(double acceleration, const Velocity& velocity) {
  Flock flock;
  flock.options.threshold_m = 5.0;
  flock.limits = {{10.0, acceleration}};
  flock.movers = {{{100, -50, 20}, velocity}};
  return flock;
}

// Head on, from behind, from above, from the side.
std::vector<Velocity> directions(RandomStream& random) {
  std::vector<Velocity> all = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int k = 0; k < test::rounds(40); ++k) {
    const auto [x, y, z] = scenes::random_direction(random);
    all.push_back({x, y, z});
  }
  return all;
}

// Advice is a velocity. Until the bee flies with it, it is a little off.
TEST(Intruders, ABeeThatHasTimeIsMissed) {
  RandomStream random(1);
  int met = 0;
  for (const double acceleration : {test::kNoLimit, 5.0, 1.0}) {
    const double least_m = std::isinf(acceleration) ? 5.0 : 4.95;
    for (const Velocity& bee : {Velocity{}, Velocity{6, 0, 0}, Velocity{10, 0, 0}}) {
      for (const double speed : {0.5, 6.0, 10.0, 17.0, 80.0}) {
        for (const Velocity& direction : directions(random)) {
          SCOPED_TRACE(testing::Message()
                       << acceleration << " m/s^2, bee at " << bee.x << " m/s, intruder at "
                       << speed << " m/s along " << direction.x << ", " << direction.y << ", "
                       << direction.z);
          Flock flock = one_bee(acceleration, bee);
          const Mover intruder = on_course(flock.movers[0], test::scaled(direction, speed), 12.0);
          // An intruder with the bee's velocity stays where it is, seen from the bee.
          if (test::distance_of(intruder.position, flock.movers[0].position) < 20.0) continue;
          ++met;
          ASSERT_GE(closest_of_all(flock, bee, {intruder}, 180), least_m);
        }
      }
    }
  }
  EXPECT_GT(met, 100);
}

// For any step, and any speed of the intruder above the bee's, the bee gets as far away as it can.
TEST(Intruders, ABeeWithoutTimeDoesWhatItCan) {
  for (const double step_s : {0.001, 0.01, 0.1}) {
    for (const double speed : {10.0, 300.0}) {
      for (const double aside_m : {0.5, 3.0}) {
        SCOPED_TRACE(testing::Message() << step_s << " s, " << speed << " m/s, " << aside_m);
        Flock flock = one_bee(2.0, {});
        flock.movers = {{{0, 0, 0}, {}}};
        flock.options.step_s = step_s;
        const std::vector<Mover> intruders = {{{-0.6 * speed, aside_m, 0}, {speed, 0, 0}}};
        flock.options.intruders = intruders;
        const auto advised =
            advise(flock.movers, std::vector<Velocity>(1), flock.limits, flock.options);
        ASSERT_TRUE(advised);
        EXPECT_EQ(advised->advice[0].kind, AdviceKind::kDeflected);
        // Away from where the intruder passes, as hard as the bee can.
        const Velocity& v = advised->advice[0].velocity;
        EXPECT_GT(test::length_of(v), 0.95 * 2.0 * step_s);
        EXPECT_LT(v.y, -0.5 * 2.0 * step_s);
        ASSERT_EQ(advised->intruder_conflicts.size(), 1U);
      }
    }
  }
}

// One intruder is too close already, one is at the same place.
TEST(Intruders, ABeeThatIsTooCloseGetsAway) {
  for (const double acceleration : {test::kNoLimit, 5.0}) {
    for (const double far_m : {0.0, 1e-9, 2.0, 5.0}) {
      SCOPED_TRACE(testing::Message() << acceleration << ", " << far_m);
      Flock flock = one_bee(acceleration, {});
      const Point at = flock.movers[0].position;
      closest_of_all(flock, {}, {{{at.x + far_m, at.y, at.z}, {}}}, 60);
      EXPECT_GE(test::distance_of(flock.movers[0].position, {at.x + far_m, at.y, at.z}), 5.0);
    }
  }
}

// A step is long enough to come too close in it, on the way from one velocity to the other.
TEST(Intruders, AreMetWithinTheStepToo) {
  Flock flock = one_bee(6.0, {3, 0, 0});
  flock.options.threshold_m = 2.0;
  flock.options.step_s = 1.0;
  flock.limits = {{6.0, 6.0}};
  flock.movers = {{{0, 0, 0}, {3, 0, 0}}};
  const std::vector<Mover> intruders{{{2.2, 0, 0}, {}}};
  flock.options.intruders = intruders;
  const auto advised =
      advise(flock.movers, std::vector<Velocity>{{-3, 0, 0}}, flock.limits, flock.options);
  ASSERT_TRUE(advised);
  const double closest_m = test::closest_as_advised(flock.movers[0], advised->advice[0].velocity,
                                                    flock.options.intruders[0], false, 1.0, 10.0);
  ASSERT_LT(closest_m, 2.0);  // 1.45
  EXPECT_FALSE(advised->advice[0].clear_of_intruders);
  EXPECT_FALSE(advised->advice[0].certified);
  ASSERT_EQ(advised->intruder_conflicts.size(), 1U);
  EXPECT_LE(advised->intruder_conflicts[0].closest_m, closest_m);
}

TEST(Intruders, AreMetWhereTheArcOfTheStepSaysSo) {
  RandomStream random(7);
  int met = 0;
  int clear = 0;
  int in_doubt = 0;
  for (int round = 0; round < test::rounds(4000); ++round) {
    const double acceleration = round % 5 == 0 ? test::kNoLimit : random.uniform(0.5, 20.0);
    Flock flock = one_bee(acceleration, {});
    flock.options.threshold_m = 2.0;
    flock.options.step_s = round % 2 == 0 ? random.uniform(0.01, 3.0) : 0.1;
    flock.options.intruder_horizon_s = round % 7 == 0 ? 0.05 : 8.0;
    const auto any = [&](double size) {
      const auto [x, y, z] = scenes::random_direction(random);
      return test::scaled({x, y, z}, random.uniform(0.0, size));
    };
    flock.movers = {{test::moved({}, any(1.0), 1.0), any(10.0)}};
    const std::vector<Mover> intruders{{test::moved({}, any(20.0), 1.0), any(12.0)}};
    flock.options.intruders = intruders;
    const auto advised =
        advise(flock.movers, std::vector<Velocity>{any(10.0)}, flock.limits, flock.options);
    ASSERT_TRUE(advised);
    const Advice& advice = advised->advice[0];
    const double closest_m = test::closest_as_advised(
        flock.movers[0], advice.velocity, intruders[0], std::isinf(acceleration),
        std::min(flock.options.step_s, flock.options.intruder_horizon_s),
        flock.options.intruder_horizon_s);
    if (flock.options.step_s > flock.options.intruder_horizon_s) continue;  // an arc cut short
    const Velocity& v = flock.movers[0].velocity;
    const Velocity change{advice.velocity.x - v.x, advice.velocity.y - v.y,
                          advice.velocity.z - v.z};
    const double strays_m =
        std::isinf(acceleration) ? 0.0 : test::length_of(change) * flock.options.step_s / 8.0;
    if (closest_m < 2.0 - 1e-9) {
      ++met;
      EXPECT_FALSE(advice.clear_of_intruders) << "round " << round << ": " << closest_m;
    } else if (closest_m > 2.0 + 2.0 * strays_m + 1e-9) {
      ++clear;
      EXPECT_TRUE(advice.clear_of_intruders) << "round " << round << ": " << closest_m;
    } else {
      ++in_doubt;
    }
  }
  EXPECT_GT(met, test::rounds(4000) / 20);
  EXPECT_GT(clear, test::rounds(4000) / 4);
  EXPECT_LT(in_doubt, test::rounds(4000) / 5);
}

// Away from two at once: between the two directions.
TEST(Intruders, RequestsThatCannotAllBeMetAreMetInPart) {
  for (const double acceleration : {test::kNoLimit, 5.0}) {
    Flock flock = one_bee(acceleration, {});
    const Point& at = flock.movers[0].position;
    const std::vector<Mover> intruders = {{{at.x - 2, at.y, at.z}, {}},
                                          {{at.x, at.y - 2, at.z}, {}}};
    flock.options.intruders = intruders;
    const auto advised =
        advise(flock.movers, std::vector<Velocity>(1), flock.limits, flock.options);
    ASSERT_TRUE(advised);
    const Velocity& v = advised->advice[0].velocity;
    const double most = std::isinf(acceleration) ? 10.0 : 0.1 * acceleration;
    EXPECT_NEAR(v.x, most * std::sqrt(0.5), 0.02 * most);
    EXPECT_NEAR(v.y, most * std::sqrt(0.5), 0.02 * most);
  }
}

// Several intruders at about the same time. No method can promise anything here; this is measured.
TEST(Intruders, SeveralAreNearlyAlwaysMissed) {
  RandomStream random(2);
  int met = 0;
  int hit = 0;
  for (int round = 0; round < (test::kSanitized ? 6 : 100); ++round) {
    Flock flock = one_bee(round % 2 == 0 ? test::kNoLimit : 5.0, {});
    std::vector<Mover> intruders;
    for (std::size_t k = 2 + random.index(4); k > 0; --k) {
      const auto [x, y, z] = scenes::random_direction(random);
      const double speed = random.uniform(3.0, 20.0);
      intruders.push_back(on_course(flock.movers[0], {speed * x, speed * y, speed * z},
                                    random.uniform(10.0, 20.0)));
    }
    ++met;
    hit += closest_of_all(flock, {}, intruders, 250) < 5.0 ? 1 : 0;
  }
  EXPECT_LE(hit, met / 20);
}

}  // namespace
}  // namespace beespace
