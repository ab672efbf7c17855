// The least change of velocity out of a velocity obstacle leads to its edge: compared with
// sampling.
#include "avoidance/constraints/velocity_obstacle.hpp"

#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace beespace::avoidance {
namespace {

using scenes::RandomStream;
using test::long_of;
using test::LongVector;

// The closest distance of the two within the time, at constant velocities.
long double closest(const VelocityObstacle& obstacle, const LongVector& velocity, double within_s) {
  const LongVector way = velocity * static_cast<long double>(within_s);
  return test::LongSegment{{}, way}.distance_to(long_of(obstacle.place));
}

VelocityObstacle random_obstacle(RandomStream& random) {
  const double apart = std::exp(random.uniform(-3.0, 3.0));
  const double far = apart * (1.0 + std::exp(random.uniform(-6.0, 4.0)));
  const double horizon_s = std::exp(random.uniform(-1.0, 3.0));
  const double speed = far / horizon_s * std::exp(random.uniform(-2.0, 3.0));
  const Vector3 place = direction(random) * far;
  // Mostly towards it.
  const Vector3 heading = place * (1.0 / far) + direction(random) * random.uniform(0.0, 1.5);
  return {place, heading * speed, apart, horizon_s, 0.1};
}

struct Seen {
  int inside = 0;
  int outside = 0;
};

void expect_on_the_edge(const VelocityObstacle& obstacle, Seen& seen) {
  const auto [normal, change] = obstacle.way_out();
  ASSERT_NEAR(length(normal), 1.0, 1e-9);
  const LongVector v = long_of(obstacle.velocity);
  const LongVector n = long_of(normal);
  const auto apart = static_cast<long double>(obstacle.apart);
  const LongVector edge = v + n * static_cast<long double>(change);
  ASSERT_NEAR(static_cast<double>(closest(obstacle, edge, obstacle.horizon_s) / apart), 1.0, 1e-6);
  // In front of the other it is too close, behind it not.
  const long double size = test::length(v) + apart / static_cast<long double>(obstacle.horizon_s);
  ASSERT_LT(closest(obstacle, edge - n * (1e-4L * size), obstacle.horizon_s), apart);
  ASSERT_GT(closest(obstacle, edge + n * (1e-4L * size), obstacle.horizon_s), apart);
  const bool too_close = closest(obstacle, v, obstacle.horizon_s) < apart;
  if (std::abs(change) > 1e-9 * static_cast<double>(size)) {
    ASSERT_EQ(too_close, change > 0.0);
  }
  ++(too_close ? seen.inside : seen.outside);
}

TEST(VelocityObstacle, TheWayOutLeadsToTheEdge) {
  RandomStream random(1);
  Seen seen;
  for (int round = 0; round < test::rounds(100'000); ++round) {
    ASSERT_NO_FATAL_FAILURE(expect_on_the_edge(random_obstacle(random), seen)) << "round " << round;
  }
  EXPECT_GT(seen.inside, test::rounds(100'000) / 5);
  EXPECT_GT(seen.outside, test::rounds(100'000) / 5);
}

// Any smaller change leaves the velocity inside; a velocity outside stays there.
TEST(VelocityObstacle, NoWayOutIsShorter) {
  RandomStream random(2);
  for (int round = 0; round < test::rounds(2'000); ++round) {
    const VelocityObstacle obstacle = random_obstacle(random);
    const double change = std::abs(obstacle.way_out().change);
    const LongVector v = long_of(obstacle.velocity);
    const auto apart = static_cast<long double>(obstacle.apart);
    const bool too_close = closest(obstacle, v, obstacle.horizon_s) < apart;
    for (int sample = 0; sample < 100; ++sample) {
      const LongVector by = long_of(direction(random) * (change * random.uniform(0.9, 1.0)));
      const long double far = closest(obstacle, v + by, obstacle.horizon_s);
      if (too_close) {
        ASSERT_LE(far, apart * (1.0L + 1e-9L)) << "round " << round;
      } else {
        ASSERT_GE(far, apart * (1.0L - 1e-9L)) << "round " << round;
      }
    }
  }
}

// All velocities beyond the plane are outside.
TEST(VelocityObstacle, NothingBeyondTheEdgeIsTooClose) {
  RandomStream random(3);
  int beyond = 0;
  for (int round = 0; round < test::rounds(5'000); ++round) {
    const VelocityObstacle obstacle = random_obstacle(random);
    const Vector3 own = direction(random) * 3.0;
    // Any other velocity that may be flown is as good, if it is longer.
    for (const double most : {1e-9, 1e9}) {
      const VelocityObstacle::WayOut out = obstacle.way_out_within(own, most);
      ASSERT_GE(out.change, obstacle.way_out().change - 1e-9 * length(obstacle.velocity));
      const HalfSpace side = half_space_of(out, own, 1.0);
      for (int sample = 0; sample < 30; ++sample) {
        const Vector3 by = direction(random) * (2.0 * std::abs(out.change) + length(own));
        if (side.inside_by(own + by) < 0.0) continue;
        ++beyond;
        ASSERT_GE(closest(obstacle, long_of(obstacle.velocity + by), obstacle.horizon_s),
                  static_cast<long double>(obstacle.apart) * (1.0L - 1e-9L))
            << "round " << round;
      }
    }
  }
  EXPECT_GT(beyond, test::rounds(5'000));
}

// A bee at its greatest speed cannot cross in front any faster: it turns, and gets out.
TEST(VelocityObstacle, ABeeThatCannotFlyFasterTurns) {
  RandomStream random(4);
  int others = 0;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    const VelocityObstacle obstacle = random_obstacle(random);
    const Vector3 own = direction(random) * random.uniform(0.0, 10.0);
    const VelocityObstacle::WayOut shortest = obstacle.way_out();
    const VelocityObstacle::WayOut out = obstacle.way_out_within(own, 10.0);
    if (half_space_of(shortest, own, 1.0).offset <= 9.0) {
      ASSERT_EQ(out.normal, shortest.normal);
      continue;
    }
    if (out.normal == shortest.normal) continue;
    ++others;
    ASSERT_LE(half_space_of(out, own, 1.0).offset, 9.0 + 1e-9);
    ASSERT_NEAR(length(out.normal), 1.0, 1e-9);
  }
  EXPECT_GE(others, test::rounds(20'000) / 1000);
}

// A bee that is too close already is out of it after a step.
TEST(VelocityObstacle, ABeeThatIsTooCloseGetsOutInAStep) {
  RandomStream random(5);
  for (int round = 0; round < test::rounds(20'000); ++round) {
    VelocityObstacle obstacle = random_obstacle(random);
    obstacle.place = direction(random) * (obstacle.apart * random.uniform(0.0, 1.0));
    if (round % 10 == 0) obstacle.place = {};
    ASSERT_TRUE(obstacle.is_too_close());
    const auto after = [&](const VelocityObstacle::WayOut& out) {
      const Vector3 velocity = obstacle.velocity + out.normal * out.change;
      return length(obstacle.place - velocity * obstacle.step_s) / obstacle.apart;
    };
    const double scale = 1.0 + length(obstacle.velocity) * obstacle.step_s / obstacle.apart;
    ASSERT_NEAR(after(obstacle.way_out()), 1.0, 1e-9 * scale);
    ASSERT_GE(after(obstacle.away()), 1.0 - 1e-9 * scale);
  }
}

TEST(VelocityObstacle, HeadOnTurnsRight) {
  const VelocityObstacle ahead{{100, 0, 0}, {10, 0, 0}, 5.0, 20.0, 0.1};
  const VelocityObstacle::WayOut out = ahead.way_out();
  EXPECT_LT(out.normal.y, -0.99);
  EXPECT_NEAR(out.change, 10.0 * 5.0 / 100.0, 1e-12);
  const VelocityObstacle above{{0, 0, 100}, {0, 0, 10}, 5.0, 20.0, 0.1};
  EXPECT_GT(above.way_out().normal.x, 0.99);
  // Each takes half of it.
  EXPECT_NEAR(half_space_of(out, {7, 0, 0}, 0.5).offset, dot(out.normal, {7, 0, 0}) + 0.25, 1e-12);
}

}  // namespace
}  // namespace beespace::avoidance
