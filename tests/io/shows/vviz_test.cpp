// Shows as Verge Aero and Finale 3D exchange them.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

std::string vviz_of(const std::string& performances, const std::string& head = {}) {
  return R"({"version":"1.0","coordinateFrame":"ogl","defaultPositionRate":2.0,)" + head +
         R"("performances":[)" + performances + "]}";
}

// Climbs 10 m in 5 s, and flies that far to the right and forward in 0.5 s each.
std::string performance(int id, const std::string& home_x, const std::string& more = {}) {
  return R"({"id":)" + std::to_string(id) + R"(,"agentDescription":{"homeX":)" + home_x +
         R"(,"homeY":0.0,"homeZ":2.0,"agentTraversal":[{"dt":5,"dx":0,"dy":10,"dz":0},)" +
         R"({"dx":1.5,"dy":0,"dz":0},{"dx":0,"dy":0,"dz":0.5})" + more + "]}}";
}

TEST(Vviz, DronesFlyFromHomeFromSampleToSample) {
  const auto show = recording_of(record(
      vviz_of(performance(0, "0.0") + "," + performance(1, "3.0"), R"("timeOffsetSecs":1,)")));
  EXPECT_EQ(ids_of(show), (std::vector<std::string>{"drone 0", "drone 1"}));
  ASSERT_TRUE(show.show);
  ASSERT_TRUE(show.bees[1].path);
  const BezierPath& path = *show.bees[1].path;
  EXPECT_EQ(path.begins_s, 1.0);
  EXPECT_EQ(path.begin, (Point{3, 2, 0}));  // y is up, z forward
  ASSERT_EQ(path.pieces.size(), 3u);
  EXPECT_EQ(path.pieces[0].ends_s, 6.0);
  EXPECT_EQ(path.pieces[0].end, (Point{3, 2, 10}));
  EXPECT_EQ(path.pieces[1].ends_s, 6.5);
  EXPECT_EQ(path.pieces[2].end, (Point{4.5, 2.5, 10}));
  EXPECT_TRUE(has_note(show, "between samples drones are taken to fly in straight lines"));
}

// As of Verge Aero, whose first samples are at home, at the beginning.
TEST(Vviz, FirstSamplesThatAllSayHomeTakeNoTime) {
  const auto with_home = [](const std::string& performance) {
    std::string text = performance;
    return text.insert(text.find(R"({"dt")"), R"({"dx":0,"dy":0.0,"dz":0},)");
  };
  const std::string home = with_home(performance(0, "0"));
  const auto all = recording_of(record(vviz_of(home + "," + with_home(performance(1, "9")))));
  EXPECT_EQ(all.bees.at(0).path->pieces.at(0).ends_s, 5.0);
  const auto some = recording_of(record(vviz_of(home + "," + performance(1, "9"))));
  EXPECT_EQ(some.bees.at(0).path->pieces.at(0).ends_s, 5.5);
  EXPECT_EQ(some.bees.at(1).path->pieces.at(0).ends_s, 5.0);
}

TEST(Vviz, ALocationWithoutAHeadingIsTheLineToType) {
  const auto located = [](const std::string& place) {
    return recording_of(record(vviz_of(performance(0, "0.0") + "," + performance(1, "3.0"),
                                       R"("globalReferenceFrame":)" + place + ",")));
  };
  EXPECT_TRUE(has_note(
      located(R"({"lat":39.905963,"lon":-75.166393,"alt":0})"),
      "the location of the show is not taken, as it does not say where x points; on a map it is "
      "shown by 'beespace export' with --origin -75.166393,39.905963,0,90 if x points east; "
      "otherwise with its degrees from north instead of 90"));
  EXPECT_TRUE(has_note(
      located("{}"),
      "the location of the show is not taken, as it does not say where x points; on a map it is "
      "shown by 'beespace export' with --origin"));
}

TEST(Vviz, LengthsMayBeInFeet) {
  RecordingOptions feet;
  feet.units.position = Unit::kFoot;
  const auto show = recording_of(record(vviz_of(performance(0, "10.0")), feet));
  ASSERT_TRUE(show.bees.at(0).path);
  EXPECT_EQ(show.bees[0].path->begin.x, 3.048);
}

TEST(Vviz, WhatIsWrongIsSaidOfTheDrone) {
  expect_error(record(vviz_of("")), {ErrorCode::kNoPoints, "bees.csv", "has no performances"});
  expect_error(record(vviz_of(performance(7, R"("a")"))),
               {ErrorCode::kNotANumber, "bees.csv", "drone 'drone 7': homeX"});
  expect_error(record(vviz_of(performance(7, "0", R"(,{"dx":0,"dy":0})"))),
               {ErrorCode::kMissingColumn, "bees.csv",
                "drone 'drone 7': agentTraversal[3]: there is no dz"});
  expect_error(record(vviz_of(performance(7, "0", R"(,{"dt":0,"dx":1,"dy":0,"dz":0})"))),
               {ErrorCode::kTimeOrder, "bees.csv", "agentTraversal[3]: dt is 0"});
  expect_error(record(R"({"coordinateFrame":"ned","performances":[]})"),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "coordinateFrame is not \"ogl\""});
}

}  // namespace
}  // namespace beespace::io
