// The truth of one agent, against closed forms: its flight, its measurements and its clock.
#include "sim/true_agent.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace beespace::sim {
namespace {

constexpr double kInstant_s = 0.02;

Follower follower_at_rest() {
  return Follower::make(1, {9.0, 4.0}, 0.1).value();
}

// A hold, which is the root.
Command hold() {
  Command command;
  command.agent = 1;
  command.number = branch_number(1, 1);
  command.state_count = 1;
  return command;
}

// From tick 1 on it accelerates along x, for so many ticks.
Command along_x(int ticks, double acceleration_mps2) {
  Command command;
  command.agent = 1;
  command.number = branch_number(1, 2);
  command.ancestor_count = 1;
  command.ancestors[0] = {branch_number(1, 1), 1};
  command.state_count = 1;
  Mover at;
  for (int tick = 0; tick <= ticks; ++tick) {
    command.states[command.state_count++] = {at, {}};
    const double v = at.velocity.x + acceleration_mps2 * 0.1;
    at.position.x += (at.velocity.x + v) * (0.5 * 0.1);
    at.velocity.x = v;
  }
  return command;
}

void take(TrueAgent& agent, const Command& command) {
  agent.look_at_clock();
  ASSERT_EQ(agent.receive(hold()).reply, CommandReply::kTaken);
  ASSERT_EQ(agent.receive(command).reply, CommandReply::kTaken);
}

void fly(TrueAgent& agent, int instants, const Vector3& towards = {}) {
  for (int i = 0; i < instants; ++i) {
    agent.look_at_clock();
    agent.fly(towards);
  }
  agent.look_at_clock();
}

AgentLoop loop_of(LoopPlace place, double gain_per_s) {
  AgentLoop loop;
  loop.place = place;
  loop.gain_per_s = gain_per_s;
  return loop;
}

TEST(TrueAgent, WithoutErrorsIsWhereItShouldBe) {
  for (const LoopPlace place : {LoopPlace::kOnboard, LoopPlace::kGround}) {
    TrueAgent agent(follower_at_rest(), {}, loop_of(place, 2.0), {}, 1);
    take(agent, along_x(10, 3.0));
    fly(agent, 55);
    EXPECT_NEAR(agent.position().x, 0.5 * 3.0 * 1.0, 1e-12);
    EXPECT_NEAR(agent.velocity().x, 3.0, 1e-12);
    fly(agent, 200);  // the fallback: it brakes, and stands
    EXPECT_LT(agent.deviation_m(), 1e-12);
    EXPECT_NEAR(length_of(agent.velocity()), 0.0, 1e-12);
  }
}

// Without corrections a drift carries it off as fast as it blows, after the instant in which it
// begins.
TEST(TrueAgent, IsCarriedByADrift) {
  AgentErrors errors;
  errors.disturbance.drift_mps = 0.5;
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kOnboard, 0.0), errors, 3);
  fly(agent, 100);
  EXPECT_NEAR(length_of(agent.position()), 0.5 * (100 - 0.5) * kInstant_s, 1e-12);
}

// Nothing corrects it before, where the loop is closed on the ground.
TEST(TrueAgent, StandsUntilItIsToldToFlyFromTheGround) {
  AgentErrors errors;
  errors.disturbance.drift_mps = 0.5;
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kGround, 0.0), errors, 3);
  agent.look_at_clock();
  ASSERT_EQ(agent.receive(hold()).reply, CommandReply::kTaken);
  fly(agent, 100);
  EXPECT_EQ(length_of(agent.position()), 0.0);
  EXPECT_EQ(length_of(agent.velocity()), 0.0);
  TrueAgent other(follower_at_rest(), {}, loop_of(LoopPlace::kGround, 0.0), errors, 3);
  take(other, along_x(10, 3.0));
  fly(other, 55);
  EXPECT_GT(other.deviation_m(), 0.4);
}

// x' = u + w, u' = -k^2 x - 2 k u comes to rest at u = -w, x = 2 w / k.
TEST(TrueAgent, ItsLoopHoldsADriftAtTwiceTheDriftByTheGain) {
  AgentErrors errors;
  errors.disturbance.drift_mps = 0.4;
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kOnboard, 2.0), errors, 3);
  fly(agent, 1'000);
  // Sampled: of_speed / of_place instead of 2 / k; measured one instant late, one instant of drift.
  const double pole = std::exp(-2.0 * kInstant_s);
  const double of_place = (1 - pole) * (1 - pole) / (kInstant_s * kInstant_s);
  const double of_speed = (2 - 2 * pole - (1 - pole) * (1 - pole) / 2) / kInstant_s;
  EXPECT_NEAR(agent.deviation_m(), 0.4 * of_speed / of_place, 1e-9);
}

