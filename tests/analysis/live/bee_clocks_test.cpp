#include "analysis/live/bee_clocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

using Step = BeeClocks::Step;
constexpr double kYear_s = 365.0 * 86'400.0;
constexpr BeeClocks::Limits kLimits{2.0, 5.0};

// Reports of bees whose clocks are `ahead_s`, each every `interval_s`, as they come; and what
// becomes of them.
struct Taken {
  AgentId bee;
  double true_s;
  double taken_s;
  double now_s;
};
struct Told {
  std::vector<Taken> taken = {};
  std::vector<Step> lost = {};
  std::vector<Step> off = {};
  std::vector<Step> right = {};
  std::vector<Step> back = {};
  std::uint64_t left_out = 0;

  [[nodiscard]] std::size_t of(PointId bee) const {
    return static_cast<std::size_t>(
        std::count_if(taken.begin(), taken.end(), [bee](const Taken& t) { return t.bee == bee; }));
  }
};

class Flock {
 public:
  explicit Flock(const BeeClocks::Limits& limits = kLimits) : clocks_(limits) {}

  // x of a report is when it really was.
  void hear(PointId bee, double true_s, double reported_s) {
    steps_.clear();
    const PositionReport report{bee, reported_s, {true_s, 0.0, 0.0}};
    if (clocks_.take(report, 0.0, steps_)) {
      told_.taken.push_back({bee, true_s, reported_s, clocks_.now()});
      EXPECT_TRUE(steps_.empty());
    }
    note();
  }
  const Told& end() {
    steps_.clear();
    clocks_.finish(steps_);
    note();
    told_.left_out = clocks_.left_out();
    return told_;
  }
  [[nodiscard]] const BeeClocks& clocks() const { return clocks_; }
  [[nodiscard]] const Told& told() const { return told_; }

 private:
  void note() {
    for (const Step& step : steps_) {
      switch (step.kind) {
        case Step::Kind::kReport:
          told_.taken.push_back(
              {step.report.id, step.report.position.x, step.report.time_s, step.now_s});
          break;
        case Step::Kind::kLost:
          told_.lost.push_back(step);
          break;
        case Step::Kind::kOff:
          told_.off.push_back(step);
          break;
        case Step::Kind::kRight:
          told_.right.push_back(step);
          break;
        case Step::Kind::kBack:
          told_.back.push_back(step);
          break;
      }
    }
  }

  BeeClocks clocks_;
  std::vector<Step> steps_;
  Told told_;
};

// Bees that report in turn, ten times a second each, the clock of each as `ahead` says.
template <class Ahead>
const Told& fly(Flock& flock, PointId bees, double lasts_s, Ahead&& ahead) {
  const auto rounds = static_cast<int>(10.0 * lasts_s);
  for (int round = 0; round < rounds; ++round) {
    for (PointId bee = 0; bee < bees; ++bee) {
      const double true_s = round / 10.0 + 0.05 * bee / bees;
      flock.hear(bee, true_s, true_s + ahead(bee, true_s));
    }
  }
  return flock.end();
}

void expect_times_right(const Told& told, double within_s) {
  for (const Taken& taken : told.taken) {
    ASSERT_NEAR(taken.taken_s, taken.true_s, within_s) << "bee " << taken.bee;
    ASSERT_NEAR(taken.now_s, taken.true_s, within_s) << "bee " << taken.bee;
  }
}

TEST(BeeClocks, ThatAreRightOrOffByALittleAreBelieved) {
  Flock flock;
  const Told& told = fly(flock, 50, 60.0, [](PointId bee, double) { return 0.02 * bee - 0.5; });
  EXPECT_EQ(told.taken.size(), 50u * 600u);
  EXPECT_TRUE(told.off.empty() && told.back.empty());
  EXPECT_EQ(told.left_out, 0u);
}

