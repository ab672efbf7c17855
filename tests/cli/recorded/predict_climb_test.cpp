// How fast aircraft climb whose last record does not say so: their heights go in steps of 25 ft.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"

namespace beespace::cli_test {
namespace {

const Arguments kQuestion = {"predict", "--separation",   "enroute", "--horizon",
                             "120",     "--fail-on-risk", "--units", "aviation"};
constexpr double kSinks_ftmin = -1000.0;

double in_steps(double feet) {
  return 25.0 * std::round(feet / 25.0);
}

// Two that fly side by side, 3 NM apart: one at 30,000 ft, the other one sinking from above by
// 1000 ft/min, so that it is 1500 ft higher at the last second. At that second, and the one before
// it, its height stands still. `told` has what each second says of the climb rate.
std::string sinking_beside(int seconds, const std::function<std::string(int)>& told,
                           bool with_speeds = true) {
  std::string text = "timestamp,icao24,latitude,longitude,altitude";
  text += with_speeds ? ",groundspeed,track,vertical_rate\n" : "\n";
  constexpr double kDegreesEachSecond = 420.0 / 3600.0 / 60.0;  // of latitude, at 420 kt
  for (int second = 0; second < seconds; ++second) {
    const double to_go = seconds - 1 - second;
    const double height = in_steps(31'490.0 + kSinks_ftmin / 60.0 * -to_go);
    const std::string lat = std::to_string(48.0 + kDegreesEachSecond * second);
    const auto add = [&](const char* id, const char* lon, double feet, const std::string& climb) {
      text += std::to_string(1'714'564'800 + second) + ',' + id + ',' + lat + ',' + lon + ',' +
              std::to_string(feet);
      text += with_speeds ? ",420,0," + climb + '\n' : "\n";
    };
    add("aaaaaa", "2.0", 30'000.0, "0");
    add("bbbbbb", "2.07472", to_go == 1.0 ? in_steps(31'490.0) : height, told(second));
  }
  return text;
}

std::string says_nothing(int) {
  return "";
}

TEST(PredictClimb, IsThatOfTheHeightsOfTheLastSecondsNotOfTwo) {
  const Finished finished = run(kQuestion, sinking_beside(30, says_nothing));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"1 without a climb rate: it is that of the heights of up to 20 s",
                              "conflicts  1, of 2 bees"});
}

TEST(PredictClimb, IsTheLastOneKnown) {
  // The record of the last second alone does not say it.
  const Finished finished =
      run(kQuestion, sinking_beside(5, [](int second) { return second < 4 ? "-1000" : ""; }));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"1 without a climb rate: it is the last one known, 30 s before at",
                              "conflicts  1, of 2 bees", "soonest    aaaaaa and bbbbbb, in 30.0"});
}

TEST(PredictClimb, KeepsSpeedAndTrackOfTheRecord) {
  // Its places stand still, but the record says that it flies at 420 kt, as the other one does.
  std::string text =
      "timestamp,icao24,latitude,longitude,altitude,groundspeed,track,vertical_rate\n";
  for (int second = 0; second < 2; ++second) {
    const std::string time = std::to_string(1'714'564'800 + second);
    text += time + ",aaaaaa,48,2.0,30000,420,0,0\n";
    text += time + ",bbbbbb,48.05,2.0,30000,420,180," + (second == 0 ? "0" : "") + '\n';
  }
  const Finished finished = run(kQuestion, text);
  expect_parts(finished.err, {"conflicts  1, of 2 bees", "0.000 NM"});
}

TEST(PredictClimb, ThatNothingTellsIsCheckedForNowAndIsNoAllClear) {
  const Finished finished = run(kQuestion, sinking_beside(5, says_nothing));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"bees       1 of 2",
                              "unknown    1 checked for now only, where last heard of: "
                              "neither a climb rate nor 10 s of heights",
                              "1 bee is checked for now only"});
}

TEST(PredictClimb, OfAircraftWithoutSpeedsIsThatOfTheHeightsToo) {
  const Finished finished = run(kQuestion, sinking_beside(30, says_nothing, false));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"2 without a velocity: it is that of the last two fixes",
                "2 without a climb rate: it is that of the heights", "conflicts  1, of 2 bees"});
  expect_failure(kQuestion, sinking_beside(5, says_nothing, false), 3,
                 "give climb rates (a column vertical_rate)");
}

TEST(PredictClimb, OfDronesInMetresIsThatOfTheLastTwoFixesBesideTheirOwnSpeed) {
  // They meet head-on after 50 s; the fixes say that the first one stands.
  const Finished finished = run({"predict", "--threshold", "5"},
                                "id,time_s,x,y,z,vx,vy\n"
                                "a,0,0,0,0,1,0\na,1,0,0,1,1,0\n"
                                "b,0,100,3,0,-1,0\nb,1,100,3,1,-1,0\n");
  expect_rows(without_lasts(rows_of(finished.out)), {{"a", "b", "49", "51", "3", "53"}});
  expect_parts(finished.err, {"2 without a climb rate: it is that of the last two fixes"});
}

}  // namespace
}  // namespace beespace::cli_test
