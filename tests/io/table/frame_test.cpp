#include "io/frames/frame_decision.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

// Longitudes beyond 90: they can be no latitudes.
std::string geographic_rows(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += "-175.5" + std::to_string(10 + i % 80) + ",6.3" + std::to_string(10 + i % 70) + "," +
            std::to_string(1310 + i * 7 % 480) + "\n";
  }
  return text;
}

TEST(Frame, AHeaderlessSwarmThatWouldBeAPillarIsInDegrees) {
  const auto loaded = load_text(geographic_rows(50));
  ASSERT_EQ(points_of(loaded).size(), 50u);
  EXPECT_EQ(loaded.value().frame, Frame::kWgs84);
  EXPECT_NE(loaded.value().frame_reason.find("pillar"), std::string::npos);
  ASSERT_EQ(loaded.value().notes.size(), 1u);
  EXPECT_NE(loaded.value().notes[0].find("longitude, latitude, height is taken"),
            std::string::npos);
}

TEST(Frame, ValuesBeyondDegreesAreMetres) {
  const auto first = load_text("0,0,0\n1000,20,30\n500,10,20\n");
  ASSERT_EQ(points_of(first).size(), 3u);
  EXPECT_EQ(first.value().frame, Frame::kMetres);
  EXPECT_EQ(first.value().frame_reason,
            "the values do not fit degrees: the first coordinate reaches 1000, beyond 360");
  const auto second = load_text("0,0,0\n100,-120,30\n");
  ASSERT_EQ(points_of(second).size(), 2u);
  EXPECT_EQ(second.value().frame_reason,
            "the values do not fit degrees: the second coordinate reaches 120, beyond 90");
}

TEST(Frame, RefusesWhatFitsBoth) {
  expect_error(load_text("1,2,3\n4,5,6\n"), {ErrorCode::kUnknownFrame, "bees.csv", "--crs wgs84"});
  // Tall and thin, but at the origin: a drone show, say.
  expect_error(load_text("0,0,0\n0.1,0.1,500\n"), {ErrorCode::kUnknownFrame, "bees.csv", "--crs"});
  // One point, and points at one place, have no width.
  expect_error(load_text("-75.5,6.3,1500\n"), {ErrorCode::kUnknownFrame, "bees.csv", "--crs"});
  expect_error(load_text("-75.5,6.3,1500\n-75.5,6.3,1900\n"),
               {ErrorCode::kUnknownFrame, "bees.csv", "--crs"});
  expect_error(load_text("-75.5,6.3\n-75.6,6.4\n"),
               {ErrorCode::kUnknownFrame, "bees.csv", "--crs"});
  // Words that do not tell the frame.
  expect_error(load_text("a,b,c\n1,2,3\n4,5,6\n"), {ErrorCode::kUnknownFrame, "bees.csv", "--crs"});
  expect_error(load_text("agent_x,agent_y,agent_z\n1,2,3\n"),
               {ErrorCode::kUnknownFrame, "bees.csv", "--crs"});
}

TEST(Frame, AFewOddRowsAmongDegreesAreNamedNotGuessedAway) {
  const std::string rows = geographic_rows(60);
  expect_error(load_text(rows + "\n-175.5,635.0,1500\n" + rows),
               {ErrorCode::kUnknownFrame, "bees.csv:62:2", "635"});
  expect_error(load_text(rows + "-7550,6.3,1500\n" + rows),
               {ErrorCode::kUnknownFrame, "bees.csv:61:1", "-7550"});
}

TEST(Frame, TheExplicitFrameAlwaysWins) {
  LoadOptions options = in_metres();
  EXPECT_EQ(points_of(load_text("lon,lat,alt\n1,2,3\n", options)), (std::vector<Point>{{1, 2, 3}}));
  options.frame = Frame::kWgs84;
  const auto loaded = load_text("x,y,z\n180,0,0\n", options);
  ASSERT_EQ(points_of(loaded).size(), 1u);
  EXPECT_NEAR(loaded.value().points[0].x, -6'378'137.0, 1e-6);
  EXPECT_EQ(loaded.value().frame_reason, "asked for with --crs wgs84");
}

TEST(Frame, AGeographicHeaderIsNotOverruledByValues) {
  expect_error(load_text("lon,lat,alt\n1000,2000,3\n"),
               {ErrorCode::kInvalidLongitude, "bees.csv:2:1", "1000"});
}

TEST(Frame, ReasonsSayWhatDecided) {
  EXPECT_EQ(load_text("lat,lon\n1,2\n").value().frame_reason,
            "the header names longitude and latitude");
  EXPECT_EQ(load_text("x,y,z\n1,2,3\n").value().frame_reason, "the header names x, y and z");
}

TEST(Frame, PillarNeedsSlendernessAndDistanceBothAtTheirLimits) {
  const auto decides = [](const std::vector<Point>& points) {
    std::vector<Point> swarm = points;  // as many as a swarm takes, all in the same box
    swarm.resize(40, points.front());
    return frame_from_values(swarm, extent_of(swarm), 3, Naming::kNone).has_value();
  };
  EXPECT_TRUE(decides({{110, 0, 0}, {111, 0, 1000}}));
  EXPECT_FALSE(decides({{110, 0, 0}, {111, 0, 999}}));
  EXPECT_TRUE(decides({{95, 0, 0}, {105, 0, 10000}}));
  EXPECT_FALSE(decides({{94.9, 0, 0}, {104.9, 0, 10000}}));
}

}  // namespace
}  // namespace beespace::io
