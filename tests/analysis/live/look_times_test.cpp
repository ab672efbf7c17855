#include "analysis/live/look_times.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>

namespace beespace::analysis {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// As a report writes it: so many tenths.
double tenths(std::int64_t count) {
  return std::strtod((std::to_string(count / 10) + "." + std::to_string(count % 10)).c_str(),
                     nullptr);
}

TEST(LookTimes, AreTheTimesThatReportsName) {
  const LookTimes looks(0.1);
  for (std::int64_t i = 0; i < 20'000; ++i) EXPECT_EQ(looks.at(i), tenths(i)) << i;
  const std::int64_t unix_time = 17'000'000'000;
  for (std::int64_t i = unix_time; i < unix_time + 2'000; ++i) EXPECT_EQ(looks.at(i), tenths(i));
}

TEST(LookTimes, NoneIsSkippedAndNoneComesTwiceAtTimesThatAreAlignedWithThem) {
  for (const std::int64_t from : {std::int64_t{0}, std::int64_t{17'000'000'000}}) {
    const LookTimes looks(0.1);
    for (std::int64_t i = from; i < from + 2'000; ++i) {
      EXPECT_EQ(looks.last_before(tenths(i)), i - 1) << i;
      EXPECT_EQ(looks.last_before(std::nextafter(tenths(i), kInfinity)), i) << i;
    }
  }
}

TEST(LookTimes, OfStepsOfEverySizeAreBeforeAndTheNextIsNot) {
  for (const double step : {1e-9, 0.001, 0.08, 1.0 / 3.0, 0.4, 1.0, 7.0, 1e6, 3e12}) {
    const LookTimes looks(step);
    for (const double time : {-1e5, -3.0, -0.1, 0.0, 0.3, 0.7, 1.0, 12.5, 3600.0, 86'400.1}) {
      const auto number = looks.last_before(time);
      ASSERT_TRUE(number) << step << " " << time;
      EXPECT_LT(looks.at(*number), time) << step;
      EXPECT_GE(looks.at(*number + 1), time) << step;
    }
  }
}

TEST(LookTimes, ThatCannotBeCountedAreNone) {
  EXPECT_FALSE(LookTimes(1e-9).last_before(1.7e9));
  EXPECT_FALSE(LookTimes(0x1p-100).last_before(1.0));
  EXPECT_FALSE(LookTimes(1.0).last_before(0x1p100));
}

}  // namespace
}  // namespace beespace::analysis
