// `beespace advise`: a snapshot in, velocities out; worked out by hand.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two bees on a collision course, one that is far from all, and one that prefers to stay.
constexpr std::string_view kSwarm =
    "id,x,y,z,vx,vy,vz,goal_x,goal_y,goal_z\n"
    "west,0,0,50,8,0,0,200,0,50\n"
    "east,20,1,50,-8,0,0,-200,1,50\n"
    "far,0,900,50,0,8,0,0,2000,50\n"
    "stay,0,-900,50,0,0,0,0,-900,50\n";

// 2 m apart at a threshold of 5 m, and standing.
constexpr std::string_view kTooClose =
    "id,x,y,z,want_vx,want_vy,want_vz\n"
    "a,0,0,0,0,0,0\n"
    "b,2,0,0,0,0,0\n";

Finished advised(const Arguments& more, std::string_view input = kSwarm) {
  return run(Arguments{"advise"} + more, input);
}

TEST(Advise, GivesEachBeeAVelocity) {
  const Finished finished = advised({"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 5u) << finished.out;
  EXPECT_EQ(rows[0], (Arguments{"id", "vx", "vy", "vz", "advice", "certified"}));
  EXPECT_EQ(rows[1][0], "west");
  EXPECT_LT(std::stod(rows[1][1]), 8.0) << "slows down";
  EXPECT_EQ(rows[1][4], "deflected");
  EXPECT_EQ(rows[1][5], "yes");
  EXPECT_EQ(rows[2][4], "deflected");
  // With 5 m/s^2 for 0.1 s.
  expect_rows({rows[3]}, {{"far", "0", "8.5", "0", "as-preferred", "yes"}});
  expect_rows({rows[4]}, {{"stay", "0", "0", "0", "as-preferred", "yes"}});
  expect_parts(
      finished.err,
      {"input      <stdin> (text, comma-separated)\n", "bees       4\n", "method     certified\n",
       "threshold  5 m (closer than)\n", "limits     10 m/s, 5 m/s^2\n", "step       0.1 s\n",
       "preferred  2\n", "deflected  2, for the sake of others\n", "braking    0\n",
       "waiting    0\n", "uncertain  none\n", "time       read "});
  EXPECT_EQ(finished.err.find("obstacles"), std::string::npos);
  EXPECT_EQ(finished.err.find("too close "), std::string::npos);
}

TEST(Advise, UnitsAreReportedAndNotMixedSilently) {
  const TemporaryFolder folder;
  const std::string intruders = folder.file("others.csv", "x_ft,y_ft,z_ft\n1000,0,0\n");
  const Finished finished = advised({"--intruders", intruders});
  expect_parts(finished.err, {"units      positions in m: no unit is named\n",
                              "units      goals in m: no unit is named\n",
                              "units      velocities in m/s: no unit is named\n",
                              "units      positions of intruders in ft: the header names it: "});
  const Finished json = advised({"--json", "--quiet"});
  EXPECT_TRUE(is_json(json.out));
  expect_parts(json.out, {R"("units": [{"of": "positions", "unit": "m")"});
  expect_failure({"advise"}, "x_ft,y_ft,z_ft,goal_x,goal_y,goal_z\n0,0,0,1000,0,0\n", 2,
                 "column 'x_ft' is in ft, but 'goal_x' beside it names no unit");
}

TEST(Advise, TheOptionsAreThoseOfTheAdvice) {
  const std::string alone = "x,y,z,goal_x,goal_y,goal_z\n0,0,0,1000,0,0\n";
  const auto speed = [&](const Arguments& more) {
    return rows_of(advised(more, alone).out, ',')[1][1];
  };
  EXPECT_EQ(speed({"--step", "1"}), "5");
  EXPECT_EQ(speed({"--step", "1", "--acceleration", "2"}), "2");
  EXPECT_EQ(speed({"--acceleration", "none"}), "10");
  EXPECT_EQ(speed({"--acceleration", "none", "--speed", "3"}), "3");
  expect_parts(advised({"--acceleration", "none", "--uncertainty", "0.5"}, alone).err,
               {"note       there is no id: bees are numbered in their order, from 0\n",
                "note       no velocities: all bees stand\n",
                "threshold  5 m (closer than), places known to 0.5 m\n",
                "limits     10 m/s, velocities change at once\n"});
  // Far enough apart but for the uncertainty.
  const std::string pair = "x,y,z,goal_x,goal_y,goal_z\n0,0,0,0,0,0\n5.5,0,0,5.5,0,0\n";
  EXPECT_EQ(advised({"--fail-on-risk"}, pair).exit_code, 0);
  EXPECT_EQ(advised({"--fail-on-risk", "--uncertainty", "0.5"}, pair).exit_code, 1);
  EXPECT_EQ(advised({"--fail-on-risk", "--threshold", "6"}, pair).exit_code, 1);
}

TEST(Advise, WishesCountBeforeGoals) {
  const std::string both =
      "id,x,y,z,goal_x,goal_y,goal_z,want_vx,want_vy,want_vz\na,0,0,0,1000,0,0,0,0,0.25\n";
  const Finished finished = advised({}, both);
  expect_rows(rows_of(finished.out, ','), {{"id", "vx", "vy", "vz", "advice", "certified"},
                                           {"a", "0", "0", "0.25", "as-preferred", "yes"}});
  expect_parts(finished.err, {"note       goals are ignored, as there are preferred velocities\n"});
  expect_parts(advised({"--json"}, both).out, {R"("preferred": "velocities")"});
  expect_parts(advised({"--json"}).out, {R"("preferred": "goals")"});
}

TEST(Advise, LimitsOfTheFileCountInsteadOfTheOptions) {
  const std::string own =
      "id,x,y,z,goal_x,goal_y,goal_z,max_speed_mps,max_acceleration_mps2\n"
      "slow,0,0,0,1000,0,0,2,100\nlazy,0,500,0,1000,500,0,100,1\n";
  const Finished finished = advised({"--step", "1"}, own);
  expect_rows(rows_of(finished.out, ','), {{"id", "vx", "vy", "vz", "advice", "certified"},
                                           {"slow", "2", "0", "0", "as-preferred", "yes"},
                                           {"lazy", "1", "0", "0", "as-preferred", "yes"}});
  expect_parts(finished.err, {"limits     of each bee, as the file tells\n"});
  expect_parts(advised({"--json"}, own).out, {R"("own_limits": true)", R"("max_speed_mps": null)"});
  expect_failure({"advise", "--speed", "5"}, own, 2,
                 "--speed does not apply: the file tells the greatest speed of each bee");
  expect_failure({"advise", "--acceleration", "5"}, own, 2, "--acceleration does not apply");
}

TEST(Advise, BeesThatAreTooCloseAreToldToSeparateAndListed) {
  const Finished finished = advised({}, kTooClose);
  EXPECT_EQ(finished.exit_code, 0);
  const TextRows rows = rows_of(finished.out, ',');
  EXPECT_LT(std::stod(rows.at(1).at(1)), 0.0);
  EXPECT_GT(std::stod(rows.at(2).at(1)), 0.0);
  EXPECT_EQ(rows[1][5], "no");
  expect_parts(finished.err,
               {"uncertain  2 bees not certified\n", "too close  1 pair\n",
                "           a and b, 2.000 m between their ways to a stop, clear in "});
  const Finished json = advised({"--json", "--quiet", "--fail-on-risk"}, kTooClose);
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_EQ(json.err, "");
  expect_parts(json.out, {R"("uncertified_count": 2)", R"("too_close": [)",
                          R"({"first": "a", "second": "b", "gap_m": 2, "clear_s": )"});
}

TEST(Advise, OnlyTheFirstPairsAreListed) {
  std::string crowd = "x,y,z,want_vx,want_vy,want_vz\n";
  for (int bee = 0; bee < 10; ++bee) crowd += std::to_string(bee) + ",0,0,0,0,0\n";
  const Finished finished = advised({"--threshold", "1.5"}, crowd);
  expect_parts(finished.err, {"too close  9 pairs\n", "           0 and 1, ", "and 4 more\n"});
}

TEST(Advise, ObstaclesAreKeptClearOf) {
  const TemporaryFolder folder;
  const std::string wall =
      folder.file("wall.json", R"({"obstacles": [{"kind": "ground", "height_m": 0},)"
                               R"( {"kind": "box", "low": [12, -50, 0], "high": [20, 50, 90]}]})");
  const std::string towards = "id,x,y,z,vx,vy,vz,goal_x,goal_y,goal_z\na,0,0,9,10,0,0,50,0,9\n";
  EXPECT_EQ(rows_of(advised({}, towards).out, ',').at(1).at(4), "as-preferred");
  const Finished kept = advised({"--obstacles", wall, "--fail-on-risk"}, towards);
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  EXPECT_LT(std::stod(rows_of(kept.out, ',').at(1).at(1)), 10.0);
  expect_parts(kept.err, {"obstacles  2, clearance 1 m\n"});
  // It needs 10.5 m to a stop already.
  const Arguments near = {"--obstacles", wall, "--clearance", "5"};
  const Finished finished = advised(near + Arguments{"--fail-on-risk"}, towards);
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"clearance 5 m\n", "near       1 bee to an obstacle\n",
                              "a, whose way to a stop comes within 1.500 m of obstacles[1]",
                              "a box", "wall.json\n"});
  const std::string json = advised(near + Arguments{"--json"}, towards).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("obstacles": 2)", R"("clearance_m": 5)", R"("near_obstacle": [)",
                      R"({"bee": "a", "obstacle": 1, "gap_m": 1.5)"});
}

