#include "io/units/iso_time.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

constexpr double kBad = std::numeric_limits<double>::infinity();

double seconds_of(std::string_view text) {
  double seconds = kBad;
  const std::string_view problem = parse_iso_time(text, seconds);
  EXPECT_EQ(problem, "") << text;
  return problem.empty() ? seconds : kBad;
}

std::string problem_of(std::string_view text) {
  double seconds = 0.0;
  return std::string(parse_iso_time(text, seconds));
}

TEST(IsoTime, CountsSecondsSince1970) {
  EXPECT_EQ(seconds_of("1970-01-01T00:00:00Z"), 0.0);
  EXPECT_EQ(seconds_of("1970-01-02T00:00:01Z"), 86401.0);
  EXPECT_EQ(seconds_of("2000-02-29T12:34:56Z"), 951827696.0);
  EXPECT_EQ(seconds_of("2024-05-01T12:00:00Z"), 1714564800.0);
  EXPECT_EQ(seconds_of("2038-01-19T03:14:08Z"), 2147483648.0);
}

TEST(IsoTime, CountsBackwardsBefore1970) {
  EXPECT_EQ(seconds_of("1969-12-31T23:59:59Z"), -1.0);
  EXPECT_EQ(seconds_of("1969-12-31T23:59:59.75Z"), -0.25);
  EXPECT_EQ(seconds_of("1969-12-31T23:59:58.75Z"), -1.25);
  EXPECT_EQ(seconds_of("0001-01-01T00:00:00Z"), -62135596800.0);
}

TEST(IsoTime, FractionsAreTheNearestDouble) {
  EXPECT_EQ(seconds_of("2024-05-01T12:00:00.25Z"), 1714564800.25);
  EXPECT_EQ(seconds_of("2024-05-01T12:00:00,25Z"), 1714564800.25);
  EXPECT_EQ(seconds_of("2024-05-01T12:00:00.123456Z"), 1714564800.123456);
  EXPECT_EQ(seconds_of("2024-05-01T12:00:00.123456789Z"), 1714564800.123456789);
  EXPECT_EQ(seconds_of("2024-05-01T12:00:00.1234567891234567Z"), 1714564800.123456789);
  EXPECT_EQ(seconds_of("1970-01-01T00:00:00.1Z"), 0.1);
}

TEST(IsoTime, OffsetsAreEastOfGreenwich) {
  EXPECT_EQ(seconds_of("2024-05-01T14:00:00+02:00"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01T14:00:00+0200"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01T14:00:00+02"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01T06:30:00-05:30"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01t12:00:00z"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01 12:00:00Z"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01 12:00:00 UTC"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01 12:00:00.000 GMT"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01 14:00:00 +02:00"), 1714564800.0);
}

TEST(IsoTime, AMissingZoneIsNotGuessed) {
  EXPECT_NE(problem_of("2024-05-01T12:00:00").find("no time zone"), std::string::npos);
  EXPECT_NE(problem_of("2024-05-01T12:00:00.5").find("no time zone"), std::string::npos);
}

TEST(IsoTime, WhatDoesNotExistIsRefused) {
  EXPECT_NE(problem_of("2023-02-29T12:00:00Z").find("no such day"), std::string::npos);
  EXPECT_NE(problem_of("2023-13-01T12:00:00Z").find("no such day"), std::string::npos);
  EXPECT_NE(problem_of("2023-01-01T24:00:00Z").find("no such time of day"), std::string::npos);
  EXPECT_NE(problem_of("2023-01-01T12:60:00Z").find("no such time of day"), std::string::npos);
  EXPECT_NE(problem_of("2016-12-31T23:59:60Z").find("leap seconds"), std::string::npos);
  EXPECT_NE(problem_of("2023-01-01T12:00:00+25:00").find("no such offset"), std::string::npos);
}

TEST(IsoTime, OtherFormsAreRefusedAndTheRightOneIsShown) {
  for (const std::string_view text :
       {"", "2024", "2024-05", "20240501T120000Z", "2024-5-1T12:00:00Z", "2024-05-01X12:00:00Z",
        "2024-05-01T12Z", "2024-05-01T12:00:00.Z", "2024-05-01T12:00:00Zulu",
        "2024-05-01T12:00:00+2", "2024-05-01T12:00:00+02:0", "2024-05-01T-1:00:00Z",
        "2024-05-01T12:00:00 UTC+2", "2024-05-01T12:00:00 CET"}) {
    EXPECT_NE(problem_of(text).find("write it as 2024-05-01T12:00:00.25Z"), std::string::npos)
        << text;
  }
  EXPECT_NE(problem_of("2024-05-01").find("a day without a time"), std::string::npos);
}

TEST(IsoTime, SlashesMayStandBetweenYearMonthAndDay) {
  EXPECT_EQ(seconds_of("2024/05/01 12:00:00Z"), 1714564800.0);
  EXPECT_NE(problem_of("2024/05-01 12:00:00Z").find("write it as"), std::string::npos);
  EXPECT_TRUE(looks_like_iso_time("2024/05/01 12:00:00"));
}

