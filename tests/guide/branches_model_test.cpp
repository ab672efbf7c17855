// All interleavings of one planner and one agent, up to a bound: the agent is always on a branch
// that its planner still holds, and in its claim; claims grow by nothing but what is sent; and once
// both have heard each other, the next command is taken. And each rule is needed: without it, the
// search finds a history in which one of this is not so.
#include "tests/guide/branch_model.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

namespace beespace::test {
namespace {

void expect_holds(ModelBounds bounds, std::size_t states) {
  if (kSanitized) {
    --bounds.ticks;
    EXPECT_EQ(check_model(bounds).violation, "");
    return;
  }
  const ModelResult result = check_model(bounds);
  EXPECT_EQ(result.violation, "");
  EXPECT_GE(result.states, states) << result.events << " events";
  EXPECT_GT(result.taken, result.states / 100) << "hardly any command was taken";
  EXPECT_EQ(result.most_live, static_cast<std::size_t>(bounds.commands + 1));
}

void expect_found(Fault fault, const ModelBounds& bounds) {
  EXPECT_EQ(check_model(bounds).violation, "") << "without the fault";
  const ModelResult result = check_model(bounds, fault);
  EXPECT_NE(result.violation, "") << result.states << " states";
  ::testing::Test::RecordProperty("violation", result.violation);
}

TEST(BranchesModel, MessagesAreLostDelayedDoubledAndReordered) {
  expect_holds({.command_delay = 1, .commands = 4, .ticks = 6}, 9'000);
  expect_holds({.command_delay = 2, .commands = 4, .ticks = 5}, 10'000);
  expect_holds({.command_delay = 3, .commands = 4, .ticks = 5}, 30'000);
}

TEST(BranchesModel, TheRootIsLost) {
  expect_holds({.command_delay = 2, .commands = 3, .ticks = 4, .knows_root = false}, 90'000);
}

TEST(BranchesModel, TheClockIsOff) {
  expect_holds({.command_delay = 1, .commands = 3, .ticks = 4, .clock_is_off = true}, 20'000);
  expect_holds({.command_delay = 2, .commands = 3, .ticks = 4, .clock_is_off = true}, 45'000);
}

TEST(BranchesModel, TheAgentStartsAnew) {
  expect_holds(
      {.command_delay = 2, .commands = 3, .ticks = 4, .clock_is_off = true, .agent_starts = 1},
      200'000);
  expect_holds({.command_delay = 3, .commands = 3, .ticks = 3, .agent_starts = 2}, 5'000);
}

TEST(BranchesModel, ThePlannerStartsAnew) {
  expect_holds({.command_delay = 2, .commands = 3, .ticks = 4, .planner_starts = 1}, 30'000);
  expect_holds({.command_delay = 2,
                .commands = 2,
                .ticks = 3,
                .clock_is_off = true,
                .agent_starts = 1,
                .planner_starts = 1},
               140'000);
}

TEST(BranchesModel, TheAgentLosesItsBranchAndAnotherPlannerTakesIt) {
  expect_holds({.command_delay = 2,
                .commands = 2,
                .ticks = 3,
                .agent_starts = 1,
                .planner_starts = 1,
                .losses = 1},
               100'000);
  expect_holds({.command_delay = 1, .commands = 2, .ticks = 2, .planner_starts = 2, .losses = 1},
               20'000);
}

TEST(BranchesModel, AnAgentThatForgotAllJoinsAnew) {
  expect_holds({.command_delay = 1, .commands = 1, .ticks = 6, .clock_is_off = true, .rejoins = 1},
               40'000);
}

// --- each rule is needed ---

constexpr ModelBounds kPlain{.command_delay = 2, .commands = 3, .ticks = 4};

TEST(BranchesModel, FindsAPlannerWhoseClockDropsBranches) {
  expect_found(Fault::kClockDrops, kPlain);
}

TEST(BranchesModel, FindsAnAcknowledgementThatDropsANewerBranch) {
  expect_found(Fault::kTakenDropsNewer, kPlain);
}

TEST(BranchesModel, FindsALateReportThatDropsWhatWasTakenAfterIt) {
  expect_found(Fault::kLateReportIsOfNow, kPlain);
}

TEST(BranchesModel, FindsARefusalThatDrops) {
  expect_found(Fault::kRefusalDrops, kPlain);
}

TEST(BranchesModel, FindsAncestorsThatHaveNotTheirOwnDeparture) {
  expect_found(Fault::kNoAncestorTicks, kPlain);
}

TEST(BranchesModel, FindsAnAgentThatTakesACommandAsItDeparts) {
  expect_found(Fault::kTakesAtDeparture, kPlain);
}

TEST(BranchesModel, FindsAnAgentThatStoresAfterItHasReplied) {
  ModelBounds bounds = kPlain;
  bounds.agent_starts = 1;
  expect_found(Fault::kStoresLate, bounds);
}

TEST(BranchesModel, FindsAnAgentThatTakesCommandsByAClockThatWasSetBack) {
  ModelBounds bounds = kPlain;
  bounds.agent_starts = 1;
  bounds.clock_is_off = true;
  expect_found(Fault::kTakesAtOnce, bounds);
}

TEST(BranchesModel, FindsAnAgentThatTakesAnOldRoot) {
  expect_found(Fault::kRootsStay, {.command_delay = 1, .commands = 2, .ticks = 5, .rejoins = 1});
}

TEST(BranchesModel, FindsAPlannerThatAdoptsWithoutAPromise) {
  expect_found(Fault::kAdoptsUnpromised,
               {.command_delay = 2, .commands = 2, .ticks = 3, .planner_starts = 1});
}

TEST(BranchesModel, FindsAPlannerThatAdoptsTheAnswerToAnotherOne) {
  expect_found(Fault::kAdoptsOldAnswer,
               {.command_delay = 2, .commands = 2, .ticks = 3, .planner_starts = 2});
}

TEST(BranchesModel, FindsAnAgentThatForgetsItsPromise) {
  expect_found(
      Fault::kForgetsPromise,
      {.command_delay = 3, .commands = 2, .ticks = 3, .agent_starts = 1, .planner_starts = 1});
}

}  // namespace
}  // namespace beespace::test
