// `beespace simulate` with fleets that are not exact: what it says of losses, and of who did not
// fly.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr const char* kInTheCage =
    "id,x,y,z,goal_x,goal_y,goal_z\n"
    "maya,0,0,10,100,0,10\n";

// A cage: a bee that cannot hold its place is carried into one of its balls.
std::string cage() {
  std::string text = R"({"obstacles": [)";
  const char* between = "";
  for (const char* at :
       {"15.5, 0, 10", "-15.5, 0, 10", "0, 15.5, 10", "0, -15.5, 10", "0, 0, 25.5", "0, 0, -5.5"}) {
    text +=
        between + std::string(R"({"kind": "sphere", "center": [)") + at + R"(], "radius_m": 12})";
    between = ", ";
  }
  return text + "]}";
}

const Arguments kWeak{"--weak", "99.9%:0.001", "--drift", "0.5", "--steps", "600"};

TEST(SimulateFleet, BeesTooCloseToObstaclesAreARisk) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mission.csv", kInTheCage);
  const std::string balls = folder.file("balls.json", cage());
  const std::string recording = folder.path("flown.csv");
  const Arguments fly =
      Arguments{"simulate", file, "--noise", "0.1", "--obstacles", balls, "--fail-on-risk"};
  const Finished sound = run(fly);
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  expect_parts(sound.err,
               {"obstacles  6, clearance 1 m\n", "clearance  none\n", "losses     none\n"});
  const Finished weak = run(fly + kWeak + Arguments{"--output", recording});
  EXPECT_EQ(weak.exit_code, 1) << weak.err;
  expect_parts(weak.err,
               {"clearance  none of those that keep their contracts; ", " of bees out of theirs"});
  // The checker of recordings says the same.
  EXPECT_EQ(run({"verify", recording, "--threshold", "5", "--obstacles", balls}).exit_code, 1);
  const Finished json = run(fly + kWeak + Arguments{"--json", "--quiet"});
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("obstacles": 6)", R"("clearance_loss_count": 0)",
                          R"("joined_count": 1)", R"("not_joined_count": 0)"});
  EXPECT_EQ(json.out.find(R"("out_clearance_loss_count": 0)"), std::string::npos) << json.out;
}

TEST(SimulateFleet, LossesOfTheWeakAndToIntrudersAreARisk) {
  const Arguments swap{"simulate", "random-swap", "--bees",        "60",
                       "--steps",  "300",         "--fail-on-risk"};
  const Finished weak = run(swap + Arguments{"--weak", "30%:0.02", "--drift", "0.5"});
  EXPECT_EQ(weak.exit_code, 1) << weak.err;
  expect_parts(weak.err, {"losses     none of those that keep their contracts; ",
                          " of bees out of theirs\n"});
  const Finished strange = run(swap + Arguments{"--intruders", "20"});
  EXPECT_EQ(strange.exit_code, 1) << strange.err;
  expect_parts(strange.err,
               {"losses     none of those that keep their contracts; ", " to intruders\n"});
  const Finished sound = run(swap + Arguments{"--noise", "0.05"});
  EXPECT_EQ(sound.exit_code, 0) << sound.err;
  expect_parts(sound.err, {"losses     none\n"});
}

TEST(SimulateFleet, WhoCouldNotJoinIsToldWithTheReason) {
  const char* const mission =
      "id,x,y,z,goal_x,goal_y,goal_z\n"
      "a,0,0,50,10,0,50\n"
      "b,0,0,55.05,10,0,60\n"
      "c,50,0,-5,60,0,-5\n"
      "d,90,0,50,99,0,50\n";
  const TemporaryFolder folder;
  const std::string ball = folder.file(
      "ball.json",
      R"({"obstacles": [{"kind": "sphere", "center": [90, 0, 48], "radius_m": 0.99}]})");
  const Arguments fly{"simulate", "-", "--fence", "0:120", "--obstacles", ball, "--steps", "100"};
  const Finished finished = run(fly, mission);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"losses     none, of 1 that flew\n",
                "not joined 3: 1 beyond a fence, or too close to it, 1 too close to obstacles, 1 "
                "too close to claims of others\n"});
  const Finished json = run(fly + Arguments{"--json", "--quiet"}, mission);
  expect_parts(json.out, {R"("joined_count": 1)", R"("not_joined_count": 3)"});
}

TEST(SimulateFleet, NominalAndOutputAreTwoFiles) {
  const std::string message = "--nominal and --output are the same; name two files";
  const Arguments fly{"simulate", "head-on", "--quiet"};
  expect_usage_error(fly + Arguments{"--nominal", "-", "--output", "-"}, message);
  const TemporaryFolder folder;
  const std::string file = folder.path("flown.csv");
  expect_usage_error(fly + Arguments{"--nominal", file, "--output", file}, message);
  expect_usage_error(fly + Arguments{"--nominal", folder.path("./flown.csv"), "--output", file},
                     message);
  EXPECT_TRUE(folder.names().empty());
  const Finished both = run(fly + Arguments{"--nominal", "-", "--json"});
  EXPECT_EQ(both.exit_code, 2);
  expect_parts(both.out, {"--json and --nominal - would both write to standard output"});
  EXPECT_EQ(run(fly + Arguments{"--nominal", folder.path("nominal.csv"), "--output", file,
                                "--steps", "10"})
                .exit_code,
            0);
  EXPECT_EQ(folder.names().size(), 2U);
}