// 10.09.2015 is a day in September, or one in October.
TEST(IsoTime, WhereTheYearIsLastDayAndMonthAreNotGuessed) {
  for (const std::string_view text : {"10.09.2015 07:00:00", "9/10/2015 07:00:00Z", "10-9-15"}) {
    EXPECT_TRUE(looks_like_other_date(text)) << text;
    EXPECT_NE(problem_of(text).find("which of its numbers is the day and which the month"),
              std::string::npos)
        << text;
  }
  EXPECT_TRUE(looks_like_other_date("2015.09.10"));
  for (const std::string_view text :
       {"", "1.5", "10.09", "10.09/2015", "123.4.5", "1.2.345", "-1"}) {
    EXPECT_FALSE(looks_like_other_date(text)) << text;
  }
}

double seconds_by(DateOrder order, std::string_view text) {
  WallTime time;
  const std::string_view problem = parse_wall_time(text, time, order);
  EXPECT_EQ(problem, "") << text;
  return problem.empty() ? seconds_after(time, 0) : kBad;
}

// 27 October 2024 at seven.
TEST(IsoTime, WhereTheOrderIsKnownTheYearMayBeLast) {
  for (const std::string_view text :
       {"27.10.2024 07:00:00", "27/10/2024 07:00:00", "27-10-2024 7:00:00", "27.10.2024, 07:00",
        "27/10/2024 7:00 AM", "2024-10-27 07:00"}) {
    EXPECT_EQ(seconds_by(DateOrder::kDayFirst, text), 1730012400.0) << text;
  }
  for (const std::string_view text : {"10/27/2024 07:00:00", "10/27/2024 7:00:00 AM"}) {
    EXPECT_EQ(seconds_by(DateOrder::kMonthFirst, text), 1730012400.0) << text;
  }
  EXPECT_EQ(seconds_by(DateOrder::kDayFirst, "5/6/2024 00:00:00"), 1717545600.0);
  EXPECT_EQ(seconds_by(DateOrder::kMonthFirst, "5/6/2024 00:00:00"), 1714953600.0);
  WallTime time;
  EXPECT_NE(parse_wall_time("10.27.2024 07:00", time, DateOrder::kDayFirst).find("no such month"),
            std::string_view::npos);
  EXPECT_NE(parse_wall_time("27/10/2024 07:00", time, DateOrder::kMonthFirst).find("no such month"),
            std::string_view::npos);
  EXPECT_NE(parse_wall_time("27.10.24 07:00", time, DateOrder::kDayFirst).find("two digits"),
            std::string_view::npos);
  EXPECT_NE(parse_wall_time("31.02.2024 07:00", time, DateOrder::kDayFirst).find("no such day"),
            std::string_view::npos);
}

TEST(IsoTime, ADateTellsItsOrderWhereItHasNoOther) {
  EXPECT_EQ(order_told_by("27/10/2024 07:00"), DateOrder::kDayFirst);
  EXPECT_EQ(order_told_by("10/27/2024"), DateOrder::kMonthFirst);
  EXPECT_EQ(order_told_by("5/6/2024"), DateOrder::kUnsaid);
  EXPECT_EQ(order_told_by("05.06.2024"), DateOrder::kDayFirst);
  EXPECT_EQ(order_told_by("27/27/2024"), DateOrder::kUnsaid);
  EXPECT_EQ(order_told_by("2024-10-27"), std::nullopt);
  EXPECT_EQ(order_told_by("17"), std::nullopt);
}

TEST(IsoTime, HalvesOfADayHaveTwelveHours) {
  constexpr DateOrder kOrder = DateOrder::kMonthFirst;
  const double midnight_s = seconds_by(kOrder, "10/27/2024 00:00:00");
  EXPECT_EQ(seconds_by(kOrder, "10/27/2024 12:00:00 AM"), midnight_s);
  EXPECT_EQ(seconds_by(kOrder, "10/27/2024 12:00 pm"), midnight_s + 43200.0);
  EXPECT_EQ(seconds_by(kOrder, "10/27/2024 7:30:15 PM"), midnight_s + 70215.0);
  WallTime time;
  EXPECT_NE(parse_wall_time("10/27/2024 13:00 PM", time, kOrder).find("no such time"),
            std::string_view::npos);
  EXPECT_NE(parse_wall_time("10/27/2024 0:30 AM", time, kOrder).find("no such time"),
            std::string_view::npos);
}

TEST(IsoTime, MinutesAreEnough) {
  EXPECT_EQ(seconds_of("2024-05-01T12:00Z"), 1714564800.0);
  EXPECT_EQ(seconds_of("2024-05-01 12:00 +00:00"), 1714564800.0);
  EXPECT_TRUE(looks_like_hours_and_minutes("7:30"));
  EXPECT_TRUE(looks_like_hours_and_minutes("07:30 PM"));
  EXPECT_FALSE(looks_like_hours_and_minutes("07:30:00"));
  EXPECT_FALSE(looks_like_hours_and_minutes("7.5"));
}

TEST(IsoTime, IsDistinguishedFromNumbersByItsYear) {
  EXPECT_TRUE(looks_like_iso_time("2024-05-01T12:00:00Z"));
  EXPECT_TRUE(looks_like_iso_time("2024-"));
  EXPECT_FALSE(looks_like_iso_time("20240501"));
  EXPECT_FALSE(looks_like_iso_time("2024.5"));
  EXPECT_FALSE(looks_like_iso_time("-2024"));
  EXPECT_FALSE(looks_like_iso_time(""));
}

}  // namespace
}  // namespace beespace::io
