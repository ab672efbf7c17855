// What `beespace advise` refuses, and how it ends then.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kOne = "id,x,y,z,goal_x,goal_y,goal_z\na,0,0,0,9,0,0\n";

TEST(AdviseRefuses, InvalidNumbers) {
  for (const std::string bad : {"0", "-5", "nan", "inf", "fast"}) {
    const std::string text = " '" + bad + "' is not a number of ";
    expect_usage_error({"advise", "--speed=" + bad},
                       "--speed" + text + "metres per second from 0.000001 to 1,000,000 (see");
    expect_usage_error({"advise", "--acceleration=" + bad},
                       "--acceleration" + text + "metres per second squared from 0.000001 to");
    expect_usage_error({"advise", "--step=" + bad}, "--step" + text + "seconds");
    expect_usage_error({"advise", "--obstacles=a.json", "--clearance=" + bad},
                       "--clearance" + text + "metres from 0.000001 to 1,000,000,000");
    expect_usage_error({"advise", "--intruders=a.csv", "--intruder-horizon=" + bad},
                       "--intruder-horizon" + text + "seconds");
    expect_usage_error({"advise", "--threshold=" + bad}, "the threshold ");
  }
  expect_usage_error({"advise", "--uncertainty=-1"},
                     "--uncertainty '-1' is not a number of metres from 0 to 1,000,000,000");
  expect_usage_error({"advise", "--threads", "two"}, "--threads 'two'");
}

TEST(AdviseRefuses, WhatItWouldIgnore) {
  expect_usage_error({"advise", "--clearance", "2"}, "--clearance is of obstacles");
  expect_usage_error({"advise", "--intruder-horizon", "2"}, "--intruder-horizon is of intruders");
  expect_usage_error({"advise", "--method", "orca", "--obstacles", "a.json"},
                     "--method orca knows nothing of obstacles and intruders");
  expect_usage_error({"advise", "--method", "mvp", "--intruders", "a.csv"},
                     "--method mvp knows nothing");
  expect_usage_error({"advise", "--method", "orca", "--fail-on-risk"}, "would always fail");
  expect_usage_error({"advise", "--method", "none"}, "none of certified, orca, mvp");
  expect_usage_error({"advise", "a.csv", "b.csv"}, "'b.csv' is one argument too many");
  expect_usage_error({"advise", "--csv"}, "'--csv' is no option of 'beespace advise'");
  expect_usage_error({"advise", "--obstacles", ""}, "--obstacles: the value is empty");
}

TEST(AdviseRefuses, ToReadStandardInputTwice) {
  for (const Arguments& twice : {Arguments{"--obstacles", "-"}, Arguments{"-", "--intruders", "-"},
                                 Arguments{"a.csv", "--obstacles", "-", "--intruders", "-"}}) {
    expect_usage_error(Arguments{"advise"} + twice, "standard input can be read once");
  }
  const TemporaryFolder folder;
  const std::string bees = folder.file("bees.csv", kOne);
  EXPECT_EQ(run({"advise", bees, "--obstacles", "-"}, R"({"obstacles": []})").exit_code, 0);
  EXPECT_EQ(run({"advise", bees, "--intruders", "-"}, "x,y,z\n9,9,9\n").exit_code, 0);
}

TEST(AdviseRefuses, TablesThatAreWrongWithTheirPlace) {
  constexpr int kBadInput = 3;
  expect_failure({"advise"}, "", kBadInput, "<stdin>: the input is empty");
  expect_failure({"advise"}, "x,y,z\n1,2,3\n", kBadInput,
                 "<stdin>:1: the header names neither goals nor preferred velocities");
  expect_failure({"advise"}, "x,y,z,goal_x,goal_y,goal_z\n1,2,3,4,5,oops\n", kBadInput,
                 "<stdin>:2:6: 'oops'");
  expect_failure({"advise"}, "id,x,y,z,goal_x,goal_y,goal_z\na,1,2,3,4,5,6\na,1,2,3,4,5,6\n",
                 kBadInput, "<stdin>:3:1: the bee 'a' is on line 2 already");
  expect_failure({"advise"}, "id,lon,lat,height,goal_x,goal_y,goal_z\na,1,2,3,4,5,6\n", kBadInput,
                 "positions in degrees are not read here");
}