TEST(BeeClocks, ThatAreAYearAheadAndGoOnBearOutNothingThemselves) {
  for (const PointId bees : {PointId{3}, PointId{1'000}}) {
    Flock flock;
    const Told& told = fly(flock, bees, 10.0, [](PointId bee, double time_s) {
      return bee == 2 && time_s > 1.0 ? kYear_s : 0.0;
    });
    ASSERT_EQ(told.off.size(), 1u);
    EXPECT_EQ(told.off[0].report.id, 2u);
    EXPECT_NEAR(told.off[0].ahead_s, kYear_s, 0.2);
    EXPECT_TRUE(told.back.empty());
    expect_times_right(told, 0.2);
    EXPECT_LE(told.left_out, 1u);
    EXPECT_GE(told.of(2), 98u) << "at times that are put right";
  }
}

TEST(BeeClocks, ThatAreSecondsAheadAreNamedAndPutRight) {
  for (const double ahead_s : {3.0, 5.0, 18.0, 59.0}) {
    for (const PointId wrong : {PointId{0}, PointId{1}, PointId{9}}) {
      Flock flock;
      const Told& told =
          fly(flock, 10, 20.0, [&](PointId bee, double) { return bee == wrong ? ahead_s : 0.0; });
      ASSERT_FALSE(told.off.empty()) << ahead_s << " " << wrong;
      for (const Step& step : told.off) EXPECT_EQ(step.report.id, wrong);
      EXPECT_NEAR(told.off[0].ahead_s, ahead_s, 0.2);
      for (PointId bee = 0; bee < 10; ++bee) EXPECT_GE(told.of(bee), 195u);
      // Once it is known, all times are right.
      const auto late = std::find_if(told.taken.begin(), told.taken.end(),
                                     [](const Taken& t) { return t.true_s > 0.3; });
      for (auto t = late; t != told.taken.end(); ++t) {
        ASSERT_NEAR(t->taken_s, t->true_s, 0.2) << ahead_s << " " << wrong;
        ASSERT_NEAR(t->now_s, t->true_s, 0.2) << ahead_s << " " << wrong;
      }
    }
  }
}

TEST(BeeClocks, ThatAreBehindForLongAreNamedAndPutRight) {
  for (const double behind_s : {3.0, 30.0, 3600.0}) {
    Flock flock;
    const Told& told =
        fly(flock, 10, 20.0, [&](PointId bee, double) { return bee == 4 ? -behind_s : 0.0; });
    ASSERT_EQ(told.off.size(), 1u) << behind_s;
    EXPECT_EQ(told.off[0].report.id, 4u);
    EXPECT_NEAR(told.off[0].ahead_s, -behind_s, 0.2);
    EXPECT_TRUE(told.back.empty());
    for (const Taken& taken : told.taken) {
      ASSERT_NEAR(taken.now_s, taken.true_s, 0.2);
      if (taken.bee != 4) continue;
      // Up to what is stale it may be late only, until it is named.
      const bool as_is = behind_s <= 5.0 && taken.true_s < told.off[0].now_s;
      ASSERT_NEAR(taken.taken_s, taken.true_s - (as_is ? behind_s : 0.0), 0.2);
    }
    // No line leads from the ones to the others.
    EXPECT_EQ(told.lost.size(), 1u);
    EXPECT_GT(told.of(4), 140u);
  }
}

TEST(BeeClocks, ThatStepAgainAndAgainAreFollowedAndNotNamedAtEachStep) {
  Flock flock;
  const Told& told = fly(flock, 5, 60.0, [](PointId bee, double time_s) {
    return bee == 3 ? 10.0 * std::floor(time_s) : 0.0;
  });
  EXPECT_GE(told.off.size(), 2u);
  EXPECT_LE(told.off.size(), 8u);
  expect_times_right(told, 0.2);
}

TEST(BeeClocks, ThatRunTooFastPullNoOtherWithThem) {
  for (const double rate : {1.01, 1.2, 2.0, 100.0}) {
    Flock flock;
    const Told& told = fly(flock, 5, 600.0, [&](PointId bee, double time_s) {
      return bee == 0 ? (rate - 1.0) * time_s : 0.0;
    });
    ASSERT_FALSE(told.off.empty()) << rate;
    for (const Step& step : told.off) EXPECT_EQ(step.report.id, 0u) << rate;
    for (const Taken& taken : told.taken) {
      if (taken.bee == 0) continue;
      ASSERT_EQ(taken.taken_s, taken.true_s);
      ASSERT_LT(std::abs(taken.now_s - taken.true_s), 2.3) << rate;
    }
    EXPECT_LT(told.off.size(), 62u) << rate;
  }
}

TEST(BeeClocks, ThatAreRightAgainAreBelievedAgain) {
  Flock flock;
  const Told& told = fly(flock, 4, 30.0, [](PointId bee, double time_s) {
    return bee == 1 && time_s > 5.0 && time_s < 15.0 ? 40.0 : 0.0;
  });
  ASSERT_EQ(told.off.size(), 1u);
  ASSERT_EQ(told.right.size(), 1u);
  EXPECT_EQ(told.right[0].report.id, 1u);
  expect_times_right(told, 0.2);
}

TEST(BeeClocks, ThatBeginAnewTogetherAreFollowed) {
  for (const PointId bees : {PointId{1}, PointId{2}, PointId{100}}) {
    Flock flock;
    const Told& told = fly(flock, bees, 20.0,
                           [](PointId, double time_s) { return time_s < 10.0 ? 1'000.0 : -10.0; });
    ASSERT_EQ(told.back.size(), 1u) << bees;
    EXPECT_TRUE(told.back[0].anew);
    EXPECT_NEAR(told.back[0].now_s, 0.0, 0.3);
    EXPECT_EQ(told.taken.size(), 200u * bees) << "none is lost";
    EXPECT_EQ(told.taken.back().now_s, told.taken.back().taken_s);
  }
}

TEST(BeeClocks, OfSeveralBeesThatAreLateTogetherDoNotTurnTimeBack) {
  // Of three bees two are heard of late, once and once more, beyond what is too old.
  Flock flock({0.4, 0.8});
  for (int round = 0; round < 50; ++round) {
    const double now_s = 0.2 * round;
    flock.hear(0, now_s, now_s);
    const bool late = round >= 20 && round < 22;
    for (const PointId bee : {PointId{1}, PointId{2}}) {
      const double made_s = late ? now_s - 0.9 : now_s + 0.01 * bee;
      flock.hear(bee, made_s, made_s);
    }
  }
  const Told& told = flock.end();
  EXPECT_TRUE(told.back.empty());
  EXPECT_TRUE(told.off.empty());
  EXPECT_EQ(told.of(0), 50u);
  for (std::size_t i = 1; i < told.taken.size(); ++i) {
    ASSERT_GE(told.taken[i].now_s, told.taken[i - 1].now_s);
  }
}

// How often a bee is heard is measured between reports that came in time: not from a late one.
TEST(BeeClocks, OfLateReportsOneAfterTheOtherDoNotTurnTimeBack) {
  Flock flock;
  const auto both = [&](double time_s) {
    flock.hear(0, time_s, time_s);
    flock.hear(1, time_s, time_s);
  };
  for (int tenth = 0; tenth <= 200; ++tenth) both(tenth / 10.0);
  flock.hear(1, 12.0, 12.0);
  both(20.1);
  for (const double late_s : {6.0, 9.0, 13.0}) flock.hear(1, late_s, late_s);
  both(20.2);
  EXPECT_TRUE(flock.end().back.empty());
  expect_times_right(flock.told(), 0.0);
}

TEST(BeeClocks, OfABeeThatIsSeldomHeardMayBeLateTwice) {
  Flock flock;
  for (int tenth = 0; tenth <= 300; ++tenth) {
    flock.hear(0, tenth / 10.0, tenth / 10.0);
    if (tenth % 60 == 0) flock.hear(1, tenth / 10.0, tenth / 10.0);
  }
  for (const double late_s : {12.0, 18.0}) flock.hear(1, late_s, late_s);
  for (int tenth = 301; tenth <= 310; ++tenth) flock.hear(0, tenth / 10.0, tenth / 10.0);
  EXPECT_TRUE(flock.end().back.empty());
}

TEST(BeeClocks, AreNotContradictedByReportsThatAreLate) {
  // Both were silent for a second; one goes on, while of the other come those that were under way.
  Flock flock({0.4, 0.8});
  for (int round = 0; round < 10; ++round) {
    flock.hear(0, 0.1 * round, 0.1 * round);
    flock.hear(1, 0.1 * round, 0.1 * round);
  }
  for (int round = 0; round < 10; ++round) {
    flock.hear(0, 2.0 + 0.1 * round, 2.0 + 0.1 * round);
    flock.hear(1, 0.9 - 0.01 * round, 0.9 - 0.01 * round);
  }
  const Told& told = flock.end();
  EXPECT_TRUE(told.off.empty());
  EXPECT_EQ(told.taken.back().now_s, 2.9);
}

TEST(BeeClocks, ThatGoOnTogetherAfterAPauseAreFollowedAndNoReportIsLost) {
  Flock flock;
  const Told& told =
      fly(flock, 100, 20.0, [](PointId, double time_s) { return time_s < 10.0 ? 0.0 : 500.0; });
  EXPECT_EQ(told.taken.size(), 200u * 100u);
  EXPECT_TRUE(told.off.empty() && told.back.empty());
  EXPECT_NEAR(told.taken.back().now_s, 520.0, 0.2);
}

// Whatever the order of bees and however long the pauses: reports in the order of their times come
// out as they went in.
TEST(BeeClocks, OfReportsInOrderChangeNothing) {
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    const auto bees = static_cast<PointId>(1 + random() % 6);
    Flock flock;
    std::vector<std::pair<PointId, double>> sent;
    double time_s = 0.0;
    for (int i = 0; i < 200; ++i) {
      const double longest_s = random() % 10 == 0 ? 1'000.0 : 3.0;
      if (random() % 3 != 0) {
        time_s += longest_s * std::uniform_real_distribution<double>(0.0, 1.0)(random);
      }
      sent.emplace_back(static_cast<PointId>(random() % bees), time_s);
      flock.hear(sent.back().first, time_s, time_s);
    }
    const Told& told = flock.end();
    EXPECT_TRUE(told.off.empty() && told.back.empty()) << round;
    ASSERT_EQ(told.taken.size(), sent.size()) << round;
    for (std::size_t i = 0; i < sent.size(); ++i) {
      ASSERT_EQ(told.taken[i].bee, sent[i].first) << round;
      ASSERT_EQ(told.taken[i].taken_s, sent[i].second) << round;
    }
  }
}

TEST(BeeClocks, KeepBackSoMuchAndNoMore) {
  BeeClocks clocks(kLimits);
  std::vector<Step> steps;
  EXPECT_TRUE(clocks.take({0, 0.0, {}}, 0.0, steps));
  constexpr std::uint64_t kReports = 200'000;
  // Its clock hardly goes on, so that it is not clear whether time has.
  for (std::uint64_t i = 0; i < kReports; ++i) {
    EXPECT_FALSE(clocks.take({1, 1'000.0 + 1e-6 * static_cast<double>(i), {}}, 0.0, steps));
  }
  EXPECT_TRUE(steps.empty());
  clocks.finish(steps);
  EXPECT_GE(steps.size(), BeeClocks::kMostKept);
  EXPECT_LE(steps.size(), BeeClocks::kMostKept + 100);
  // And one that says that the rest does not go on from the first.
  EXPECT_EQ(steps.size() + clocks.left_out(), kReports + 1) << "what is left out is counted";
}

TEST(BeeClocks, OfManyBeesThatGoOnAfterAPauseLoseNoReport) {
  Flock flock;
  const Told& told =
      fly(flock, 200'000, 0.4, [](PointId, double time_s) { return time_s < 0.2 ? 0.0 : 500.0; });
  EXPECT_EQ(told.taken.size(), 4u * 200'000u);
  EXPECT_EQ(told.left_out, 0u);
}

}  // namespace
}  // namespace beespace::analysis
