// Numbers as figures and map files show them.
#include "report/number_label.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace beespace::report {
namespace {

TEST(NumberLabel, CountsAreGroupedAndAgreeWithTheirNoun) {
  EXPECT_EQ(count_label(0), "0");
  EXPECT_EQ(count_label(1'234'567), "1,234,567");
  EXPECT_EQ(count_label(1, "pair", "pairs"), "1 pair");
  EXPECT_EQ(count_label(1'000, "pair", "pairs"), "1,000 pairs");
}

TEST(NumberLabel, DecimalsAreGroupedBeforeThePointOnlyAndNeverMinusZero) {
  EXPECT_EQ(decimal_label(1234.5, 1), "1,234.5");
  EXPECT_EQ(decimal_label(-1234567.0, 0), "\u22121,234,567");
  EXPECT_EQ(decimal_label(-123.0, 0), "\u2212123");
  EXPECT_EQ(decimal_label(-0.0001, 2), "0.00");
  EXPECT_EQ(decimal_label(1e30, 0), "1e+30");
}

TEST(NumberLabel, LengthsHaveThreeDigitsThatCountAndAUnit) {
  EXPECT_EQ(length_label(0.0), "0 m");
  EXPECT_EQ(length_label(0.0124), "12.4 mm");
  EXPECT_EQ(length_label(57.294), "57.3 m");
  EXPECT_EQ(length_label(100.0), "100 m");
  EXPECT_EQ(length_label(1234.0), "1,234 m");
  EXPECT_EQ(length_label(12'345.0), "12.3 km");
  EXPECT_EQ(listed_length(4.99812), "4.998 m");
  EXPECT_EQ(listed_length(5.0), "5.000 m");
  EXPECT_EQ(listed_length(0.0), "0 m");
}

TEST(NumberLabel, LengthsBelowALimitAreNotRoundedUpToIt) {
  EXPECT_EQ(length_label_below(100.0, 57.294), "57.3 m");
  EXPECT_EQ(listed_length_below(0.002, 0.00456), "4.56 mm");
  EXPECT_EQ(length_label_below(0.002, 0.153), "153 mm");
  EXPECT_EQ(length_label_below(0.002, std::nextafter(0.002, 0.0)), "1.9999999999999996 mm");
  EXPECT_EQ(listed_length_below(2e-6, 1.2e-6), "1.2 \u00B5m");
  EXPECT_EQ(length_label_below(1e-5, 5.9994e-6), "6 \u00B5m");
  EXPECT_EQ(length_label_below(1e-5, 9.99996e-6), "9.99996 \u00B5m");
  EXPECT_EQ(length_label_below(1e-5, std::nextafter(1e-5, 0.0)), "0.000009999999999999999 m");
  EXPECT_EQ(length_label(1e-5), "10 \u00B5m");
  EXPECT_EQ(length_label(5e-10), "under 1 \u00B5m");
  EXPECT_EQ(listed_length_below(0.5, 0.00456), "0.005 m");
  EXPECT_EQ(length_label_below(100.0, 99.9), "99.9 m");
  EXPECT_EQ(length_label_below(100.0, 99.9996), "99.9996 m");
  EXPECT_EQ(length_label_below(100.0, std::nextafter(100.0, 0.0)), "99.99999999999999 m");
  EXPECT_EQ(length_label_below(100.0, 100.0), "100 m");
  EXPECT_EQ(length_label_below(100.0, 100.04), "100 m");
  EXPECT_EQ(length_label_below(5'000.0, 4'999.7), "4,999.7 m");
  EXPECT_EQ(length_label_below(20'000.0, 19'999.0), "19.999 km");
  EXPECT_EQ(length_label_below(0.005, 0.00499999), "4.99999 mm");
  EXPECT_EQ(length_label_below(5.0, 0.0), "0 m");
  EXPECT_EQ(listed_length_below(5.0, 4.998), "4.998 m");
  EXPECT_EQ(listed_length_below(5.0, 4.99996), "4.99996 m");
  EXPECT_EQ(listed_length_below(5.0, 5.0004), "5.000 m");
  EXPECT_EQ(listed_length_below(100.0, 99.99998), "99.99998 m");
  EXPECT_EQ(listed_length_below(20'000.0, 19'999.0), "19.999 km");
  EXPECT_EQ(listed_length_below(1e-3, 0.9999999e-3), "0.9999999 mm");
  const double close_to_much = std::nextafter(1e15, 0.0);
  EXPECT_EQ(length_label_below(1e15, close_to_much), "999,999,999,999.9999 km");
}

TEST(NumberLabel, ClocksShowWhatTheirStepNeeds) {
  EXPECT_EQ(clock_label(43'410.0, 60.0), "12:03");
  EXPECT_EQ(clock_label(43'410.0, 30.0), "12:03:30");
  EXPECT_EQ(clock_label(43'410.25, 0.01), "12:03:30.25");
  EXPECT_EQ(clock_label(59.999999, 1.0), "00:01:00");
}

TEST(NumberLabel, InstantsAreThoseOfTheCalendar) {
  EXPECT_EQ(instant_label(0.0), "1970-01-01T00:00:00Z");
  EXPECT_EQ(instant_label(-1.0), "1969-12-31T23:59:59Z");
  EXPECT_EQ(instant_label(951'782'400.0), "2000-02-29T00:00:00Z");
  EXPECT_EQ(instant_label(1'709'251'200.5), "2024-03-01T00:00:00.5Z");
  EXPECT_EQ(instant_label(86'399.9999999), "1970-01-02T00:00:00Z");
  EXPECT_EQ(instant_label(-62'167'219'200.0), "0000-01-01T00:00:00Z");
  EXPECT_EQ(instant_label(253'402'300'799.0), "9999-12-31T23:59:59Z");
  EXPECT_EQ(instant_label(1e300), "");
  EXPECT_EQ(date_label(1'709'164'800.0), "2024-02-29");
}

}  // namespace
}  // namespace beespace::report
