// Live input line by line: tables and objects of the same words.
#include "io/live/report_lines.hpp"

#include "tests/io/live/report_lines_reading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

TEST(ReportLines, ATableComesLineByLine) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("id,time_s,x,y,z,vx,vy,vz\n")));
  EXPECT_FALSE(lines.understood());
  const auto report = report_of(lines.take("a,1.5,1,2,3,4,5,6\r\n"));
  EXPECT_TRUE(lines.understood());
  EXPECT_EQ(report.id, "a");
  EXPECT_EQ(report.time_s, 1.5);
  EXPECT_EQ(report.position, (Point{1, 2, 3}));
  EXPECT_EQ(report.velocity, (Velocity{4, 5, 6}));
  EXPECT_EQ(report.frame, Frame::kMetres);
  EXPECT_FALSE(report.since_1970);
  EXPECT_EQ(lines.description(), "text, comma-separated");
  EXPECT_TRUE(lines_note(lines, "times are read from column 2 'time_s' in seconds"));
  EXPECT_EQ(lines.lines(), 2u);
}

TEST(ReportLines, DegreesDatesAndVelocitiesByCompass) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("time;drone;lat;lon;alt;vn;ve;vd")));
  const auto report = report_of(lines.take("2024-05-01T12:00:00.25Z;b 7;6.3;-75.5;1683.7;1;2;-3"));
  EXPECT_EQ(report.id, "b 7");
  EXPECT_EQ(report.time_s, 1714564800.25);
  EXPECT_TRUE(report.since_1970);
  EXPECT_EQ(report.frame, Frame::kWgs84);
  EXPECT_EQ(report.position, (Point{-75.5, 6.3, 1683.7}));
  EXPECT_EQ(report.velocity, (Velocity{2, 1, 3}));
}

TEST(ReportLines, BlankLinesSayNothingAndAreCounted) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("\n")));
  EXPECT_FALSE(says_something(lines.take("")));
  EXPECT_FALSE(says_something(lines.take("id,time_s,x,y,z")));
  EXPECT_FALSE(says_something(lines.take(" \r\n")));
  expect_line_error(lines.take("a,0,1,2,q"), {ErrorCode::kNotANumber, "<stdin>:5:5", "'q'"});
}

TEST(ReportLines, ABadLineIsAnErrorAndTheNextOneIsRead) {
  ReportLines lines({}, "live");
  EXPECT_FALSE(says_something(lines.take("id,time_s,x,y,z")));
  EXPECT_EQ(report_of(lines.take("a,0,1,2,3")).id, "a");
  expect_line_error(lines.take("a,1,1,2"), {ErrorCode::kColumnCount, "live:3", "4"});
  const auto bad = lines.take("a,soon,1,2,3");
  expect_line_error(bad, {ErrorCode::kNotANumber, "live:4:2", "'soon'"});
  EXPECT_EQ(bad.error().message.find("--skip-bad"), std::string::npos);
  expect_line_error(lines.take("a,1,nan,2,3"), {ErrorCode::kNotFinite, "live:5:3", "'nan'"});
  expect_line_error(lines.take("a,1,1e40,2,3"), {ErrorCode::kOutsideDomain, "live:6:3", "1e40"});
  EXPECT_EQ(report_of(lines.take("a,2,1,2,3")).time_s, 2.0);
}

TEST(ReportLines, ABadFirstRecordDoesNotMisleadTheNext) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("id,time,x,y,z")));
  EXPECT_FALSE(lines.take("a,b,c,d,e").has_value());
  EXPECT_EQ(report_of(lines.take("a,2024-05-01T12:00:00Z,1,2,3")).time_s, 1714564800.0);
}

TEST(ReportLines, NumbersThatAreTooSmallCountAsZero) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("id,time_s,x,y,z,vx,vy,vz")));
  const ReportLine report = report_of(lines.take("a,0,-9.8e-32,2,3,-9.8e-32,1e-31,3"));
  EXPECT_EQ(report.position, (Point{0.0, 2.0, 3.0}));
  ASSERT_TRUE(report.velocity.has_value());
  EXPECT_EQ(*report.velocity, (Velocity{0.0, 0.0, 3.0}));
}

