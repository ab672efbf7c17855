// `beespace fleet` of a show in metres and a log in degrees: deviations that are put in by hand.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/cli/fleet/small_show.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kAskedFor = 2;

TEST(FlownShow, IsComparedWhereItSaysThatItIsAndSaysWhoWasFarthest) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished finished =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z"}, log_of({"1", "2"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out, {"\n1\tDrone 1\t", "\n2\tDrone 2\t1\t2025-11-27T19:00:20.000Z\t"});
  expect_parts(finished.err,
               {"compared   2 drones, 62 fixes; nothing was set at the times of 20 more",
                "deviation  at most 1.000 m",
                "farthest   2 (Drone 2), 1.000 m from where it was set to be at "
                "2025-11-27T19:00:20.000Z\n",
                "ids are matched by their numbers: '1' is to fly what was set for "
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
  expect_parts(told.err, {"farthest   2 (Drone 2), 1.000 m"});
  // Turned by a quarter it is elsewhere.
  placed.back() = "19.0617,47.4731,102.5,0";
  expect_parts(run(placed, log_of({"1", "2"})).err, {"farthest   2 (Drone 2), 14.142 m"});
}

// Who got which place is often decided at the field.
TEST(FlownShow, NumbersThatMeanOthersGiveWayToWhereEachBegan) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished finished =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z"}, log_of({"2", "1"}));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"deviation  at most 1.000 m", "farthest   1 (Drone 2), 1.000 m",
                              "ids differ, and so each is to fly what was set to begin where it "
                              "began: '2' that of 'Drone 1'"});
}

TEST(FlownShow, HeightsAboveTakeOffAndOthersAreNotMixed) {
  TemporaryFolder folder;
  const std::string set = folder.file("show.json", show_with(kLocation));
  const Finished relative = run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z",
                                 "--columns", "lat=3,lon=4,height=6", "--crs", "wgs84"},
                                log_of({"1", "2"}));
  EXPECT_EQ(relative.exit_code, 0) << relative.err;
  expect_parts(relative.err, {"farthest   2 (Drone 2), 1.000 m"});
  const Finished ellipsoid =
      run({"fleet", "--set", set, "--set-begins", "2025-11-27T19:00:00Z"},
          log_of({"1", "2"}, "timestamp,drone_id,lat,lon,height_above_ellipsoid,alt_rel"));
  EXPECT_EQ(ellipsoid.exit_code, kAskedFor) << ellipsoid.out;
  expect_parts(ellipsoid.err, {"heights of what was flown are above the WGS84 ellipsoid",
                               "--origin 19.0617,47.4731,102.5,90"});
}

}  // namespace
}  // namespace beespace::cli_test