TEST(AdviseRefuses, ObstaclesAndIntrudersThatAreWrong) {
  constexpr int kBadInput = 3;
  const TemporaryFolder folder;
  const auto obstacles = [&](const std::string& text) {
    return Arguments{"advise", "--obstacles", folder.file("city.json", text)};
  };
  expect_failure(obstacles("{"), kOne, kBadInput, "city.json:1");
  expect_failure(obstacles(R"({"obstacles": [{"kind": "tree"}]})"), kOne, kBadInput,
                 "obstacles[0].kind 'tree' is not known");
  expect_failure(obstacles(R"({"obstacles": [{"kind": "ground", "height_m": 0}, )"
                           R"({"kind": "box", "low": [1, 0, 0], "high": [0, 1, 1]}]})"),
                 kOne, kBadInput, "city.json: obstacles[1]: ");
  const auto intruders = [&](const std::string& text) {
    return Arguments{"advise", "--intruders", folder.file("birds.csv", text)};
  };
  expect_failure(intruders("id,x,y\na,1,2\n"), kOne, kBadInput, "birds.csv:1: a position needs");
  expect_failure(intruders("x,y,z,vx,vy,vz\n1,2,3,4,5,nan\n"), kOne, kBadInput, "birds.csv:2:6");
}

TEST(AdviseRefuses, AThresholdOutsideTheDomainOfWhatMoves) {
  for (const auto& [threshold, remedy] :
       std::vector<std::pair<std::string, std::string>>{{"-1", "a finite distance above zero"},
                                                        {"0", "a finite distance above zero"},
                                                        {"1e-31", "7.9e-31 m to 1.3e+30 m"},
                                                        {"2e30", "7.9e-31 m to 1.3e+30 m"}}) {
    const Finished finished = run({"advise", "--threshold", threshold}, kOne);
    EXPECT_EQ(finished.exit_code, 2);
    expect_parts(finished.err, {threshold, remedy});
  }
}

// A header alone is a table without bees; an empty file is no table.
TEST(AdviseTakes, ATableOfNoIntruders) {
  const TemporaryFolder folder;
  const Finished finished =
      run({"advise", "--intruders", folder.file("birds.csv", "id,x,y,z,vx,vy,vz\n")}, kOne);
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err, {"birds.csv has no intruders", "intruders  0"});
  expect_failure({"advise", "--intruders", folder.file("empty.csv", "")}, kOne, 3,
                 "empty.csv: the input is empty");
}

TEST(AdviseRefuses, FilesThatCannotBeRead) {
  constexpr int kSystem = 4;
  const TemporaryFolder folder;
  const std::string nowhere = folder.path("missing.csv");
  expect_failure({"advise", nowhere}, {}, kSystem, "missing.csv");
  expect_failure({"advise", "--obstacles", nowhere}, kOne, kSystem, "missing.csv");
  expect_failure({"advise", "--intruders", nowhere}, kOne, kSystem, "missing.csv");
}

TEST(AdviseRefuses, InJsonToo) {
  const Finished finished = run({"advise", "--json"}, "x,y,z\n1,2,3\n");
  EXPECT_EQ(finished.exit_code, 3);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {"\"error\"", "names neither goals nor preferred velocities"});
}

TEST(AdviseEnds, WithAFileThatIsThereWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const std::string file = folder.file("advice.csv", "old");
  EXPECT_EQ(run({"advise", "--output", file}, "x,y,z\n1,2,3\n").exit_code, 3);
  EXPECT_EQ(folder.read("advice.csv"), "old");
  EXPECT_EQ(run({"advise", "--output", file, "--quiet"}, kOne).out, "");
  EXPECT_EQ(folder.read("advice.csv"),
            "id,vx,vy,vz,advice,certified\na,0.5,0,0,as-preferred,yes\n");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"advice.csv"});
  expect_failure({"advise", "--output", folder.path("nowhere/a.csv")}, kOne, 4, "nowhere/a.csv");
  expect_failure({"advise", "--output", "/dev/full"}, kOne, 4, "the disk is full");
}

TEST(AdviseEnds, QuietlyWhenTheReaderIsGone) {
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  for (const Arguments& more : {Arguments{}, Arguments{"--json"}}) {
    const Finished finished = run(Arguments{"advise"} + more, kOne, closed);
    EXPECT_EQ(finished.exit_code, 141);
    EXPECT_EQ(finished.err, "");
  }
}

TEST(AdviseEnds, AtOnceWhereATerminalHasNoInput) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  Surroundings surroundings;
  surroundings.input_on_terminal = true;
  Running running({"advise"}, surroundings);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"say which file to read, or pipe the swarm in"});
}

TEST(AdviseEnds, WithRedWhereABeeIsNotCertified) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  const TemporaryFolder folder;
  const std::string file =
      folder.file("bees.csv", "x,y,z,want_vx,want_vy,want_vz\n0,0,0,0,0,0\n1,0,0,0,0,0\n");
  expect_parts(run_on_terminal({"advise", file}).err, {"uncertain  \x1b[1;31m2 bees"});
}

}  // namespace
}  // namespace beespace::cli_test
