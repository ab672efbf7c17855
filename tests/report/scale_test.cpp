// Axes: values to places, and ticks.
#include "report/figure/scale.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::report {
namespace {

std::vector<std::string> labels(const std::vector<Tick>& ticks) {
  std::vector<std::string> all;
  for (const Tick& tick : ticks) all.push_back(tick.label);
  return all;
}

using Labels = std::vector<std::string>;

TEST(Scale, GoesFromValuesToPlacesAndBack) {
  const Scale linear({-10.0, 30.0}, 100.0, 500.0);
  EXPECT_DOUBLE_EQ(linear(0.0), 200.0);
  EXPECT_DOUBLE_EQ(linear.value_at(200.0), 0.0);
  EXPECT_DOUBLE_EQ(linear(1e9), 500.0);
  const Scale upwards({0.0, 10.0}, 500.0, 100.0);
  EXPECT_DOUBLE_EQ(upwards(2.5), 400.0);
  const Scale decades({0.1, 1000.0}, 0.0, 400.0, Scale::Kind::kLogarithmic);
  EXPECT_NEAR(decades(1.0), 100.0, 1e-9);
  EXPECT_NEAR(decades.value_at(300.0), 100.0, 1e-9);
  EXPECT_DOUBLE_EQ(decades(0.0), 0.0);
}

TEST(Ticks, AreOneTwoOrFiveTimesAPowerOfTenAndNotTooMany) {
  EXPECT_DOUBLE_EQ(nice_step(100.0, 10), 10.0);
  EXPECT_DOUBLE_EQ(nice_step(100.0, 9), 20.0);
  EXPECT_DOUBLE_EQ(nice_step(1.0, 3), 0.5);
  EXPECT_DOUBLE_EQ(nice_step(6e-7, 1), 1e-6);
  EXPECT_EQ(labels(nice_ticks({-0.3, 1.1}, 4)), (Labels{"0.0", "0.5", "1.0"}));
  EXPECT_EQ(labels(nice_ticks({-1234.0, 1234.0}, 5)),
            (Labels{"\u22121,000", "\u2212500", "0", "500", "1,000"}));
  EXPECT_EQ(labels(nice_ticks({0.0, 50'000.0}, 3, 1e3)), (Labels{"0", "20", "40"}));
}

TEST(Ticks, EndWhereDoublesCannotTellThemApart) {
  EXPECT_TRUE(nice_ticks({1e18, 1e18 + 256.0}, 1'000'000).empty());
  EXPECT_LE(nice_ticks({-1e120, 1e120}, 5).size(), 6u);
}

TEST(Ticks, OfLogarithmsAreAtPowersOfTen) {
  EXPECT_EQ(labels(logarithmic_ticks({0.01, 1000.0}, 7)),
            (Labels{"0.01", "0.1", "1", "10", "100", "1,000"}));
  EXPECT_EQ(labels(logarithmic_ticks({0.9, 60.0}, 9)), (Labels{"1", "2", "5", "10", "20", "50"}));
  EXPECT_LE(logarithmic_ticks({1e-120, 1e120}, 7).size(), 8u);
}

TEST(Ticks, OfClocksAreAtWholeMinutesAndHours) {
  EXPECT_EQ(labels(clock_ticks({800.0, 4400.0}, 5, 0.0)),
            (Labels{"00:15", "00:30", "00:45", "01:00"}));
  EXPECT_EQ(labels(clock_ticks({86'400.0 + 10.0, 86'400.0 + 60.0}, 4, 86'400.0)),
            (Labels{"00:00:15", "00:00:30", "00:00:45", "00:01:00"}));
}

}  // namespace
}  // namespace beespace::report
