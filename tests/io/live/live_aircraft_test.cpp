// Live input of aircraft: readsb's objects and BaseStation messages, line by line.
#include "tests/io/live/report_lines_reading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

constexpr std::string_view kFlying =
    R"({"now":1000000.5,"hex":"4B1814","flight":"SWR12AB ","alt_baro":9000,"alt_geom":10000,)"
    R"("gs":360,"track":0,"geom_rate":600,"lat":47.25,"lon":8.5,"seen_pos":2.5,"seen":0.1})";
constexpr std::string_view kAirborne =
    "MSG,3,1,1,4B1814,1,2024/05/01,12:00:00.250,2024/05/01,12:00:00.250,,10000,,,47.25,8.5,,,0,0,0,"
    "0\r\n";
constexpr std::string_view kVelocity =
    "MSG,4,1,1,4B1814,1,2024/05/01,12:00:00.000,2024/05/01,12:00:00.000,,,360,180,,,600,,0,0,0,0\n";

TEST(LiveAircraft, ObjectsOfReadsb) {
  ReportLines lines;
  const auto report = report_of(lines.take(kFlying));
  EXPECT_EQ(report.id, "4b1814");
  EXPECT_EQ(report.label, "SWR12AB");
  EXPECT_EQ(report.time_s, 999998.0);
  EXPECT_TRUE(report.since_1970);
  EXPECT_EQ(report.frame, Frame::kWgs84);
  EXPECT_EQ(report.position, (Point{8.5, 47.25, 10000 * 0.3048}));
  ASSERT_TRUE(report.velocity.has_value());
  EXPECT_EQ(report.velocity->x, 0.0);
  EXPECT_NEAR(report.velocity->y, 185.2, 1e-12);
  EXPECT_NEAR(report.velocity->z, 3.048, 1e-15);
  EXPECT_TRUE(lines.understood());
  EXPECT_EQ(lines.description(), "readsb JSON");
  EXPECT_EQ(lines.heights(), HeightDatum::kEllipsoid);
}

TEST(LiveAircraft, ObjectsThatSayNoPositionAreCounted) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take(R"({"now":1,"hex":"a","seen":3})")));
  EXPECT_TRUE(lines.understood());
  EXPECT_FALSE(says_something(lines.take(R"({"now":1,"hex":"b","seen":3})")));
  EXPECT_TRUE(lines_note(lines, "2 records without a position are left out"));
  EXPECT_EQ(report_of(lines.take(kFlying)).id, "4b1814");
}

TEST(LiveAircraft, ALookAtManyInOneLineIsToldHowToBeTakenApart) {
  ReportLines lines;
  expect_line_error(
      lines.take(R"({"now":1,"messages":7,"aircraft":[{"hex":"a","lat":1,"lon":2}]})"),
      {ErrorCode::kUnsupportedFormat, "<stdin>:1",
       "jq -c --unbuffered '.now as $now | .aircraft[] | .now = $now'"});
}

TEST(LiveAircraft, ObjectsWithoutNowHaveNoTime) {
  ReportLines lines;
  expect_line_error(lines.take(R"({"hex":"a","lat":1,"lon":2,"alt_geom":3,"seen_pos":1})"),
                    {ErrorCode::kMissingColumn, "<stdin>:1", "there is no 'now'"});
}

TEST(LiveAircraft, BadObjectsAreErrorsAndTheNextOneIsRead) {
  ReportLines lines;
  EXPECT_EQ(report_of(lines.take(kFlying)).id, "4b1814");
  expect_line_error(lines.take(R"({"now":1,"hex":"a","lat":"x"})"),
                    {ErrorCode::kNotANumber, "<stdin>:2", "'lat' is a string"});
  expect_line_error(lines.take(R"({"now":1,"hex":)"),
                    {ErrorCode::kTruncated, "<stdin>:3:16", "ends too early"});
  const auto bad = lines.take(R"({"now":1,"hex":"a","lat":99,"lon":2,"alt_geom":3,"seen_pos":1})");
  expect_line_error(bad, {ErrorCode::kInvalidLatitude, "<stdin>:4", "latitude 99"});
  EXPECT_EQ(bad.error().message.find("--skip-bad"), std::string::npos);
  EXPECT_EQ(report_of(lines.take(kFlying)).id, "4b1814");
}

TEST(LiveAircraft, ObjectsOfOwnWordsAreNotReadsbs) {
  ReportLines lines;
  const auto report =
      report_of(lines.take(R"({"hex":"A","time_s":1,"lat":47,"lon":8,"height_m":10000})"));
  EXPECT_EQ(report.id, "A");
  EXPECT_EQ(report.position.z, 10000.0);
}

TEST(LiveAircraft, HeightsByPressureWhereTheyAreAskedFor) {
  RecordingOptions options;
  options.heights = HeightSource::kPressure;
  ReportLines lines(options);
  EXPECT_EQ(report_of(lines.take(kFlying)).position.z, 2743.2);
  EXPECT_EQ(lines.heights(), HeightDatum::kPressure);
}

TEST(LiveAircraft, MessagesOfBaseStation) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take(kVelocity)));
  EXPECT_TRUE(lines.understood());
  const auto report = report_of(lines.take(kAirborne));
  EXPECT_EQ(report.id, "4b1814");
  EXPECT_EQ(report.time_s, 1714564800.25);
  EXPECT_EQ(report.position, (Point{8.5, 47.25, 10000 * 0.3048}));
  ASSERT_TRUE(report.velocity.has_value());
  EXPECT_NEAR(report.velocity->y, -185.2, 1e-12);
  EXPECT_EQ(lines.heights(), HeightDatum::kPressure);
  EXPECT_TRUE(lines_note(lines, "UTC"));
  expect_line_error(lines.take("MSG,3"), {ErrorCode::kColumnCount, "<stdin>:3", "this one has 2"});
  EXPECT_EQ(report_of(lines.take(kAirborne)).id, "4b1814");
}

TEST(LiveAircraft, MessagesHaveNoGeometricHeights) {
  RecordingOptions options;
  options.heights = HeightSource::kGeometric;
  ReportLines lines(options);
  expect_line_error(lines.take(kAirborne),
                    {ErrorCode::kInvalidArgument, "<stdin>:1", "by pressure only"});
  EXPECT_FALSE(lines.understood());
}

TEST(LiveAircraft, MetresDoNotGoWithThem) {
  RecordingOptions options;
  options.frame = Frame::kMetres;
  ReportLines objects(options);
  expect_line_error(objects.take(kFlying),
                    {ErrorCode::kInvalidArgument, "<stdin>:1", "--crs metres"});
  ReportLines messages(options);
  expect_line_error(messages.take(kAirborne),
                    {ErrorCode::kInvalidArgument, "<stdin>:1", "--crs metres"});
}

TEST(LiveAircraft, VelocitiesOfMoreAircraftThanAreKeptAreForgotten) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take(kVelocity)));
  for (int i = 0; i < 70'000; ++i) {
    EXPECT_FALSE(says_something(
        lines.take("MSG,8,1,1,X" + std::to_string(i) +
                   ",1,2024/05/01,12:00:00.000,2024/05/01,12:00:00.000,,,,,,,,,,,,0")));
  }
  EXPECT_FALSE(report_of(lines.take(kAirborne)).velocity.has_value());
}

}  // namespace
}  // namespace beespace::io
