// `beespace simulate`: the flight, its summary, and that the recording agrees with it.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

const Arguments kSwap = {"simulate", "random-swap", "--bees", "30"};

// A member of a JSON document whose value holds no comma.
std::string value_of(const std::string& json, const std::string& name) {
  const std::string key = "\"" + name + "\": ";
  const std::size_t at = json.find(key);
  if (at == std::string::npos) return "absent";
  const std::size_t begin = at + key.size();
  return json.substr(begin, json.find_first_of(",\n", begin) - begin);
}

std::string without_times(std::string json) {
  const std::size_t begin = json.find("\"advice_us\"");
  return json.substr(0, begin);
}

TEST(Simulate, BeesWhoChangePlacesKeepTheirDistanceAndArrive) {
  const Finished finished = run(kSwap + Arguments{"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "");
  expect_parts(
      finished.err,
      {"scenario   random-swap, about 15 m apart, seed 1\n", "bees       30\n",
       "method     certified\n", "threshold  5 m (closer than)\n", "limits     10 m/s, 5 m/s^2\n",
       " of 0.1 s (", "s), until all had arrived\n", "losses     none\n", "closest    ",
       " m apart in the step from ", "arrived    30 (100.0 %)\n", "path ratio 1.", "stuck      ",
       " s a bee\n", "time       advice ", " us a bee a step, in all "});
}

TEST(Simulate, WithoutPreventionTheyDoNot) {
  const Arguments question = {"simulate", "random-swap", "--bees", "60", "--method", "none"};
  const Finished finished = run(question + Arguments{"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"method     none: each bee as it likes\n",
                              " of separation, a pair a step; in ", "time       in all "});
  EXPECT_EQ(run(question).exit_code, 0);
}

// Two bees fly straight at each other, and are hindered equally on both sides: neither turns.
TEST(Simulate, BeesThatAreStuckAtTheEndAreNamed) {
  const Finished finished =
      run({"simulate", "head-on", "--method", "orca", "--steps", "300", "--json"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.out, {R"("arrived": 0)", R"("stuck_at_end": [0, 1])"});
  expect_parts(finished.err, {" s a bee; at the end 2 for up to ", " s: 0, 1\n"});
  expect_parts(run({"simulate", "head-on", "--json"}).out, {R"("stuck_at_end": [])"});
}

TEST(Simulate, TwoWhoFlyAtEachOtherPassOrMeet) {
  // At 100 m and 10 m/s, with 5 m/s^2 at both ends, they are in the middle after 6 s.
  const Finished careless =
      run({"simulate", "head-on", "--method", "none", "--json", "--quiet", "--fail-on-risk"});
  EXPECT_EQ(careless.exit_code, 1);
  EXPECT_EQ(careless.err, "");
  EXPECT_TRUE(is_json(careless.out)) << careless.out;
  expect_parts(careless.out,
               {R"("command": "simulate")", R"("scenario": "head-on")", R"("bees": 2)",
                R"("spacing_m": 100)", R"("seed": null)", R"("method": "none")",
                R"("threshold_m": 5)", R"("max_speed_mps": 10)", R"("max_acceleration_mps2": 5)",
                R"("step_s": 0.1)", R"("all_stand": true)", R"("breach_count": 0)",
                R"("closest": {"first": 0, "second": 1, "step_begins_s": )", R"("arrived": 2)",
                R"("path_ratio": 1)", R"("stuck_s": )", R"("advice_us": null)"});
  const Finished careful = run({"simulate", "head-on", "--json", "--quiet", "--fail-on-risk"});
  EXPECT_EQ(careful.exit_code, 0);
  expect_parts(careful.out,
               {R"("method": "certified")", R"("loss_count": 0)", R"("steps_with_losses": 0)",
                R"("uncertified_count": 0)", R"("all_stand": true)", R"("arrived": 2)"});
}

TEST(Simulate, ASphereIsSwappedThroughItsMiddle) {
  const Finished finished = run({"simulate", "sphere-swap", "--bees", "20", "--spacing", "12",
                                 "--threshold", "2", "--acceleration", "none", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"scenario   sphere-swap, about 12 m apart, seed 1\n",
                              "limits     10 m/s, velocities change at once\n", "losses     none\n",
                              "arrived    20 (100.0 %)\n"});
}

TEST(Simulate, ItEndsAfterTheMostSteps) {
  const Finished finished = run(kSwap + Arguments{"--steps", "7", "--step", "0.5"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err, {"flown      7 steps of 0.5 s (3.50 s), the most (--steps)\n"});
}

TEST(Simulate, OneBeeHasNoneToAvoid) {
  const Finished finished = run({"simulate", "random-swap", "--bees", "1"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"flown      0 steps of 0.1 s (0.00 s), until all had arrived\n",
                "closest    no two came closer than 10 m\n", "arrived    1 (100.0 %)\n",
                "path ratio none: no bee has flown and arrived\n"});
}

TEST(Simulate, TheRecordingIsATableOfAllBeesStepByStep) {
  const TemporaryFolder folder;
  const std::string file = folder.path("pair.csv");
  ASSERT_EQ(run({"simulate", "head-on", "--steps", "2", "--output", file}).exit_code, 0);
  const TextRows rows = rows_of(folder.read("pair.csv"), ',');
  // With 5 m/s^2 for 0.1 s they are at 0.5 m/s, and 0.025 m farther.
  expect_rows(rows, {{"time_s", "id", "x", "y", "z", "vx", "vy", "vz"},
                     {"0", "0", "0", "0", "0", "0", "0", "0"},
                     {"0", "1", "100", "0", "0", "0", "0", "0"},
                     {"0.1", "0", "0.025", "0", "0", "0.5", "0", "0"},
                     {"0.1", "1", "99.975", "0", "0", "-0.5", "0", "0"},
                     {"0.2", "0", "0.1", "0", "0", "1", "0", "0"},
                     {"0.2", "1", "99.9", "0", "0", "-1", "0", "0"}});
  EXPECT_EQ(folder.names(), std::vector<std::string>{"pair.csv"});
}

TEST(Simulate, VelocitiesThatJumpAreNotWritten) {
  const Finished finished =
      run({"simulate", "head-on", "--steps", "1", "--acceleration", "none", "--output", "-"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_rows(rows_of(finished.out, ','), {{"time_s", "id", "x", "y", "z"},
                                           {"0", "0", "0", "0", "0"},
                                           {"0", "1", "100", "0", "0"},
                                           {"0.1", "0", "1", "0", "0"},
                                           {"0.1", "1", "99", "0", "0"}});
}

TEST(Simulate, TheSameSeedIsTheSameFlightWithAnyNumberOfThreads) {
  const Arguments question = kSwap + Arguments{"--output", "-", "--quiet"};
  const Finished one = run(question + Arguments{"--threads", "1"});
  EXPECT_EQ(one.out, run(question + Arguments{"--threads", "3"}).out);
  EXPECT_EQ(one.out, run(question + Arguments{"--seed", "1"}).out);
  EXPECT_NE(one.out, run(question + Arguments{"--seed", "2"}).out);
  const Arguments json = kSwap + Arguments{"--json", "--quiet"};
  EXPECT_EQ(without_times(run(json + Arguments{"--threads", "1"}).out),
            without_times(run(json + Arguments{"--threads", "2"}).out));
}

class SimulatedRecording : public testing::TestWithParam<const char*> {};

// The checks of a recording find what was found during the flight.
TEST_P(SimulatedRecording, IsWhatVerifyAndReplayRead) {
  const TemporaryFolder folder;
  const std::string file = folder.path(GetParam());
  const Finished flown = run(kSwap + Arguments{"--json", "--quiet", "--output", file});
  ASSERT_EQ(flown.exit_code, 0) << flown.err;
  const Finished checked = run({"verify", file, "--threshold", "5", "--max-speed", "10",
                                "--max-acceleration", "5", "--json", "--quiet"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out;
  EXPECT_EQ(value_of(checked.out, "steps"), value_of(flown.out, "steps"));
  EXPECT_EQ(value_of(checked.out, "distance_m"), value_of(flown.out, "distance_m"));
  const Finished replayed =
      run({"replay", file, "--threshold", "5", "--fail-on-risk", "--output", "/dev/null"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  expect_parts(replayed.err, {"bees       30\n", "verdict    keeps its distance"});
}

INSTANTIATE_TEST_SUITE_P(InEveryFormat, SimulatedRecording,
                         testing::Values("swap.csv", "swap.tsv", "swap.csv.gz", "swap.tsv.gz",
                                         "swap"),
                         [](const auto& of) {
                           std::string name = of.param;
                           for (char& c : name) c = c == '.' ? '_' : c;
                           return name;
                         });

TEST(Simulate, WhatWasLostIsFoundInTheRecordingToo) {
  const TemporaryFolder folder;
  const std::string file = folder.path("swap.csv");
  const Finished flown = run({"simulate", "random-swap", "--bees", "60", "--method", "none",
                              "--json", "--quiet", "--output", file});
  ASSERT_NE(value_of(flown.out, "loss_count"), "0");
  const Finished checked =
      run({"verify", file, "--json", "--quiet", "--max-speed", "10", "--max-acceleration", "5"});
  EXPECT_EQ(checked.exit_code, 1);
  for (const char* name : {"loss_count", "breach_count", "distance_m"}) {
    EXPECT_EQ(value_of(checked.out, name), value_of(flown.out, name)) << name;
  }
}

TEST(Simulate, VelocitiesThatJumpAreCheckedAsStraightLines) {
  const TemporaryFolder folder;
  const std::string file = folder.path("swap.csv");
  ASSERT_EQ(run(kSwap + Arguments{"--acceleration", "none", "--fail-on-risk", "--output", file})
                .exit_code,
            0);
  const Finished checked = run({"verify", file, "--max-speed", "10"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  expect_parts(checked.err,
               {"motion     straight lines from fix to fix: there are no velocities\n"});
}

TEST(Simulate, InvalidNumbersAreRefused) {
  for (const char* bad : {"0", "-1", "1.5", "many", "99999999999"}) {
    expect_usage_error({"simulate", "random-swap", "--bees", bad},
                       "--bees '" + std::string(bad) + "' is not a whole number from 1 to");
    expect_usage_error({"simulate", "random-swap", "--steps", bad}, "--steps '");
  }
  for (const char* bad : {"0", "-5", "nan", "inf", "fast"}) {
    const std::string text = "'" + std::string(bad) + "' is not a number of ";
    expect_usage_error({"simulate", "random-swap", "--speed=" + std::string(bad)},
                       "--speed " + text + "metres per second from 0.000001 to 1,000,000 (see");
    expect_usage_error({"simulate", "random-swap", "--acceleration=" + std::string(bad)},
                       "--acceleration " + text + "metres per second squared");
    expect_usage_error({"simulate", "random-swap", "--step=" + std::string(bad)},
                       "--step " + text + "seconds");
    expect_usage_error({"simulate", "random-swap", "--spacing=" + std::string(bad)},
                       "--spacing " + text + "metres");
    expect_usage_error({"simulate", "random-swap", "--threshold=" + std::string(bad)},
                       "the threshold ");
  }
  expect_usage_error({"simulate", "random-swap", "--seed", "-1"}, "--seed '-1' is not a whole");
  expect_usage_error({"simulate", "random-swap", "--threads", "two"}, "--threads 'two'");
}

TEST(Simulate, BeesMayNotBeginTooClose) {
  for (const char* spacing : {"5", "4.9", "1"}) {
    expect_usage_error({"simulate", "random-swap", "--spacing", spacing},
                       "--spacing " + std::string(spacing) +
                           " is not above the threshold of 5 m; bees would begin too close");
    expect_usage_error({"simulate", "head-on", "--spacing", spacing}, "is not above the threshold");
  }
  EXPECT_EQ(run(kSwap + Arguments{"--spacing", "5.1", "--steps", "3", "--fail-on-risk"}).exit_code,
            0);
}

TEST(Simulate, WhatTheScenarioWouldIgnoreIsRefused) {
  expect_usage_error({"simulate", "head-on", "--bees", "4"}, "--bees does not apply to head-on");
  expect_usage_error({"simulate", "head-on", "--seed", "4"}, "--seed does not apply to head-on");
  expect_usage_error({"simulate"}, "SCENARIO is required");
  expect_usage_error({"simulate", "random"}, "did you mean 'random-swap'?");
  expect_usage_error({"simulate", "random-swap", "--method", "best"},
                     "none of certified, orca, mvp, none");
  expect_usage_error({"simulate", "random-swap", "head-on"}, "'head-on' is one argument too many");
}

TEST(Simulate, StandardOutputHasRoomForOneOfTheTwo) {
  const Finished finished = run({"simulate", "head-on", "--json", "--output", "-"});
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.err, {"--json and --output - would both write to standard output"});
}

TEST(Simulate, TheFormatFollowsFromTheEndingOrIsRefused) {
  const TemporaryFolder folder;
  expect_usage_error({"simulate", "head-on", "--output", folder.path("a.npy")},
                     "npy and bin hold positions only");
  expect_usage_error({"simulate", "head-on", "--output", folder.path("a.xls")},
                     "tells no format of a recording");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Simulate, AFailedRunLeavesNothing) {
  const TemporaryFolder folder;
  expect_failure({"simulate", "head-on", "--output", folder.path("nowhere/a.csv")}, {}, 4,
                 "nowhere/a.csv");
  expect_failure({"simulate", "head-on", "--output", "/dev/full"}, {}, 4, "the disk is full");
  Surroundings full;
  full.output = Surroundings::Output::kFile;
  full.file = "/dev/full";
  EXPECT_EQ(run({"simulate", "head-on", "--output", "-"}, {}, full).exit_code, 4);
  EXPECT_EQ(run({"simulate", "head-on", "--json"}, {}, full).exit_code, 4);
  EXPECT_TRUE(folder.names().empty());
}

TEST(Simulate, ItEndsQuietlyWhenTheReaderIsGone) {
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  for (const Arguments& more : {Arguments{"--output", "-"}, Arguments{"--json"}}) {
    const Finished finished = run(Arguments{"simulate", "head-on"} + more, {}, closed);
    EXPECT_EQ(finished.exit_code, 141);
    EXPECT_EQ(finished.err, "");
  }
}

TEST(Simulate, CtrlCLeavesNothing) {
  const TemporaryFolder folder;
  folder.file("swap.csv", "old");
  // Crowded, and to be flown for very long.
  Running running({"simulate", "random-swap", "--bees", "3000", "--spacing", "6", "--steps",
                   "1000000", "--step", "0.001", "--output", folder.path("swap.csv")});
  for (int i = 0; i < 1'000 && folder.names().size() < 2; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_EQ(folder.names().size(), 2u) << "no temporary file appeared";
  running.signal(SIGINT);
  EXPECT_EQ(running.finish().exit_code, 130);
  EXPECT_EQ(folder.names(), std::vector<std::string>{"swap.csv"});
  EXPECT_EQ(folder.read("swap.csv"), "old");
}

TEST(Simulate, APersonSeesHowFarItHasCome) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  Surroundings watched;
  watched.error_on_terminal = true;
  Running running(
      {"simulate", "random-swap", "--bees", "500", "--steps", "1000000", "--step", "0.001"},
      watched);
  std::this_thread::sleep_for(std::chrono::milliseconds(1'700));
  running.signal(SIGINT);
  const std::string messages = running.finish().err;
  expect_parts(messages, {"\r\x1b[Kflying [", "] 0."});
}

TEST(Simulate, LossesAreRed) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  expect_parts(run_on_terminal({"simulate", "head-on", "--method", "none"}).err,
               {"losses     \x1b[1;31m"});
}

}  // namespace
}  // namespace beespace::cli_test