TEST(SimulateFleet, TheLogOfTheFleetHasTheLinesOfGuide) {
  const TemporaryFolder folder;
  const Arguments fly{"simulate", "-", "--steps", "3", "--quiet"};
  const char* const mission = "id,x,y,z,goal_x,goal_y,goal_z\nana,0,0,50,10,0,50\n";
  const Finished finished = run(fly + Arguments{"--fleet-log", "-"}, mission);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(finished.out.starts_with(
      R"({"event": "command", "id": "ana", "number": "1.1", "starts": -1, "path": [[)"))
      << finished.out.substr(0, 200);
  expect_parts(finished.out,
               {R"("period_s": 0.1, "braking_mps2": 4})",
                R"({"event": "status", "id": "ana", "tick": 0, "contract": "kept", "reason": )"
                R"("none", "certified": )",
                R"({"event": "status", "id": "ana", "tick": 2, )"});
  // That it is written changes nothing.
  const Arguments files{"--output", folder.path("one.csv"), "--drift", "0.1"};
  EXPECT_EQ(run(fly + files, mission).exit_code, 0);
  EXPECT_EQ(run(fly + Arguments{"--output", folder.path("other.csv"), "--fleet-log",
                                folder.path("log.ndjson")},
                mission)
                .exit_code,
            0);
  EXPECT_EQ(folder.read("one.csv"), folder.read("other.csv"));
}

TEST(SimulateFleet, TheLogOfTheFleetIsAFileOfItsOwn) {
  const TemporaryFolder folder;
  const std::string file = folder.path("flown.csv");
  const Arguments fly{"simulate", "head-on", "--quiet", "--fleet-log"};
  expect_usage_error(fly + Arguments{file, "--output", file},
                     "--fleet-log and --output are the same; name two files");
  expect_usage_error(fly + Arguments{"-", "--nominal", "-"},
                     "--fleet-log and --nominal are the same; name two files");
  const Finished both = run(fly + Arguments{"-", "--json"});
  EXPECT_EQ(both.exit_code, 2);
  expect_parts(both.err, {"--json and --fleet-log - would both write to standard output"});
  EXPECT_TRUE(folder.names().empty());
}

TEST(SimulateFleet, CommandsThatComeTooLateForAllAreNoted) {
  const Arguments fly{"simulate", "head-on", "--latency", "6", "--steps", "100"};
  const std::string note = "commands come too late for all; give a greater --command-delay";
  for (const char* delay : {"2", "5", "6"}) {
    const Finished late = run(fly + Arguments{"--command-delay", delay});
    EXPECT_EQ(late.exit_code, 0) << late.err;
    expect_parts(late.err, {"note       " + note});
  }
  EXPECT_EQ(run(fly + Arguments{"--command-delay", "7"}).err.find(note), std::string::npos);
  const Finished fine = run(fly);
  EXPECT_EQ(fine.err.find(note), std::string::npos) << fine.err;
}

TEST(SimulateFleet, TheSummarySaysHowToRepeatIt) {
  const Finished finished =
      run({"simulate", "random-swap", "--bees", "10", "--steps", "10", "--seed", "7", "--noise",
           "0.1", "--gust", "0.2", "--drift", "0.3", "--latency", "1", "--loss", "10%"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"scenario   random-swap, about 15 m apart, seed 7\n", "loop       onboard\n",
                "errors     noise 0.1 m, gusts 0.2 m/s, drift 0.3 m/s\n",
                "commands   taken after 4 steps, latency 1, loss 10.0 %, at most 8 in a row\n"});
}

TEST(SimulateFleet, ErrorsOfFiguresNameTheOptions) {
  const Finished finished = run({"simulate", "head-on", "--drift", "2"});
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"deviation_mps (--drift, --gust and --clock-error) 2",
                              "correction_mps (--reserve)"});
}

constexpr const char* kAcross =
    "id,x,y,z,goal_x,goal_y,goal_z\n"
    "maya,0,0,10,100,0,10\n";

// Where bees begin is told by the scenario or the file; what noise and wind do is not.
TEST(SimulateFleet, HasASeedWhereverItsBeesBegin) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mission.csv", kAcross);
  for (const std::string& scenario : {std::string("head-on"), file}) {
    const Arguments fly{"simulate", scenario, "--steps", "20", "--output", "-", "--quiet"};
    const auto flown = [&](const char* seed) {
      return run(fly + Arguments{"--noise", "0.1", "--seed", seed});
    };
    const Finished first = flown("1");
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, flown("1").out);
    EXPECT_NE(first.out, flown("2").out);
    expect_usage_error(fly + Arguments{"--seed", "2"}, "--seed does not apply to ");
  }
}

}  // namespace
}  // namespace beespace::cli_test