TEST(ReportLines, WhatTheHeaderLeavesOpenIsAnErrorOfItsLine) {
  for (const auto& [header, record, code, message] :
       std::vector<std::tuple<std::string, std::string, ErrorCode, std::string>>{
           {"id,time,x,y,z", "a,0,1,2,3", ErrorCode::kInvalidArgument,
            "--time-unit s, ms, us or ns, or in the header"},
           {"id,time_s,x,y,z,ref_lat,ref_lon,ref_alt", "a,0,1,2,3,47,8,400",
            ErrorCode::kUnknownFrame, "which each drone has of its own"},
           {"time_s,x,y,z", "0,1,2,3", ErrorCode::kMissingColumn, "there is no id"},
           {"id,x,y,z", "a,1,2,3", ErrorCode::kMissingColumn, "neither a time nor a velocity"},
           {"id,x,y,vx,vy", "a,1,2,3,4", ErrorCode::kMissingColumn, "there is no time"},
           {"id,time_s,p,q,r", "a,0,1,2,3", ErrorCode::kMissingColumn, "names no position"},
           {"id,time_s,uav_x,uav_y", "a,0,1,2", ErrorCode::kUnknownFrame, "--crs"}}) {
    ReportLines lines;
    EXPECT_FALSE(says_something(lines.take("")));
    EXPECT_FALSE(says_something(lines.take(header)));
    const auto bad = lines.take(record);
    ASSERT_FALSE(bad.has_value()) << header;
    EXPECT_EQ(to_string(bad.error().code), to_string(code)) << header;
    EXPECT_EQ(bad.error().location.line, 2u) << header;
    EXPECT_NE(bad.error().message.find(message), std::string::npos) << bad.error().message;
    EXPECT_FALSE(lines.understood()) << header;
  }
}

TEST(ReportLines, TheCallerMayNameColumnsInsteadOfAHeader) {
  RecordingOptions options;
  options.columns = "id=1,time=2,x=3,y=4,z=5";
  options.time_unit = Unit::kMillisecond;
  ReportLines lines(options);
  EXPECT_EQ(report_of(lines.take("7,1500,1,2,3")).time_s, 1.5);
  EXPECT_EQ(report_of(lines.take("8,1600,1,2,3")).id, "8");
}

TEST(ReportLines, ATableWithoutAHeaderMustBeDescribed) {
  ReportLines lines;
  expect_line_error(lines.take("7,1500,1,2,3"),
                    {ErrorCode::kMissingColumn, "<stdin>:1", "there is no header"});
}

TEST(ReportLines, VelocitiesThatAreNotAllKnownAreNone) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("id,time_s,x,y,z,vx,vy,vz")));
  EXPECT_FALSE(report_of(lines.take("a,0,1,2,3,4,,6")).velocity.has_value());
  EXPECT_FALSE(report_of(lines.take("a,0,1,2,3,4,5,nan")).velocity.has_value());
  EXPECT_TRUE(report_of(lines.take("a,0,1,2,3,4,5,0")).velocity.has_value());
}

TEST(ReportLines, ObjectsAreReadByTheWordsOfTables) {
  ReportLines lines;
  auto report =
      report_of(lines.take(R"({"id": "a", "time_s": 1.5, "x": 1, "y": 2, "z": 3, "vx": 4, )"
                           R"("vy": 5, "vz": 6, "more": {"deep": [1]}})"));
  EXPECT_EQ(report.id, "a");
  EXPECT_EQ(report.time_s, 1.5);
  EXPECT_EQ(report.position, (Point{1, 2, 3}));
  EXPECT_EQ(report.velocity, (Velocity{4, 5, 6}));
  report = report_of(lines.take(R"({"z": 3e0, "y": -2, "x": 1, "id": 12, "time_s": 2})"));
  EXPECT_EQ(report.id, "12");
  EXPECT_EQ(report.position, (Point{1, -2, 3}));
  EXPECT_FALSE(report.velocity.has_value());
  EXPECT_EQ(lines.description(), "JSON, an object a line");
}

TEST(ReportLines, ObjectsInDegreesWithMillisecondsSince1970) {
  ReportLines lines;
  const auto report = report_of(lines.take(
      R"({"name":"b","unix_time_ms":1714564800250,"lat":6.3,"lon":-75.5,"height":1683.7})"));
  EXPECT_EQ(report.time_s, 1714564800.25);
  EXPECT_TRUE(report.since_1970);
  EXPECT_EQ(report.frame, Frame::kWgs84);
  EXPECT_EQ(report.position, (Point{-75.5, 6.3, 1683.7}));
}

