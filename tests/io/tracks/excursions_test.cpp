// What leaps away and back, as nothing of its kind moves, was not there.
#include "io/recording/excursions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

// A body in an arena that flies a circle of 2 m at 1 m/s, measured 120 times a second, within 1 mm;
// off by `off_m` from 5 s to `until_s`.
std::vector<Fix> circling(const Point& off_m, double until_s, double step_s = 1.0 / 120.0) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise_m(0.0, 0.001);
  std::vector<Fix> fixes;
  for (int i = 0; i < 1200; ++i) {
    const double t = i * step_s;
    Point at = {2.0 * std::cos(t / 2.0) + noise_m(random), 2.0 * std::sin(t / 2.0),
                1.0 + noise_m(random)};
    if (t > 5.0 && t < until_s) at = {at.x + off_m.x, at.y + off_m.y, at.z + off_m.z};
    fixes.push_back({t, at});
  }
  return fixes;
}

std::size_t watched(const std::vector<Fix>& fixes) {
  ExcursionWatch watch;
  std::size_t backs = 0;
  for (const Fix& fix : fixes) {
    if (watch.take(fix, Frame::kMetres)) ++backs;
  }
  return backs;
}

TEST(Excursions, OfMotionCaptureAreFoundFromTheFixBeforeToTheOneBehind) {
  const auto fixes = circling({0, -3, 0}, 6.2);
  const auto found = excursions(fixes, Frame::kMetres);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LE(fixes[found[0].before].time_s, 5.0);
  EXPECT_GT(fixes[found[0].before + 1].time_s, 5.0);
  EXPECT_LT(fixes[found[0].behind - 1].time_s, 6.2);
  EXPECT_GE(fixes[found[0].behind].time_s, 6.2);
  EXPECT_EQ(found[0].leaps, (std::vector<std::size_t>{found[0].before + 1, found[0].behind}));
  EXPECT_EQ(watched(fixes), 1u);
  // Of one fix alone, of heights, and for long.
  EXPECT_EQ(excursions(circling({5, 0, 0}, 5.01), Frame::kMetres).size(), 1u);
  EXPECT_EQ(excursions(circling({0, 0, 30}, 6.2), Frame::kMetres).size(), 1u);
  EXPECT_EQ(excursions(circling({60, 0, 0}, 9.5), Frame::kMetres).size(), 1u);
}

TEST(Excursions, AreNoneWithoutThem) {
  EXPECT_TRUE(excursions(circling({}, 6.0), Frame::kMetres).empty());
  EXPECT_EQ(watched(circling({}, 6.0)), 0u);
  // As far as noise and a dart lead.
  EXPECT_TRUE(excursions(circling({0.4, 0, 0}, 5.01), Frame::kMetres).empty());
  // Set down elsewhere, and not back.
  EXPECT_TRUE(excursions(circling({3, 0, 0}, 99.0), Frame::kMetres).empty());
  // From one second to the next it can be ten metres away.
  EXPECT_TRUE(excursions(circling({10, 0, 0}, 7.0, 1.0), Frame::kMetres).empty());
}

// Fish rest, dart off for some tenths of a second, and turn round: 30 pictures a second.
TEST(Excursions, DartsOfFishAreNone) {
  std::vector<Fix> fixes;
  double at_m = 0.0;
  for (int i = 0; i < 900; ++i) {
    const int phase = i % 150;
    const double speed_mps = phase < 3 ? 2.0 : phase < 6 ? -2.0 : 0.01;
    at_m += speed_mps / 30.0;
    fixes.push_back({i / 30.0, {at_m, 0, 0}});
  }
  EXPECT_TRUE(excursions(fixes, Frame::kMetres).empty());
  EXPECT_EQ(watched(fixes), 0u);
}

// Written 20 times a second, known once a second: no step of 15 m takes a twentieth of one.
TEST(Excursions, HeldPlacesLeadToNone) {
  std::vector<Fix> fixes;
  for (int i = 0; i < 6000; ++i) {
    const int second = i / 20;
    const bool away = second % 60 == 30;
    fixes.push_back({i / 20.0, {second * 0.1 + (away ? 15.0 : 0.0), 0, 0}});
  }
  EXPECT_TRUE(excursions(fixes, Frame::kMetres).empty());
  EXPECT_EQ(watched(fixes), 0u);
}

// An episode of a simulator ends, and the agent is put back to where it began.
TEST(Excursions, BeginningAnewIsNone) {
  std::vector<Fix> fixes;
  for (int i = 0; i < 600; ++i) fixes.push_back({i / 20.0, {(i % 200) * 0.05, 0, 0}});
  EXPECT_TRUE(excursions(fixes, Frame::kMetres).empty());
  EXPECT_EQ(watched(fixes), 0u);
}

TEST(Excursions, ThatAreManyAreHowItMoves) {
  std::vector<Fix> fixes;
  for (int i = 0; i < 400; ++i)
    fixes.push_back({i / 20.0, {i * 0.01 + (i % 10 == 0 ? 9.0 : 0.0), 0, 0}});
  EXPECT_TRUE(excursions(fixes, Frame::kMetres).empty());
}

}  // namespace
}  // namespace beespace::io
