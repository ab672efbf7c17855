#include "fleet/nominal_path.hpp"

#include "avoidance/agent_state.hpp"
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace beespace::fleet {
namespace {

using scenes::RandomStream;

constexpr FlightLimits kLimits{.max_speed_mps = 10.0, .max_acceleration_mps2 = 4.0};
constexpr double kPeriod_s = 0.25;

Mover random_mover(RandomStream& random) {
  const Vector3 at = core::vector_of(scenes::random_direction(random)) * random.uniform(0.0, 1e3);
  const Vector3 v = core::vector_of(scenes::random_direction(random)) * random.uniform(0.0, 10.0);
  return {point_of(at), velocity_of(v)};
}

// The Adviser tells to brake, or nothing is sent: both must be the same doubles.
TEST(NominalPath, BrakesAsTheAdviserDoes) {
  RandomStream random(1);
  const Braking braking(kLimits, kPeriod_s);
  for (int round = 0; round < test::rounds(10'000); ++round) {
    const Mover state = random_mover(random);
    const Vector3 advised = braking.braked(core::vector_of(state.velocity));
    const Mover next = braked_step(state, braking);
    ASSERT_EQ(next.velocity, velocity_of(advised));
    ASSERT_EQ(next, step_to(state, velocity_of(advised), kPeriod_s));
  }
}

TEST(NominalPath, FollowsItsStatesAndThenBrakesToAStop) {
  const Braking braking(kLimits, kPeriod_s);
  std::vector<BranchState> states(3);
  states[0].nominal = {{0, 0, 0}, {2, 0, 0}};
  states[1] = {step_to(states[0].nominal, {2.5, 0, 0}, kPeriod_s), {0, 1, 0}};
  states[2] = {step_to(states[1].nominal, {2.5, 0, 0}, kPeriod_s), {0, 2, 0}};
  const Path path{100, states};
  EXPECT_EQ(path.last_tick(), 102);
  EXPECT_EQ(path.at(100, braking), states[0]);
  EXPECT_EQ(path.at(102, braking), states[2]);
  EXPECT_EQ(path.at(-5, braking), states[0]);
  EXPECT_EQ(path.at(103, braking).nominal.velocity, (Velocity{1.5, 0, 0}));
  EXPECT_EQ(path.at(103, braking).correction, Velocity{});
  EXPECT_EQ(path.at(104, braking).nominal.velocity, (Velocity{0.5, 0, 0}));
  const BranchState stop = path.at(105, braking);
  EXPECT_TRUE(stands(stop.nominal));
  EXPECT_EQ(path.at(std::numeric_limits<Tick>::max(), braking), stop);
}

TEST(NominalPath, ChangesVelocityEvenlyWithinATick) {
  const BranchState from{{{1, 0, 0}, {2, 0, 0}}, {0, 4, 0}};
  const BranchState next{step_to(from.nominal, {4, 0, 0}, 0.5), {0, 0, 0}};
  EXPECT_EQ(within_tick(from, next, 0.0, 0.5), from);
  const BranchState half = within_tick(from, next, 0.25, 0.5);
  EXPECT_EQ(half.nominal.velocity, (Velocity{3, 0, 0}));
  EXPECT_EQ(half.nominal.position, (Point{1.625, 0, 0}));
  EXPECT_EQ(half.correction, (Velocity{0, 2, 0}));
}

// Places at ticks are the middles of the middles of ticks: claims need not name them.
TEST(NominalPath, PlacesAtTicksLieHalfwayBetweenTheMiddlesOfTicks) {
  RandomStream random(2);
  for (int round = 0; round < test::rounds(10'000); ++round) {
    const Mover state = random_mover(random);
    const Mover next = step_to(state, random_mover(random).velocity, kPeriod_s);
    const Vector3 before = core::vector_of(middle_of_tick(state, kPeriod_s));
    const Vector3 after = core::vector_of(middle_of_tick(next, kPeriod_s));
    const Vector3 off = (before + after) * 0.5 - core::vector_of(next.position);
    ASSERT_LE(core::length(off), 1e-12);
  }
}

// While it brakes, an agent is on the segment from the middle of the tick before to its latest
// stop.
TEST(NominalPath, TheFallbackStaysOnItsSegment) {
  RandomStream random(3);
  const Braking braking(kLimits, kPeriod_s);
  for (int round = 0; round < test::rounds(2'000); ++round) {
    Mover state = random_mover(random);
    const Vector3 begin = core::vector_of(state.position);
    const Vector3 way = core::vector_of(latest_stop(state, braking)) - begin;
    const double along = core::length(way);
    for (; !stands(state); state = braked_step(state, braking)) {
      const Vector3 middle = core::vector_of(middle_of_tick(state, kPeriod_s)) - begin;
      const Vector3 stop = core::vector_of(latest_stop(state, braking)) - begin;
      for (const Vector3& place : {middle, stop}) {
        ASSERT_LE(core::length(cross(place, way)), 1e-12 * (1.0 + along) * (1.0 + along));
        ASSERT_GE(dot(place, way), 0.0);
        ASSERT_LE(core::length(place), along * (1.0 + 1e-12));
      }
    }
  }
}

}  // namespace
}  // namespace beespace::fleet
