// Curves against each other and against limits, where the answer is known by hand: exactly the
// threshold, a bit of it less, corners, peaks between ends.
#include <beespace/verify_path.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace beespace {
namespace {

constexpr TimeSpan kAlways{-1e9, 1e9};

BezierPath line(double begins_s, const Point& from, double ends_s, const Point& to) {
  return {begins_s, from, {{ends_s, to, {}, 0}}};
}

// A cubic of numbers that are no short binary ones.
BezierPath bow(double x) {
  return {0.1, {x, 0.1, 0.7}, {{3.7, {x, 7.3, 9.1}, {{{x, 0.3, 3.3}, {x, 8.1, 8.7}}}, 2}}};
}

PathEncounter encounter(const BezierPath& first, const BezierPath& second, double threshold_m,
                        const TimeSpan& during = kAlways) {
  const auto found = closest_on_paths(first, second, during, threshold_m);
  EXPECT_TRUE(found && *found);
  return found && *found ? **found : PathEncounter{};
}

TEST(ClosestOnPaths, ExactlyTheThresholdIsNotCloserAndOneUlpMoreIs) {
  const PathEncounter kept = encounter(bow(1.5), bow(6.5), 5.0);
  EXPECT_FALSE(kept.closer);
  EXPECT_LE(kept.closest_m, 5.0);
  EXPECT_NEAR(kept.closest_m, 5.0, 1e-8);
  EXPECT_TRUE(encounter(bow(1.5), bow(6.5), std::nextafter(5.0, 6.0)).closer);
}

TEST(ClosestOnPaths, WindowsThatDoNotFitTogetherAreAsExact) {
  // The same way in thirds and in one.
  const BezierPath whole = line(0.0, {0, 0, 0}, 3.0, {9, 0, 0});
  const BezierPath thirds{
      0.0, {0, 4, 0}, {{1.0, {3, 4, 0}, {}, 0}, {2.0, {6, 4, 0}, {}, 0}, {3.0, {9, 4, 0}, {}, 0}}};
  EXPECT_FALSE(encounter(whole, thirds, 4.0).closer);
  EXPECT_TRUE(encounter(whole, thirds, std::nextafter(4.0, 5.0)).closer);
}

TEST(ClosestOnPaths, StraightLinesThatTouchTheThresholdAtAThirdOfTheTimeKeepIt) {
  // At 1 s of 3 they are right beside each other, 5 m apart.
  const BezierPath still = line(0.0, {1, 5, 0}, 3.0, {1, 5, 0});
  const BezierPath passing = line(0.0, {0, 0, 0}, 3.0, {3, 0, 0});
  const PathEncounter found = encounter(still, passing, 5.0);
  EXPECT_FALSE(found.closer);
  EXPECT_NEAR(found.closest_s, 1.0, 1e-3);
  EXPECT_TRUE(encounter(still, passing, std::nextafter(5.0, 6.0)).closer);
}

TEST(ClosestOnPaths, ADipBetweenSamplesIsFound) {
  // y = 40 s (1 - s) x 3/4 ...: a cubic that reaches three quarters of its controls.
  const BezierPath bowed{0.0, {0, 0, 0}, {{10.0, {0, 0, 0}, {{{0, 8, 0}, {0, 8, 0}}}, 2}}};
  const BezierPath still = line(0.0, {0, 10, 0}, 10.0, {0, 10, 0});
  const PathEncounter found = encounter(bowed, still, 4.5);
  EXPECT_TRUE(found.closer);
  EXPECT_NEAR(found.closest_m, 4.0, 1e-8);
  EXPECT_NEAR(found.closest_s, 5.0, 1e-3);
  EXPECT_FALSE(encounter(bowed, still, 4.0).closer);
}

TEST(ClosestOnPaths, OnlyTheTimeThatIsAskedForCounts) {
  const BezierPath first = line(0.0, {0, 0, 0}, 10.0, {10, 0, 0});
  const BezierPath second = line(0.0, {10, 0, 0}, 10.0, {0, 0, 0});
  EXPECT_NEAR(encounter(first, second, 1.0).closest_m, 0.0, 1e-8);
  EXPECT_NEAR(encounter(first, second, 1.0, {0.0, 2.0}).closest_m, 6.0, 1e-8);
  const auto apart = closest_on_paths(first, line(11.0, {0, 0, 0}, 12.0, {1, 0, 0}), kAlways, 1.0);
  ASSERT_TRUE(apart);
  EXPECT_FALSE(apart->has_value());
}

TEST(ClosestOnPaths, RefusesWhatItCannotComputeWith) {
  const BezierPath good = line(0.0, {0, 0, 0}, 1.0, {1, 0, 0});
  const auto code = [&](const BezierPath& path, double threshold_m) {
    const auto found = closest_on_paths(good, path, kAlways, threshold_m);
    return found ? std::optional<ErrorCode>() : found.error().code;
  };
  EXPECT_EQ(code(good, 0.0), ErrorCode::kInvalidThreshold);
  EXPECT_EQ(code(line(1.0, {}, 0.0, {}), 1.0), ErrorCode::kTimeOrder);
  EXPECT_EQ(code(line(0.0, {NAN, 0, 0}, 1.0, {}), 1.0), ErrorCode::kNotFinite);
}

PathCheck checked(const BezierPath& path, const PathLimits& limits = {}) {
  auto found = check_path(path, limits);
  EXPECT_TRUE(found);
  return found ? *std::move(found) : PathCheck{};
}

PathPeak peak(const PathCheck& check, PathLimit limit) {
  return check.peaks[static_cast<std::size_t>(limit)];
}

// From rest to rest, 10 m up and 6 m along in 4 s: 1.5 times the mean in the middle.
const BezierPath kLift{1.0, {0, 0, 0}, {{5.0, {6, 0, 10}, {{{0, 0, 0}, {6, 0, 10}}}, 2}}};

TEST(CheckPath, PeaksAreThoseOfTheCurve) {
  const PathCheck check = checked(kLift);
  EXPECT_NEAR(peak(check, PathLimit::kClimb).value, 3.75, 1e-8);
  EXPECT_GE(peak(check, PathLimit::kClimb).value, 3.75);
  EXPECT_NEAR(peak(check, PathLimit::kClimb).at_s, 3.0, 1e-3);
  EXPECT_NEAR(peak(check, PathLimit::kHorizontalSpeed).value, 2.25, 1e-8);
  EXPECT_NEAR(peak(check, PathLimit::kSpeed).value, std::hypot(3.75, 2.25), 1e-8);
  EXPECT_EQ(peak(check, PathLimit::kDescent).value, 0.0);
  EXPECT_EQ(peak(check, PathLimit::kHeight).value, 10.0);
  EXPECT_DOUBLE_EQ(peak(check, PathLimit::kAcceleration).value, std::hypot(6.0, 10.0) * 6.0 / 16.0);
}

TEST(CheckPath, AValueAtItsLimitIsWithinItAndALittleMoreIsNot) {
  PathLimits limits;
  limits[PathLimit::kClimb] = 3.75;
  EXPECT_TRUE(checked(kLift, limits).excesses.empty());
  limits[PathLimit::kClimb] = 3.75 * (1.0 - 3e-9);
  const PathCheck check = checked(kLift, limits);
  ASSERT_EQ(check.excesses.size(), 1u);
  EXPECT_EQ(check.excesses[0].limit, PathLimit::kClimb);
  EXPECT_EQ(check.excesses[0].begins_s, 1.0);
  EXPECT_EQ(check.excesses[0].ends_s, 5.0);
}

TEST(CheckPath, StretchesThatTouchAreOne) {
  const BezierPath zigzag{0.0,
                          {0, 0, 0},
                          {{1.0, {5, 0, 0}, {}, 0},
                           {2.0, {10, 0, 0}, {}, 0},
                           {3.0, {11, 0, 0}, {}, 0},
                           {4.0, {17, 0, 0}, {}, 0}}};
  PathLimits limits;
  limits[PathLimit::kHorizontalSpeed] = 4.0;
  const PathCheck check = checked(zigzag, limits);
  ASSERT_EQ(check.excesses.size(), 2u);
  EXPECT_EQ(check.excesses[0].ends_s, 2.0);
  EXPECT_EQ(check.excesses[0].peak.value, 5.0);
  EXPECT_EQ(check.excesses[1].begins_s, 3.0);
  EXPECT_EQ(check.excesses[1].peak.value, 6.0);
}

BezierPath turned(double first_mps, double first_s, double second_mps, double second_s) {
  const double there_m = first_mps * first_s;
  return {0.0,
          {0, 0, 0},
          {{first_s, {there_m, 0, 0}, {}, 0},
           {first_s + second_s, {there_m + second_mps * second_s, 0, 0}, {}, 0}}};
}

// 1 m/s one second, and -0.5 m/s for three: 1.5 m/s in the two seconds between their middles, in
// which the corner is cut by less than half a metre.
TEST(CheckPath, ACornerNeedsTheAccelerationThatTakesItWithinHalfOfBothPieces) {
  PathLimits limits;
  limits[PathLimit::kAcceleration] = 0.7;
  const PathCheck check = checked(turned(1.0, 1.0, -0.5, 3.0), limits);
  EXPECT_EQ(peak(check, PathLimit::kAcceleration).value, 0.75);
  EXPECT_TRUE(peak(check, PathLimit::kAcceleration).at_corner);
  ASSERT_EQ(check.excesses.size(), 1u);
  EXPECT_EQ(check.excesses[0].begins_s, 0.5);
  EXPECT_EQ(check.excesses[0].ends_s, 2.5);
  EXPECT_EQ(check.excesses[0].peak.at_s, 1.0);
}

// From 7 m/s to -7 m/s: in the 10 s between the middles a drone would leave its path by 17 m.
TEST(CheckPath, ACornerOfLongPiecesIsTakenNearThePath) {
  PathLimits limits;
  limits[PathLimit::kAcceleration] = 4.0;
  const PathCheck check = checked(turned(7.0, 10.0, -7.0, 10.0), limits);
  const double least_mps2 = 14.0 * 14.0 / (8.0 * kCornerDeviation_m);
  EXPECT_NEAR(peak(check, PathLimit::kAcceleration).value, least_mps2, 1e-9);
  ASSERT_EQ(check.excesses.size(), 1u);
  const double takes_s = 14.0 / least_mps2;
  EXPECT_NEAR(check.excesses[0].begins_s, 10.0 - 0.5 * takes_s, 1e-9);
  EXPECT_NEAR(check.excesses[0].ends_s, 10.0 + 0.5 * takes_s, 1e-9);
  EXPECT_TRUE(check.excesses[0].peak.at_corner);
}

// A circle of 20 m at 5 m/s accelerates by 1.25 m/s^2: chords that leave it by less than half a
// metre say so, as long as they are.
TEST(CheckPath, ASimplifiedCurveKeepsItsAcceleration) {
  for (const int chords : {12, 16, 48, 200}) {
    BezierPath circle{0.0, {20, 0, 0}, {}};
    for (int i = 1; i <= chords; ++i) {
      const double turn = 2.0 * 3.14159265358979 * i / chords;
      circle.pieces.push_back({20.0 / 5.0 * turn, {20 * std::cos(turn), 20 * std::sin(turn), 0}});
    }
    const double sagitta_m = 20.0 * (1.0 - std::cos(3.14159265358979 / chords));
    const double found = peak(checked(circle), PathLimit::kAcceleration).value;
    EXPECT_NEAR(found, 1.25, sagitta_m < kCornerDeviation_m ? 0.03 : 0.4) << chords;
  }
}

TEST(CheckPath, RefusesALimitBelowZeroAndNone) {
  PathLimits limits;
  limits[PathLimit::kHeight] = -1.0;
  const auto below = check_path(kLift, limits);
  ASSERT_FALSE(below);
  EXPECT_EQ(below.error().code, ErrorCode::kInvalidArgument);
  limits[PathLimit::kHeight] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(check_path(kLift, limits));
}

}  // namespace
}  // namespace beespace
