// `beespace guide` and `beespace follow`: what they say to each other, refuse and remember.
#include "tests/cli/guide/guide_runs.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::cli_test {
namespace {

TEST(Guide, SaysWhatFollowsFromTheFigures) {
  const Finished finished = guide(
      "", {"--deviation", "0.2", "--correction-acceleration", "1", "--correction-speed", "1"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_in(finished.err, "tube ");
  expect_in(finished.err, "threshold  2 m between true positions; nominal paths keep 2.");
  expect_in(finished.err, "--planned-speed 9 --planned-acceleration 4 --agent ID");
  EXPECT_EQ(finished.out, "");
}

TEST(Guide, FiguresThatContradictEachOtherAreWrongUsage) {
  const Finished finished = guide(kJoin, {"--deviation", "0.5"});
  EXPECT_EQ(finished.exit_code, 2);
  expect_in(finished.err, "0.5");
  EXPECT_EQ(finished.out, "");
}

TEST(Guide, OptionsThatMakeNoSense) {
  EXPECT_EQ(guide("", {"--fence", "0,0,1"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--fence", "0,0,0,1"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--shape", "cube"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--shape", "ellipsoid:0"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--clearance", "1"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--log", "x"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--obstacles", "-"}).exit_code, 2);
  EXPECT_EQ(guide("", {"--command-delay", "0"}).exit_code, 2);
}

TEST(Guide, AnAgentJoinsAndIsCommanded) {
  const Finished finished = guide(kJoin + kTick, {"--status", "all"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_in(finished.out, R"({"event": "joined", "id": "a", "joined": true)");
  expect_in(finished.out, R"({"event": "command", "id": "a", "number": "1.1")");
  expect_in(finished.out, R"({"event": "status", "id": "a", "tick": 1, "contract": "kept")");
  expect_in(finished.out, R"({"event": "ticked", "tick": 1, "agents": 1, "commands": 1)");
}

TEST(Guide, WhoIsTooCloseDoesNotJoin) {
  const Finished finished =
      guide(kJoin + R"({"event": "join", "id": "b", "position": [1, 0, 30]})");
  expect_in(line_with(finished.out, R"("id": "b")"), R"("joined": false)");
  expect_in(line_with(finished.out, R"("id": "b")"), R"("touches": ["a"])");
}

TEST(Guide, AFenceAndAnObstacleAreKept) {
  const Finished finished = guide(kJoin, {"--fence", "0,0,2,80;0,0,-1,-120"});
  expect_in(line_with(finished.out, "joined"), R"("joined": false)");
  expect_in(line_with(finished.out, "joined"), R"("fences": [0])");
}

// Each is an error that names the agent, and the others fly on.
TEST(Guide, BadMessagesAreRefusedAndTheOthersCount) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {"nonsense", "no JSON"},
      {R"({"event": "join", "id": "b", "position": [0, 9, 30], "radius": 1})", "radius_m"},
      {R"({"event": "join", "id": "a", "position": [0, 9, 30]})", "'a' has joined already"},
      {R"({"event": "goal", "id": "z", "position": [0, 9, 30]})", "'z' is not in the fleet"},
      {R"({"event": "report", "id": "a", "held": "1.9", "tick": 1, "position": [0, 0, 30]})",
       "'a' says that it is on branch 1.9"},
      {R"({"event": "ack", "id": "a", "number": "1.9", "reply": "taken", "held": "1.9", "tick": 1})",
       "never sent"},
      {R"({"event": "hello", "epoch": 4})", "for agents"},
      {R"({"event": "tick", "tick": 1})", "tick"},
      {R"({"event": "adopt", "id": "c", "period_s": 0.1, "braking_mps2": 5, "stored": {"promised": 1, "tick": 1}})",
       "no branch"}};
  for (const auto& [line, part] : bad) {
    const Finished finished =
        guide(kJoin + kTick + line + "\n" + R"({"event": "tick", "tick": 2})");
    EXPECT_EQ(finished.exit_code, 0) << line;
    expect_in(line_with(finished.out, R"("refused")"), part);
    expect_in(line_with(finished.out, R"("refused")"), R"("line": 3)");
    expect_in(finished.out, R"({"event": "ticked", "tick": 2, "agents": 1)");
    expect_in(finished.err, "1 could not be taken");
  }
}

// The next tick tells whether it was the planner that was late.
TEST(Guide, AReportFromTheFutureNamesTheAgent) {
  const Finished finished =
      guide(kJoin + kTick +
            R"({"event": "report", "id": "a", "held": "1.1", "tick": 99, "position": [0, 0, 30]})"
            "\n"
            R"({"event": "tick", "tick": 2})");
  expect_in(line_with(finished.out, R"("tick": 2, "contract")"),
            R"("contract": "out", "reason": "future", "certified": false)");
}

TEST(Guide, ALineOfTenMegabytesStopsNoAgent) {
  const Finished finished =
      guide(kJoin + R"({"event": "goal", "id": ")" + std::string(10'000'000, 'x') + "\n" + kTick);
  EXPECT_EQ(finished.exit_code, 0);
  expect_in(line_with(finished.out, R"("refused")"), "bytes");
  expect_in(finished.out, R"("event": "ticked")");
}

TEST(Guide, EachStartHasAGreaterEpochAndCallsWhoWasInTheFleet) {
  const TemporaryFolder folder;
  const Arguments store = {"--store", folder.path("fleet.ndjson")};
  expect_in(guide(kJoin + kTick, store).out, R"("number": "1.1")");
  const Finished again = guide(kTick, store);
  expect_in(again.out, R"({"event": "hello", "id": "a", "epoch": 2})");
  expect_in(again.err, "epoch      2");
  // It asked before the planner was started anew: it may be elsewhere by now.
  const Finished late = guide(kJoin + kTick, store);
  expect_in(line_with(late.out, R"("refused")"), "not answered the planner");
  const Finished gone = guide(R"({"event": "leave", "id": "a"})"
                              "\n" +
                                  kTick,
                              store);
  EXPECT_EQ(gone.out.find("hello"), std::string::npos);
  expect_in(guide(kTick, store).err, "epoch      5");
}

TEST(Guide, AStoreThatIsSomethingElseIsLeftAsItIs) {
  const TemporaryFolder folder;
  const std::string file = folder.file("other.txt", "id,x,y\n");
  const Finished finished = guide(kTick, {"--store", file});
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_EQ(folder.read("other.txt"), "id,x,y\n");
  EXPECT_EQ(guide(kTick, {"--store", folder.path("none/fleet.ndjson")}).exit_code, 4);
}

// What a guide commands a follower takes, and remembers.
TEST(Follow, TakesACommandAndGoesOnWithItAfterARestart) {
  const TemporaryFolder folder;
  const Arguments store = {"--store", folder.path("a.json"), "--simulated"};
  const std::string command = line_with(guide(kJoin + kTick).out, R"("command")");
  const Finished first = follow(kTick + command + "\n" + R"({"event": "tick", "tick": 2})", store);
  EXPECT_EQ(first.exit_code, 0);
  expect_in(first.out, R"({"event": "join", "id": "a", "position": [0,0,30])");
  expect_in(first.out,
            R"({"event": "ack", "id": "a", "number": "1.1", "reply": "taken", "held": "1.1")");
  expect_in(first.out, R"({"event": "report", "id": "a", "held": "1.1", "tick": 2)");
  const Finished again = follow(R"({"event": "hello", "epoch": 2})", store);
  expect_in(again.out, R"("braking_mps2": 5, "stored": {"promised": 2)");
  const Finished other = follow("", {"--store", folder.path("a.json"), "--period", "0.2"});
  EXPECT_EQ(other.exit_code, 2) << other.err;
}

TEST(Follow, TakesNothingThatWasPlannedOtherwise) {
  const std::string command =
      line_with(guide(kJoin + kTick, {"--correction-acceleration", "1"}).out, R"("command")");
  const Finished finished = follow(kTick + command);
  expect_in(finished.out, R"("reply": "invalid")");
  expect_in(finished.err, "brakes with 4 m/s^2");
}

TEST(Follow, LeavesOutWhatIsWrongOrAboutOthers) {
  const Finished finished = follow(
      "nonsense\n"
      R"({"event": "goal", "id": "b"})"
      "\n"
      R"({"event": "status"})"
      "\n");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "");
  expect_in(finished.err, "bad lines  1 left out");
}

TEST(Follow, AStoreOfAnotherAgentIsRefused) {
  const TemporaryFolder folder;
  const std::string file = folder.file(
      "a.json",
      R"({"event": "adopt", "id": "b", "period_s": 0.1, "braking_mps2": 5, "stored": {"promised": 1, "tick": 1}})");
  EXPECT_EQ(follow("", {"--store", file}).exit_code, 3);
}

}  // namespace
}  // namespace beespace::cli_test
