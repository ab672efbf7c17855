// `beespace simulate` with missions of files, with obstacles, and with scenarios that have more
// than one stream.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr const char* kMission =
    "id,x,y,z,goal_x,goal_y,goal_z\n"
    "maya,0,0,10,100,0,10\n"
    "\"w, illy\",100,0,10,0,0,10\n";

constexpr const char* kCity =
    R"({"obstacles": [{"kind": "cylinder", "center": [50, 0], "radius_m": 6},
                      {"kind": "ground", "height_m": 0}]})";

TEST(SimulateMission, AFileOfStartsAndGoals) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mission.csv", kMission);
  const Finished finished = run({"simulate", file, "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"scenario   " + file + "\n", "bees       2\n", "limits     10 m/s, 5 m/s^2\n",
                "closest    maya and w, illy, 5.", "arrived    2 (100.0 %)\n"});
  const Finished json = run({"simulate", "-", "--json", "--quiet"}, kMission);
  EXPECT_EQ(json.exit_code, 0) << json.err;
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out,
               {R"("scenario": "-")", R"("bees": 2)", R"("spacing_m": null)", R"("seed": null)",
                R"("obstacles": 0)", R"("clearance_m": null)", R"("own_limits": false)",
                R"("closest": {"first": "maya", "second": "w, illy")"});
}

TEST(SimulateMission, IdsAreWrittenIntoTheRecording) {
  const TemporaryFolder folder;
  const std::string file = folder.file("mission.csv", kMission);
  const std::string recording = folder.path("flown.csv");
  ASSERT_EQ(run({"simulate", file, "--steps", "50", "--output", recording}).exit_code, 0);
  const std::string text = folder.read("flown.csv");
  expect_parts(text, {"time_s,id,x,y,z,vx,vy,vz\n0,maya,0,0,10,0,0,0\n0,\"w, illy\",100,"});
  const Finished checked = run({"verify", recording, "--max-speed", "10", "--max-acceleration=5"});
  EXPECT_EQ(checked.exit_code, 0) << checked.err;
  expect_parts(checked.err, {"bees       2\n"});
}

TEST(SimulateMission, EachBeeFliesAsItCan) {
  const char* const slow_and_fast =
      "x,y,z,goal_x,goal_y,goal_z,max_speed_mps,max_acceleration_mps2\n"
      "0,0,0,40,0,0,2,1\n0,20,0,40,20,0,8,4\n";
  const TemporaryFolder folder;
  const Finished finished =
      run({"simulate", "-", "--fail-on-risk", "--output", folder.path("flown.csv")}, slow_and_fast);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"limits     of the file, each bee its own\n", "losses     none\n",
                "note       there is no id: bees are numbered in their order, from 0\n"});
  const Finished checked = run({"verify", folder.path("flown.csv")});
  expect_parts(checked.err, {"peak speed 8.000 m/s\n", "peak accel 4.000 m/s^2\n"});
  const Finished json = run({"simulate", "-", "--json", "--quiet"}, slow_and_fast);
  expect_parts(json.out,
               {R"("own_limits": true)", R"("max_speed_mps": null)", R"("breach_count": 0)"});
  const Finished too_much = run({"simulate", "-", "--speed", "3"}, slow_and_fast);
  EXPECT_EQ(too_much.exit_code, 2);
  expect_parts(too_much.err, {"--speed does not apply: the file tells the greatest speed of each"});
  const Finished harder = run({"simulate", "-", "--acceleration", "3"}, slow_and_fast);
  EXPECT_EQ(harder.exit_code, 2);
}

TEST(SimulateMission, VelocitiesOfTheFileAreNotUsedAndThatIsReported) {
  const Finished finished = run({"simulate", "-"},
                                "id,x,y,z,goal_x,goal_y,goal_z,vx,vy,vz,colour\n"
                                "a,0,0,0,10,0,0,1,0,0,red\n");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"note       not read: column 11 'colour'\n",
                              "note       the velocities of the file are not used"});
}

