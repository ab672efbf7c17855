// Intruders do not take part: all bees give way to them, and keep apart from each other.
#include "tests/avoidance/flock.hpp"
#include "tests/avoidance/intruder.hpp"
#include "tests/support/rounds.hpp"
#include "tests/verify/curve_oracle.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

double closest_in_step(Mover from, const Mover& to, const Mover& intruder, bool at_once,
                       double step_s) {
  if (at_once) from.velocity = to.velocity;
  const Mover later{test::moved(intruder.position, intruder.velocity, step_s), intruder.velocity};
  // The minimum of a smooth distance, so a few samples find its neighbourhood.
  const auto distance = [&](long double u) {
    const auto a = test::place_at(from, to, step_s, u);
    const auto b = test::place_at(intruder, later, step_s, u);
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  return static_cast<double>(test::least_of(distance, 4));
}

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
      closest_m = std::min(closest_m, closest_in_step(before, flock.movers[0], intruder,
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
