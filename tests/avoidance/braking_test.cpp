#include "avoidance/constraints/braking.hpp"

#include "avoidance/constraints/closest_points.hpp"
#include "avoidance/velocity_solver.hpp"
#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::avoidance {
namespace {

using scenes::RandomStream;
using test::long_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Case {
  FlightLimits limits;
  double step_s;
  AgentState agent;
};

// Speeds from far below to far above what a step of braking removes.
Case random_case(RandomStream& random) {
  const double step_s = std::exp(random.uniform(-5.0, 0.0));
  const double change = std::exp(random.uniform(-5.0, 3.0));
  const double speed = change * std::exp(random.uniform(-3.0, 4.0));
  const FlightLimits limits{speed * random.uniform(0.3, 2.0), change / step_s};
  const AgentState agent{direction(random) * random.uniform(0.0, 100.0), direction(random) * speed,
                         Braking(limits, step_s), limits.max_speed_mps};
  return {limits, step_s, agent};
}

TEST(Braking, TheStoppingDistanceIsThatOfTheFormula) {
  const Braking braking({20.0, 2.0}, 0.5);
  EXPECT_EQ(braking.stopping_segment({8.0, 0.0, 0.0}), (Vector3{16.0 + 2.0, 0.0, 0.0}));
  EXPECT_EQ(braking.stopping_segment({0.0, 0.0, -8.0}), (Vector3{0.0, 0.0, -18.0}));
  EXPECT_EQ(braking.stopping_segment({}), (Vector3{}));
  EXPECT_EQ(braking.change(), 1.0);
  EXPECT_EQ(braking.braked({0.0, 8.0, 0.0}), (Vector3{0.0, 7.0, 0.0}));
  EXPECT_EQ(braking.braked({0.0, 1.0, 0.0}), (Vector3{}));
  EXPECT_EQ(braking.drift({8.0, 0.0, 0.0}), (Vector3{2.0, 0.0, 0.0}));
  EXPECT_EQ(braking.way_after({0.0, 8.0, 0.0}), (Vector3{0.0, 4.0 + 16.0, 0.0}));
}

TEST(Braking, WithoutALimitABeeStopsWhereItIs) {
  const Braking braking({20.0, kInfinity}, 0.5);
  EXPECT_TRUE(braking.at_once());
  EXPECT_EQ(braking.stopping_segment({8.0, 0.0, 0.0}), (Vector3{}));
  EXPECT_EQ(braking.drift({8.0, 0.0, 0.0}), (Vector3{}));
  EXPECT_EQ(braking.way_after({8.0, 0.0, 0.0}), (Vector3{4.0, 0.0, 0.0}));
}

// Flown in steps, a bee stops within its stopping segment, and near the end of it.
TEST(Braking, StopsWithinItsStoppingSegment) {
  RandomStream random(1);
  for (int round = 0; round < test::rounds(5'000); ++round) {
    const auto [limits, step_s, agent] = random_case(random);
    const double way = length(agent.braking.stopping_segment(agent.velocity));
    double flown = 0.0;
    Vector3 v = agent.velocity;
    while (length(v) > 0.0) {
      const Vector3 next = agent.braking.braked(v);
      ASSERT_LE(length(next - v), agent.braking.change() * (1.0 + 1e-12));
      flown += 0.5 * (length(v) + length(next)) * step_s;
      v = next;
    }
    ASSERT_LE(flown, way * (1.0 + 1e-12)) << "round " << round;
    // The unused part of the last step.
    const double spare = 0.5 * step_s * (length(agent.velocity) + agent.braking.change());
    ASSERT_GE(flown, way - spare * (1.0 + 1e-12)) << "round " << round;
  }
}

// After a step of braking the stopping segment lies in the previous one, and is shorter.
TEST(Braking, AfterAStepOfBrakingTheSegmentLiesInTheOldOne) {
  RandomStream random(2);
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const auto [limits, step_s, agent] = random_case(random);
    const Vector3 braked = agent.braking.braked(agent.velocity);
    const Segment old_way = agent.stopping_segment();
    const test::LongSegment old{long_of(old_way.from), long_of(old_way.way)};
    const double rounding = 1e-13 * (length(old_way.from) + length(old_way.way));
    const Vector3 stop = agent.stop_after(braked);
    ASSERT_LE(static_cast<double>(old.distance_to(long_of(stop))), rounding) << "round " << round;
    ASSERT_LE(length(agent.braking.stopping_segment(braked)), length(old_way.way) * (1.0 + 1e-15));
    // The position a step later, plus half a step's drift.
    const Vector3 middle = agent.position + agent.velocity * (0.5 * step_s);
    const Vector3 later = middle + braked * (0.5 * step_s);
    ASSERT_LE(static_cast<double>(old.distance_to(long_of(middle))), rounding);
    ASSERT_LE(static_cast<double>(old.distance_to(long_of(later))), rounding);
  }
}

// stop_after() is where the stopping segment of the next step ends, for any new velocity.
TEST(Braking, TheStopAfterAStepIsTheEndOfTheNextSegment) {
  RandomStream random(3);
  for (int round = 0; round < test::rounds(20'000); ++round) {
    const auto [limits, step_s, agent] = random_case(random);
    const Vector3 next = direction(random) * random.uniform(0.0, limits.max_speed_mps);
    AgentState later = agent;
    later.position = agent.position + (agent.velocity + next) * (0.5 * step_s);
    later.velocity = next;
    const Vector3 stop = later.stopping_segment().at(1.0);
    const double rounding =
        1e-13 * (length(agent.position) + length(stop) + length(agent.velocity));
    ASSERT_LE(length(agent.stop_after(next) - stop), rounding) << "round " << round;
  }
}

// No step within the limits moves the stopping point farther than this.
TEST(Braking, StraysIsAsFarAsAStopMayMove) {
  RandomStream random(4);
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const auto [limits, step_s, agent] = random_case(random);
    const Vector3 next =
        agent.able(direction(random) * random.uniform(0.0, 3.0) * limits.max_speed_mps);
    const double strays = agent.strays() * (1.0 + 1e-12);
    ASSERT_LE(length(agent.stop_after(next) - agent.stopping_segment().at(1.0)), strays)
        << "round " << round;
  }
}

// growth_along and growth_across are the slopes of way_after.
TEST(Braking, GrowthIsTheSlopeOfTheWayAfterAStep) {
  RandomStream random(5);
  for (int round = 0; round < test::rounds(5'000); ++round) {
    const AgentState agent = random_case(random).agent;
    const Vector3& v = agent.velocity;
    const double speed = length(v);
    const Vector3 heading = v * (1.0 / speed);
    Vector3 aside = cross(heading, direction(random));
    aside = aside * (1.0 / length(aside));
    const double little = 1e-4 * speed;
    const auto grown = [&](const Vector3& by) {
      return (agent.braking.way_after(v + by * little) - agent.braking.way_after(v - by * little)) *
             (0.5 / little);
    };
    const double along = agent.braking.growth_along(speed);
    const double across = agent.braking.growth_across(speed);
    ASSERT_LE(length(grown(heading) - heading * along), 1e-6 * along) << "round " << round;
    ASSERT_LE(length(grown(aside) - aside * across), 1e-6 * across) << "round " << round;
  }
}

TEST(AgentState, ReachesTheNearestToItsWishThatItsLimitsAllow) {
  const AgentState agent{{}, {3, 0, 0}, Braking({5.0, 2.0}, 0.5), 5.0};
  EXPECT_EQ(agent.able({3.5, 0.5, 0}), (Vector3{3.5, 0.5, 0}));
  EXPECT_EQ(agent.able({5, 0, 0}), (Vector3{4, 0, 0}));
  EXPECT_EQ(agent.able({3, 0, -9}), agent.able(core::at_most({3, 0, -9}, 5.0)));
  EXPECT_EQ(agent.able({}), (Vector3{2, 0, 0}));
  const AgentState too_fast{{}, {9, 0, 0}, Braking({5.0, 2.0}, 0.5), 5.0};
  EXPECT_EQ(too_fast.able({9, 0, 0}), (Vector3{8, 0, 0}));
  EXPECT_EQ(too_fast.able({0, 5, 0}), (Vector3{8, 0, 0}));
  const AgentState nimble{{}, {3, 0, 0}, Braking({5.0, kInfinity}, 0.5), 5.0};
  EXPECT_EQ(nimble.able({-9, 0, 0}), (Vector3{-5, 0, 0}));
}

}  // namespace
}  // namespace beespace::avoidance