TEST(SimulateMission, ErrorsInTheFileAreReportedWithTheirPlace) {
  const TemporaryFolder folder;
  expect_failure({"simulate", folder.path("nowhere.csv")}, {}, 4, "there is no such file");
  expect_failure({"simulate", "-"}, "x,y,z\n1,2,3\n", 3, "<stdin>:1: the header names no goals");
  expect_failure({"simulate", "-"}, "x,y,z,goal_x,goal_y,goal_z\n1,2,oops,4,5,6\n", 3,
                 "<stdin>:2:3: 'oops' is not a number (z)");
  const char* const close = "id,x,y,z,goal_x,goal_y,goal_z\na,0,0,0,9,9,9\nb,0,0,4,50,50,50\n";
  expect_failure({"simulate", "-"}, close, 3,
                 "<stdin>: the bees 'a' and 'b' begin 4.000 m apart, and the threshold is 5 m");
  EXPECT_EQ(run({"simulate", "-", "--threshold", "3"}, close).exit_code, 0);
  expect_failure({"simulate", "-"}, "x,y,z,goal_x,goal_y,goal_z\n0,0,0,9,9,9\n0,0,6,9,9,10\n", 3,
                 "want to stop 1.000 m apart");
}

TEST(SimulateMission, ObstaclesAreKeptClearOf) {
  const TemporaryFolder folder;
  const std::string mission = folder.file("mission.csv", kMission);
  const std::string city = folder.file("city.json", kCity);
  const Finished finished =
      run({"simulate", mission, "--obstacles", city, "--clearance", "2", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"obstacles  2, clearance 2 m\n", "clearance  kept\n", "nearest    ",
                " from obstacles[0], a cylinder of " + city + ", at ", "arrived    2 (100.0 %)\n"});
  const Finished careless = run({"simulate", mission, "--obstacles", "-", "--method", "none",
                                 "--json", "--quiet", "--fail-on-risk"},
                                kCity);
  EXPECT_EQ(careless.exit_code, 1);
  expect_parts(careless.out, {R"("obstacles": 2)", R"("clearance_m": 1)", R"("method": "none")",
                              R"("nearest_obstacle": {"bee": ")", R"("obstacle": 0)"});
  EXPECT_EQ(careless.out.find(R"("clearance_loss_count": 0)"), std::string::npos);
}

TEST(SimulateMission, BeesBeginAndStopClearOfObstacles) {
  const TemporaryFolder folder;
  const std::string mission = folder.file("mission.csv", kMission);
  const std::string city = folder.file("city.json", kCity);
  expect_failure({"simulate", mission, "--obstacles", city, "--clearance", "12"}, {}, 3,
                 "mission.csv: the bee 'maya' begins 10.000 m from obstacles[1], the ground of " +
                     city + ", and the clearance is 12 m; move one of the two");
  const std::string box = folder.file(
      "box.json", R"({"obstacles": [{"kind": "box", "low": [90, -5, 0], "high": [110, 5, 20]}]})");
  expect_failure({"simulate", mission, "--obstacles", box}, {}, 3,
                 "the bee 'w, illy' begins inside obstacles[0], a box of " + box);
  const std::string ball = folder.file(
      "ball.json", R"({"obstacles": [{"kind": "sphere", "center": [30, 0, 0], "radius_m": 10}]})");
  expect_usage_error({"simulate", "random-swap", "--bees", "64", "--obstacles", ball},
                     ", a sphere of " + ball);
  expect_failure({"simulate", "-", "--obstacles", ball},
                 "x,y,z,goal_x,goal_y,goal_z\n0,0,0,30,0,0\n", 3, "wants to stop inside");
}

TEST(SimulateMission, ErrorsInObstaclesAreReported) {
  const TemporaryFolder folder;
  const std::string mission = folder.file("mission.csv", kMission);
  const Arguments question = {"simulate", mission, "--obstacles", "-"};
  expect_failure(question, R"({"obstacles": [{"kind": "cone"}]})", 3,
                 "<stdin>: obstacles[0].kind 'cone' is not known");
  expect_failure(question, "{\n  oops}", 3, "<stdin>:2:3: this is no JSON");
  expect_failure(question,
                 R"({"obstacles": [{"kind": "ground", "height_m": 0},
                                   {"kind": "sphere", "center": [0, 0, 0], "radius_m": -1}]})",
                 3, "<stdin>: obstacles[1]: ");
  expect_failure({"simulate", mission, "--obstacles", folder.path("nowhere.json")}, {}, 4,
                 "there is no such file");
}

