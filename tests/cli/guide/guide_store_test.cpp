// What `beespace guide` and `beespace follow` remember: a store is of one process at a time, never
// goes back, and one that is damaged is left as it is.
#include "tests/cli/guide/guide_runs.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace beespace::cli_test {
namespace {

constexpr int kBadStore = 3;
constexpr int kCannotOpen = 4;

void write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

// The files of others, and what is left of one's own where a disk fails.
const std::vector<std::string> kDamaged = {
    "", "\n", "id,x,y\n", "{}", R"({"event": "hel)", R"({"event": "tick", "tick": 1})"};

TEST(GuideStore, IsOfOnePlannerAtATimeByWhicheverName) {
  const TemporaryFolder folder;
  const std::string file = folder.path("fleet.ndjson");
  const std::string link = folder.path("link.ndjson");
  std::filesystem::create_symlink("fleet.ndjson", link);
  // The link leads to a file that is not there yet.
  Running first(guide_with({"--store", link}));
  first.send(kJoin + kTick);
  expect_in(first.read_line(), R"("joined": true)");
  for (const std::string& name : {file, link, folder.path("./fleet.ndjson")}) {
    expect_failure(guide_with({"--store", name}), kTick, kCannotOpen,
                   name + ": another planner works with this store; stop it first");
  }
  first.close_input();
  EXPECT_EQ(first.finish().exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  expect_in(guide(kTick, {"--store", file}).err, "epoch      2\n");
}

TEST(GuideStore, IsFreeAgainWhenItsPlannerWasKilled) {
  const TemporaryFolder folder;
  const Arguments store = {"--store", folder.path("fleet.ndjson")};
  {
    const Running killed(guide_with(store));
    killed.send(kJoin + kTick);
    expect_in(killed.read_line(), R"("joined": true)");
  }
  EXPECT_EQ(guide(kTick, store).exit_code, 0);
}

// As where the lock was removed by hand, and another planner begun.
TEST(GuideStore, NeverGetsALowerEpoch) {
  const TemporaryFolder folder;
  const std::string file = folder.path("fleet.ndjson");
  const std::string later = R"({"event": "hello", "epoch": 9})"
                            "\n";
  Running first(guide_with({"--store", file}));
  first.send(kJoin);
  expect_in(first.read_line(), R"("joined": true)");
  write(file, later);
  first.send(kTick);
  first.close_input();
  const Finished finished = first.finish();
  EXPECT_EQ(finished.exit_code, kCannotOpen);
  expect_in(finished.err, "a planner of epoch 9 has stored here since this one, of epoch 1");
  // Nothing is said to agents any more.
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(folder.read("fleet.ndjson"), later);
}

TEST(GuideStore, ThatIsDamagedIsNamedAndLeftAsItIs) {
  for (const std::string& text : kDamaged) {
    const TemporaryFolder folder;
    const std::string file = folder.file("fleet.ndjson", text);
    expect_failure(guide_with({"--store", file}), kTick, kBadStore,
                   "fleet.ndjson:1: this file is damaged, or not what a planner stored");
    EXPECT_EQ(folder.read("fleet.ndjson"), text);
  }
}

TEST(GuideStore, NamesTheLineThatIsDamaged) {
  const TemporaryFolder folder;
  const Arguments store = {"--store", folder.path("fleet.ndjson")};
  EXPECT_EQ(guide(kJoin + kTick, store).exit_code, 0);
  const std::string whole = folder.read("fleet.ndjson");
  write(folder.path("fleet.ndjson"), whole.substr(0, whole.size() - 5));
  expect_failure(guide_with(store), kTick, kBadStore, "fleet.ndjson:2: this file is damaged");
}

TEST(FollowStore, IsOfOneAgentAtATimeByWhicheverName) {
  const TemporaryFolder folder;
  const std::string file = folder.path("a.json");
  const std::string link = folder.path("link.json");
  std::filesystem::create_symlink("a.json", link);
  Running first(follow_with({"--store", link}));
  first.send(kTick);
  expect_in(first.read_line(), R"("event": "join")");
  for (const std::string& name : {file, link}) {
    expect_failure(follow_with({"--store", name}), kTick, kCannotOpen,
                   name + ": another 'beespace follow' works with this store; stop it first");
  }
  first.close_input();
  EXPECT_EQ(first.finish().exit_code, 0);
  EXPECT_EQ(follow(kTick, {"--store", file}).exit_code, 0);
}

TEST(FollowStore, NeverPromisesALowerEpoch) {
  const TemporaryFolder folder;
  const Arguments store = {"--store", folder.path("a.json")};
  EXPECT_EQ(follow(R"({"event": "hello", "epoch": 5})", store).exit_code, 0);
  const std::string promised = folder.read("a.json");
  expect_in(promised, R"("promised": 5)");
  const Finished lower = follow(R"({"event": "hello", "epoch": 3})", store);
  EXPECT_EQ(lower.out, "");
  EXPECT_EQ(folder.read("a.json"), promised);
}

TEST(FollowStore, ThatIsDamagedIsNamedAndLeftAsItIs) {
  for (const std::string& text : kDamaged) {
    const TemporaryFolder folder;
    const std::string file = folder.file("a.json", text);
    expect_failure(follow_with({"--store", file}), kTick, kBadStore,
                   "a.json: this file is damaged, or not what agent 'a' stored");
    EXPECT_EQ(folder.read("a.json"), text);
  }
}

// A message like its own, with another path than it can fly.
TEST(FollowStore, HasAPathThatTheAgentCanFly) {
  const TemporaryFolder folder;
  const Arguments store = {"--store", folder.path("a.json")};
  const std::string command = line_with(guide(kJoin + kTick).out, R"("command")");
  EXPECT_EQ(follow(kTick + command, store).exit_code, 0);
  std::string text = folder.read("a.json");
  const std::size_t at = text.find("[0,0,30,0,0,0]");
  ASSERT_NE(at, std::string::npos) << text;
  text.replace(at, 14, "[0,0,30,99,0,0]");
  write(folder.path("a.json"), text);
  expect_failure(follow_with(store), kTick, kBadStore,
                 "agent 'a' cannot be on the branch in this file with its --planned-speed of 10");
  EXPECT_EQ(folder.read("a.json"), text);
}

}  // namespace
}  // namespace beespace::cli_test
