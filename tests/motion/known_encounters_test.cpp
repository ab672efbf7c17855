// Encounters that are constructed from the time and distance of the closest approach, so the right
// answer is known. And the limits: now, never, the horizon, no horizon at all.
#include <beespace/brute_force.hpp>
#include <beespace/closest_approach.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

PredictOptions options_of(double threshold, double horizon, bool inclusive = false) {
  PredictOptions options;
  options.threshold_m = threshold;
  options.horizon_s = horizon;
  options.inclusive = inclusive;
  return options;
}

PredictOptions cylinder(double threshold, double vertical, double horizon, bool inclusive = false) {
  PredictOptions options = options_of(threshold, horizon, inclusive);
  options.vertical_m = vertical;
  return options;
}

Approach approach_of(const Mover& first, const Mover& second, const PredictOptions& options) {
  return *closest_approach(first, second, options.approach());
}
const Mover kStill{{0, 0, 0}, {0, 0, 0}};

// Directions at right angles, each of length 9.
constexpr Point kAxes[] = {{1, 4, 8}, {4, 7, -4}, {8, -4, 1}};

Point combined(const Point& a, double times_a, const Point& b, double times_b) {
  return {a.x * times_a + b.x * times_b, a.y * times_a + b.y * times_b,
          a.z * times_a + b.z * times_b};
}

// Whatever is computed of a handful of doubles that are exact.
void expect_about(double found, double truly) {
  EXPECT_LE(std::abs(found - truly), 0x1p-50 * std::abs(truly)) << found << " is not " << truly;
}

// Threshold 45 units, closest 27, so half of the way inside is 36 units long. Of few bits, all of
// it.
struct Plan {
  double unit;
  double speed;      // in lengths of `along`
  double closest_s;  // a whole number of times that it takes to cross 36 units, or nearly so
  int axes;
};

void expect_as_planned(const Plan& plan) {
  const Point& along = kAxes[plan.axes % 3];
  const Point& aside = kAxes[(plan.axes + 1 + plan.axes / 3) % 3];
  const double half_s = 4.0 * plan.unit / plan.speed;
  const Point r = combined(along, -plan.speed * plan.closest_s, aside, 3.0 * plan.unit);
  const Point v = combined(along, plan.speed, aside, 0.0);
  const Mover first{{5 * plan.unit, -plan.unit, 0}, {}};
  const Mover second{{5 * plan.unit + r.x, r.y - plan.unit, r.z}, {v.x, v.y, v.z}};
  const PredictOptions options = options_of(45.0 * plan.unit, 2.0 * plan.closest_s + half_s);
  const auto found = approach_of(first, second, options);
  expect_about(found.closest_s, plan.closest_s);
  expect_about(found.closest_m, 27.0 * plan.unit);
  ASSERT_TRUE(found.conflict.has_value());
  expect_about(found.conflict->begins_s, plan.closest_s - half_s);
  expect_about(found.conflict->ends_s, plan.closest_s + half_s);
}

TEST(KnownEncounter, ReportsTheTimesAndTheDistanceThatItWasBuiltFrom) {
  for (const double unit : {0x1p-40, 0.25, 1.0, 0x1p+30}) {
    for (const double speed : {0x1p-20, 0.5, 3.0, 700.0}) {
      for (const double crossings : {2.0, 12.5, 4096.0}) {
        const double crossing_s = std::exp2(std::ceil(std::log2(4.0 * unit / speed)));
        for (int axes = 0; axes < 6; ++axes) {
          expect_as_planned({unit, speed, crossings * crossing_s, axes});
        }
      }
    }
  }
}

TEST(KnownEncounter, AlreadyTooCloseBeginsNowAndEndsWhenTheyAreClear) {
  // 2 m ahead at 0.5 m/s: 5 m away after 6 s.
  const auto found = approach_of(kStill, {{2, 0, 0}, {0.5, 0, 0}}, options_of(5, 60));
  EXPECT_EQ(found.closest_s, 0.0);
  EXPECT_EQ(found.closest_m, 2.0);
  EXPECT_EQ(found.conflict, (TimeSpan{0, 6}));
  // First nearer: through the middle after 2 s, clear after 7.
  const auto nearer = approach_of(kStill, {{2, 0, 0}, {-1, 0, 0}}, options_of(5, 60));
  EXPECT_EQ(nearer.closest_s, 2.0);
  EXPECT_EQ(nearer.closest_m, 0.0);
  EXPECT_EQ(nearer.conflict, (TimeSpan{0, 7}));
}

TEST(KnownEncounter, MoversThatSeparateAreClosestNow) {
  const auto found = approach_of(kStill, {{6, 0, 0}, {0.5, 3, 0}}, options_of(5, 60));
  EXPECT_EQ(found.closest_s, 0.0);
  EXPECT_EQ(found.closest_m, 6.0);
  EXPECT_FALSE(found.conflict.has_value());
}

TEST(KnownEncounter, EndsAtTheHorizonWhileTheyAreStillTooClose) {
  const Mover coming{{10, 0, 0}, {-1, 0, 0}};
  const auto found = approach_of(kStill, coming, options_of(4, 8));
  EXPECT_EQ(found.closest_s, 8.0);
  EXPECT_EQ(found.closest_m, 2.0);
  EXPECT_EQ(found.conflict, (TimeSpan{6, 8}));
  const auto too_early = approach_of(kStill, coming, options_of(4, 5));
  EXPECT_EQ(too_early.closest_s, 5.0);
  EXPECT_EQ(too_early.closest_m, 5.0);
  EXPECT_FALSE(too_early.conflict.has_value());
}

