// Messages and values that `beespace guide` refuses: what it says, and what it no longer promises.
#include "tests/cli/guide/guide_runs.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::cli_test {
namespace {

const std::string kClear = R"("clear_of_intruders": true)";
const std::string kNotClear = R"("clear_of_intruders": false)";
const std::string kNoIntruders = R"({"event": "intruders", "intruders": []})"
                                 "\n";

// Of a tick with --status all.
std::string status_at(const std::string& out, int number) {
  return line_with(out, R"("event": "status", "id": "a", "tick": )" + std::to_string(number) + ",");
}

// One number is wrong, a member is misspelt, the line ends too early or is too long.
const std::vector<std::string> kBadIntruders = {
    R"({"event": "intruders", "intruders": [{"position": [1e300, 0, 0]}]})",
    R"({"event": "intruders", "intruders": [{"position": [90, 0, 30], "radius_m": -1}]})",
    R"({"event": "intruders", "intruders": [{"position": [90, 0, 30], "radius": 1}]})",
    R"({"event": "intruders", "intruders": [{"position": [90, )",
    R"({"event": "intruders")" + std::string(300'000, ' ') + R"(, "intruders": []})"};

TEST(GuideIntruders, ABadListLeavesNoAgentClearUntilTheNextGoodOne) {
  for (const std::string& bad : kBadIntruders) {
    const Finished finished = guide(
        kJoin + kNoIntruders + tick(1) + bad + "\n" + tick(2) + tick(3) + kNoIntruders + tick(4),
        {"--status", "all"});
    EXPECT_EQ(finished.exit_code, 0);
    expect_in(line_with(finished.out, R"("refused")"), R"("line": 4)");
    expect_in(status_at(finished.out, 1), kClear);
    expect_in(status_at(finished.out, 2), kNotClear);
    expect_in(status_at(finished.out, 3), kNotClear);
    expect_in(status_at(finished.out, 4), kClear);
  }
}

TEST(GuideIntruders, AnotherBadLineTellsNothingOfThem) {
  for (const std::string bad : {"nonsense", R"({"event": "goal", "id": "a", "position": [1, )"}) {
    const Finished finished =
        guide(kJoin + kNoIntruders + tick(1) + bad + "\n" + tick(2), {"--status", "all"});
    expect_in(finished.out, R"("refused")");
    expect_in(status_at(finished.out, 2), kClear);
  }
}

// It comes from 60 m at 20 m/s, and has flown past after 3 s.
TEST(GuideIntruders, ThoseOfTheLastListFlyOnAfterABadOne) {
  const std::string list =
      R"({"event": "intruders", "intruders": [{"position": [60, 0, 30], "velocity": [-20, 0, 0]}]})"
      "\n";
  const std::string near = R"("intruder_conflict", "id": "a", "tick": 11, "intruder": 0)";
  for (const std::string& bad : kBadIntruders) {
    const std::string begin = kJoin + list + tick(1);
    expect_in(guide(begin + bad + "\n" + tick(11)).out, near);
    expect_in(guide(begin + tick(10) + bad + "\n" + tick(11)).out, near);
    const Finished past = guide(begin + tick(50) + bad + "\n" + tick(51));
    expect_in(past.out, R"("ticked", "tick": 51)");
    EXPECT_EQ(past.out.find(R"("tick": 51, "intruder")"), std::string::npos) << past.out;
  }
}

TEST(GuideMavlink, ASystemHasOneName) {
  const std::string join = R"({"event": "join", "id": "007", "position": [0, 0, 30]})"
                           "\n"
                           R"({"event": "join", "id": "7", "position": [0, 9, 30]})"
                           "\n";
  const TemporaryFolder folder;
  const std::string log = folder.path("log.ndjson");
  const Finished finished = guide(join + kTick, {"--format", "mavlink", "--log", log});
  EXPECT_EQ(finished.exit_code, 0);
  const std::string told = folder.read("log.ndjson");
  expect_in(line_with(told, R"("id": "007")"), R"("event": "refused")");
  expect_in(line_with(told, R"("id": "007")"), "1 to 254 without zeros before it, and '007'");
  expect_in(line_with(told, R"("id": "7")"), R"("joined": true)");
  expect_in(told, R"("ticked", "tick": 1, "agents": 1,)");
}

// Where it is on its branch was known to the planner before alone.
TEST(GuideMavlink, NoAgentIsAdopted) {
  const TemporaryFolder folder;
  const std::string log = folder.path("log.ndjson");
  const std::string adopt =
      R"({"event": "adopt", "id": "7", "period_s": 0.1, "braking_mps2": 5, "stored": {"promised": 2, "tick": 1, "branch": {"number": "1.1", "starts": 0, "path": [[0,0,30,0,0,0]], "ancestors": []}}})"
      "\n";
  guide(adopt + kTick, {"--format", "mavlink", "--log", log, "--epoch", "2"});
  expect_in(line_with(folder.read("log.ndjson"), R"("refused")"), "'7' is, let it leave");
  expect_in(line_with(guide(adopt + kTick, {"--epoch", "2"}).out, R"("joined")"),
            R"("joined": true)");
}

TEST(GuideMessages, BranchesAreNamedAsInMessages) {
  const std::string fly = kJoin + kTick +
                          R"({"event": "ack", "id": "a", "number": "1.1", "reply": "taken", )"
                          R"("held": "1.1", "tick": 1})"
                          "\n"
                          R"({"event": "goal", "id": "a", "position": [50, 0, 30]})"
                          "\n" +
                          tick(2) +
                          R"({"event": "ack", "id": "a", "number": "1.2", "reply": "taken", )"
                          R"("held": "1.2", "tick": 2})"
                          "\n" +
                          tick(3);
  const Finished never = guide(
      fly + R"({"event": "report", "id": "a", "held": "1.9", "tick": 3, "position": [0, 0, 30]})");
  expect_in(line_with(never.out, R"("refused")"), "is on branch 1.9, which was never sent");
  const Finished acknowledged = guide(
      fly +
      R"({"event": "ack", "id": "a", "number": "1.9", "reply": "taken", "held": "1.9", "tick": 3})");
  expect_in(line_with(acknowledged.out, R"("refused")"),
            "acknowledges branch 1.9, which was never sent");
  const Finished back = guide(
      fly + R"({"event": "report", "id": "a", "held": "1.1", "tick": 3, "position": [0, 0, 30]})");
  expect_in(line_with(back.out, R"("refused")"),
            "is on branch 1.1, after it acknowledged branch 1.2;");
}

TEST(GuideOptions, ErrorsOfShapesQuoteAllThatWasTyped) {
  for (const std::string shape : {"cylinder:0", "cylinder:", "cylinder:1e99", "ellipsoid:-1",
                                  "ellipsoid:x", "cube", "cylinder"}) {
    expect_usage_error(guide_with({"--shape", shape}), "--shape '" + shape + "' is ");
    expect_usage_error({"simulate", "head-on", "--shape", shape}, "--shape '" + shape + "' is ");
  }
}

TEST(GuideOptions, ErrorsOfAFileOfFencesNameTheLine) {
  const TemporaryFolder folder;
  const std::string file = folder.file("fence", "# the ground\n0,0,1,10\n\n0,0,-1\n");
  expect_failure(guide_with({"--fence", file}), "", 3, "fence:4: '0,0,-1' is no plane");
  const std::string empty = folder.file("empty", "# nothing\n");
  expect_failure(guide_with({"--fence", empty}), "", 3, "empty: there is no plane in this file");
}

}  // namespace
}  // namespace beespace::cli_test
