// Times are told in UTC, in the zone that was named, or as they stand in the file: then never as
// UTC.
#include "report/calendar_words.hpp"

#include "report/clock_offsets.hpp"
#include "report/figure/calendar_axis.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace beespace::report {
namespace {

constexpr double kHour_s = 3'600.0;
constexpr double kNewDay_s = 86'400.0;
constexpr std::int64_t kMay1_s = 1'714'521'600;  // 2024-05-01 00:00
// Clocks in Berlin are set back, from 03:00 to 02:00.
constexpr double kSetBack_s = 1'729'990'800.0;  // 2024-10-27T01:00:00Z

io::Calendar in(const char* zone) {
  auto found = io::TimeZone::find(zone);
  EXPECT_TRUE(found.has_value());
  return {true, *found, {}};
}

io::Calendar utc() {
  return {true, {}, {}};
}

io::Calendar unnamed(bool dated) {
  return {false, {}, io::WallClock{dated, dated ? kMay1_s : 0}};
}

std::vector<std::string> labels_of(const std::vector<Tick>& ticks) {
  std::vector<std::string> labels;
  labels.reserve(ticks.size());
  for (const Tick& tick : ticks) labels.push_back(tick.label);
  return labels;
}

TEST(CalendarWords, InUtcWhereNothingElseIsSaid) {
  EXPECT_EQ(date_time_label(kMay1_s + 1.5, utc()), "2024-05-01T00:00:01.5Z");
  EXPECT_EQ(short_moment_label(kMay1_s + 1.4, utc(), true), "05-01 00:00:01");
  // A rounding of instants since 1970 below, which is no second earlier.
  EXPECT_EQ(short_moment_label(kMay1_s + 1.9999999, utc(), true), "05-01 00:00:02");
  EXPECT_EQ(short_moment_label(kMay1_s - 1e-6, utc(), true), "05-01 00:00:00");
  EXPECT_EQ(date_time_label(1.5, {}), "");
  EXPECT_EQ(short_moment_label(1.5, {}, true), "");
  EXPECT_EQ(date_time_label(kMay1_s, in("UTC")), "2024-05-01T00:00:00Z");
}

TEST(CalendarWords, OfAZoneTheLocalTimeWithItsOffset) {
  const io::Calendar berlin = in("Europe/Berlin");
  EXPECT_EQ(date_time_label(kMay1_s, berlin), "2024-05-01T02:00:00+02:00");
  EXPECT_EQ(short_moment_label(kSetBack_s - 1.0, berlin, false), "02:59:59+02:00");
  EXPECT_EQ(short_moment_label(kSetBack_s, berlin, true), "10-27 02:00:00+01:00");
  EXPECT_EQ(short_moment_label(kMay1_s, in("-03:30"), true), "04-30 20:30:00-03:30");
}

TEST(CalendarWords, WhatNamesNoZoneIsToldAsItStandsInTheFile) {
  EXPECT_EQ(date_time_label(9.0 * kHour_s, unnamed(true)), "2024-05-01 09:00:00");
  EXPECT_EQ(short_moment_label(33.0 * kHour_s, unnamed(true), true), "05-02 09:00:00");
  EXPECT_EQ(date_time_label(9.0 * kHour_s + 0.25, unnamed(false)), "09:00:00.25");
  EXPECT_EQ(short_moment_label(9.0 * kHour_s, unnamed(false), true), "09:00:00");
}

TEST(ClockOffsets, TellWhenTheClockIsTurned) {
  const auto offsets = clock_offsets(
      in("Europe/Berlin"), {kSetBack_s - 100.0 * kNewDay_s, kSetBack_s + 200.25 * kNewDay_s});
  ASSERT_EQ(offsets.size(), 3u);
  EXPECT_EQ(offsets[0].ahead_s, 2.0 * kHour_s);
  EXPECT_EQ(offsets[1].from_s, kSetBack_s);
  EXPECT_EQ(offsets[1].ahead_s, kHour_s);
  EXPECT_EQ(offsets[2].from_s, 1'743'296'400.0);  // 2025-03-30T01:00:00Z
  EXPECT_EQ(offsets[2].ahead_s, 2.0 * kHour_s);
  EXPECT_EQ(clock_offsets(utc(), {0.0, 1e9}).size(), 1u);
  const auto file = clock_offsets(unnamed(true), {kHour_s, 2.0 * kHour_s});
  ASSERT_EQ(file.size(), 1u);
  EXPECT_EQ(file.front().ahead_s, static_cast<double>(kMay1_s));
  // Within a recording shorter than a second, and just behind its end.
  EXPECT_EQ(clock_offsets(in("Europe/Berlin"), {kSetBack_s - 0.5, kSetBack_s + 0.25}).size(), 2u);
  EXPECT_EQ(clock_offsets(in("Europe/Berlin"), {kSetBack_s - 0.5, kSetBack_s - 0.25}).size(), 1u);
}

TEST(CalendarAxis, HasWholeHoursOfTheClock) {
  const Range hours{kSetBack_s - 2.0 * kHour_s, kSetBack_s + 2.0 * kHour_s};
  const auto ticks = calendar_ticks(hours, 5, in("Europe/Berlin"));
  EXPECT_EQ(labels_of(ticks),
            (std::vector<std::string>{"01:00", "02:00", "02:00", "03:00", "04:00"}));
  EXPECT_EQ(calendar_title(hours, in("Europe/Berlin")), "Time (Europe/Berlin, from 2024-10-27)");
  EXPECT_EQ(labels_of(calendar_ticks({kMay1_s - 0.5, kMay1_s + 4.0 * kHour_s}, 5, in("+05:30"))),
            (std::vector<std::string>{"06:00", "07:00", "08:00", "09:00"}));
}

TEST(CalendarAxis, HasDaysOfTheClockBeforeAndBehindItsTurn) {
  const Range days{kSetBack_s - 2.0 * kNewDay_s, kSetBack_s + 2.0 * kNewDay_s};
  const auto ticks = calendar_ticks(days, 4, in("Europe/Berlin"));
  EXPECT_EQ(labels_of(ticks), (std::vector<std::string>{"10-26", "10-27", "10-28", "10-29"}));
  ASSERT_EQ(ticks.size(), 4u);
  EXPECT_EQ(ticks[1].value, kSetBack_s - 3.0 * kHour_s);   // 00:00+02:00
  EXPECT_EQ(ticks[2].value, kSetBack_s + 22.0 * kHour_s);  // 00:00+01:00
}

TEST(CalendarAxis, SaysInWhichTimeItIs) {
  const Range hour{kMay1_s + 1.0, kMay1_s + kHour_s};
  EXPECT_EQ(calendar_title(hour, utc()), "Time (UTC, from 2024-05-01)");
  EXPECT_EQ(calendar_title(hour, in("Europe/Berlin")),
            "Time (Europe/Berlin, +02:00, from 2024-05-01)");
  EXPECT_EQ(calendar_title(hour, in("+02:00")), "Time (+02:00, from 2024-05-01)");
  EXPECT_EQ(calendar_title({0.0, kHour_s}, unnamed(true)),
            "Time (as in the file, from 2024-05-01)");
  EXPECT_EQ(calendar_title({0.0, kHour_s}, unnamed(false)), "Time (as in the file)");
  EXPECT_EQ(labels_of(calendar_ticks({23.0 * kHour_s, 25.0 * kHour_s}, 3, unnamed(true))),
            (std::vector<std::string>{"23:00", "05-02", "01:00"}));
  EXPECT_EQ(labels_of(calendar_ticks({23.0 * kHour_s, 25.0 * kHour_s}, 3, unnamed(false))),
            (std::vector<std::string>{"23:00", "00:00", "01:00"}));
}

}  // namespace
}  // namespace beespace::report
