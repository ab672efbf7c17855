// With --vertical the closest pair in a straight line may keep apart in height: pages, pictures and
// map files, and the summary of `detect`, name the pairs in conflict.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

using report_test::ParsedJson;

// a and "above" are closest, but 10 m apart in height; a and c are 20 m apart at one height.
constexpr std::string_view kBees = "id,x,y,z\na,0,0,0\nabove,3,0,10\nc,20,0,0\n";
constexpr std::string_view kFlown =
    "id,time_s,x,y,z\na,0,0,0,0\na,9,0,90,0\nabove,0,3,0,10\nabove,9,3,90,10\n"
    "c,0,20,0,0\nc,9,20,90,0\n";
constexpr std::string_view kOverTheEarth =
    "id,longitude,latitude,height\na,0,0,100\nabove,0.00003,0,110\nc,0.0002,0,100\n";
const Arguments kCylinder = {"--threshold", "25", "--vertical", "5"};
const Arguments kFlatCylinder = {"--threshold", "19", "--vertical", "5"};  // no conflict

std::string made(const Arguments& command, std::string_view input) {
  const Finished finished = run(command + Arguments{"--quiet"}, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  return finished.out;
}

TEST(SeenVertical, MapFilesNameThePairsInConflict) {
  for (const std::string format : {"kml", "czml"}) {
    const std::string map =
        made(Arguments{"export", "--format", format} + kCylinder, kOverTheEarth);
    expect_parts(map, {"22.3 m from c", "22.3 m from a"});
    EXPECT_EQ(map.find("above\""), std::string::npos);
    EXPECT_EQ(map.find("from above"), std::string::npos);
  }
  const std::string map =
      made(Arguments{"export", "--format", "geojson"} + kCylinder, kOverTheEarth);
  expect_parts(map, {R"("id":"a","nearest":"c","nearest_m":22.2)",
                     R"("id":"c","nearest":"a","nearest_m":22.2)"});
}

TEST(SeenVertical, PicturesRingTheClosestInConflict) {
  const std::string bees = made(Arguments{"plot"} + kCylinder, kBees);
  expect_parts(bees, {"closest: 20 m", "a \u2013 c", "horizontally 25 m"});
  const std::string flown = made(Arguments{"plot"} + kCylinder, kFlown);
  expect_parts(flown, {"closest: 20 m", "a \u2013 c", "horizontally 25 m"});
  for (const std::string& picture : {bees, flown}) {
    EXPECT_EQ(picture.find("10.4"), std::string::npos);
  }
}

TEST(SeenVertical, WithoutConflictsTheClosestAreReportedToKeepApart) {
  for (const std::string_view input : {kBees, kFlown}) {
    expect_parts(made(Arguments{"plot"} + kFlatCylinder, input),
                 {"closest, not too close: 3 m across, 10 m in height", "a \u2013 above",
                  ", not too close</text>"});
  }
}

TEST(SeenVertical, DetectSaysTheSame) {
  const Finished risky = run(Arguments{"detect"} + kCylinder, kBees);
  EXPECT_EQ(risky.out, "a\nc\n");
  expect_parts(risky.err, {"closest    a and c, 20.000 m apart\n"});
  expect_parts(run(Arguments{"detect", "--json"} + kCylinder, kBees).out, {"\"distance_m\": 20"});
  expect_parts(run(Arguments{"detect"} + kFlatCylinder, kBees).err,
               {"closest    a and above, 10.440 m apart in a straight line, not too close\n"});
}

class SeenVerticalPage : public PageCommand {};

TEST_F(SeenVerticalPage, HasTheClosestInConflict) {
  for (const std::string_view input : {kBees, kFlown}) {
    const Page risky = reported(kCylinder, input);
    EXPECT_EQ(std::uint64_t(risky.risk()["closest"]["first"]), 0u);
    EXPECT_EQ(std::uint64_t(risky.risk()["closest"]["second"]), 2u);
    EXPECT_EQ(double(risky.risk()["closest"]["distance_m"]), 20.0);
    const Page none = reported(kFlatCylinder, input);
    EXPECT_EQ(std::uint64_t(none.risk()["closest"]["second"]), 1u);
  }
}

// Not the closest two in a straight line, who keep apart in height.
TEST_F(SeenVerticalPage, HasThoseNearestToAConflictOverTime) {
  const Page page = reported(kCylinder, kFlown);
  const auto separation = page.swarm()["separation"].value();
  const auto horizontal_m = page.values(separation["horizontal_m"]);
  const auto height_m = page.values(separation["height_m"]);
  ASSERT_GT(horizontal_m.size(), 500u);
  for (const double metres : horizontal_m) EXPECT_NEAR(metres, 20.0, 1e-9);
  for (const double metres : height_m) EXPECT_NEAR(metres, 0.0, 1e-9);
}

}  // namespace
}  // namespace beespace::cli_test
