// Times of clocks that are set back at night, and of several clocks.
#include "tests/io/tracks/recording_loading.hpp"

#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

RecordingOptions in_berlin() {
  RecordingOptions options;
  options.time_zone = TimeZone::find("Europe/Berlin").value();
  return options;
}

// Of one bee in the night in which 02:00 to 03:00 comes twice.
std::string night(const std::vector<std::string>& times) {
  std::string text = "id,timestamp,lon,lat\n";
  int count = 0;
  for (const std::string& time : times) {
    text += "a,2023-10-29 " + time + ":00,10." + std::to_string(100 + count++) + ",46\n";
  }
  return text;
}

std::vector<double> steps_of(const Recording& recording) {
  std::vector<double> steps;
  const std::vector<double> times_s = times_of(recording.bees.at(0));
  for (std::size_t i = 1; i < times_s.size(); ++i) steps.push_back(times_s[i] - times_s[i - 1]);
  return steps;
}

TEST(TurnedClocks, TheOrderOfTheRecordsTellsWhichOfTwoTimesIsMeant) {
  const Recording half_hours = recording_of(
      record(night({"01:00", "01:30", "02:00", "02:30", "02:00", "02:30", "03:00", "03:30"}),
             in_berlin()));
  EXPECT_EQ(steps_of(half_hours), std::vector<double>(7, 1800.0));
  const Recording hours =
      recording_of(record(night({"00:00", "01:00", "02:00", "02:00", "03:00"}), in_berlin()));
  EXPECT_EQ(steps_of(hours), std::vector<double>(4, 3600.0));
}

TEST(TurnedClocks, WhereItDoesNotTheyAreRefused) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> unclear = {
      {{"01:00", "01:30", "02:00", "02:30", "03:00"}, "bees.csv:4:2"},           // once
      {{"01:00", "01:30", "02:00"}, "bees.csv:4:2"},                             // the end
      {{"02:00", "02:00", "03:00"}, "bees.csv:3:2"},                             // no known pace
      {{"01:45", "02:00", "02:15", "02:00", "02:15", "03:00"}, "bees.csv:5:2"},  // another pace
      {{"01:45", "02:00", "02:00", "02:15", "02:15", "03:00"}, "bees.csv:4:2"},  // by the clock
  };
  for (const auto& [times, place] : unclear) {
    const auto read = record(night(times), in_berlin());
    expect_error(read, {ErrorCode::kNotANumber, place, "show it twice"});
    EXPECT_NE(to_string(read.error()).find("--skip-bad"), std::string::npos);
  }
  RecordingOptions skipping = in_berlin();
  skipping.skip_bad = true;
  EXPECT_EQ(recording_of(record(night(unclear[0].first), skipping)).bees.at(0).fixes.size(), 3u);
}

TEST(TurnedClocks, EachBeeIsJudgedByItself) {
  std::string both = night({"01:00", "01:30", "02:00", "02:30", "02:00", "02:30", "03:00"});
  both += "b,2023-10-29 02:30:00,10,46\n";
  expect_error(record(both, in_berlin()),
               {ErrorCode::kNotANumber, "bees.csv:9:2", "show it twice"});
}

// The fault that this is about: the zones beside the times were passed over, as if all were of one
// clock.
TEST(ClockZones, SeveralAreRefused) {
  for (const char* const name : {"timezone", "tz", "study-timezone", "Time Zone", "UTC_offset"}) {
    const std::string text = "id,timestamp,lon,lat," + std::string(name) +
                             "\na,2023-06-01 12:00:00,10,46,Europe/Madrid\n"
                             "b,2023-06-01 12:00:00,10,46.1,Europe/London\n";
    expect_error(record(text), {ErrorCode::kInvalidArgument, "bees.csv:3:5",
                                "this time is of zone 'Europe/London', but those before are of "
                                "'Europe/Madrid': they are not of one clock"});
    EXPECT_EQ(recording_of(record(text, in_berlin())).bees.size(), 2u) << "who says it knows it";
  }
}

TEST(ClockZones, OfSeveralFilesToo) {
  const TemporaryFolder folder;
  const std::string header = "timestamp,lon,lat,timezone\n";
  const auto one = folder.write("one.csv", header + "2023-06-01 12:00:00,10,46,Europe/Madrid\n");
  const auto two = folder.write("two.csv", header + "2023-06-01 12:00:00,10,46,Europe/London\n");
  const auto both = load_recording({one, two});
  ASSERT_FALSE(both.has_value());
  const std::string text = to_string(both.error());
  EXPECT_NE(text.find("two.csv:2:4: "), std::string::npos) << text;
  EXPECT_NE(text.find("not of one clock"), std::string::npos) << text;
}

TEST(ClockZones, OneOrOfInstantsSaysNothing) {
  EXPECT_TRUE(recording_of(record("id,timestamp,lon,lat,timezone\n"
                                  "a,2023-06-01 12:00:00,10,46,CEST\n"
                                  "b,2023-06-01 12:00:00,10,46.1,CEST\n"))
                  .missing.none());
  EXPECT_TRUE(recording_of(record("id,timestamp,lon,lat,timezone\n"
                                  "a,2023-06-01T12:00:00Z,10,46,CEST\n"
                                  "b,2023-06-01T12:00:00Z,10,46.1,BST\n"))
                  .since_1970);
}

// Beside the time in UTC that tables of Movebank have.
TEST(ClockZones, LocalTimesOfMovebankAreNotInUtc) {
  RecordingOptions options = columns_are("time=4", Unit::kUnstated);
  const std::string text =
      "individual-local-identifier,timestamp,study-timezone,study-local-timestamp,location-long,"
      "location-lat\n"
      "a,2023-06-01 10:00:00,Europe/Madrid,2023-06-01 12:00:00,10,46\n"
      "b,2023-06-01 11:00:00,Europe/London,2023-06-01 12:00:00,10,46.1\n";
  expect_error(record(text, options),
               {ErrorCode::kInvalidArgument, "bees.csv:3:3", "not of one clock"});
  EXPECT_TRUE(recording_of(record(text)).since_1970);
}

// Of several files, some of which are of the clocks of a place.
TEST(ClockZones, WhatIsInUtcStaysSoWhicheverZoneOthersAreOf) {
  RecordingOptions madrid;
  madrid.time_zone = TimeZone::find("Europe/Madrid").value();
  const std::vector<std::string> tables = {
      "timestamp,location-long,location-lat,individual-local-identifier\n"
      "2023-06-01 10:00:00,10,46,a\n",
      "id,utc_time,lon,lat\na,2023-06-01 10:00:00,10,46\n",
      "id,Date & Time [GMT],lon,lat\na,2023-06-01 10:00:00,10,46\n",
      "id,UTC_Date,UTC_Time,lon,lat\na,2023-06-01,10:00:00,10,46\n"};
  for (const std::string& table : tables) {
    EXPECT_EQ(recording_of(record(table, madrid)).bees[0].fixes[0].time_s, 1'685'613'600.0)
        << table;
  }
  EXPECT_EQ(recording_of(record("id,datetime,lon,lat\na,2023-06-01 10:00:00,10,46\n", madrid))
                .bees[0]
                .fixes[0]
                .time_s,
            1'685'606'400.0);
}

}  // namespace
}  // namespace beespace::io
