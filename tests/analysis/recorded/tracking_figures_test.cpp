#include "analysis/recorded/tracking_figures.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::analysis {
namespace {

constexpr double kEver = std::numeric_limits<double>::infinity();

// A circle of 20 m radius at 8 m/s, a fix each tenth of a second.
Point on_circle(double time_s) {
  return {20.0 * std::cos(0.4 * time_s), 20.0 * std::sin(0.4 * time_s), 10.0};
}

template <class Flown>
SetAndFlown flight(const Flown& flown) {
  SetAndFlown bee;
  for (int k = 0; k < 400; ++k) {
    const double time_s = 0.1 * k;
    bee.set.fixes.push_back({time_s, on_circle(time_s)});
    bee.flown.fixes.push_back({time_s, flown(time_s)});
  }
  return bee;
}

TEST(TrackingFigures, AnExactFlightDeviatesByNothing) {
  const TrackingFigures figures = tracking_figures({flight(on_circle)}, kEver);
  EXPECT_EQ(figures.fixes, 400u);
  EXPECT_EQ(figures.not_set, 0u);
  EXPECT_EQ(figures.deviation_m.greatest, 0.0);
  EXPECT_EQ(figures.rate_mps.greatest, 0.0);
}

TEST(TrackingFigures, ALagIsFound) {
  const TrackingFigures figures =
      tracking_figures({flight([](double t) { return on_circle(t - 0.35); })}, kEver);
  ASSERT_TRUE(figures.lag_s);
  EXPECT_NEAR(*figures.lag_s, 0.35, 0.011);
  EXPECT_NEAR(figures.deviation_m.greatest, 8.0 * 0.35, 0.01);
  EXPECT_LT(figures.without_lag_m.greatest, 0.05);
}

TEST(TrackingFigures, ASwingHasItsRateAndAcceleration) {
  // 0.3 m, once in 3 s.
  const double turn = 2.0 * std::acos(-1.0) / 3.0;
  const TrackingFigures figures = tracking_figures({flight([&](double t) {
                                                     Point p = on_circle(t);
                                                     p.z += 0.3 * std::sin(turn * t);
                                                     return p;
                                                   })},
                                                   kEver);
  EXPECT_NEAR(figures.deviation_m.greatest, 0.3, 0.01);
  EXPECT_NEAR(figures.rate_mps.greatest, 0.3 * turn, 0.01);
  EXPECT_NEAR(figures.acceleration_mps2.greatest, 0.3 * turn * turn, 0.03);
  EXPECT_FALSE(figures.lag_s);
}

TEST(TrackingFigures, OneOutlierIsTheGreatestAndNotUsual) {
  std::vector<SetAndFlown> bees(10, flight(on_circle));
  bees[3].flown.fixes[200].position.z += 5.0;
  const TrackingFigures figures = tracking_figures(bees, kEver);
  EXPECT_DOUBLE_EQ(figures.deviation_m.greatest, 5.0);
  EXPECT_EQ(figures.deviation_m.usual, 0.0);
}

TEST(TrackingFigures, OfEachBeeTheFarthestTheMeanAndWhat95Of100DoNotExceed) {
  SetAndFlown bee{{{{0, {0, 0, 0}}, {100, {0, 0, 0}}}}, {}};
  for (int second = 0; second < 100; ++second) {
    bee.flown.fixes.push_back({static_cast<double>(second), {0, 0, second == 7 ? 5.0 : 1.0}});
  }
  const TrackingFigures figures = tracking_figures({bee, {bee.set, {}}}, kEver);
  ASSERT_EQ(figures.each.size(), 2u);
  ASSERT_TRUE(figures.each[0]);
  EXPECT_EQ(figures.each[0]->fixes, 100u);
  EXPECT_DOUBLE_EQ(figures.each[0]->farthest_m, 5.0);
  EXPECT_DOUBLE_EQ(figures.each[0]->farthest_s, 7.0);
  EXPECT_NEAR(figures.each[0]->mean_m, 1.04, 1e-12);
  EXPECT_DOUBLE_EQ(figures.each[0]->p95_m, 1.0);
  EXPECT_FALSE(figures.each[1]);
}

TEST(TrackingFigures, WhereNothingWasSetNothingIsCompared) {
  SetAndFlown bee = flight(on_circle);
  bee.set.fixes.erase(bee.set.fixes.begin() + 100, bee.set.fixes.begin() + 200);
  bee.flown.fixes.push_back({100.0, {}});
  const TrackingFigures figures = tracking_figures({bee}, 1.0);
  EXPECT_EQ(figures.not_set, 101u);
  EXPECT_EQ(figures.fixes, 300u);
  EXPECT_EQ(figures.deviation_m.greatest, 0.0);
  EXPECT_EQ(tracking_figures({}, kEver).fixes, 0u);
}

}  // namespace
}  // namespace beespace::analysis
