// `beespace report --fleet-log`: a flight of `simulate` and what its planner said, in one page.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

using report_test::has;
using report_test::Json;

// Ten bees, of which some are weak, over a link that loses.
class ReportFleet : public PageCommand {
 protected:
  void SetUp() override {
    PageCommand::SetUp();
    if (IsSkipped()) return;
    flown_ = folder_.path("flown.csv");
    log_ = folder_.path("fleet.ndjson");
    const Finished finished = run({"simulate", "random-swap", "--bees", "10", "--steps", "60",
                                   "--noise", "0.1", "--gust", "0.3", "--loss", "20%", "--weak",
                                   "20%:0.3", "--output", flown_, "--fleet-log", log_, "--quiet"});
    ASSERT_EQ(finished.exit_code, 0) << finished.err;
  }

  std::string flown_;
  std::string log_;
};

TEST_F(ReportFleet, ThePageHasEachTickOfEachBee) {
  const Page page = reported({flown_, "--fleet-log", log_, "--threshold", "5"});
  const Json fleet = page.swarm()["fleet"];
  const Json states = fleet["states"];
  EXPECT_EQ(report_test::text_of(fleet["title"]), "fleet.ndjson");
  EXPECT_EQ(page.numbers(states["counts"]), std::vector<std::uint64_t>(10, 60));
  const auto contracts = page.numbers(states["contract"]);
  EXPECT_NE(std::count(contracts.begin(), contracts.end(), 2), 0);
  const auto newest = page.numbers(states["newest"]);
  EXPECT_EQ(std::count(newest.begin(), newest.end(), 0), 0);
  const auto times_s = page.values(states["time_s"]);
  EXPECT_DOUBLE_EQ(times_s.front(), 0.0);
  EXPECT_NEAR(times_s.back(), 5.9, 1e-9);
}

TEST_F(ReportFleet, WithoutALogThePageIsAsItWas) {
  const Page with = reported({flown_, "--fleet-log", log_, "--threshold", "5"});
  const Page without = reported({flown_, "--threshold", "5"});
  EXPECT_FALSE(has(without.swarm(), "fleet"));
  const auto& elements = without.parts.elements;
  ASSERT_LT(elements.size(), with.parts.elements.size());
  EXPECT_TRUE(std::equal(elements.begin(), elements.end(), with.parts.elements.begin()));
}

TEST_F(ReportFleet, APackedLogOnStandardInputWillDo) {
  const std::string packed = folder_.path("fleet.ndjson.gz");
  const Finished finished = run({"simulate", "head-on", "--steps", "5", "--noise", "0.1",
                                 "--output", flown_, "--fleet-log", packed, "--quiet"});
  ASSERT_EQ(finished.exit_code, 0) << finished.err;
  const Page page = reported({flown_, "--fleet-log", "-"}, folder_.read("fleet.ndjson.gz"));
  EXPECT_TRUE(has(page.swarm(), "fleet"));
}

TEST_F(ReportFleet, TheLogIsOfTheFirstOfTwoThatAreCompared) {
  const Page page = reported({flown_, "--compare", flown_, "--fleet-log", log_});
  EXPECT_TRUE(has(page.swarm(0), "fleet"));
  EXPECT_FALSE(has(page.swarm(1), "fleet"));
}

TEST_F(ReportFleet, WhatDoesNotFitIsSaidWithItsPlace) {
  const std::string page = folder_.path("page.html");
  const auto expect = [&](const Arguments& inputs, int exit_code, const std::string& message) {
    expect_failure(Arguments{"report", "-o", page} + inputs, {}, exit_code, message);
    EXPECT_FALSE(std::filesystem::exists(page));
  };
  const std::string two = folder_.file("two.csv", "id,time_s,x,y,z\n0,0,0,0,0\n0,9,1,0,0\n");
  expect(
      {two, "--fleet-log", log_}, kBadInput,
      "fleet.ndjson:2: agent '1' is not in the recording; give the recording of the same flight");
  const std::string late = folder_.file("late.csv", "id,time_s,x,y,z\n0,90,0,0,0\n0,99,1,0,0\n");
  expect({late, "--fleet-log", log_}, kBadInput,
         "fleet.ndjson: this log is of the times from 0 to 5.9 s (ticks times their period), and "
         "the recording of those from 90 to 99 s");
  expect({flown_, "--fleet-log", flown_}, kBadInput, "flown.csv:1:1: this is no JSON");
  expect({flown_, "--fleet-log", folder_.path("none.ndjson")}, kSystem, "none.ndjson");
  const std::string bees = folder_.file("bees.csv", "id,x,y,z\n0,0,0,0\n1,9,0,0\n");
  expect({bees, "--fleet-log", log_}, kUsage,
         "'bees.csv' is a snapshot, and the log of a fleet tells of a flight");
  expect_usage_error({"report", "-", "--fleet-log", "-"}, "standard input can be read once");
  expect_failure({"report", flown_, "--fleet-log", log_, "-o", log_}, {}, kUsage, "fleet.ndjson");
}

TEST_F(ReportFleet, AgentsThatTheRecordingLacksAreLeftOutWhenAsked) {
  const Page page =
      reported({"--fleet-log", log_, "--skip-bad"}, "id,time_s,x,y,z\n0,0,0,0,0\n0,9,1,0,0\n");
  const auto notes = report_test::texts_of(page.swarm()["notes"]);
  const char* const note = "agents of the fleet's log that the recording lacks, left out: 9";
  EXPECT_NE(std::find(notes.begin(), notes.end(), note), notes.end());
}

}  // namespace
}  // namespace beespace::cli_test