TEST(TrueAgent, AGustStaysWithinItsBoundAndFlips) {
  AgentErrors errors;
  errors.disturbance.drift_mps = 0.1;
  errors.disturbance.gust_mps = 1.0;
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kOnboard, 0.0), errors, 4);
  double along = 0.0;
  bool flipped = false;
  for (int i = 0; i < 1'000; ++i) {
    agent.fly({});
    EXPECT_LE(length_of(agent.velocity()), 1.1 + 1e-12);
    EXPECT_GE(length_of(agent.velocity()), 0.9 - 1e-12);
    const double now = agent.velocity().x;
    flipped = flipped || now * along < 0.0;
    along = now;
  }
  EXPECT_TRUE(flipped);
}

TEST(TrueAgent, AnAdversaryPushesAlongTheWayToItsNeighbour) {
  AgentErrors errors;
  errors.disturbance = {.kind = ErrorKind::kAdversarial, .drift_mps = 0.1, .gust_mps = 0.5};
  errors.report_error_m = 0.3;
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kOnboard, 0.0), errors, 4);
  agent.fly({0.0, 1.0, 0.0});
  EXPECT_EQ(agent.velocity().x, 0.0);
  EXPECT_NEAR(std::abs(agent.velocity().y - 0.1), 0.5, 1e-12);
  // What it measures says the opposite.
  const Vector3 off = vector_of(agent.report().position) - agent.position();
  EXPECT_NEAR(length_of(off), 0.3, 1e-12);
  EXPECT_LT(off.y * (agent.velocity().y - 0.1), 0.0);
}

TEST(TrueAgent, ReportsWithinTheErrorAndNotWithout) {
  AgentErrors errors;
  errors.report_error_m = 0.25;
  errors.report_velocity_error_mps = 0.1;
  TrueAgent agent(follower_at_rest(), {1.0, 2.0, 3.0}, loop_of(LoopPlace::kOnboard, 0.0), errors,
                  5);
  double most_m = 0.0;
  for (int i = 0; i < 1'000; ++i) {
    const AgentReport report = agent.report();
    most_m = std::max(most_m, length_of(vector_of(report.position) - agent.position()));
    EXPECT_LE(length_of(vector_of(*report.velocity)), 0.1);
  }
  EXPECT_LE(most_m, 0.25);
  EXPECT_GT(most_m, 0.24);
}

TEST(TrueAgent, AWeakOneFallsBehind) {
  AgentErrors errors;
  errors.strength = 0.5;
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kOnboard, 0.0), errors, 1);
  take(agent, along_x(10, 4.0));
  fly(agent, 55);
  EXPECT_NEAR(agent.velocity().x, 2.5, 1e-12);
  EXPECT_NEAR(agent.deviation_m(), 0.5 * (4.0 - 2.5), 1e-12);
}

TEST(TrueAgent, ItsClockIsOffByTheBoundAtMostAndNeverRunsBackwards) {
  for (const bool wanders : {false, true}) {
    double most_s = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      AgentClock clock({0.03, wanders, 0.05}, 20'000'000, seed);
      std::int64_t before = clock.shows_ns();
      const std::int64_t offset = before;
      for (std::int64_t instant = 1; instant < 2'000; ++instant) {
        const std::int64_t promised = clock.will_show_ns();
        clock.go_on();
        ASSERT_EQ(clock.shows_ns(), promised);
        ASSERT_GT(clock.shows_ns(), before);
        before = clock.shows_ns();
        const double off_s = static_cast<double>(before - instant * 20'000'000) * 1e-9;
        ASSERT_LE(std::abs(off_s), 0.03);
        ASSERT_TRUE(wanders || before - instant * 20'000'000 == offset);
        most_s = std::max(most_s, std::abs(off_s));
      }
    }
    EXPECT_GT(most_s, 0.025);
  }
}

// Integers: the tick is right at each instant, where floors of sums of seconds are not.
TEST(TrueAgent, CountsItsTicks) {
  TrueAgent agent(follower_at_rest(), {}, loop_of(LoopPlace::kGround, 0.0), {}, 1);
  AgentLoop floors = loop_of(LoopPlace::kGround, 0.0);
  floors.floors_ticks = true;
  TrueAgent floored(follower_at_rest(), {}, floors, {}, 1);
  int wrong = 0;
  for (std::int64_t instant = 0; instant < 1'000; ++instant) {
    agent.look_at_clock();
    floored.look_at_clock();
    ASSERT_EQ(agent.follower().tick(), instant / 5);
    wrong += floored.follower().tick() == instant / 5 ? 0 : 1;
    agent.fly({});
    floored.fly({});
  }
  EXPECT_GT(wrong, 0);
}

}  // namespace
}  // namespace beespace::sim