TEST(ReportLines, KeysMayComeLater) {
  ReportLines lines;
  EXPECT_FALSE(report_of(lines.take(R"({"id":"a","time_s":0,"x":1,"y":2,"z":3})")).velocity);
  const auto report =
      report_of(lines.take(R"({"id":"a","time_s":0,"x":1,"y":2,"z":3,"vx":4,"vy":5,"vz":6})"));
  EXPECT_EQ(report.velocity, (Velocity{4, 5, 6}));
}

// A message of another kind is an error of its line alone, whatever keys it brings.
TEST(ReportLines, ObjectsOfAnotherKindDoNotEndWhatIsBelieved) {
  for (const char* const time : {R"("2026-11-28T12:00:00.5Z")", "1795867200.5"}) {
    ReportLines lines;
    const std::string report =
        std::string(R"({"id": "a", "time": )") + time + R"(, "lon": 8, "lat": 47, "alt": 500})";
    EXPECT_TRUE(says_something(lines.take(report)));
    EXPECT_FALSE(lines.take(R"({"error": "timeout"})").has_value());
    EXPECT_FALSE(lines.take(R"({"type": "heartbeat", "uptime": 12})").has_value());
    EXPECT_TRUE(says_something(lines.take(report))) << time;
    EXPECT_FALSE(lines.ended());
  }
}

// As of columns: what the object says of its place counts, however it says so.
TEST(ReportLines, ObjectsThatSayThatTheirPlaceIsNoneAreLeftOut) {
  const std::string place = R"({"id": "a", "time_s": 1, "x": 2, "y": 3, "z": 4, )";
  for (const char* const mark :
       {R"("fix_type": 1})", R"("fix_type": "no fix"})", R"("fix": false})", R"("valid": false})",
        R"("gps_fix": 0})", R"("xy_valid": false})", R"("z_valid": 0})"}) {
    ReportLines lines;
    EXPECT_FALSE(says_something(lines.take(place + mark))) << mark;
    EXPECT_EQ(lines.hidden_id(), "a") << mark;
  }
  for (const char* const mark :
       {R"("fix_type": 3})", R"("fix_type": null})", R"("fix": true})", R"("xy_valid": 1})"}) {
    ReportLines lines;
    EXPECT_TRUE(says_something(lines.take(place + mark))) << mark;
  }
  ReportLines lines;
  expect_line_error(lines.take(place + R"("fix_type": "perhaps"})"),
                    {ErrorCode::kMalformedRecord, "<stdin>:1", "'perhaps' is not known"});
}

TEST(ReportLines, DatesInObjectsAreTimes) {
  ReportLines lines;
  EXPECT_EQ(
      report_of(lines.take(R"({"id":"a","time":"2024-05-01T12:00:00Z","x":1,"y":2,"z":3})")).time_s,
      1714564800.0);
  expect_line_error(lines.take(R"({"id":"a","time":5,"x":1,"y":2,"z":3})"),
                    {ErrorCode::kNotANumber, "<stdin>:2", "where a date and time should be"});
}

TEST(ReportLines, BadObjectsAreErrorsAndTheNextOneIsRead) {
  ReportLines lines;
  const std::string good = R"({"id":"a","time_s":0,"lon":1,"lat":2,"height":3})";
  EXPECT_EQ(report_of(lines.take(good)).id, "a");
  expect_line_error(lines.take(R"({"id":"a","time_s":0,)"),
                    {ErrorCode::kTruncated, "<stdin>:2:22", "ends too early"});
  expect_line_error(lines.take(R"({"id":"a" "time_s":0})"),
                    {ErrorCode::kCorrupt, "<stdin>:3:11", "a comma or } is expected"});
  expect_line_error(lines.take("[1]"), {ErrorCode::kUnsupportedFormat, "<stdin>:4", "an array"});
  expect_line_error(lines.take(R"({"id":"a","time_s":0,"lat":2,"height":3})"),
                    {ErrorCode::kMissingColumn, "<stdin>:5", "there is no 'lon'"});
  expect_line_error(lines.take(R"({"id":"a","time_s":0,"lon":"1","lat":2,"height":3})"),
                    {ErrorCode::kNotANumber, "<stdin>:6", "'lon' is a string"});
  expect_line_error(lines.take(R"({"id":"a","time_s":0,"lon":1,"lat":91,"height":3})"),
                    {ErrorCode::kInvalidLatitude, "<stdin>:7", "latitude 91"});
  expect_line_error(lines.take(R"({"id":1.5,"time_s":0,"lon":1,"lat":2,"height":3})"),
                    {ErrorCode::kMalformedRecord, "<stdin>:8", "'id' is no id"});
  expect_line_error(lines.take(R"({"id":"a","time_s":1e300,"lon":1,"lat":2,"height":3})"),
                    {ErrorCode::kOutsideDomain, "<stdin>:9", "'time_s' cannot be computed"});
  EXPECT_EQ(report_of(lines.take(good)).id, "a");
}