TEST(SimulateMission, OptionsThatWouldBeIgnoredAreRefused) {
  const TemporaryFolder folder;
  const std::string mission = folder.file("mission.csv", kMission);
  for (const char* option : {"--bees=4", "--spacing=20", "--seed=3"}) {
    expect_usage_error({"simulate", mission, option},
                       "does not apply to a file, which tells who begins where; leave it out");
  }
  expect_usage_error({"simulate", mission, "--clearance", "2"},
                     "--clearance is of obstacles and fences, and there are none; add "
                     "--obstacles or --fence");
  expect_usage_error({"simulate", "-", "--obstacles", "-"}, "cannot both be standard input");
  expect_usage_error({"simulate", "pillars", "--clearance", "0"},
                     "--clearance '0' is not a number of metres");
  expect_usage_error({"simulate", "mission"}, "and no file (which would have a '.' or '/' in its");
}

class StreamScenario : public testing::TestWithParam<const char*> {};

TEST_P(StreamScenario, IsFlownWithoutALossAndArrives) {
  const Finished finished = run({"simulate", GetParam(), "--bees", "60", "--json", "--quiet",
                                 "--fail-on-risk", "--steps", "3000"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out,
               {"\"scenario\": \"" + std::string(GetParam()) + "\"", R"("bees": 60)",
                R"("loss_count": 0)", R"("clearance_loss_count": 0)", R"("uncertified_count": 0)",
                R"("breach_count": 0)", R"("all_stand": true)", R"("arrived": 60)"});
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, StreamScenario,
                         testing::Values("crossing-streams", "funnel", "pillars"),
                         [](const auto& of) {
                           std::string name = of.param;
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(SimulateMission, PillarsHaveObstaclesOfTheirOwn) {
  const TemporaryFolder folder;
  const std::string ball =
      folder.file("ball.json",
                  R"({"obstacles": [{"kind": "sphere", "center": [90, 500, 0], "radius_m": 10}]})");
  const Finished finished = run({"simulate", "pillars", "--bees", "30", "--obstacles", ball});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {", a cylinder of the scenario, at "});
  const Finished one = run({"simulate", "pillars", "--bees", "30", "--json", "--quiet"});
  const Finished two =
      run({"simulate", "pillars", "--bees", "30", "--json", "--quiet", "--obstacles", ball});
  const auto count = [](const std::string& json) {
    const std::string key = "\"obstacles\": ";
    return std::stoi(json.substr(json.find(key) + key.size()));
  };
  EXPECT_GT(count(one.out), 9);
  EXPECT_EQ(count(two.out), count(one.out) + 1);
}

TEST(SimulateMission, OtherMethodsAreThereToCompareWith) {
  for (const char* method : {"orca", "mvp"}) {
    const Finished finished =
        run({"simulate", "random-swap", "--bees", "30", "--method", method, "--json"});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    EXPECT_TRUE(is_json(finished.out)) << finished.out;
    expect_parts(finished.out,
                 {"\"method\": \"" + std::string(method) + "\"", R"("breach_count": 0)"});
    expect_parts(finished.err,
                 {"method     " + std::string(method) + ": ", ", which promises nothing\n"});
  }
}

TEST(DensitySweep, HasALineForEachSpacing) {
  const Finished finished =
      run({"simulate", "density-sweep", "--bees", "40", "--threshold", "4", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, "");
  expect_parts(finished.err,
               {"scenario   random swaps, closer and closer together, seed 1\n", "bees       40\n",
                "method     certified\n",
                "spacing    losses   closest   arrived  path ratio   stuck s  us a bee a step\n",
                "\n      12 m         0", "\n      10 m         0", "\n       8 m         0",
                "\n       7 m         0", "\n       6 m         0"});
}

TEST(DensitySweep, IsADocumentOfRuns) {
  const Finished finished =
      run({"simulate", "density-sweep", "--bees", "20", "--steps", "20", "--json", "--quiet"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.err, "");
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out,
               {R"("command": "simulate")", R"("scenario": "density-sweep")", R"("runs": [)",
                R"("scenario": "random-swap")", R"("spacing_m": 15,)", R"("spacing_m": 12.5,)",
                R"("spacing_m": 10,)", R"("spacing_m": 8.75,)", R"("spacing_m": 7.5,)"});
}

TEST(DensitySweep, WithoutPreventionSeparationIsLost) {
  const Finished finished =
      run({"simulate", "density-sweep", "--bees", "60", "--method", "none", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
}

TEST(DensitySweep, TakesNoSpacingAndWritesNoRecording) {
  for (const char* option : {"--spacing=20", "--output=a.csv"}) {
    expect_usage_error({"simulate", "density-sweep", option},
                       "does not apply to density-sweep, which flies several missions");
  }
}

}  // namespace
}  // namespace beespace::cli_test
