// `beespace fleet` of a show in metres and a log in degrees: deviations that are put in by hand, by
// the radii of curvature of WGS84 (10 m are 0.000132658 degrees of longitude at 47.4731 degrees,
// and 0.00008994418 of latitude).
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kAskedFor = 2;
constexpr std::string_view kLocation =
    R"(,"environment":{"type":"outdoor","location":{"origin":[474731000,190617000,102500],)"
    R"("orientation":"90"}})";

std::string drone(const std::string& name, const std::string& x) {
  const auto at = [&x](const std::string& time, const std::string& z) {
    return "[" + time + ",[" + x + ",0," + z + "],[]]";
  };
  return R"({"type":"generic","settings":{"name":")" + name + R"(","home":[)" + x +
         R"(,0,0],"trajectory":{"version":1,"takeoffTime":0,"points":[)" + at("0", "0") + "," +
         at("5", "0") + "," + at("15", "10") + "," + at("25", "10") + "," + at("35", "0") + "]}}}";
}

// Two, 10 m beside each other along x, climb 10 m from 5 s to 15 s, and land from 25 s to 35 s.
std::string show_with(std::string_view location) {
  return R"({"version":1,"settings":{"validation":{"minDistance":2}},"swarm":{"drones":[)" +
         drone("Drone 1", "0") + "," + drone("Drone 2", "10") + "]}" + std::string(location) + "}";
}

double height_m(int second) {
  if (second < 5 || second > 35) return 0.0;
  if (second < 15) return second - 5.0;
  return second <= 25 ? 10.0 : 35.0 - second;
}

// The second of `ids` is 1 m north of its place at 20 s.
std::string log_of(const std::array<const char*, 2>& ids,
                   const std::string& header = "timestamp,drone_id,lat,lon,alt_amsl,alt_rel") {
  std::string text = header + "\n";
  for (int second = 0; second <= 40; ++second) {
    for (std::size_t bee = 0; bee < ids.size(); ++bee) {
      const double latitude = 47.4731 + (bee == 1 && second == 20 ? 0.000008994418 : 0.0);
      const double longitude = 19.0617 + (bee == 1 ? 0.000132657587 : 0.0);
      std::array<char, 160> line = {};
      std::snprintf(line.data(), line.size(), "2025-11-27T19:00:%02dZ,%s,%.10f,%.10f,%.2f,%.2f\n",
                    second, ids[bee], latitude, longitude, 102.5 + height_m(second),
                    height_m(second));
      text += line.data();
    }
  }
  return text;
}

TEST(FlownShow, IsComparedWhereItSaysThatItIsAndSaysWhoWasFarthest) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished finished =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z"}, log_of({"1", "2"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out,
               {"2 bees, 62 fixes compared, at 20 nothing was set\n", "deviation     1.000 m",
                "farthest      2 (Drone 2), 1.000 m from where it was set to be at "
                "2025-11-27T19:00:20.000Z\n"});
  expect_parts(finished.err, {"ids are matched by their numbers: '1' is to fly what was set for "
                              "'Drone 1'",
                              "what was set is placed on the Earth at longitude 19.0617, latitude "
                              "47.4731, height 102.5 m, with x towards 90 degrees from north"});
  const Finished json =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z", "--json"},
          log_of({"1", "2"}));
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("farthest": {"id": "2", "set_id": "Drone 2", "deviation_m": )",
                          R"("at": "2025-11-27T19:00:20.000Z"},)", R"("each": [)"});
}

// When it began is not guessed.
TEST(FlownShow, AsksWhenItBeganWithTheLineToType) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished finished = run({"fleet", "--set", set}, log_of({"1", "2"}));
  EXPECT_EQ(finished.exit_code, kAskedFor);
  EXPECT_EQ(finished.out, "");
  expect_parts(finished.err,
               {"say with --set-begins when 0 s was: by the take-off of 2 drones, when they are "
                "first 2 m above where they began, that is --set-begins 2025-11-27T19:00:00.000Z"});
  expect_usage_error({"fleet", "--set", set, "--set-begins", "19:00"},
                     "--set-begins is '19:00': say a date and time");
}

TEST(FlownShow, WithoutALocationAsksForTheOrigin) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with({}));
  const std::vector<std::string> typed = {"fleet", "--set", set, "--set-begins",
                                          "2025-11-27T19:00:00Z"};
  const Finished asked = run(typed, log_of({"1", "2"}));
  EXPECT_EQ(asked.exit_code, kAskedFor);
  expect_parts(asked.err, {"say with --origin lon,lat,height,heading where x = y = z = 0 of what "
                           "was set is",
                           "as in --origin lon,lat,102.5,90"});
  std::vector<std::string> placed = typed;
  placed.insert(placed.end(), {"--origin", "19.0617,47.4731,102.5,90"});
  const Finished told = run(placed, log_of({"1", "2"}));
  EXPECT_EQ(told.exit_code, 0) << told.err;
  expect_parts(told.out, {"farthest      2 (Drone 2), 1.000 m"});
  // Turned by a quarter it is elsewhere.
  placed.back() = "19.0617,47.4731,102.5,0";
  expect_parts(run(placed, log_of({"1", "2"})).out, {"farthest      2 (Drone 2), 14.142 m"});
}

// Who got which place is often decided at the field.
TEST(FlownShow, NumbersThatMeanOthersGiveWayToWhereEachBegan) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished finished =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z"}, log_of({"2", "1"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out, {"deviation     1.000 m", "farthest      1 (Drone 2), 1.000 m"});
  expect_parts(finished.err, {"ids differ, and so each is to fly what was set to begin where it "
                              "began: '2' that of 'Drone 1'"});
}

TEST(FlownShow, HeightsAboveTakeOffAndOthersAreNotMixed) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished relative = run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z",
                                 "--columns", "lat=3,lon=4,height=6", "--crs", "wgs84"},
                                log_of({"1", "2"}));
  EXPECT_EQ(relative.exit_code, 0) << relative.err;
  expect_parts(relative.out, {"farthest      2 (Drone 2), 1.000 m"});
  const Finished ellipsoid =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z"},
          log_of({"1", "2"}, "timestamp,drone_id,lat,lon,height_above_ellipsoid,alt_rel"));
  EXPECT_EQ(ellipsoid.exit_code, kAskedFor) << ellipsoid.out;
  expect_parts(ellipsoid.err, {"heights of what was flown are above the WGS84 ellipsoid",
                               "--origin 19.0617,47.4731,102.5,90"});
}

}  // namespace
}  // namespace beespace::cli_test
