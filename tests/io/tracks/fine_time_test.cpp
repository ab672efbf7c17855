// Columns of times: two of one time, the finer one; by their zone's name; days as Excel has them.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

// As Airdata exports flights: 10 records a second, 0.3 s after a full one.
std::string flight(int records, int step_ms = 100, int drift_ms = 0) {
  std::string text = "time(millisecond),datetime(utc),x_m,y_m\n";
  for (int k = 0; k < records; ++k) {
    const int second = (300 + k * (step_ms + drift_ms)) / 1000;
    text += std::to_string(k * step_ms) + ",2023-05-01 12:00:" + (second < 10 ? "0" : "") +
            std::to_string(second) + "," + std::to_string(k) + ",0\n";
  }
  return text;
}

constexpr double kNoon_s = 1682942400.0;  // 2023-05-01T12:00:00Z

TEST(FineTime, OfMillisecondsBesideDatesIsTaken) {
  const Recording recording = recording_of(record(flight(30)));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_TRUE(recording.since_1970);
  const std::vector<double> times = times_of(recording.bees[0]);
  ASSERT_EQ(times.size(), 30u);
  EXPECT_NEAR(times.front(), kNoon_s + 0.3, 1e-6);
  EXPECT_NEAR(times.back(), kNoon_s + 3.2, 1e-6);
  EXPECT_TRUE(has_note(recording,
                       "times are read from column 1 'time(millisecond)' in milliseconds "
                       "from the "
                       "moment on that column 2 'datetime(utc)' tells to the second"));
  const auto said = record(flight(30), columns_are("time=2", Unit::kUnstated));
  EXPECT_EQ(recording_of(said).bees.at(0).fixes.size(), 30u);
}

TEST(FineTime, ThatDoesNotGoOnAsTheDatesDoIsAskedAbout) {
  for (const std::string& text : {flight(30, 100, 90), flight(3)}) {
    expect_error(record(text), {ErrorCode::kMissingColumn, "bees.csv:1",
                                "both column 1 'time(millisecond)' and column 2 'datetime(utc)' "
                                "look like the time"});
  }
}

// ---- Names --------------------------------------------------------------------------------------

std::string dated(const std::string& name) {
  return "id," + name + ",x_m,y_m\na,2024-05-01 12:00:00,1,2\na,2024-05-01 12:00:01,2,2\n";
}

TEST(TimesByTheirZone, AreTimesInUtc) {
  for (const std::string name : {"utc", "UTC", "gmt", "GMT", "utc_time", "GMT Time"}) {
    const Recording recording = recording_of(record(dated(name)));
    EXPECT_TRUE(recording.since_1970) << name;
    EXPECT_EQ(times_of(recording.bees.at(0)).front(), 1714564800.0) << name;
  }
}

TEST(TimesByTheirZone, OfTheClocksOfAPlaceAskForTheZone) {
  for (const std::string name :
       {"local_time", "Local Time", "localtime", "LMT", "local_datetime"}) {
    expect_error(record(dated(name)),
                 {ErrorCode::kInvalidArgument, "bees.csv:1:2",
                  "is of the clocks of a place, but of which? Say it with --time-zone, as in "
                  "--time-zone Europe/Madrid"});
    RecordingOptions options;
    options.time_zone = TimeZone::utc();
    EXPECT_TRUE(recording_of(record(dated(name), options)).since_1970) << name;
  }
  // Times of day alone are of one clock.
  EXPECT_TRUE(record("id,local_time,x_m,y_m\na,12:00:00,1,2\na,12:00:01,2,2\n"));
}

TEST(TimesByTheirZone, AreTakenWhereNoOtherColumnIsTheTime) {
  const std::string rows =
      "a,2024-05-01 12:00:00,2024-05-01 14:00:00,1,2\na,2024-05-01 12:00:01,2024-05-01 "
      "14:00:01,2,2\n";
  for (const std::string names :
       {"utc,local_time", "utc_time,LMT", "timestamp,utc", "timestamp,local_time"}) {
    const Recording recording =
        recording_of(record("id," + names + ",x_m,y_m\n" + rows, columns_are("", Unit::kUnstated)));
    EXPECT_TRUE(has_note(recording, "times are read from column 2 ")) << names;
  }
}

// ---- Excel --------------------------------------------------------------------------------------

TEST(DaysOfExcel, AreAskedAboutAndNotTakenForSeconds) {
  for (const std::string name : {"time", "timestamp", "Date/Time", "utc", "date"}) {
    const auto loaded = record("id," + name + ",x_m,y_m\na,44927.5,1,2\na,44927.500694,2,2\n");
    ASSERT_FALSE(loaded) << name;
    EXPECT_NE(loaded.error().message.find("if these are days as Excel counts them"),
              std::string::npos)
        << name << ": " << loaded.error().message;
  }
  const auto seconds = record("id,time,x_m,y_m\na,0.5,1,2\na,1.5,2,2\n");
  ASSERT_FALSE(seconds);
  EXPECT_EQ(seconds.error().message.find("Excel"), std::string::npos);
}

}  // namespace
}  // namespace beespace::io
