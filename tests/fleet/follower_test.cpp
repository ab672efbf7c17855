#include <beespace/command.hpp>
#include <beespace/follower.hpp>

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace beespace {
namespace {

constexpr AgentId kAgent = 7;
constexpr FlightLimits kPlanned{.max_speed_mps = 8.0, .max_acceleration_mps2 = 2.0};
constexpr double kPeriod_s = 0.5;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Tick kFirst = std::numeric_limits<Tick>::min();
constexpr Tick kLast = std::numeric_limits<Tick>::max();

BranchNumber number(std::uint32_t count, std::uint32_t epoch = 1) {
  return branch_number(epoch, count);
}

// The agent holds a place.
Command root(BranchNumber of, Tick starts = 9) {
  Command command;
  command.agent = kAgent;
  command.number = of;
  command.starts = starts;
  command.state_count = 4;
  for (auto& state : command.states) state.nominal.position = {1, 2, 3};
  return command;
}

// It follows another one up to a tick, and accelerates from there for a tick.
Command departing(const Command& base, BranchNumber of, Tick departs, double speed_mps) {
  Command command = base;
  command.number = of;
  command.state_count = static_cast<std::uint32_t>(departs + 2 - base.starts);
  for (std::size_t i = base.state_count; i < command.state_count; ++i) {
    command.states[i] = command.states[i - 1];
  }
  Mover& last = command.states[command.state_count - 1].nominal;
  const Mover& before = command.states[command.state_count - 2].nominal;
  last.velocity = {speed_mps, 0, 0};
  last.position = before.position;
  last.position.x += (before.velocity.x + speed_mps) * (0.5 * kPeriod_s);
  command.ancestors[0] = {base.number, departs};
  command.ancestor_count = 1;
  return command;
}

Follower fresh(Tick tick = 10) {
  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  follower.advance(tick);
  return follower;
}

Follower rooted(Tick tick = 10) {
  Follower follower = fresh(tick);
  EXPECT_EQ(follower.receive(root(number(1))).reply, CommandReply::kTaken);
  return follower;
}

CommandReply reply_to(Follower follower, const Command& command) {
  const BranchNumber held = follower.held();
  const Acknowledgement reply = follower.receive(command);
  EXPECT_EQ(reply.agent, kAgent);
  EXPECT_EQ(reply.number, command.number);
  EXPECT_EQ(reply.tick, follower.tick());
  EXPECT_EQ(reply.held, follower.held());
  EXPECT_EQ(follower.held(), reply.reply == CommandReply::kTaken ? command.number : held);
  return reply.reply;
}

TEST(Follower, IsMadeOfFiguresThatMakeSense) {
  EXPECT_TRUE(Follower::make(kAgent, kPlanned, kPeriod_s));
  EXPECT_TRUE(Follower::make(kAgent, {.max_speed_mps = 0, .max_acceleration_mps2 = 1}, 1.0));
  for (const double wrong : {0.0, -1.0, kNan, kInfinity}) {
    EXPECT_FALSE(Follower::make(kAgent, kPlanned, wrong)) << wrong;
    EXPECT_FALSE(Follower::make(kAgent, {8.0, wrong}, kPeriod_s)) << wrong;
    if (wrong != 0.0) {
      EXPECT_FALSE(Follower::make(kAgent, {wrong, 2.0}, kPeriod_s)) << wrong;
    }
  }
  const auto endless = Follower::make(kAgent, {1e20, 1e-20}, kPeriod_s);
  ASSERT_FALSE(endless);
  EXPECT_EQ(endless.error().code, ErrorCode::kInvalidArgument);
  EXPECT_NE(endless.error().message.find("1e+20"), std::string::npos) << endless.error().message;
}

TEST(Follower, TakesARootOnlyWhereItIsOnNoBranch) {
  EXPECT_EQ(reply_to(fresh(), root(number(1))), CommandReply::kTaken);
  EXPECT_EQ(reply_to(rooted(), root(number(2))), CommandReply::kNoAncestor);
  EXPECT_EQ(reply_to(rooted(), root(number(1))), CommandReply::kOlder);
  EXPECT_EQ(reply_to(fresh(), departing(root(number(1)), number(2), 12, 1)),
            CommandReply::kNoBranch);
}

TEST(Follower, TakesARootOnlyWhileItsStatesLast) {
  EXPECT_EQ(reply_to(fresh(8), root(number(1))), CommandReply::kTooEarly);
  EXPECT_EQ(reply_to(fresh(9), root(number(1))), CommandReply::kTaken);
  EXPECT_EQ(reply_to(fresh(12), root(number(1))), CommandReply::kTaken);
  EXPECT_EQ(reply_to(fresh(13), root(number(1))), CommandReply::kTooLate);
}

TEST(Follower, TakesARootOnlyOfAnAgentThatStands) {
  Command moves = root(number(1));
  for (std::size_t i = 0; i < moves.state_count; ++i) {
    moves.states[i].nominal.velocity = {0.5, 0, 0};
    moves.states[i].nominal.position.x = 0.25 * static_cast<double>(i);
  }
  EXPECT_EQ(reply_to(fresh(), moves), CommandReply::kInvalid);
}

TEST(Follower, TakesABranchBeforeItDeparts) {
  const Command next = departing(root(number(1)), number(2), 12, 1.0);
  EXPECT_EQ(reply_to(rooted(10), next), CommandReply::kTaken);
  EXPECT_EQ(reply_to(rooted(11), next), CommandReply::kTaken);
  EXPECT_EQ(reply_to(rooted(12), next), CommandReply::kTooLate);
  Command later = next;
  later.starts = 11;
  later.ancestors[0].departs = 14;
  EXPECT_EQ(reply_to(rooted(10), later), CommandReply::kTooEarly);
}

TEST(Follower, TakesNoBranchThatDoesNotListItsOwn) {
  Command next = departing(root(number(2)), number(3), 12, 1.0);
  EXPECT_EQ(reply_to(rooted(), next), CommandReply::kNoAncestor);
  next.ancestors[1] = {number(1), 11};
  next.ancestor_count = 2;
  EXPECT_EQ(reply_to(rooted(10), next), CommandReply::kTaken);
  EXPECT_EQ(reply_to(rooted(11), next), CommandReply::kTooLate) << "each has its own departure";
}

TEST(Follower, TakesNothingOlder) {
  Follower follower = rooted();
  const Command second = departing(root(number(1)), number(2), 12, 1.0);
  const Command third = departing(root(number(1)), number(3), 12, 1.0);
  ASSERT_EQ(follower.receive(third).reply, CommandReply::kTaken);
  EXPECT_EQ(reply_to(follower, second), CommandReply::kOlder);
  EXPECT_EQ(reply_to(follower, third), CommandReply::kOlder);
}

TEST(Follower, KeepsItsPromise) {
  Follower follower = rooted();
  EXPECT_TRUE(follower.promise(3));
  EXPECT_TRUE(follower.promise(3));
  EXPECT_FALSE(follower.promise(2));
  EXPECT_EQ(follower.stored().promised, 3U);
  EXPECT_EQ(reply_to(follower, departing(root(number(1)), number(9, 2), 12, 1.0)),
            CommandReply::kOlder);
  EXPECT_EQ(reply_to(follower, departing(root(number(1)), number(1, 3), 12, 1.0)),
            CommandReply::kTaken);
}

TEST(Follower, ATakenCommandPromisesItsEpoch) {
  Follower follower = fresh();
  ASSERT_EQ(follower.receive(root(number(1, 4))).reply, CommandReply::kTaken);
  EXPECT_FALSE(follower.promise(3));
  EXPECT_TRUE(follower.promise(4));
}

TEST(Follower, OneThatLostItsBranchTakesNothingOfThatEpoch) {
  Follower follower = rooted();
  follower.lose();
  EXPECT_EQ(follower.held(), 0U);
  EXPECT_EQ(follower.setpoint(0.1), Setpoint{});
  EXPECT_EQ(reply_to(follower, root(number(1))), CommandReply::kOlder);
  EXPECT_EQ(reply_to(follower, departing(root(number(1)), number(2), 12, 1.0)),
            CommandReply::kOlder);
  EXPECT_EQ(reply_to(follower, departing(root(number(1)), number(1, 2), 12, 1.0)),
            CommandReply::kNoBranch);
  EXPECT_EQ(reply_to(follower, root(number(1, 2))), CommandReply::kTaken);
}

TEST(Follower, ItsTickNeverRunsBackwards) {
  Follower follower = rooted(10);
  follower.advance(12);
  follower.advance(11);
  EXPECT_EQ(follower.tick(), 12);
  follower.advance(kFirst);
  EXPECT_EQ(follower.tick(), 12);
}

TEST(Follower, KnowsNoTickBeforeTheFirst) {
  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  EXPECT_EQ(reply_to(follower, root(number(1), 0)), CommandReply::kTooEarly);
  follower.advance(-3);
  EXPECT_EQ(follower.tick(), -3);
}

TEST(Follower, GoesOnAfterARestart) {
  Follower before = rooted(10);
  before.advance(11);
  ASSERT_EQ(before.receive(departing(root(number(1)), number(2), 13, 1.0)).reply,
            CommandReply::kTaken);
  Follower after = *Follower::make(kAgent, kPlanned, kPeriod_s);
  ASSERT_TRUE(after.restore(before.stored()));
  EXPECT_EQ(after.held(), number(2));
  before.advance(14);
  after.advance(14);
  EXPECT_EQ(after.setpoint(0.2), before.setpoint(0.2));
  EXPECT_EQ(after.stored().promised, 1U);
}

// Its clock may have been set back by two ticks: no command that has departed by the old clock may
// be taken by the new one.
TEST(Follower, TakesCommandsTwoTicksAfterARestart) {
  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  ASSERT_TRUE(follower.restore(rooted(10).stored()));
  const Command next = departing(root(number(1)), number(2), 20, 1.0);
  EXPECT_EQ(reply_to(follower, next), CommandReply::kTooEarly);
  follower.advance(9);
  EXPECT_EQ(follower.tick(), 10) << "it does not run backwards";
  EXPECT_EQ(reply_to(follower, next), CommandReply::kTooEarly);
  follower.advance(11);
  EXPECT_EQ(reply_to(follower, next), CommandReply::kTooEarly);
  follower.advance(12);
  EXPECT_EQ(reply_to(follower, next), CommandReply::kTaken);
}

TEST(Follower, RestoresNothingThatCannotHaveBeenStored) {
  Follower follower = *Follower::make(kAgent, kPlanned, kPeriod_s);
  EXPECT_TRUE(follower.restore({})) << "on no branch";
  StoredBranch stored = rooted().stored();
  stored.branch.agent = 8;
  ASSERT_FALSE(follower.restore(stored));
  EXPECT_NE(follower.restore(stored).error().message.find("agent 7"), std::string::npos);
  stored = rooted().stored();
  stored.branch.state_count = 0;
  EXPECT_FALSE(follower.restore(stored));
  EXPECT_EQ(follower.held(), 0U) << "an error changes nothing";
}

TEST(Follower, SaysWhereToBe) {
  Follower follower = rooted(10);
  EXPECT_EQ(follower.setpoint(0.3), (Setpoint{{{1, 2, 3}, {}}, {}, false}));
  Command next = departing(root(number(1)), number(2), 12, 1.0);
  next.states[4].correction = {0, 0.5, 0};  // at tick 13
  ASSERT_EQ(follower.receive(next).reply, CommandReply::kTaken);
  EXPECT_EQ(follower.setpoint(0.3).nominal.position, (Point{1, 2, 3}));
  // Halfway to a metre per second.
  const Setpoint starts{{{1 + 0.0625, 2, 3}, {0.5, 0, 0}}, {0, 0.25, 0}, false};
  EXPECT_EQ(follower.setpoint(1.25), starts);
  follower.advance(12);
  EXPECT_EQ(follower.setpoint(0.25), starts);
  // It has braked after a tick more.
  const Setpoint stands{{{1 + 0.5, 2, 3}, {}}, {}, true};
  EXPECT_EQ(follower.setpoint(1.0), stands);
  EXPECT_EQ(follower.setpoint(1e9), stands);
  EXPECT_EQ(follower.setpoint(kInfinity), stands);
  follower.advance(kLast);
  EXPECT_EQ(follower.setpoint(0.0), stands);
  EXPECT_EQ(follower.setpoint(kInfinity), stands);
  follower.advance(12);
  EXPECT_EQ(follower.setpoint(kNan), follower.setpoint(0.0));
  EXPECT_EQ(follower.setpoint(-1.0), follower.setpoint(0.0));
}

// --- what comes may be anything ---

class HostileCommand : public ::testing::Test {
 protected:
  void expect_invalid(const char* why) const {
    EXPECT_EQ(reply_to(rooted(), command_), CommandReply::kInvalid) << why;
  }

  Command command_ = departing(root(number(1)), number(2), 12, 1.0);
};

TEST_F(HostileCommand, ItsCountsAreBeyondItsArrays) {
  for (const std::uint32_t count : {0U, 37U, 0xFFFF'FFFFU}) {
    command_.state_count = count;
    expect_invalid("states");
  }
  command_.state_count = 5;
  for (const std::uint32_t count : {17U, 0xFFFF'FFFFU}) {
    command_.ancestor_count = count;
    expect_invalid("ancestors");
  }
}

TEST_F(HostileCommand, ItsNumbersCannotBe) {
  for (const BranchNumber of : {number(0, 0), number(2, 0), number(0, 2)}) {
    command_.number = of;
    expect_invalid("its own");
  }
  command_.number = number(2);
  for (const BranchNumber of : {number(0, 0), number(2), number(3), number(1, 2)}) {
    command_.ancestors[0].number = of;
    expect_invalid("that of an ancestor");
  }
  command_.number = number(4);
  command_.ancestor_count = 2;
  command_.ancestors[0] = {number(1), 11};
  command_.ancestors[1] = {number(1), 12};
  expect_invalid("twice the same");
}

TEST_F(HostileCommand, ItIsOfAnotherAgent) {
  command_.agent = 8;
  expect_invalid("agent");
}

TEST_F(HostileCommand, ItsTicksAreAtTheEnds) {
  for (const Tick tick : {kFirst, kFirst + 1, kLast - 40, kLast}) {
    Command other = command_;
    other.starts = tick;
    EXPECT_EQ(reply_to(rooted(), other), CommandReply::kInvalid);
    for (const Tick at : {kFirst, kLast}) {
      EXPECT_EQ(reply_to(fresh(at), other), CommandReply::kInvalid);
      Command hold = root(number(1), tick);
      EXPECT_EQ(reply_to(fresh(at), hold), CommandReply::kInvalid);
      EXPECT_NE(reply_to(fresh(at), root(number(1))), CommandReply::kTaken);
    }
    other = command_;
    other.ancestors[0].departs = tick;
    EXPECT_EQ(reply_to(rooted(), other),
              tick < 0 ? CommandReply::kTooLate : CommandReply::kInvalid);
  }
}

TEST_F(HostileCommand, ItsValuesAreNoNumbers) {
  for (const double wrong : {kNan, kInfinity, -kInfinity, 1e300}) {
    for (std::size_t at = 0; at < command_.state_count; ++at) {
      for (int value = 0; value < 9; ++value) {
        Command other = command_;
        BranchState& state = other.states[at];
        const std::array<double*, 9> values = {
            &state.nominal.position.x, &state.nominal.position.y, &state.nominal.position.z,
            &state.nominal.velocity.x, &state.nominal.velocity.y, &state.nominal.velocity.z,
            &state.correction.x,       &state.correction.y,       &state.correction.z};
        *values[static_cast<std::size_t>(value)] = wrong;
        EXPECT_EQ(reply_to(rooted(), other), CommandReply::kInvalid) << wrong;
      }
    }
  }
}

TEST_F(HostileCommand, ItsStatesJump) {
  Command other = command_;
  other.states[3].nominal.position.x += 1e-3;
  EXPECT_EQ(reply_to(rooted(), other), CommandReply::kInvalid) << "a place";
  EXPECT_EQ(reply_to(rooted(), departing(root(number(1)), number(2), 12, 1.001)),
            CommandReply::kInvalid)
      << "more than the acceleration allows";
  Command fast = root(number(1));
  for (std::size_t i = 0; i < fast.state_count; ++i) {
    fast.states[i].nominal = {{4.5 * static_cast<double>(i), 0, 0}, {9, 0, 0}};
  }
  EXPECT_EQ(reply_to(fresh(), fast), CommandReply::kInvalid) << "more than the greatest speed";
}

// It is a path, but not from where the agent is.
TEST_F(HostileCommand, ItJumpsFromTheBranchThatItDepartsFrom) {
  for (std::size_t i = 0; i < command_.state_count; ++i) {
    command_.states[i].nominal.position.z += 0.5;
  }
  expect_invalid("a place beside it");
  command_ = departing(root(number(1)), number(2), 10, 1.0);
  command_.ancestors[0].departs = 11;
  expect_invalid("it departs before it says");
}

// Any bytes at all: nothing but what the rules allow is taken. (What a sanitizer finds is found.)
TEST_F(HostileCommand, ItIsNoise) {
  std::mt19937_64 random(5);
  int taken = 0;
  for (int round = 0; round < 20'000; ++round) {
    Command other = command_;
    auto* const bytes = reinterpret_cast<unsigned char*>(&other);
    for (int change = 0; change < 3; ++change) {
      // Mostly in the first fields and states.
      const std::size_t size = round % 2 == 0 ? 400 : sizeof(Command);
      bytes[random() % size] = static_cast<unsigned char>(random());
    }
    Follower follower = rooted();
    const CommandReply reply = follower.receive(other).reply;
    taken += reply == CommandReply::kTaken ? 1 : 0;
    const Setpoint setpoint = follower.setpoint(100.0);
    ASSERT_TRUE(std::isfinite(setpoint.nominal.position.x));
    ASSERT_TRUE(setpoint.holding);
  }
  EXPECT_GT(taken, 100) << "bytes that do not count";
  EXPECT_LT(taken, 19'000);
}

}  // namespace
}  // namespace beespace