TEST(ReportLines, ObjectsThatSayTooLittle) {
  for (const auto& [object, code, message] :
       std::vector<std::tuple<std::string, ErrorCode, std::string>>{
           {R"({})", ErrorCode::kMissingColumn, "this object is empty"},
           {R"({"id":"a","time_s":0})", ErrorCode::kMissingColumn, "names no position"},
           {R"({"time_s":0,"x":1,"y":2})", ErrorCode::kMissingColumn, "there is no id"},
           {R"({"id":"a","x":1,"y":2})", ErrorCode::kMissingColumn,
            "neither a time nor a velocity"},
           {R"({"id":"a","time_s":0,"position":[1,2,3]})", ErrorCode::kMissingColumn,
            "'position' is an array; of three numbers"},
           {R"({"id":"a","time_s":0,"position":{"x":1,"y":2}})", ErrorCode::kMissingColumn,
            "jq -c --unbuffered '. + .position | del(.position)' before '| beespace watch'"},
           // The place before the unit of the time, and in objects within each other.
           {R"({"id":"a","time":0,"position":[1,2,3]})", ErrorCode::kMissingColumn,
            "make values of their own: jq -c --unbuffered '. + {x: .position[0]"},
           {R"({"id":"a","time":0,"pose":{"position":{"x":1,"y":2}}})", ErrorCode::kMissingColumn,
            "with names as pose.x, and read that: jq -c --unbuffered '[paths(scalars)"},
           // Where nothing is said of several files, which watch does not take.
           {R"({"id":"a","time":0,"x":1,"y":2})", ErrorCode::kInvalidArgument,
            "Say it with --time-unit s, ms, us or ns, or in the header: time_s"}}) {
    ReportLines lines;
    const auto bad = lines.take(object);
    ASSERT_FALSE(bad.has_value()) << object;
    EXPECT_EQ(to_string(bad.error().code), to_string(code)) << object;
    EXPECT_EQ(bad.error().location.line, 1u) << object;
    EXPECT_NE(bad.error().message.find(message), std::string::npos) << bad.error().message;
    EXPECT_FALSE(lines.understood());
    EXPECT_EQ(report_of(lines.take(R"({"id":"a","time_s":0,"x":1,"y":2,"z":3})")).id, "a");
  }
}

TEST(ReportLines, PosesOfRosInJsonHaveTheirNanosecondsAndAreInMetres) {
  const auto line = [](const std::string& nanoseconds, const std::string& x) {
    return R"({"name":"a","header.stamp.sec":1717250400,"header.stamp.nanosec":)" + nanoseconds +
           R"(,"header.frame_id":"map","pose.position.x":)" + x +
           R"(,"pose.position.y":2,"pose.position.z":3,"pose.orientation.w":1})";
  };
  ReportLines lines;
  const ReportLine first = report_of(lines.take(line("250000000", "1")));
  EXPECT_EQ(first.time_s, 1717250400.25);
  EXPECT_EQ(first.frame, Frame::kMetres);
  EXPECT_TRUE(first.since_1970);
  EXPECT_EQ(report_of(lines.take(line("500000000", "2"))).time_s, 1717250400.5);
  expect_line_error(lines.take(line("2000000000", "2")),
                    {ErrorCode::kOutsideDomain, "<stdin>:3",
                     "'header.stamp.nanosec' is 2e+09, no number of nanoseconds"});
}

