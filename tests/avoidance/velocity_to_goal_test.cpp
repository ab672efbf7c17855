// A bee that flies as velocity_to_goal() says arrives at its goal, and stops there.
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;

struct Trip {
  double seconds = 0.0;
  double overshoot_m = 0.0;
  bool arrived = false;
};

// One bee without neighbours, advised until it arrives.
Trip fly(const Point& start, const Point& goal, const FlightLimits& limits, double step_s,
         int most) {
  test::Flock flock;
  flock.options.step_s = step_s;
  flock.limits = {limits};
  flock.movers = {{start, {}}};
  const double way_m = test::distance_of(start, goal);
  Adviser adviser;
  Advised advised;
  Trip trip;
  for (int step = 0; step < most; ++step) {
    const Mover& bee = flock.movers[0];
    const Velocity wish = *velocity_to_goal(bee.position, goal, limits, step_s);
    EXPECT_LE(test::length_of(wish), limits.max_speed_mps * (1.0 + 1e-12));
    test::fly_a_step(flock, adviser, {wish}, advised);
    trip.seconds += step_s;
    trip.overshoot_m =
        std::max(trip.overshoot_m, test::distance_of(start, flock.movers[0].position) - way_m);
    trip.arrived = test::distance_of(flock.movers[0].position, goal) <= 1e-6 * way_m &&
                   test::length_of(flock.movers[0].velocity) <= 1e-6 * limits.max_speed_mps;
    if (trip.arrived) break;
  }
  return trip;
}

TEST(VelocityToGoal, ArrivesAndStopsWithoutFlyingPastTheGoal) {
  RandomStream random(1);
  double slowest = 0.0;
  for (int round = 0; round < test::rounds(2'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double speed = test::log_uniform(random, 0.1, 100.0);
    const double step_s = test::log_uniform(random, 0.01, 1.0);
    const FlightLimits limits{
        speed, round % 3 == 0 ? test::kNoLimit : speed * test::log_uniform(random, 0.05, 50.0)};
    const Point start{random.uniform(-100.0, 100.0), random.uniform(-100.0, 100.0), 5.0};
    const auto [x, y, z] = scenes::random_direction(random);
    const double way_m = speed * test::log_uniform(random, 0.01, 100.0);
    const Point goal{start.x + way_m * x, start.y + way_m * y, start.z + way_m * z};
    // With half of the acceleration at the end, and some steps to settle.
    const double a = limits.max_acceleration_mps2;
    const double takes_s = way_m / speed + (std::isinf(a) ? 0.0 : speed / a + std::sqrt(way_m / a));
    const int most = 80 + static_cast<int>(4.0 * takes_s / step_s);
    const Trip trip = fly(start, goal, limits, step_s, most);
    ASSERT_TRUE(trip.arrived) << limits.max_speed_mps << " m/s, " << a << " m/s^2, " << step_s
                              << " s, " << way_m << " m";
    ASSERT_LE(trip.overshoot_m, 1e-9 * way_m + 1e-12)
        << limits.max_speed_mps << " m/s, " << a << " m/s^2, " << step_s << " s, " << way_m << " m";
    slowest = std::max(slowest, (trip.seconds - 60.0 * step_s) / takes_s);
  }
  EXPECT_LT(slowest, 3.0);
}

TEST(VelocityToGoal, IsZeroAtTheGoalAndPointsThere) {
  const FlightLimits limits{10.0, 5.0};
  EXPECT_EQ(*velocity_to_goal({1, 2, 3}, {1, 2, 3}, limits, 0.1), Velocity{});
  EXPECT_EQ(*velocity_to_goal({1, 2, 3}, {1, 2, 3 + 5e-10}, limits, 0.1), Velocity{});
  EXPECT_EQ(*velocity_to_goal({0, 0, 0}, {0, 1000, 0}, limits, 0.1), (Velocity{0, 10, 0}));
  EXPECT_EQ(*velocity_to_goal({0, 0, 0}, {-1000, 0, 0}, {7.0, test::kNoLimit}, 0.1),
            (Velocity{-7, 0, 0}));
  // Without a limit of acceleration: there in a step.
  EXPECT_EQ(*velocity_to_goal({0, 0, 0}, {0.25, 0, 0}, {7.0, test::kNoLimit}, 0.5),
            (Velocity{0.5, 0, 0}));
  EXPECT_EQ(*velocity_to_goal({0, 0, 0}, {9, 0, 0}, {0.0, 5.0}, 0.1), Velocity{});
  // Braking with half of the acceleration: 20 m at 10 m/s.
  EXPECT_NEAR(velocity_to_goal({0, 0, 0}, {20, 0, 0}, {50.0, 5.0}, 0.1).value().x, 10.0, 1e-12);
}

}  // namespace
}  // namespace beespace
