// Dates of tables whose year comes last: one that can be read in one way alone tells the order of
// all; otherwise it is asked for.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kSevenOnThe27th_s = 1730012400.0;  // 2024-10-27T07:00:00Z

std::string with_header(const std::string& rows) {
  return "id;time;x_m;y_m\n" + rows;
}

RecordingOptions in_utc(DateOrder dates = DateOrder::kUnsaid) {
  RecordingOptions options;
  options.time_zone = TimeZone::utc();
  options.dates = dates;
  return options;
}

std::vector<double> first_times(const std::string& text, const RecordingOptions& options) {
  const Recording recording = recording_of(record(text, options));
  return recording.bees.empty() ? std::vector<double>() : times_of(recording.bees.front());
}

TEST(DateOrderOfTables, PointsStandBehindTheDay) {
  const std::string text =
      with_header("a;05.06.2024 07:00:00;1,5;2,5\na;05.06.2024 07:00:01;1,5;2,5\n");
  EXPECT_EQ(first_times(text, in_utc()), (std::vector<double>{1717570800.0, 1717570801.0}));
  EXPECT_TRUE(has_note(recording_of(record(text, in_utc())), "the day first (they have points)"));
}

TEST(DateOrderOfTables, OneDateTellsItOfAll) {
  EXPECT_EQ(
      first_times(with_header("a;05/06/2024 07:00:00;1;2\na;27/10/2024 07:00:00;1;2\n"), in_utc()),
      (std::vector<double>{1717570800.0, kSevenOnThe27th_s}));
  const std::string american =
      with_header("a;05/06/2024 7:00:00 AM;1;2\na;10/27/2024 7:00:00 AM;1;2\n");
  EXPECT_EQ(first_times(american, in_utc()),
            (std::vector<double>{1714978800.0, kSevenOnThe27th_s}));
  EXPECT_TRUE(has_note(recording_of(record(american, in_utc())),
                       "the month first (as '10/27/2024 7:00:00 AM' in line 3 tells)"));
}

TEST(DateOrderOfTables, WhereNoDateTellsItItIsAskedFor) {
  const std::string text = with_header("a;05/06/2024 07:00:00;1;2\na;06/06/2024 07:00:00;1;2\n");
  expect_error(record(text, in_utc()),
               {ErrorCode::kInvalidArgument, "bees.csv:2:2",
                "'05/06/2024 07:00:00': is the day first, or the month? No date here tells it; say "
                "it with --dates day-first or --dates month-first"});
  EXPECT_EQ(first_times(text, in_utc(DateOrder::kDayFirst))[0], 1717570800.0);
  EXPECT_EQ(first_times(text, in_utc(DateOrder::kMonthFirst))[0], 1714978800.0);
}

TEST(DateOrderOfTables, DatesThatContradictEachOtherAreNamedWithTheirLines) {
  const std::string text = with_header(
      "a;05/06/2024 07:00:00;1;2\na;27/10/2024 07:00:00;1;2\n"
      "a;10/28/2024 07:00:00;1;2\n");
  for (const bool skip_bad : {false, true}) {
    RecordingOptions options = in_utc();
    options.skip_bad = skip_bad;
    expect_error(record(text, options),
                 {ErrorCode::kInvalidArgument, "bees.csv:4:2",
                  "'10/28/2024 07:00:00' has the month first, but '27/10/2024 07:00:00' in line 3 "
                  "the day"});
  }
  // Whose order is said has bad records.
  RecordingOptions said = in_utc(DateOrder::kDayFirst);
  expect_error(record(text, said), {ErrorCode::kNotANumber, "bees.csv:4:2", "no such month"});
  said.skip_bad = true;
  EXPECT_EQ(first_times(text, said).size(), 2u);
}

TEST(DateOrderOfTables, TheDayMayHaveAColumnOfItsOwn) {
  for (const std::string header :
       {"id;Datum;Uhrzeit;x_m;y_m\n", "id;Fecha;Hora;x_m;y_m\n", "id;date;time;x_m;y_m\n"}) {
    EXPECT_EQ(
        first_times(header + "a;27.10.2024;07:00:00;1;2\na;27.10.2024;7:00:01;1;2\n", in_utc()),
        (std::vector<double>{kSevenOnThe27th_s, kSevenOnThe27th_s + 1.0}))
        << header;
    EXPECT_EQ(first_times(header + "a;27/10/2024;07:00;1;2\na;27/10/2024;07:01;1;2\n", in_utc()),
              (std::vector<double>{kSevenOnThe27th_s, kSevenOnThe27th_s + 60.0}))
        << header;
    expect_error(record(header + "a;05/06/2024;07:00;1;2\n", in_utc()),
                 {ErrorCode::kInvalidArgument, "bees.csv:2:2", "is the day first, or the month?"});
  }
}

TEST(DateOrderOfTables, ADateWithItsTimeIsTheTimeWhateverItIsCalled) {
  for (const std::string name :
       {"Datum", "date", "Fecha", "Date Time", "Date/Time", "UTC_datetime"}) {
    EXPECT_EQ(first_times("id;" + name + ";x_m;y_m\na;27.10.2024 07:00;1;2\n", in_utc()),
              std::vector<double>{kSevenOnThe27th_s})
        << name;
  }
}

// As loggers of Ornitela write them.
TEST(DateOrderOfTables, TimesOfDayBesideDatesWithTimesAreTheSameAgain) {
  const std::string text =
      "device_id,UTC_datetime,UTC_date,UTC_time,Latitude,Longitude\n"
      "171,2024-10-27 07:00:00,2024-10-27,07:00:00,47.7,9.17\n";
  const Recording recording = recording_of(record(text));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(times_of(recording.bees[0]), std::vector<double>{kSevenOnThe27th_s});
  EXPECT_TRUE(recording.since_1970);
  EXPECT_TRUE(has_note(recording, "are of UTC: the header says it"));
  const Recording newer =
      recording_of(record("device_id,UTC_datetime,UTC_date,UTC_time,Latitude,Longitude,"
                          "UTC_timestamp,milliseconds\n171,2024-10-27 07:00:00,2024-10-27,"
                          "07:00:00,47.7,9.17,2024-10-27 07:00:00.500,500\n"));
  ASSERT_EQ(newer.bees.size(), 1u);
  EXPECT_EQ(times_of(newer.bees[0]), std::vector<double>{kSevenOnThe27th_s + 0.5});
}

TEST(DateOrderOfTables, MinutesWithoutADateMayBeSecondsAndAreAskedFor) {
  expect_error(record("id;time;x_m;y_m\na;07:30;1;2\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:2",
                "'07:30' is not a time: without a date it may be hours and minutes, or minutes and "
                "seconds"});
  EXPECT_TRUE(has_note(recording_of(record(with_header("a;27.10.2024 07:30;1;2\n"), in_utc())),
                       "without seconds, which are taken for 0"));
}

}  // namespace
}  // namespace beespace::io
