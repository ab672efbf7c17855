#include "io/units/time_zone.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "io/units/iso_time.hpp"

namespace beespace::io {
namespace {

// What a clock shows, as seconds.
std::int64_t shown(std::string_view text) {
  WallTime time;
  EXPECT_EQ(parse_wall_time(text, time), "") << text;
  return time.seconds;
}

std::int64_t offset_of(const TimeZone& zone, std::string_view text) {
  std::int64_t offset_s = -1;
  EXPECT_EQ(zone.offset_of_local(shown(text), offset_s), "") << text;
  return offset_s;
}

std::string problem_of(const TimeZone& zone, std::string_view text) {
  std::int64_t offset_s = 0;
  return zone.offset_of_local(shown(text), offset_s);
}

TimeZone zone_of(std::string_view name) {
  auto zone = TimeZone::find(name);
  EXPECT_TRUE(zone) << name << ": " << zone.error().message;
  return zone ? *zone : TimeZone::utc();
}

// In 2015 Spain turned its clocks forward on the 29th of March and back on the 25th of October, at
// 01:00 UTC (Directive 2000/84/EC).
TEST(TimeZones, ClocksAreTurned) {
  const TimeZone madrid = zone_of("Europe/Madrid");
  EXPECT_EQ(offset_of(madrid, "2015-03-29 01:59:59"), 3600);
  EXPECT_EQ(offset_of(madrid, "2015-03-29 03:00:00"), 7200);
  EXPECT_EQ(offset_of(madrid, "2015-10-25 01:59:59"), 7200);
  EXPECT_EQ(offset_of(madrid, "2015-10-25 03:00:00"), 3600);
  EXPECT_EQ(madrid.offset_at(shown("2015-10-25 00:59:59")), 7200);
  EXPECT_EQ(madrid.offset_at(shown("2015-10-25 01:00:00")), 3600);
}

TEST(TimeZones, WhatClocksShowTwiceOrNeverIsSaid) {
  const TimeZone madrid = zone_of("Europe/Madrid");
  for (const char* const text : {"2015-10-25 02:00:00", "2015-10-25 02:59:59"}) {
    EXPECT_NE(problem_of(madrid, text).find("show it twice"), std::string::npos) << text;
  }
  for (const char* const text : {"2015-03-29 02:00:00", "2015-03-29 02:59:59"}) {
    EXPECT_NE(problem_of(madrid, text).find("never show it"), std::string::npos) << text;
  }
}

// Zone data list changes up to 2037 at most; then a rule says them.
TEST(TimeZones, ARuleGoesOnBehindTheListedChanges) {
  const TimeZone madrid = zone_of("Europe/Madrid");
  EXPECT_EQ(offset_of(madrid, "2045-07-01 12:00:00"), 7200);
  EXPECT_EQ(offset_of(madrid, "2045-12-01 12:00:00"), 3600);
  EXPECT_EQ(offset_of(zone_of("Australia/Sydney"), "2145-12-01 12:00:00"), 39600);
  EXPECT_EQ(offset_of(madrid, "2036-07-01 12:00:00"), 7200);
  EXPECT_EQ(offset_of(zone_of("Asia/Kolkata"), "2045-07-01 12:00:00"), 19800);
}

TEST(TimeZones, OffsetsAndUtcNeverChange) {
  EXPECT_EQ(offset_of(TimeZone::utc(), "2015-10-25 02:30:00"), 0);
  EXPECT_EQ(offset_of(zone_of("+02:00"), "2015-10-25 02:30:00"), 7200);
  EXPECT_EQ(offset_of(zone_of("-0330"), "2015-10-25 02:30:00"), -12600);
  EXPECT_EQ(zone_of("-0330").name(), "-03:30");
  EXPECT_EQ(zone_of("Z").name(), "UTC");
}

TEST(TimeZones, OthersAreRefused) {
  for (const char* const name : {"", "Europe", "Europe/Nowhere", "+2", "+25:00", "../zoneinfo",
                                 "/etc/localtime", "Madrid", "local"}) {
    EXPECT_FALSE(TimeZone::find(name)) << name;
  }
}

TEST(TimeZones, OffsetsHaveATextThatIsReadAgain) {
  EXPECT_EQ(offset_text(0), "Z");
  EXPECT_EQ(offset_text(7200), "+02:00");
  EXPECT_EQ(offset_text(-12600), "-03:30");
  EXPECT_EQ(offset_text(-884), "-00:14:44");  // Madrid before 1901
}

}  // namespace
}  // namespace beespace::io