TEST(Advise, AllGiveWayToIntruders) {
  const TemporaryFolder folder;
  const std::string birds =
      folder.file("birds.csv", "id,x,y,z,vx,vy,vz\nhawk,0,40,0,0,-10,0\nowl,0,-999,0,0,0,0\n");
  const std::string hovering = "id,x,y,z,want_vx,want_vy,want_vz\na,1,0,0,0,0,0\n";
  const Finished finished = advised({"--intruders", birds, "--fail-on-risk"}, hovering);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_EQ(rows_of(finished.out, ',').at(1).at(4), "deflected");
  expect_parts(finished.err,
               {"intruders  2, seen to fly straight on for 10 s\n",
                "conflicts  1 conflict with an intruder ahead\n", "a and the intruder hawk, in "});
  const std::string json = advised({"--intruders", birds, "--json"}, hovering).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("intruders": 2)", R"("intruder_horizon_s": 10)",
                      R"({"bee": "a", "intruder": "hawk", "begins_s": )"});
  // It takes 3.5 s to come.
  EXPECT_EQ(advised({"--intruders", birds, "--intruder-horizon", "2", "--fail-on-risk"}, hovering)
                .exit_code,
            0);
  const std::string still = folder.file("still.csv", "x,y,z\n0,0,3\n");
  expect_parts(advised({"--intruders", still}, hovering).err,
               {"still.csv has no velocities: intruders stand\n", "and the intruder 0, in 0.00 s"});
}

