// What is not known, contradicts itself or was not compared is never an all-clear.
#include <gtest/gtest.h>

#include <algorithm>

#include <string>
#include <string_view>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

const std::string kHeader = "id,time_s,x,y,z\n";

// Up to 10 m, 1 m/s along x, and down again: from 0 s to `lasts_s`.
std::string flight(const std::string& id, int y, int lasts_s) {
  std::string text;
  for (int t = 0; t <= lasts_s; ++t) {
    const int z = std::min({10, 2 * t, 2 * (lasts_s - t)});
    const int x = std::min({std::max(0, t - 5), lasts_s - 10});
    text += id + "," + std::to_string(t) + "," + std::to_string(x) + "," + std::to_string(y) + "," +
            std::to_string(100 + z) + "\n";
  }
  return text;
}

// The same, but its log ends in the air.
std::string cut_off(const std::string& id, int y, int lasts_s, int at_s) {
  std::string text = flight(id, y, lasts_s);
  const std::string last = "\n" + id + "," + std::to_string(at_s) + ",";
  return text.substr(0, text.find('\n', text.find(last) + 1) + 1);
}

TEST(NoFalseAllClear, ADroneThatIsCutOffInTheAirIsNotCertified) {
  const std::string input = kHeader + flight("a", 0, 30) + cut_off("b", 20, 30, 15);
  const Finished verify = run({"verify", "--threshold", "2"}, input);
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(
      verify.err,
      {"verdict    not seen as a whole: holds in the known time; 1 bee known for a part of "
       "the recording only (1 of which begin or end in the air while others fly)\n",
       "1 bee before the first or after the last fix, for 15 s in all; 1 of them in the "
       "air then\n"});
  const Finished replay = run({"replay", "--threshold", "2", "--fail-on-risk"}, input);
  EXPECT_EQ(replay.exit_code, 1);
  expect_parts(replay.err, {"no conflict in the known time; 1 bee known for a part of the"});
  const Finished large =
      run({"replay", "--threshold", "2", "--fail-on-risk", "--memory", "64MiB"}, input);
  EXPECT_EQ(large.exit_code, 1) << large.err;
  expect_parts(large.err, {"1 of them in the air then\n"});
  const Finished json = run({"verify", "--threshold", "2", "--json", "--quiet"}, input);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("holds": false)", R"("bees_partly_known": 1)",
                          R"("bees_cut_off_in_the_air": 1)"});
}

TEST(NoFalseAllClear, DronesThatLandAtDifferentTimesAreFine) {
  const std::string input = kHeader + flight("a", 0, 30) + flight("b", 20, 20);
  const Finished verify = run({"verify", "--threshold", "2"}, input);
  EXPECT_EQ(verify.exit_code, 0) << verify.err;
  expect_parts(verify.err, {"verdict    holds in the known time; 1 bee known for a part of the "
                            "recording only\n"});
  EXPECT_EQ(run({"replay", "--threshold", "2", "--fail-on-risk"}, input).exit_code, 0);
  EXPECT_EQ(
      run({"replay", "--threshold", "2", "--fail-on-risk", "--memory", "64MiB"}, input).exit_code,
      0);
}

// The same in degrees: a log may break off in a collision. Who is heard of a little later than
// others is not cut off.
TEST(NoFalseAllClear, WhoIsCutOffInTheAirInDegreesIsNotCertified) {
  const auto fix = [](const char* id, double time_s, double lat, int height_m) {
    return std::string(id) + "," + std::to_string(time_s) + ",8.0," + std::to_string(lat) + "," +
           std::to_string(height_m) + "\n";
  };
  std::string all = "id,time_s,lon,lat,height_m\n";
  std::string broken = all;
  for (int t = 0; t <= 60; ++t) {
    const int height_m = 500 + std::min({20, 2 * std::max(0, t - 5), 2 * std::max(0, 55 - t)});
    all += fix("a", t, 47.0, height_m) + fix("b", t + 0.5, 47.001, height_m);
    broken += fix("a", t, 47.0, height_m);
    if (t < 40) broken += fix("b", t + 0.5, 47.001, height_m);
  }
  for (const Arguments& more : {Arguments{}, Arguments{"--memory", "64MiB"}}) {
    const Arguments ask = Arguments{"replay", "--threshold", "5", "--fail-on-risk"} + more;
    const Finished fine = run(ask, all);
    EXPECT_EQ(fine.exit_code, 0) << fine.err;
    const Finished cut = run(ask, broken);
    EXPECT_EQ(cut.exit_code, 1) << cut.err;
    expect_parts(cut.err, {"(1 of which begin or end in the air while others fly)\n"});
  }
  EXPECT_EQ(run({"verify", "--threshold", "5"}, broken).exit_code, 1);
}

// Who is seen in a plane comes and goes.
TEST(NoFalseAllClear, WhoComesAndGoesIsKnownForAPartOnly) {
  std::string input = "id,time_s,x,y\n";
  for (int t = 0; t <= 20; ++t)
    input += "a," + std::to_string(t) + "," + std::to_string(t) + ",0\n";
  for (int t = 5; t <= 9; ++t) input += "b," + std::to_string(t) + "," + std::to_string(t) + ",9\n";
  const Finished finished = run({"verify", "--threshold", "2"}, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"holds in the known time; 1 bee known for a part"});
  EXPECT_EQ(run({"replay", "--threshold", "2", "--fail-on-risk"}, input).exit_code, 0);
}

TEST(NoFalseAllClear, NothingComparedIsARisk) {
  constexpr std::string_view apart =
      "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\nb,2,9,0,0\nb,3,9,0,0\n";
  for (const Arguments& more : {Arguments{}, Arguments{"--memory", "64MiB"}}) {
    const Finished finished = run(Arguments{"replay", "--fail-on-risk"} + more, apart);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.err, {"nothing to compare"});
    EXPECT_EQ(run(Arguments{"replay"} + more, apart).exit_code, 0);
  }
  const Finished verify = run({"verify"}, apart);
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(verify.err, {"nothing to compare: no two bees are there at the same time"});
  // One bee alone is checked for what it may do alone.
  EXPECT_EQ(run({"verify"}, "id,time_s,x,y,z\na,0,0,0,0\na,1,0,0,0\n").exit_code, 0);
}

// Longitude and latitude under each other's name in one of two files.
TEST(NoFalseAllClear, SwappedDegreesAreSaid) {
  TemporaryFolder folder;
  const std::string one =
      folder.file("a.csv", "id,time_s,lon,lat\na,0,9,47\na,1,9.00001,47\na,2,9.00002,47\n");
  const std::string other =
      folder.file("b.csv", "id,time_s,lat,lon\nb,0,9.0001,47\nb,1,9.0001,47\nb,2,9.0001,47\n");
  const Finished finished = run({"replay", one, other, "--threshold", "50"});
  expect_parts(finished.err, {"bee 'a' is 5,",
                              " km from the nearest other one, but would be 0.0 km "
                              "from 'b' with longitude and latitude the other way round"});
  const std::string far =
      folder.file("c.csv", "id,time_s,lon,lat\nb,0,30,-47\nb,1,30,-47\nb,2,30,-47\n");
  EXPECT_EQ(run({"replay", one, far}).err.find("the other way round"), std::string::npos);
}

}  // namespace
}  // namespace beespace::cli_test
