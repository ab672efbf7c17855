#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

constexpr std::string_view kHeader = "id,time_s,x,y,z\n";

Result<Recording> with_row(std::string_view row, const RecordingOptions& options = {}) {
  return record(std::string(kHeader) + "a,0,1,2,3\n" + std::string(row) + "\n", options);
}

TEST(BadTrack, EmptyInputAndNothingBehindTheHeader) {
  expect_error(record(""), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(record(" \n\n"), {ErrorCode::kNoPoints, "bees.csv", "the input is empty"});
  expect_error(record(kHeader), {ErrorCode::kNoPoints, "bees.csv", "a header and no record"});
}

// As folders of drones have them, without a header or with a name in its place.
TEST(BadTrack, TablesOfOneDroneWithoutAHeaderAreOfferedColumnsWithoutAnId) {
  expect_error(record("0,1,2,3,0,255,0,0\n2,1,2,3,0,255,0,0\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "or, where each file is one bee, time=1,x=2,y=3,z=4, or frame=1,x=2,y=3,z=4 with "
                "--fps N (there are 8 columns"});
  expect_error(record("copter_1\n0,1,2,3,0,255,0,0\n2,1,2,3,0,255,0,0\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "the first line has one cell, 'copter_1', and no header that tells the columns: if "
                "it is the name of the drone, leave it out, as by sed 1d FILE > plain/FILE in a "
                "new folder 'plain', and say which columns are which, as in beespace replay plain "
                "--columns frame=1,x=2,y=3,z=4 --fps N"});
}

TEST(BadTrack, MissingColumnsAreNamedWithThoseThatAreThere) {
  expect_error(record("id,time_s,a,b\nx,0,1,2\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "the header names no position (x and y, or longitude and latitude); say which is "
                "which, perhaps with --columns id=1,time=2,x=3,y=4, or, of degrees, "
                "id=1,time=2,lon=3,lat=4 (the columns are 1 'id', 2 'time_s', 3 'a', 4 'b')"});
  // A height that is none would keep apart who is not.
  expect_error(record("id,time_s,a,b,c\nx,0,1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "say which is which, perhaps with --columns id=1,time=2,x=3,y=4, or"});
  // Of DAIDALUS without its line of units, and of a data frame of move.
  expect_error(record("NAME,sx,sy,sz,vz,trk,gs,time_s\nA,0,0,5,0,0,180,0\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "--columns id=1,time=8,x=2,y=3,z=4, or"});
  expect_error(record("trackId,timestamps,coords.x1,coords.x2,sensor\n"
                      "Anna,2023-08-15 06:00:00,8.9,47.7,GPS\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "x=3,y=4, or, of degrees, id=1,time=2,lon=3,lat=4 ("});
  expect_error(record("time_s,Callsign,Altitude [ft],Position\n0,BAW9,33000,"
                      "\"48.166554,2.000000\"\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "column 4 'Position' seems to hold latitude and longitude in one; make two"});
  const auto twice = [](const std::string& object) {
    return record(object + "\n" + object + "\n");
  };
  expect_error(twice(R"({"id": "a", "time_s": 0, "position": [1, 2, 3]})"),
               {ErrorCode::kMissingColumn, "bees.csv",
                "column 3 'position' is an array; of three numbers x, y, z make values of their "
                "own: jq -c '. + {x: .position[0], y: .position[1], z: .position[2]} | "
                "del(.position)' FILE > xyz.ndjson"});
  expect_error(record("agent,A,A,A,B,B,B\ncoord,x,y,z,x,y,z\ntime,,,,,,\n0.0,1,2,3,4,5,6\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "pandas.read_csv('FILE', header=[0, 1], index_col=0).stack(0)"});
  expect_error(record("step,agent_id,pos_x,pos_y,pos_z\n0,A,1,2,3\n1,A,1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "column 1 'step' seems to count steps, and there is no time; say how many are in a "
                "second, as in --columns frame=1 --fps 10 ("});
  expect_error(record("name,time_s,colour\nAnna,0,red\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "name its columns with --columns x=N"});
  expect_error(record("id,timestamp,lon,lat\na,2023-08-15T06:00:00Z,8,47\n"
                      "a,2023-08-15T06:00:00Z,8,47.1\n"),
               {ErrorCode::kTimeOrder, "bees.csv:3",
                "at the same time, 2023-08-15T06:00:00.000Z, in bees.csv, line 2"});
  expect_error(record("id,time_s,lat,alt\nx,0,1,2\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "the header names no position"});
  expect_error(record("id,x,y,z\na,1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "there is neither a time nor a velocity"});
  expect_error(record("\x93NUMPY\x01 {'descr': '|O', 'shape': ()}"),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "idtrackerai_csv FOLDER"});
  // A day and a time of day, under names of a collar's own.
  expect_error(record("id,LMT_Date,LMT_Time,lon,lat\na,2024-05-01,12:00:00,8,47\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "say so with --columns date=2"});
  expect_error(record("CollarSerialNumber,Year,Julianday,Hour,Minute,lat,lon,FixTime,2D/3D\n"
                      "7,23,10,0,1,47,8,77,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "the time is in several columns, of days, hours and minutes, which are not read; "
                "write it in one, as 2024-05-01T12:00:00Z"});
  expect_error(record("id,time,lon,lat\na,10-Okt-2023 00:01:07,8,47\n"),
               {ErrorCode::kNotANumber, "bees.csv:1:2",
                "'10-Okt-2023 00:01:07' is neither a number nor a date that is read"});
}

TEST(BadTrack, WithoutAHeaderTheColumnsMustBeGiven) {
  expect_error(record("a,0,1,2,3\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "there is no header that tells the columns; say which is which"});
  expect_error(record("0,1,2,3\n"), {ErrorCode::kMissingColumn, "bees.csv:1", "no header"});
}

TEST(BadTrack, TheUnitOfTimeIsNotGuessed) {
  expect_error(record("id,time,x,y,z\na,0,1,2,3\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:2",
                "column 2 'time' holds the time, but in which unit? Say it with --time-unit"});
  RecordingOptions options;
  options.columns = "id=1,time=2,x=3,y=4,z=5";
  expect_error(record("a,0,1,2,3\n", options),
               {ErrorCode::kInvalidArgument, "bees.csv:1:2", "in which unit?"});
  expect_error(record("id,time [min],x,y,z\na,0,1,2,3\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:1:2", "is in 'min'; convert it first"});
}

// What is wrong is the first value, not the header.
TEST(BadTrack, ATimeThatIsWrongInTheFirstRecordIsNamedWithItsLine) {
  expect_error(record("# a comment\nid,time,x,y,z\n\na,2015-09-10,1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:4:2",
                "'2015-09-10' is not a time: it is a day without a time"});
  expect_error(record("id,date,time,x,y,z\na,yesterday,07:00:00,1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:2", "write the day as 2024-05-01"});
  expect_error(record("id,date,time,x,y,z\na,9/10/2015,07:00:00,1,2,3\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:2:2", "is the day first, or the month?"});
  EXPECT_EQ(times_of(recording_of(record("id,time,x_m,y_m,z_m\n"
                                         "a,2015/09/10 07:00:00Z,1,2,3\n"))
                         .bees[0])[0],
            1441868400.0);
}

// The day of a time of day is not left out because its column has a name that is not known.
TEST(BadTrack, ADayBesideTimesOfDayIsNotIgnored) {
  const std::string rows = "\na,07:00:00,1,2,3,10.09.2015\na,07:00:00,1,2,3,11.09.2015\n";
  expect_error(record("id,time,x_m,y_m,z_m,Tag" + rows),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "column 6 'Tag' may hold their day; say so with --columns date=6"});
  expect_error(record("id,time,x_m,y_m,z_m,obs_date\na,07:00:00,1,2,3,\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "column 6 'obs_date' may hold their day"});
  expect_error(record("id,date,utc_date,time,x_m,y_m,z_m\na,2015-09-10,2015-09-10,07:00:00,1,2,3"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "may hold their day"});
}

// Hours later, or a night that was left out.
TEST(BadTrack, TimesOfDayThatGoBackMayBeOfAnotherDay) {
  const std::string header = "id,time,x_m,y_m,z_m\n";
  expect_error(record(header + "a,20:00:00,1,2,3\nb,09:00:00,1,2,3\na,10:00:00,9,2,3\n"),
               {ErrorCode::kTimeOrder, "bees.csv:4:2",
                "the times of day of bee 'a' go back here, as if another day had begun"});
  const TemporaryFolder folder;
  const std::string first = folder.write("1.csv", header + "a,07:00:00,1,2,3\na,08:00:00,1,2,3\n");
  const std::string second = folder.write("2.csv", header + "a,07:30:00,1,2,3\na,08:30:00,1,2,3\n");
  expect_error(load_recording({first, second}),
               {ErrorCode::kTimeOrder, second + ":2:2", "go back"});
}

TEST(BadTrack, ATimeInTwoUnitsIsATimeWhoseUnitIsAskedFor) {
  for (const std::string name : {"time_s_ms", "Time [us] [ms]", "timestamp_ms_ns"}) {
    const std::string text = "id," + name + ",x,y,z\na,0,1,2,3\na,1000,1,2,3\n";
    expect_error(record(text), {ErrorCode::kInvalidArgument, "bees.csv:1:2", "in which unit?"});
    RecordingOptions options;
    options.time_unit = Unit::kMillisecond;
    EXPECT_TRUE(record(text, options).has_value()) << name;
  }
}

TEST(BadTrack, SeveralTimesMustBeDistinguished) {
  expect_error(
      record("id,time_s,timestamp_us,x,y,z\na,0,0,1,2,3\n"),
      {ErrorCode::kMissingColumn, "bees.csv:1", "say which with --columns time=2 or time=3"});
}

TEST(BadTrack, InvalidColumnOptions) {
  const auto wish = [](const std::string& columns) {
    return record("id,time_s,x,y,z,vx\na,0,1,2,3,4\n", columns_are(columns));
  };
  expect_error(wish("when=1"), {ErrorCode::kInvalidArgument, "bees.csv",
                                "'when=1' is not understood; write role=column"});
  expect_error(wish("time"), {ErrorCode::kInvalidArgument, "bees.csv", "'time' is not understood"});
  expect_error(wish("time=2,time=3"), {ErrorCode::kInvalidArgument, "bees.csv", "given twice"});
  expect_error(wish("vx=6,ve=6"), {ErrorCode::kInvalidArgument, "bees.csv", "given twice"});
  expect_error(wish("vx=6"), {ErrorCode::kInvalidArgument, "bees.csv", "a velocity needs vx and"});
  expect_error(wish("time=2,"), {ErrorCode::kInvalidArgument, "bees.csv", "a comma at the end"});
  expect_error(wish("time=9"), {ErrorCode::kMissingColumn, "bees.csv:1", "there is no column 9"});
  expect_error(wish("time=when"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "there is no column named 'when'"});
  expect_error(wish("time=3,x=3,y=4,z=5"), {ErrorCode::kInvalidArgument, "bees.csv",
                                            "column 3 cannot be both position and time"});
  expect_error(wish("x=3"), {ErrorCode::kInvalidArgument, "bees.csv", "x needs y too"});
}

TEST(BadTrack, NumbersThatAreNone) {
  expect_error(with_row("a,oops,1,2,3"),
               {ErrorCode::kNotANumber, "bees.csv:3:2", "'oops' is not a number (time)"});
  expect_error(with_row("a,1,1,\"2,5\",3"),
               {ErrorCode::kNotANumber, "bees.csv:3:4", "decimals with a point"});
  expect_error(with_row("a,nan,1,2,3"),
               {ErrorCode::kNotFinite, "bees.csv:3:2", "'nan' is no time"});
  expect_error(with_row("a,1,-inf,2,3"),
               {ErrorCode::kNotFinite, "bees.csv:3:3", "'-inf' is no position (x)"});
  EXPECT_EQ(with_row("a,1,-inf,2,3").error().location.record, 1u);
}

TEST(BadTrack, NumbersThatCannotBeComputedWithExactly) {
  expect_error(with_row("a,1e31,1,2,3"), {ErrorCode::kOutsideDomain, "bees.csv:3:2",
                                          "cannot be computed with exactly (time)"});
  expect_error(with_row("a,1,1,2e31,3"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:4", "use 0, or a size of 7.9e-31 to"});
  expect_error(with_row("a,1,1e999,2,3"),
               {ErrorCode::kNotFinite, "bees.csv:3:3", "too large for a number"});
  expect_error(with_row("a,1,1e-999,2,3"),
               {ErrorCode::kOutsideDomain, "bees.csv:3:3", "too small for a number"});
}

// A flight that comes to rest: what fades away to less than motion can be computed with is zero.
TEST(BadTrack, NumbersThatAreTooSmallCountAsZero) {
  const auto read =
      record("id,time_s,x,y,z,vx,vy,vz\na,-1e-40,-9.8e-32,1e-31,3,-9.8e-32,1,1e-300\n");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  const Fix& fix = read->bees.at(0).fixes.at(0);
  EXPECT_EQ(fix.time_s, 0.0);
  EXPECT_EQ(fix.position, (Point{0.0, 0.0, 3.0}));
}

TEST(BadTrack, VelocitiesThatAreNone) {
  const std::string header = "id,time_s,x,y,z,vx,vy,vz\n";
  expect_error(record(header + "a,0,1,2,3,4,fast,6\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:7", "'fast' is not a number (velocity)"});
  expect_error(record(header + "a,0,1,2,3,4,1e40,6\n"),
               {ErrorCode::kOutsideDomain, "bees.csv:2:7", "exactly (velocity)"});
}

TEST(BadTrack, PositionsBeyondTheEarth) {
  const std::string header = "id,time_s,lon,lat,alt\n";
  expect_error(record(header + "a,0,361,0,0\n"),
               {ErrorCode::kInvalidLongitude, "bees.csv:2:3", "longitude 361 is beyond 360"});
  expect_error(record(header + "a,0,0,91,0\n"),
               {ErrorCode::kInvalidLatitude, "bees.csv:2:4", "latitude 91 is beyond 90"});
  expect_error(record(header + "a,0,0,0,2000000\n"),
               {ErrorCode::kInvalidHeight, "bees.csv:2:5", "no height of a bee"});
}

TEST(BadTrack, HeightsInFeetAreNotTakenForMetres) {
  expect_error(record("id,time_s,lon [rad],lat [rad],alt_ft\na,0,1,2,3\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:1:3", "is in 'rad'"});
}

TEST(BadTrack, DatesThatAreNone) {
  const std::string text = "id,time,x,y,z\na,2024-05-01T12:00:00Z,1,2,3\n";
  expect_error(record(text + "a,2024-05-01T12:00:61Z,1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:3:2",
                "'2024-05-01T12:00:61Z' is not a time: there is no such time of day"});
  expect_error(record(text + "a,yesterday,1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:3:2", "write it as 2024-05-01T12:00:00.25Z"});
  expect_error(record(text + "a,,1,2,3\n"), {ErrorCode::kNotANumber, "bees.csv:3:2", "no"});
  // Beside those that have a zone.
  expect_error(record(text + "a,2024-05-01 12:00:00,1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:3:2", "it has no time zone; write Z for UTC"});
  expect_error(record("id,time,x,y,z\na,2024-05-01 12:00:00,1,2,3\na,2024-05-01 12:00:01Z,1,2,3\n"),
               {ErrorCode::kNotANumber, "bees.csv:3:2", "but the first times have none"});
}

TEST(BadTrack, OneBeeAtTwoPlacesAtATime) {
  expect_error(
      record("id,time_s,x,y,z\na,0,1,2,3\nb,0,1,2,4\nb,1.5,1,2,3\na,0,1,2,9\nb,1.5,0,0,0\n"),
      {ErrorCode::kTimeOrder, "bees.csv:5",
       "bee 'a' is at another place at the same time, 0 s, in bees.csv, line 2; correct "
       "one of them, or name the column that tells the bees apart with --columns id="});
}

TEST(BadTrack, OneBeeTwiceInASnapshot) {
  expect_error(record("id,x,y,z,vx,vy,vz\na,1,2,3,4,5,6\na,7,8,9,1,1,1\n"),
               {ErrorCode::kTimeOrder, "bees.csv:3",
                "bee 'a' comes twice, before in bees.csv, line 2; without a time"});
}

TEST(BadTrack, RecordsOfAnotherShape) {
  expect_error(with_row("a,1,1,2"),
               {ErrorCode::kColumnCount, "bees.csv:3", "4 columns where the header has 5"});
  expect_error(with_row(",1,1,2,3"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:1", "the id is empty"});
  // Several whose names are not known are not one.
  for (const std::string_view row : {"NA,1,1,2,3", "n/a,1,1,2,3", "NaN,1,1,2,3"}) {
    expect_error(with_row(row), {ErrorCode::kMalformedRecord, "bees.csv:3:1", "it is not known"});
  }
  EXPECT_TRUE(with_row("Nana,1,1,2,3"));
  expect_error(with_row("\"a,1,1,2,3"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:1", "never closed on this line"});
  expect_error(with_row("# a,1,1,2,3"),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "a comment, or a record?"});
  for (const std::string_view row :
       {"#a,1,1,2", "#1,1,1,2,3,", "#b;1;2;3", "#b\t1", "# 7, again"}) {
    expect_error(with_row(row),
                 {ErrorCode::kMalformedRecord, "bees.csv:3", "a comment, or a record?"});
  }
  for (const std::string_view row : {"# a comment", "# a comment, too", "# 3 bees at 4 Hz", "#"}) {
    EXPECT_TRUE(with_row(row)) << row;
  }
  const auto without =
      recording_of(record("id,time_s,x,y,z\n#1,0,0,0\nq,0,0,0,0\n", skipping_bad()));
  EXPECT_EQ(without.missing.count, 1u);
  expect_error(with_row(std::string_view("a,1,1,\0,3", 10)),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "NUL"});
}

TEST(BadTrack, ALineTooLongForARecord) {
  expect_error(with_row("a," + std::string(2'000'000, '1') + ",1,2,3"),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "is too long for a record"});
}

TEST(BadTrack, NoTextAtAll) {
  expect_error(record("[1, 2]"), {ErrorCode::kUnsupportedFormat, "bees.csv", "this is JSON"});
  expect_error(record("%PDF-1.4"), {ErrorCode::kUnsupportedFormat, "bees.csv", "a PDF document"});
  expect_error(record("\xFF\xFEi\0d\0"), {ErrorCode::kUnsupportedFormat, "bees.csv", "UTF-16"});
}

TEST(BadTrack, ValuesThatContradictBareNamesAreRefused) {
  expect_error(record("id,time_s,x,y\na,0,-75.54,6.31\na,1,-75.55,6.32\n"),
               {ErrorCode::kUnknownFrame, "bees.csv", "could as well be longitude and latitude"});
  RecordingOptions options;
  options.frame = Frame::kMetres;
  EXPECT_TRUE(record("id,time_s,x,y\na,0,-75.54,6.31\na,1,-75.55,6.32\n", options).has_value());
}

TEST(BadTrack, WhatTheValuesCannotTellIsRefusedWithItsLine) {
  std::string text = "id,time_s,gps_x,gps_y,gps_z\n";
  for (int i = 0; i < 20; ++i) text += "a," + std::to_string(i) + ",1.5,2.5,3\n";
  expect_error(record(text), {ErrorCode::kUnknownFrame, "bees.csv", "degrees or metres?"});
  expect_error(record(text + "a,20,1000,2.5,3\n"),
               {ErrorCode::kUnknownFrame, "bees.csv:22", "Nearly all records would fit degrees"});
}

TEST(BadTrack, WhereEveryRecordIsBadTheFirstIsShown) {
  expect_error(record("id,time_s,x,y,z\na,0,?,2,3\na,1,1,?,3\n", skipping_bad()),
               {ErrorCode::kNoPoints, "bees.csv", "all 2 records are bad; the first: '?' is not"});
  expect_error(record("id,time_s,x,y,z\na,0,?,2,3\n", skipping_bad()),
               {ErrorCode::kNoPoints, "bees.csv", "the only record is bad: '?' is not a number"});
}

TEST(BadTrack, AUnitInWhichTimesAreTensOfThousandsOfYearsAheadIsNotTheirs) {
  for (const char* const digits : {"1777629600000", "1777629600000000", "1777629600000000000"}) {
    const std::string text = std::string("timestamp,id,x,y,z\n") + digits + ",a,1,2,3\n";
    RecordingOptions options;
    options.time_unit = Unit::kSecond;
    const auto refused = record(text, options);
    ASSERT_FALSE(refused) << digits;
    EXPECT_NE(refused.error().message.find("seconds since 1970, as the size of its numbers tells, "
                                           "and not what --time-unit says"),
              std::string::npos)
        << refused.error().message;
  }
  // Of a clock that began lately.
  RecordingOptions options;
  options.time_unit = Unit::kMicrosecond;
  EXPECT_TRUE(record("timestamp,id,x,y,z\n1777629600,a,1,2,3\n", options));
}

}  // namespace
}  // namespace beespace::io
