// Velocities that contradict straight lines between fixes: what replay makes of them.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

const std::string kMovingHeader = "id,time_s,x,y,z,vx,vy,vz\n";

// Two abreast, 10 m apart; at 5 s the curve of the first is halfway on the second's side: its
// velocities lead it there and back, 9.5 m of the 10.
std::string bulge(double vy_mps) {
  const std::string v = std::to_string(vy_mps);
  return kMovingHeader + "a,0,0,0,10,1," + v + ",0\na,10,10,0,10,1,-" + v + ",0\n" +
         "b,0,0,10,10,1,0,0\nb,10,10,10,10,1,0,0\n";
}

// 10 s between two fixes: the curve leaves the line by 10 / 4 of the velocity.
const std::string kNear = bulge(3.8);

TEST(VelocityCurves, WhoComesTooCloseAlongCurvesAloneIsInAPossibleConflict) {
  const Finished verify = run({"verify", "--threshold", "2"}, kNear);
  EXPECT_EQ(verify.exit_code, 1) << verify.err;
  const Finished finished = run({"replay", "--threshold", "2", "--fail-on-risk"}, kNear);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err,
               {"verdict    may not keep its distance: 1 conflict of 1 pair, 1 possible, along "
                "curves with the given velocities\n",
                "a and b, 0.500 m apart at 5.00 s", "both are looked at"});
  expect_parts(finished.out, {"certain", "a\tb\t", "\tno\t"});
  const Finished json = run({"replay", "--threshold", "2", "--json", "--quiet"}, kNear);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("conflict_count": 1)", R"("followed": true)", R"("certain": false)"});
}

// A bound, at most a third above; of small things in millimetres, not in hundredths of a metre.
TEST(VelocityCurves, HowFarTheyLeadIsToldToTheMillimetre) {
  const Finished finished = run({"replay", "--threshold", "0.02"}, bulge(0.0009));
  expect_parts(finished.err, {"leave the straight lines by up to 0.003 m (a from 0.00 s"});
}

TEST(VelocityCurves, StraightPassesThemOver) {
  const Finished finished =
      run({"replay", "--threshold", "2", "--fail-on-risk", "--straight"}, kNear);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"verdict    keeps its distance\n"});
  const Finished json = run({"replay", "--threshold", "2", "--straight", "--json"}, kNear);
  expect_parts(json.out, {R"("velocities": null)"});
}

// A hundredth of the threshold is not to be told from how velocities are measured.
TEST(VelocityCurves, OnlyWhatIsWellBelowTheThresholdCounts) {
  for (const auto& [vy_mps, code] : {std::pair{3.203, 0}, std::pair{3.207, 0}, {3.22, 1}}) {
    const Finished finished = run({"replay", "--threshold", "2", "--fail-on-risk"}, bulge(vy_mps));
    EXPECT_EQ(finished.exit_code, code) << vy_mps << finished.err;
  }
}

// The same in height and horizontally, with a vertical threshold.
TEST(VelocityCurves, CylindersAreLookedAtToo) {
  const Finished near =
      run({"replay", "--threshold", "2", "--vertical", "1", "--fail-on-risk"}, kNear);
  EXPECT_EQ(near.exit_code, 1) << near.err;
  expect_parts(near.err, {"a and b, 0.500 m horizontally and 0 m vertically apart at 5.00 s"});
  const std::string high = kMovingHeader +
                           "a,0,0,0,10,1,0,3.8\na,10,10,0,10,1,0,-3.8\n"
                           "b,0,0,0,20,1,0,0\nb,10,10,0,20,1,0,0\n";
  EXPECT_EQ(
      run({"replay", "--threshold", "2", "--vertical", "1", "--fail-on-risk"}, high).exit_code, 1);
  EXPECT_EQ(
      run({"replay", "--threshold", "2", "--vertical", "0.5", "--fail-on-risk"}, high).exit_code,
      0);
}

// In degrees, with heights in feet: level flight is level along the curve, too.
TEST(VelocityCurves, FlightLevelsStayApart) {
  const std::string level =
      "icao24,timestamp,latitude,longitude,altitude_ft,groundspeed_kt,track,vertical_rate_fpm\n"
      "a,1533099600,47.00,8.0,35000,400,90,64\na,1533099610,47.00,8.03,35000,400,90,0\n"
      "b,1533099600,47.00,8.0,36000,400,90,0\nb,1533099610,47.00,8.03,36000,400,90,-64\n";
  const Finished finished = run({"replay", "--separation", "enroute", "--fail-on-risk"}, level);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
}

TEST(VelocityCurves, VelocitiesThatCannotBeAreNoAllClear) {
  const Finished finished = run({"replay", "--threshold", "2", "--fail-on-risk"}, bulge(1e13));
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err,
               {"no conflict along straight lines; the velocities lead too far away"});
}

TEST(VelocityCurves, WithMemoryTheyAreNotLookedAt) {
  const Finished finished =
      run({"replay", "--threshold", "2", "--fail-on-risk", "--memory", "64MiB"}, kNear);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"no conflict along straight lines; with --memory velocities are not "
                              "looked at"});
  EXPECT_EQ(run({"replay", "--threshold", "2", "--fail-on-risk", "--memory", "64MiB", "--straight"},
                kNear)
                .exit_code,
            0);
}

// Where velocities agree with straight lines, or are not known, nothing is said of them.
TEST(VelocityCurves, VelocitiesThatAgreeChangeNothing) {
  const std::string agree = kMovingHeader +
                            "a,0,0,0,10,1,0,0\na,10,10,0,10,1,0,0\n"
                            "b,0,0,10,10,1,0,0\nb,10,10,10,10,,,\n";
  const Finished finished = run({"replay", "--threshold", "2", "--fail-on-risk"}, agree);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"verdict    keeps its distance\n"});
  EXPECT_EQ(finished.err.find("leave the straight lines"), std::string::npos);
}

TEST(VelocityCurves, PagesHaveThemToo) {
  TemporaryFolder folder;
  const std::string input = folder.file("near.csv", kNear);
  const Finished finished = run({"export", input, "--threshold", "2", "--format", "csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out, {"a,b,", ",no,"});
  expect_parts(finished.err, {"possible, along curves that have the given velocities"});
}

}  // namespace
}  // namespace beespace::cli_test
