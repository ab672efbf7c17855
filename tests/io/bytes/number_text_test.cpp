#include "io/bytes/number_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::io {
namespace {

TEST(NumberText, ExactNumbersReadBackAsTheSameDouble) {
  for (const double value : {0.1, 1.0 / 3.0, 73.19845091175326, 1e-300, -2.5, 1e22, 100.0}) {
    const auto back = parse_number(exact(value));
    ASSERT_TRUE(back.has_value());
    EXPECT_EQ(*back, value);
  }
  EXPECT_EQ(exact(100.0), "100");
}

TEST(NumberText, OneIsCountedUnlikeSeveral) {
  EXPECT_EQ(counted(1, "bee", "bees"), "1 bee");
  EXPECT_EQ(counted(0, "bee", "bees"), "0 bees");
  EXPECT_EQ(counted(1'234, "bee", "bees"), "1,234 bees");
}

TEST(NumberText, ThousandsAreGrouped) {
  EXPECT_EQ(grouped(std::uint64_t{0}), "0");
  EXPECT_EQ(grouped(std::uint64_t{999}), "999");
  EXPECT_EQ(grouped(std::uint64_t{1'000}), "1,000");
  EXPECT_EQ(grouped(std::uint64_t{1'234'567}), "1,234,567");
  EXPECT_EQ(grouped(1234.5678, 2), "1,234.57");
  EXPECT_EQ(grouped(-1234.5, 0), "-1,234");
}

TEST(NumberText, LengthsKeepTheirMeaningAtEveryScale) {
  EXPECT_EQ(length(0.0), "0 m");
  EXPECT_EQ(length(73.19845), "73.198 m");
  EXPECT_EQ(length(0.0001), "0.1 mm");  // never rounded to zero
  EXPECT_EQ(length(7.987e-5), "0.0799 mm");
  EXPECT_EQ(length(9.9999e-4), "1 mm");
  EXPECT_EQ(length(8.360992226604871e-11), "under 0.001 mm");
  EXPECT_EQ(length_below(50.0, 7.99e-5), "under 1 mm");
  EXPECT_EQ(length_below(0.005, 7.99e-5), "0.0799 mm");
  EXPECT_EQ(length_below(0.001, 0.0009999), "0.9999 mm");
  EXPECT_EQ(length(12'345.6), "12.3 km");
}

// What is below a limit is told below it, with as many digits as that needs.
TEST(NumberText, RoundingNeverReachesALimit) {
  EXPECT_EQ(length_below(100.0, 99.9994), "99.999 m");
  EXPECT_EQ(length_below(100.0, 99.9996), "99.9996 m");
  EXPECT_EQ(length_below(100.0, 99.99999999), "99.99999999 m");
  EXPECT_EQ(length_below(100.0, std::nextafter(100.0, 0.0)), "99.99999999999999 m");
  EXPECT_EQ(length_below(100.0, 100.0), "100.000 m");
  EXPECT_EQ(length_below(100.0, 100.0001), "100.000 m");
  EXPECT_EQ(length_below(18'520.0, 18'519.9), "18.5 km");
  EXPECT_EQ(length_below(18'500.0, 18'499.9), "18.4999 km");
  EXPECT_EQ(grouped_below(1000.0, 999.6, 0), "999.6");
  EXPECT_EQ(grouped_below(1000.0, 999.4, 0), "999");
  EXPECT_EQ(grouped_below(1e-20, 9.99e-21, 3), "0.000");
  EXPECT_EQ(length(1e20), "1e+20 m");
}

TEST(NumberText, SizesTimesAndSharesAreForPeople) {
  EXPECT_EQ(byte_count(999), "999 B");
  EXPECT_EQ(byte_count(39'200), "39.2 kB");
  EXPECT_EQ(byte_count(999'999), "1.0 MB");
  EXPECT_EQ(duration(0.0123), "12.3 ms");
  EXPECT_EQ(duration(1.25), "1.25 s");
  EXPECT_EQ(percentage(0.296), "29.6 %");
}

TEST(NumberText, OnlyAWholeNumberIsANumber) {
  EXPECT_EQ(parse_number("1e2"), 100.0);
  EXPECT_TRUE(std::isnan(parse_number("nan").value_or(0.0)));
  EXPECT_EQ(parse_number("-inf"), -std::numeric_limits<double>::infinity());
  EXPECT_FALSE(parse_number("").has_value());
  EXPECT_FALSE(parse_number("100m").has_value());
  EXPECT_FALSE(parse_number("1,5").has_value());
  EXPECT_FALSE(std::isfinite(parse_number("1e999").value_or(0.0)));
}

TEST(NumberText, OnePlusSignMayComeFirst) {
  EXPECT_EQ(parse_number("+5"), 5.0);
  EXPECT_EQ(parse_number("+.5"), 0.5);
  for (const char* bad : {"+", "++5", "+-5", "-+5", "5+"}) {
    EXPECT_FALSE(parse_number(bad).has_value()) << bad;
  }
}

TEST(NumberText, WholeNumbersAreDigitsBelowTwoToThe64) {
  EXPECT_EQ(parse_whole("0"), 0u);
  EXPECT_EQ(parse_whole("18446744073709551615"), std::numeric_limits<std::uint64_t>::max());
  for (const char* bad : {"", "-1", "+1", "1.0", "1e3", " 1", "0x10", "18446744073709551616"}) {
    EXPECT_FALSE(parse_whole(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace beespace::io