TEST(ReportLines, WholeDegreesOfMavlinkAreTakenInJson) {
  const auto line = [](const char* lon) {
    return std::string(R"({"mavpackettype": "GLOBAL_POSITION_INT", "sysid": "r1", "time_boot_ms": 0,
                         "lat": 474000000, "lon": )") +
           lon + R"(, "alt": 500000, "relative_alt": 0, "vx": 0, "vy": 50, "vz": 0})";
  };
  ReportLines lines;
  const ReportLine report = report_of(lines.take(line("84999335")));
  EXPECT_EQ(report.frame, Frame::kWgs84);
  EXPECT_EQ(report.position.x, 8.4999335);
  EXPECT_EQ(report.position.y, 47.4);
  EXPECT_EQ(report.position.z, 500.0);
  EXPECT_TRUE(lines_note(lines, "whole numbers of 1e-7 degrees"));
  expect_line_error(lines.take(line("84999335.5")),
                    {ErrorCode::kMalformedRecord, "<stdin>:2", "no whole number of 1e-7 degrees"});
}

TEST(ReportLines, FramesOfRosInJsonAreCompared) {
  const auto line = [](const char* id, const char* frame) {
    return std::string(R"({"id": ")") + id + R"(", "time_s": 1, "header.frame_id": ")" + frame +
           R"(", "x_m": 1, "y_m": 2, "z_m": 3})";
  };
  ReportLines lines;
  EXPECT_EQ(report_of(lines.take(line("a", "a/odom"))).id, "a");
  expect_line_error(lines.take(line("b", "b/odom")),
                    {ErrorCode::kUnknownFrame, "<stdin>:2", "they cannot be compared"});
}

TEST(ReportLines, WhatIsNoTextIsRefused) {
  ReportLines lines;
  expect_line_error(lines.take("PK\x03\x04"),
                    {ErrorCode::kUnsupportedFormat, "<stdin>:1", "a zip archive"});
}

TEST(ReportLines, AByteOrderMarkIsNoPartOfTheHeader) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("\xEF\xBB\xBFid,time_s,x,y,z")));
  EXPECT_EQ(report_of(lines.take("a,0,1,2,3")).id, "a");
}

// 31,000 m are feet: so may be what came before.
TEST(ReportLines, HeightsThatNothingFliesAtEndWhatIsBelieved) {
  for (const std::string first : {"id,time_s,lat,lon,height\n",
                                  "time,icao24,lat,lon,velocity,heading,vertrate,callsign,"
                                  "onground,baroaltitude,geoaltitude\n"}) {
    const bool opensky = first.starts_with("time,");
    const auto line = [opensky](const std::string& height) {
      return opensky ? "1700000000,3c6444,47,8,230,90,0,DLH1,false," + height + "," + height
                     : "a,1700000000,47,8," + height;
    };
    ReportLines lines;
    EXPECT_FALSE(says_something(lines.take(first)));
    EXPECT_EQ(report_of(lines.take(line("11000"))).position.z, 11000.0);
    EXPECT_FALSE(lines.ended());
    expect_line_error(lines.take(line("31000")),
                      {ErrorCode::kInvalidArgument, "<stdin>:3", "heights go up to 31000"});
    EXPECT_TRUE(lines.ended());
  }
  RecordingOptions options;
  options.units.height = Unit::kMetre;
  ReportLines said(options);
  EXPECT_FALSE(says_something(said.take("id,time_s,lat,lon,height")));
  EXPECT_EQ(report_of(said.take("a,1,47,8,31000")).position.z, 31000.0);
}

TEST(ReportLines, AddressesInCapitalsAreTheSameAircraft) {
  ReportLines lines;
  EXPECT_FALSE(says_something(lines.take("time_s,icao24,lat,lon,alt_ft")));
  EXPECT_EQ(report_of(lines.take("1,3C6444,47,8,31000")).id, "3C6444");
  EXPECT_EQ(report_of(lines.take("2,3c6444,47,8,31000")).id, "3C6444");
  ReportLines objects;
  const std::string object = R"("lat":47,"lon":8,"alt_ft":31000})";
  EXPECT_EQ(report_of(objects.take(R"({"time_s":1,"icao24":"3c6444",)" + object)).id, "3c6444");
  EXPECT_EQ(report_of(objects.take(R"({"time_s":2,"icao24":"3C6444",)" + object)).id, "3c6444");
}

}  // namespace
}  // namespace beespace::io
