// Clocks that are apart by less than what is disbelieved: who is named, and who is not.
#include "analysis/live/clock_lags.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace beespace::analysis {
namespace {

// The clocks of bees, and how long their reports take, at a time.
using OfBee = std::function<double(AgentId id, double time_s)>;

// `reports_s`: how often each reports. As BeeClocks does, time goes on with the latest report.
std::vector<ClockLags::Told> told_of(AgentId bees, double reports_s, const OfBee& ahead_s,
                                     const OfBee& takes_s, ClockLags* lags = nullptr) {
  ClockLags own(0.5);
  ClockLags& judge = lags == nullptr ? own : *lags;
  struct Report {
    double comes_s;
    double says_s;
    AgentId id;
  };
  std::vector<Report> reports;
  for (int k = 0; k < static_cast<int>(30.0 / reports_s); ++k) {
    for (AgentId id = 0; id < bees; ++id) {
      const double time_s = k * reports_s + 0.01 * static_cast<double>(id);
      reports.push_back({time_s + takes_s(id, time_s), time_s + ahead_s(id, time_s), id});
    }
  }
  std::stable_sort(reports.begin(), reports.end(),
                   [](const Report& a, const Report& b) { return a.comes_s < b.comes_s; });
  std::vector<ClockLags::Told> told;
  double now_s = -std::numeric_limits<double>::infinity();
  for (const Report& report : reports) {
    now_s = std::max(now_s, report.says_s);
    judge.take(report.id, report.says_s, now_s, told);
  }
  return told;
}

double nothing(AgentId, double) {
  return 0.0;
}
OfBee of_third(double value) {
  return [value](AgentId id, double) { return id == 3 ? value : 0.0; };
}

TEST(ClockLags, ABeeThatIsAheadOrBehindOfTheOthersIsNamed) {
  for (const double ahead_s : {1.5, 0.8, -1.5, -0.8}) {
    for (const double reports_s : {0.1, 0.25}) {
      ClockLags lags(0.5);
      const auto told = told_of(8, reports_s, of_third(ahead_s), nothing, &lags);
      ASSERT_EQ(told.size(), 1u) << ahead_s << " " << reports_s;
      EXPECT_EQ(told[0].bee, 3u);
      EXPECT_NEAR(told[0].ahead_s, ahead_s, reports_s + 0.1);
      EXPECT_FALSE(told[0].right);
      EXPECT_EQ(lags.named(), 1u);
    }
  }
}

TEST(ClockLags, WhoseReportsAllTakeLongerIsNamedToo) {
  const auto told = told_of(8, 0.1, nothing, of_third(1.5));
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NEAR(told[0].ahead_s, -1.5, 0.2);
}

TEST(ClockLags, OfTwoOneIsNamed) {
  EXPECT_EQ(told_of(
                2, 0.1, [](AgentId id, double) { return id == 1 ? 1.5 : 0.0; }, nothing)
                .size(),
            1u);
}

TEST(ClockLags, ReportsInTheOrderOfTheirTimesSayNothing) {
  // All at once, every second: the first of each is a second behind what was before.
  EXPECT_TRUE(told_of(8, 1.0, nothing, nothing).empty());
  EXPECT_TRUE(told_of(8, 0.1, nothing, nothing).empty());
}

TEST(ClockLags, SomeReportsThatTakeLongAreNoWrongClock) {
  std::mt19937 random(7);
  std::exponential_distribution<double> delay(2.0);
  EXPECT_TRUE(told_of(20, 0.1, nothing, [&](AgentId, double) { return delay(random); }).empty());
  // And none of a bee for two seconds.
  EXPECT_TRUE(told_of(8, 0.1, nothing, [](AgentId id, double t) {
                return id == 3 && t > 10.0 && t < 12.0 ? 12.0 - t : 0.0;
              }).empty());
}

TEST(ClockLags, WhoIsRightAgainIsSaidToBe) {
  ClockLags lags(0.5);
  const auto told = told_of(
      8, 0.1, [](AgentId id, double t) { return id == 3 && t < 15.0 ? 1.5 : 0.0; }, nothing, &lags);
  ASSERT_EQ(told.size(), 2u);
  EXPECT_FALSE(told[0].right);
  EXPECT_TRUE(told[1].right);
  EXPECT_EQ(told[1].bee, 3u);
  EXPECT_EQ(lags.named(), 1u);
}

TEST(ClockLags, WhoHasLeftIsForgotten) {
  ClockLags lags(0.5);
  told_of(8, 0.1, of_third(1.5), nothing, &lags);
  lags.forget(3);
  for (const auto& told : told_of(8, 0.1, nothing, nothing, &lags)) EXPECT_NE(told.bee, 3u);
  lags.clear();
  EXPECT_TRUE(told_of(8, 0.1, nothing, nothing, &lags).empty());
}

}  // namespace
}  // namespace beespace::analysis
