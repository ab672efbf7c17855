// `beespace verify --obstacles`: bees that fly too close to obstacles.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// One flies past a pillar of 1 m at 3 m from its middle, one through a wall in a single step, one
// far away.
constexpr std::string_view kFlight =
    "id,time_s,x,y,z\n"
    "a,0,-10,3,5\nb,0,100,0,5\nc,0,0,300,500\n"
    "a,1,10,3,5\nb,1,140,0,5\nc,1,0,300,500\n";
constexpr std::string_view kObstacles =
    R"({"obstacles": [{"kind": "cylinder", "center": [0, 0], "radius_m": 1},)"
    R"({"kind": "box", "low": [119, -50, 0], "high": [119.5, 50, 50]}]})";

class VerifyObstacles : public testing::Test {
 protected:
  Finished check(const std::vector<std::string>& options) {
    std::vector<std::string> all{"verify", "--obstacles", file_};
    all.insert(all.end(), options.begin(), options.end());
    return run(all, kFlight);
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.file("city.json", kObstacles);
};

TEST_F(VerifyObstacles, AFlightThroughAWallBetweenFixesIsFound) {
  const Finished finished = check({});
  EXPECT_EQ(finished.exit_code, 1);
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1U) << finished.out;
  EXPECT_EQ(rows[0].at(0), "clearance");
  EXPECT_EQ(rows[0].at(1), "b");
  EXPECT_EQ(rows[0].at(2), "obstacles[1], a box");
  EXPECT_LT(std::stod(rows[0].at(5)), 0.3);
  expect_parts(finished.err,
               {"obstacles  2, clearance 1 m\n", "clearance  1 bee in a step\n",
                "losses     none\n", "verdict    does not keep clear of obstacles\n"});
}

TEST_F(VerifyObstacles, TheClearanceIsTheLimit) {
  EXPECT_EQ(rows_of(check({"--clearance", "1.999999"}).out).size(), 1U);
  const TextRows rows = rows_of(check({"--clearance", "2.000001"}).out);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].at(1), "a");
  EXPECT_EQ(rows[0].at(2), "obstacles[0], a cylinder");
  EXPECT_NEAR(std::stod(rows[0].at(5)), 2.0, 0.01);
}

TEST_F(VerifyObstacles, TheDocumentSaysSo) {
  const Finished finished = check({"--json"});
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {"\"obstacles\": 2,", "\"clearance_m\": 1,",
                              "\"clearance_loss_count\": 1,", "\"finding\": \"clearance\""});
}

TEST_F(VerifyObstacles, InvalidOptionsAreRefused) {
  expect_usage_error({"verify", "--clearance", "2"}, "--clearance is of obstacles");
  expect_usage_error({"verify", "--obstacles", file_, "--clearance", "0"},
                     "--clearance '0' is not a number of metres above 0");
  const Finished degrees = run({"verify", "--crs", "wgs84", "--obstacles", file_},
                               "id,time_s,lon,lat,h\na,0,1,2,3\na,1,1,2,4\n");
  EXPECT_EQ(degrees.exit_code, 3);
  expect_parts(degrees.err, {"obstacles are in metres, and the flight is in degrees"});
  const std::string upside_down = folder_.file(
      "bad.json", R"({"obstacles": [{"kind": "box", "low": [0, 0, 5], "high": [1, 1, 1]}]})");
  const Finished bad = run({"verify", "--obstacles", upside_down}, kFlight);
  EXPECT_EQ(bad.exit_code, 3);
  expect_parts(bad.err, {"bad.json", "obstacles[0]: "});
  EXPECT_EQ(run({"verify", "--obstacles", "missing.json"}, kFlight).exit_code, 4);
}

}  // namespace
}  // namespace beespace::cli_test