TEST(KnownEncounter, OfTheSameVelocityLastsAllTheTimeOrNever) {
  const Velocity v{1e3, -2, 7};
  const Mover first{{0, 0, 0}, v};
  const Mover second{{3, 4, 0}, v};
  const auto never = approach_of(first, second, options_of(5, 60));
  EXPECT_EQ(never.closest_s, 0.0);
  EXPECT_EQ(never.closest_m, 5.0);
  EXPECT_FALSE(never.conflict.has_value());
  const PredictOptions more = options_of(std::nextafter(5.0, 6.0), 60);
  EXPECT_EQ(approach_of(first, second, more).conflict, (TimeSpan{0, 60}));
  EXPECT_EQ(approach_of(first, second, options_of(5, 60, true)).conflict, (TimeSpan{0, 60}));
}

TEST(KnownEncounter, WithoutAHorizonIsWhatIsTrueNow) {
  const Mover leaving{{3, 4, 0}, {1, 1, 1}};
  const auto found = approach_of(kStill, leaving, options_of(6, 0));
  EXPECT_EQ(found.closest_s, 0.0);
  EXPECT_EQ(found.closest_m, 5.0);
  EXPECT_EQ(found.conflict, (TimeSpan{0, 0}));
  EXPECT_FALSE(approach_of(kStill, leaving, options_of(5, 0)).conflict.has_value());
  EXPECT_EQ(approach_of(kStill, leaving, options_of(5, 0, true)).conflict, (TimeSpan{0, 0}));
}

TEST(KnownEncounter, ASingleInstantOfContactHasBothEndsInIt) {
  // Passes at exactly 5 m after 4 s.
  const Mover passing{{-8, 5, 0}, {2, 0, 0}};
  EXPECT_FALSE(approach_of(kStill, passing, options_of(5, 60)).conflict.has_value());
  const auto grazing = approach_of(kStill, passing, options_of(5, 60, true));
  EXPECT_EQ(grazing.conflict, (TimeSpan{4, 4}));
  EXPECT_EQ(grazing.closest_s, 4.0);
  EXPECT_EQ(grazing.closest_m, 5.0);
  // Is at exactly 5 m now, and leaves.
  const auto leaving = approach_of(kStill, {{5, 0, 0}, {1, 0, 0}}, options_of(5, 60, true));
  EXPECT_EQ(leaving.conflict, (TimeSpan{0, 0}));
  // Is at exactly 5 m now, and passes by on a tangent.
  const auto tangent = approach_of(kStill, {{5, 0, 0}, {0, 1, 0}}, options_of(5, 60, true));
  EXPECT_EQ(tangent.conflict, (TimeSpan{0, 0}));
  // Comes to exactly 5 m at the horizon.
  const auto touching = approach_of(kStill, {{9, 0, 0}, {-1, 0, 0}}, options_of(5, 4, true));
  EXPECT_EQ(touching.conflict, (TimeSpan{4, 4}));
}

TEST(KnownEncounter, AtTheSamePlaceIsAtDistanceZero) {
  const Mover mover{{1e9, -1e9, 7}, {3, 2, 1}};
  const auto found = approach_of(mover, mover, options_of(1e-9, 60));
  EXPECT_EQ(found.closest_s, 0.0);
  EXPECT_EQ(found.closest_m, 0.0);
  EXPECT_EQ(found.conflict, (TimeSpan{0, 60}));
}

TEST(KnownEncounter, OfACylinderLastsWhileBothAreBelow) {
  // Within 4 m horizontally from 6 s to 14 s, within 2 m in height from 8 s to 12 s.
  const Mover crossing{{10, 0, 10}, {-1, 0, -1}};
  const auto found = approach_of(kStill, crossing, cylinder(4, 2, 60));
  EXPECT_EQ(found.conflict, (TimeSpan{8, 12}));
  EXPECT_EQ(found.closest_s, 10.0);
  EXPECT_EQ(found.closest_m, 0.0);
  const auto wide = approach_of(kStill, crossing, cylinder(1, 2, 60));
  EXPECT_EQ(wide.conflict, (TimeSpan{9, 11}));
  // One after the other is no conflict: at 6 m in height when it is at 4 m horizontally.
  const Mover apart{{10, 0, 2}, {-1, 0, 1}};
  EXPECT_FALSE(approach_of(kStill, apart, cylinder(4, 6, 60)).conflict.has_value());
  EXPECT_FALSE(approach_of(kStill, apart, cylinder(4, 8, 60)).conflict.has_value());
  EXPECT_EQ(approach_of(kStill, apart, cylinder(4, 8, 60, true)).conflict, (TimeSpan{6, 6}));
  const auto just = cylinder(4, std::nextafter(8.0, kInfinity), 60);
  EXPECT_TRUE(approach_of(kStill, apart, just).conflict.has_value());
}

// A prediction gives the closest approach during the conflict; an approach gives that of all times.
TEST(KnownEncounter, OfACylinderIsClosestWithinTheConflictInAPrediction) {
  // Closest at 20 s, 30 m apart, 1 m beside it; at the same height until 10 s.
  const std::vector<Mover> movers = {kStill, {{1, 0, -40}, {0, 0, 2}}};
  const PredictOptions options = cylinder(3, 20, 15);
  const std::vector<Conflict> found = *brute_force::predict_conflicts(movers, options);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].begins_s, 10.0);
  EXPECT_EQ(found[0].ends_s, 15.0);
  EXPECT_EQ(found[0].closest_s, 15.0);
  EXPECT_EQ(found[0].closest_m, std::sqrt(101.0));
}

}  // namespace
}  // namespace beespace
