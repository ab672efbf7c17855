// Aircraft that turn between their fixes: straight lines from fix to fix cut their circles, and
// what keeps apart on these may have been too close.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// One that circles so far from a place, a fix every 4 s, as an IGC log; `phase` in turns. The place
// may be that of another thermal in the east.
std::string circling(const std::string& id, double phase, double radius_m = 80.0, int from_s = 0,
                     double east_m = 0.0) {
  constexpr double kTurn = 6.283185307179586;
  constexpr double kPeriod_s = 20.0;
  std::string text = "AXXX" + id + "\nHFDTE200726\n";
  for (int t = from_s; t < 120; t += 4) {
    const double angle = kTurn * (t / kPeriod_s + phase);
    const double north_minutes = radius_m * std::sin(angle) / 1852.0;
    const double east_minutes = (east_m + radius_m * std::cos(angle)) / (1852.0 * 0.682);
    std::array<char, 80> line{};
    std::snprintf(line.data(), line.size(), "B11%02d%02d47%05.0fN008%05.0fEA0150001550\n",
                  30 + t / 60, t % 60, 1000.0 * (30.0 + north_minutes),
                  1000.0 * (30.0 + east_minutes));
    text += line.data();
  }
  return text;
}

TEST(GlidersThatCircle, AreInConflictPerhapsWhereOnlyStraightLinesAre) {
  const TemporaryFolder folder;
  folder.file("a.igc", circling("001", 0.0));
  folder.file("b.igc", circling("002", 0.5));
  const Finished finished =
      run({"replay", "--threshold", "150", "--fail-on-risk", folder.path("")});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"may not keep its distance",
                              "where two in conflict turn, straight lines between fixes may be "
                              "off by up to",
                              "and so may how close they come; ", "possible, not certain"});
  EXPECT_EQ(finished.out.find("yes"), std::string::npos) << "certain";
  const Finished surely = run({"replay", "--threshold", "200", folder.path("")});
  expect_parts(surely.err, {"does not keep its distance"});
  EXPECT_EQ(surely.err.find("not certain"), std::string::npos);
}

// One 40 m farther out than the other in the same thermal, always beside it, with fixes between
// those of the other: chords cut both circles in turn, and what is between swings to and fro.
TEST(GlidersThatCircle, AreInOneConflictAsLongAsTheyMayStayClose) {
  const TemporaryFolder folder;
  folder.file("a.igc", circling("001", 0.0, 80.0, 0));
  folder.file("b.igc", circling("002", 0.0, 120.0, 2));
  const Finished one = run({"replay", "--threshold", "45", folder.path("")});
  EXPECT_EQ(rows_of(one.out).size(), 1u) << one.out;
  expect_parts(one.err, {"of 1 pair", "and so may how close they come",
                         "stretches between which the two may have stayed closer are told as one"});
  // Fixes of both at one time say where both are: they are apart there.
  folder.file("b.igc", circling("002", 0.5, 80.0, 0));
  const Finished apart = run({"replay", "--threshold", "150", folder.path("")});
  EXPECT_GT(rows_of(apart.out).size(), 10u) << apart.out;
}

// Side by side in two thermals, 300 m apart, against each other: where they are nearest, 140 m
// apart, no fix is (half of a chord before and after it), and straight lines keep 172 m.
TEST(GlidersThatCircle, MayComeTooCloseOnTheirArcsWhereStraightLinesKeepApart) {
  const TemporaryFolder folder;
  folder.file("a.igc", circling("001", 0.1, 80.0));
  folder.file("b.igc", circling("002", 0.6, 80.0, 0, 300.0));
  const Arguments replay = {"replay", folder.path(""), "--fail-on-risk", "--threshold"};
  const Finished finished = run(replay + Arguments{"150"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"may not keep its distance", "possible, on the arcs of turns",
                              "on the arcs on which they turn between fixes two are up to",
                              "nearer than on straight lines"});
  EXPECT_EQ(finished.out.find("yes"), std::string::npos) << "certain";
  const TextRows rows = rows_of(finished.out);
  ASSERT_GT(rows.size(), 1u) << finished.out;
  EXPECT_NEAR(std::stod(rows[0].at(4)), 140.0, 3.0);
  // With a vertical limit, too.
  const Finished both = run(replay + Arguments{"150", "--vertical", "50"});
  EXPECT_EQ(both.exit_code, 1) << both.err;
  expect_parts(both.err, {"may not keep its distance", "possible, on the arcs of turns"});
  // What no arc brings closer keeps its distance.
  const Finished apart = run(replay + Arguments{"135"});
  EXPECT_EQ(apart.exit_code, 0) << apart.err;
  expect_parts(apart.err, {"keeps its distance"});
  const Finished page = run({"report", "--threshold", "150", folder.path(""), "-o", "-"});
  EXPECT_NE(page.out.find("possible, not certain"), std::string::npos);
}

// In circles to one side the arcs of two that are opposite each other in one thermal lead apart.
TEST(GlidersThatCircle, AreFartherApartOnTheirArcsWhereTheseLeadAway) {
  const TemporaryFolder folder;
  folder.file("a.igc", circling("001", 0.0));
  folder.file("b.igc", circling("002", 0.5));
  const Finished finished =
      run({"replay", "--threshold", "120", "--fail-on-risk", folder.path("")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.err.find("arcs"), std::string::npos) << finished.err;
}

// A conflict that is none for sure is possible beside a vertical limit, too.
TEST(GlidersThatCircle, AreInConflictPerhapsBesideAVerticalLimit) {
  const TemporaryFolder folder;
  folder.file("a.igc", circling("001", 0.0));
  folder.file("b.igc", circling("002", 0.5));
  const Finished finished =
      run({"replay", "--threshold", "150", "--vertical", "50", folder.path("")});
  expect_parts(finished.err, {"may not keep its distance", "possible, not certain"});
  EXPECT_EQ(finished.out.find("yes"), std::string::npos) << "certain";
}

// Half a circle from one fix to the next, 60 s later, as the speed of 250 kt says, which the chord
// has not: the curve that has both velocities cuts it, too.
TEST(AircraftThatHold, MayComeTooCloseOnTheHalfCirclesBetweenTheirFixes) {
  std::string text =
      "timestamp,icao24,callsign,latitude,longitude,altitude,geoaltitude,"
      "groundspeed,track,vertical_rate\n";
  for (int minute = 0; minute < 8; ++minute) {
    const bool north = minute % 2 == 0;
    const std::string time = "2024-06-01 09:0" + std::to_string(minute) + ":00Z,";
    const std::string latitude = north ? "48.022085," : "47.977915,";
    const std::string heights = ",8000,8200,249,";
    text +=
        time + "3c6444,DLH1AA," + latitude + "9.000000" + heights + (north ? "90" : "270") + ",0\n";
    text +=
        time + "3c6445,DLH2BB," + latitude + "9.135707" + heights + (north ? "270" : "90") + ",0\n";
  }
  const Arguments replay = {"replay", "--separation", "terminal", "--fail-on-risk"};
  const Finished finished = run(replay, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err,
               {"may not keep its distance", "possible, on the arcs of turns between fixes"});
  const Finished straight = run(replay + Arguments{"--straight"}, text);
  EXPECT_EQ(straight.exit_code, 0) << straight.err;
}

}  // namespace
}  // namespace beespace::cli_test
