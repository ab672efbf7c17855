// When two are closer along their curves, where the answer is known by hand: hovering exactly the
// threshold apart is no conflict, and joins none.
#include "analysis/recorded/along_curves.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace beespace::analysis {
namespace {

constexpr Conflict kPossible{3, 7, 0.0, 6.0, 72.0, 1.7, true};

BezierPath lines(const Point& from, const std::vector<Fix>& to) {
  BezierPath path{0.0, from, {}};
  for (const Fix& fix : to) path.pieces.push_back({fix.time_s, fix.position, {}, 0});
  return path;
}

std::vector<Conflict> along(const BezierPath& first, const BezierPath& second, double threshold_m,
                            const Conflict& conflict = kPossible) {
  auto found = along_curves(conflict, {first}, {second}, threshold_m);
  EXPECT_TRUE(found);
  return found ? *found : std::vector<Conflict>{};
}

const BezierPath kStill = lines({0, 0, 10}, {{72.0, {0, 0, 10}}});

TEST(AlongCurves, HoveringExactlyTheThresholdApartIsNoConflict) {
  EXPECT_TRUE(along(kStill, lines({0.8, 0, 10}, {{72.0, {0.8, 0, 10}}}), 0.8).empty());
  EXPECT_EQ(
      along(kStill, lines({0.8, 0, 10}, {{72.0, {0.8, 0, 10}}}), std::nextafter(0.8, 1)).size(),
      1U);
}

TEST(AlongCurves, ADipBetweenTwoHoversLastsAsLongAsTheDip) {
  const auto found = along(
      kStill,
      lines({2, 0, 10}, {{5, {2, 0, 10}}, {6, {1.7, 0, 10}}, {7, {2, 0, 10}}, {72, {2, 0, 10}}}),
      2.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].first, 3U);
  EXPECT_EQ(found[0].second, 7U);
  EXPECT_NEAR(found[0].begins_s, 5.0, 1e-6);
  EXPECT_NEAR(found[0].ends_s, 7.0, 1e-6);
  EXPECT_NEAR(found[0].closest_m, 1.7, 1e-8);
  EXPECT_NEAR(found[0].closest_s, 6.0, 1e-6);
  EXPECT_TRUE(found[0].certain);
}

TEST(AlongCurves, DipsThatMeetExactlyAtTheThresholdAreTwo) {
  const auto dips = [](double between_m) {
    return lines({2, 0, 10}, {{5, {2, 0, 10}},
                              {6, {1.5, 0, 10}},
                              {7, {between_m, 0, 10}},
                              {8, {1.2, 0, 10}},
                              {9, {2, 0, 10}}});
  };
  const auto two = along(kStill, dips(2.0), 2.0);
  ASSERT_EQ(two.size(), 2U);
  EXPECT_NEAR(two[0].ends_s, 7.0, 1e-6);
  EXPECT_NEAR(two[1].begins_s, 7.0, 1e-6);
  const auto one = along(kStill, dips(std::nextafter(2.0, 1.0)), 2.0);
  ASSERT_EQ(one.size(), 1U);
  EXPECT_NEAR(one[0].begins_s, 5.0, 1e-6);
  EXPECT_NEAR(one[0].ends_s, 9.0, 1e-6);
  EXPECT_NEAR(one[0].closest_m, 1.2, 1e-8);
}

// Along x = 4 (2 t - 1)^2 in its time t of 0 to 1, from piece to piece of the other.
TEST(AlongCurves, ACurveIsCloserBetweenTheRootsOfItsDistance) {
  const BezierPath bow{10.0, {4, 0, 10}, {{20.0, {4, 0, 10}, {{{-4, 0, 10}}}, 1}}};
  const BezierPath still =
      lines({0, 0, 10}, {{12, {0, 0, 10}}, {15.5, {0, 0, 10}}, {72, {0, 0, 10}}});
  const auto found = along(still, bow, 1.0);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].begins_s, 12.5, 1e-6);
  EXPECT_LE(found[0].begins_s, 12.5);
  EXPECT_NEAR(found[0].ends_s, 17.5, 1e-6);
  EXPECT_GE(found[0].ends_s, 17.5);
  EXPECT_NEAR(found[0].closest_m, 0.0, 1e-8);
}

TEST(AlongCurves, OnlyTheTimeOfTheConflictIsLookedAt) {
  const BezierPath near = lines({1, 0, 10}, {{72, {1, 0, 10}}});
  const auto found = along(kStill, near, 2.0, {0, 1, 20.0, 25.0, 30.0, 1.0, true});
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].begins_s, 20.0);
  EXPECT_EQ(found[0].ends_s, 30.0);
}

TEST(AlongCurves, WhereTheTwoAreNotThereTogetherTheConflictStays) {
  const BezierPath later{80.0, {0, 0, 10}, {{90.0, {0, 0, 10}, {}, 0}}};
  EXPECT_EQ(along(kStill, later, 2.0), std::vector{kPossible});
  Conflict possible = kPossible;
  possible.certain = false;
  EXPECT_EQ(along(kStill, later, 2.0, possible), std::vector{possible});
}

}  // namespace
}  // namespace beespace::analysis