TEST(Advise, JsonHasEverythingInIt) {
  const Finished finished = advised({"--json", "--quiet"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(
      finished.out,
      {R"("version": ")",
       R"("command": "advise")",
       R"("files": ["<stdin>"])",
       R"("bees": 4)",
       R"("notes": [])",
       R"("method": "certified")",
       R"("threshold_m": 5)",
       R"("uncertainty_m": 0)",
       R"("own_limits": false)",
       R"("max_speed_mps": 10)",
       R"("max_acceleration_mps2": 5)",
       R"("step_s": 0.1)",
       R"("obstacles": 0)",
       R"("clearance_m": null)",
       R"("intruders": 0)",
       R"("intruder_horizon_s": null)",
       R"("as_preferred_count": 2)",
       R"("deflected_count": 2)",
       R"("braking_count": 0)",
       R"("waiting_count": 0)",
       R"("uncertified_count": 0)",
       R"("advice": [)",
       R"({"id": "far", "vx": 0, "vy": 8.5, "vz": 0, "advice": "as-preferred", "certified": true, )"
       R"("keeps_apart": true, "clear_of_intruders": true})",
       R"("too_close": [])",
       R"("near_obstacle": [])",
       R"("intruder_conflicts": [])",
       R"("refused": [])",
       R"("none_count": 0)"});
  // Without an id bees are numbers.
  expect_parts(
      advised({"--json", "--acceleration", "none"}, "x,y,z,want_vx,want_vy,want_vz\n0,0,0,1,0,0\n")
          .out,
      {R"({"id": 0, "vx": 1, )", R"("max_acceleration_mps2": null)"});
}

TEST(Advise, IdsComeBackAsTheyWere) {
  const std::string odd = "id,x,y,z,want_vx,want_vy,want_vz\n\"a, \"\"b\"\"\",0,0,0,0,0,0\n";
  EXPECT_EQ(rows_of(advised({}, odd).out, '\n').at(1).at(0),
            "\"a, \"\"b\"\"\",0,0,0,as-preferred,yes");
  expect_parts(advised({"--json"}, odd).out, {R"({"id": "a, \"b\"", )"});
}

TEST(Advise, TheAnswerIsTheSameWithAnyNumberOfThreads) {
  const Finished made = run({"generate", "--scene", "crossing", "--points", "400", "--size", "60"});
  std::string table = made.out;
  table.replace(0, table.find('\n'), "id,x,y,z,want_vx,want_vy,want_vz");
  const Finished one = advised({"--threads", "1", "--quiet"}, table);
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_NE(one.out.find("deflected"), std::string::npos);
  EXPECT_EQ(one.out, advised({"--threads", "3", "--quiet"}, table).out);
}

TEST(Advise, OtherMethodsAreThereToCompareWith) {
  for (const std::string method : {"orca", "mvp"}) {
    const Finished finished = advised({"--method", method});
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    expect_parts(finished.err, {"method     " + method + ", which promises nothing\n",
                                "uncertain  all: this method certifies no bee\n"});
    EXPECT_EQ(rows_of(finished.out, ',').at(1).at(5), "no");
  }
}

}  // namespace
}  // namespace beespace::cli_test
