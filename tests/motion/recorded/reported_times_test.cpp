// Reported times and distances, compared with fractions.
//
// With u = 2^-53: the components of r and w are differences of doubles, so each has a relative
// error of u. All that is computed from them has an error of a few u of its terms: |r|, the
// threshold, and |w| times the time, which is at most |r| until the two are closest and about |r| +
// X until they are apart. So distances are right to within 2^-48 of |r| + X: 32 u, of which less
// than 5 have been seen. Begin and end are judged by the distance at the reported instant: it
// equals the threshold to within that. (The instants themselves are less accurate: where a pair
// only grazes, a last bit of the threshold is half the digits of the time.)
#include "tests/support/encounter_maker.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/brute_force.hpp>
#include <beespace/closest_approach.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using test::Encounter;
using test::EncounterMaker;
using test::ExactEncounter;
using test::Fraction;
using test::rounds;

// Whether `squared`, of a length, is that of one from low to high.
bool squared_is_between(const Fraction& squared, const Fraction& low, const Fraction& high) {
  return (low <= 0 || squared >= low * low) && high >= 0 && squared <= high * high;
}

class Report {
 public:
  explicit Report(const Encounter& e) : e_(e), exact_(e.first, e.second, e.options) {
    constexpr double kShare = 0x1p-48;
    const Point& p = e.first.position;
    const Point& q = e.second.position;
    const double apart = std::hypot(q.x - p.x, q.y - p.y, q.z - p.z) * (1.0 + 0x1p-40);
    slack_ = Fraction(apart * kShare);
    level_slack_ = Fraction((apart + e.options.threshold_m) * kShare);
    const double vertical = e.options.vertical_m.value_or(0.0);
    height_slack_ = Fraction((std::abs(q.z - p.z) * (1.0 + 0x1p-40) + vertical) * kShare);
  }

  // Of closest_approach, which looks at all of [0, horizon].
  void expect_true(const Approach& approach) const {
    const Fraction truly = exact_.closest_time();
    const Fraction off = Fraction(approach.closest_s) - truly;
    EXPECT_TRUE(squared_is_between(off * off * exact_.squared_speed(), 0, slack_))
        << "closest at " << approach.closest_s;
    expect_distance(approach.closest_m, truly);
    EXPECT_GE(approach.closest_s, 0.0);
    EXPECT_LE(approach.closest_s, e_.options.horizon_s);
    if (!approach.conflict) return;
    expect_true(*approach.conflict);
    if (e_.options.vertical_m) return;
    EXPECT_LE(approach.conflict->begins_s, approach.closest_s);
    EXPECT_LE(approach.closest_s, approach.conflict->ends_s);
  }

  // Of a prediction, where the closest instant is one of the conflict.
  void expect_true(const Conflict& conflict) const {
    expect_true(TimeSpan{conflict.begins_s, conflict.ends_s});
    EXPECT_LE(conflict.begins_s, conflict.closest_s);
    EXPECT_LE(conflict.closest_s, conflict.ends_s);
    expect_distance(conflict.closest_m, Fraction(conflict.closest_s));
    expect_distance(conflict.closest_m,
                    exact_.closest_time({Fraction(conflict.begins_s), Fraction(conflict.ends_s)}));
  }

 private:
  void expect_true(const TimeSpan& span) const {
    EXPECT_GE(span.begins_s, 0.0);
    EXPECT_LE(span.begins_s, span.ends_s);
    EXPECT_LE(span.ends_s, e_.options.horizon_s);
    for (const double end : {span.begins_s, span.ends_s}) {
      EXPECT_FALSE(is_outside(Fraction(end))) << end << " is no time of conflict";
    }
    EXPECT_TRUE(span.begins_s == 0.0 || !is_inside(Fraction(span.begins_s)))
        << "begins before " << span.begins_s;
    EXPECT_TRUE(span.ends_s == e_.options.horizon_s || !is_inside(Fraction(span.ends_s)))
        << "ends after " << span.ends_s;
    // What lies deep in the conflict lies in the span.
    const Fraction witness = *exact_.witness();
    if (is_inside(witness)) {
      EXPECT_LE(Fraction(span.begins_s), witness);
      EXPECT_GE(Fraction(span.ends_s), witness);
    }
  }

  // Too far away, or too close, by more than rounding explains.
  [[nodiscard]] bool is_outside(const Fraction& time) const {
    const Fraction most = Fraction(e_.options.threshold_m) + level_slack_;
    if (!squared_is_between(exact_.squared_level_distance(time), 0, most)) return true;
    return e_.options.vertical_m &&
           exact_.height_difference(time) > Fraction(*e_.options.vertical_m) + height_slack_;
  }
  [[nodiscard]] bool is_inside(const Fraction& time) const {
    const Fraction most = Fraction(e_.options.threshold_m) - level_slack_;
    if (!squared_is_between(exact_.squared_level_distance(time), 0, most)) return false;
    return !e_.options.vertical_m ||
           exact_.height_difference(time) < Fraction(*e_.options.vertical_m) - height_slack_;
  }

  void expect_distance(double reported, const Fraction& time) const {
    // Until the end of a conflict they have moved as far as they were apart, and the threshold.
    const Fraction& slack = e_.options.vertical_m ? level_slack_ + height_slack_ : slack_;
    EXPECT_TRUE(squared_is_between(exact_.squared_distance(time), Fraction(reported) - slack,
                                   Fraction(reported) + slack))
        << "not " << reported << " m away at " << time.convert_to<double>();
  }

  const Encounter& e_;
  ExactEncounter exact_;
  Fraction slack_;
  Fraction level_slack_;
  Fraction height_slack_;
};

class ReportedTimes : public testing::Test {
 protected:
  void expect_true(const Encounter& e) {
    std::ostringstream shown;
    shown << e;
    SCOPED_TRACE(shown.str());
    const Report report(e);
    const Approach approach = *closest_approach(e.first, e.second, e.options.approach());
    report.expect_true(approach);
    const std::vector<Mover> movers = {e.first, e.second};
    const auto conflicts = *brute_force::predict_conflicts(movers, e.options);
    ASSERT_EQ(conflicts.size(), approach.conflict ? 1U : 0U);
    if (!conflicts.empty()) {
      ++conflicts_;
      report.expect_true(conflicts[0]);
      EXPECT_EQ((TimeSpan{conflicts[0].begins_s, conflicts[0].ends_s}), *approach.conflict);
    }
    const Approach swapped = *closest_approach(e.second, e.first, e.options.approach());
    EXPECT_EQ(swapped.closest_s, approach.closest_s);
    EXPECT_EQ(swapped.closest_m, approach.closest_m);
    EXPECT_EQ(swapped.conflict, approach.conflict);
    if (HasFailure()) FAIL() << "and no more of these";
  }

  int conflicts_ = 0;
};

TEST_F(ReportedTimes, AreTrueOnALatticeAndBesideIt) {
  EncounterMaker make(21);
  for (int round = 0; round < rounds(4000) && !HasFatalFailure(); ++round) {
    const Encounter e = make.on_lattice();
    expect_true(round % 2 == 0 ? e : make.nudged(e));
  }
  EXPECT_GT(conflicts_, rounds(900));
}

TEST_F(ReportedTimes, AreTrueForRandomDoublesNearAndFarFromTheOrigin) {
  EncounterMaker make(22);
  for (int round = 0; round < rounds(4000) && !HasFatalFailure(); ++round) {
    const Encounter e = make.ragged();
    expect_true(round % 2 == 0 ? e : make.moved(e, {1e9, -1e9, 1e9}));
  }
  EXPECT_GT(conflicts_, rounds(900));
}

TEST_F(ReportedTimes, AreTrueAtAllMagnitudes) {
  EncounterMaker make(23);
  for (int round = 0; round < rounds(2000) && !HasFatalFailure(); ++round) {
    expect_true(make.of_any_magnitude());
    if (!HasFatalFailure()) expect_true(make.nudged(make.rescaled(make.on_lattice())));
  }
  EXPECT_GT(conflicts_, rounds(900));
}

// Just about at the threshold and moving almost around each other: here the square of the chord is
// what rounding leaves of two numbers that are almost the same.
TEST_F(ReportedTimes, AreTrueWhereTheyCircleAtTheThreshold) {
  EncounterMaker make(24);
  test::SceneMaker& random = make.random();
  for (int round = 0; round < rounds(4000) && !HasFatalFailure(); ++round) {
    const double x = random.between(1, 2);
    const double y = random.between(1, 2);
    // Any angle to the tangent, and often one whose square is about a last bit.
    const auto bits = static_cast<int>(round % 2 == 0 ? random.below(70) : 24 + random.below(6));
    const double out = std::ldexp(random.between(-1, 1), -bits);
    Encounter e{{}, {{x, y, 0}, {out * x - y, out * y + x, 0}}, {}};
    e.options.threshold_m = std::hypot(x, y);
    const double towards = random.below(2) == 0 ? 9.0 : 0.0;
    for (std::size_t ulps = random.below(3); ulps > 0; --ulps) {
      e.options.threshold_m = std::nextafter(e.options.threshold_m, towards);
    }
    e.options.horizon_s = 1e6;
    e.options.inclusive = random.below(2) == 0;
    if (random.below(3) == 0) e.options.vertical_m = 1.0;
    expect_true(e);
  }
  EXPECT_GT(conflicts_, rounds(900));
}

// The horizontal threshold is grazed, where a last bit of it is half the digits of the time, just
// when the height is left. The reported instant satisfies both, not one that is 1e-8 m too high.
TEST_F(ReportedTimes, AreTrueWhereAGrazedCylinderIsLeftInHeight) {
  Encounter e{{{-0x1.02a632b4365fcp+3, -0x1.b018c301843c4p+3, -0x1.5d07b0478f8b7p+4},
               {-0x1.b0ce1e0d6941cp-11, 0x1.eace1a5a1d8a8p-10, -0x1.720c370722492p-11}},
              {{-0x1.3de03bee6e3d7p+3, -0x1.b018c301843c4p+3, -0x1.6dfa1daaaf656p+4},
               {0x1.0d87e7108c7a8p-7, 0x1.244318b594f6ep-5, -0x1.049ab4339f8cap-4}},
              {}};
  e.options.threshold_m = 0x1.c9b12de74328ep+0;
  e.options.vertical_m = 0x1.eb7a7912cbb36p+0;
  e.options.inclusive = true;
  e.options.horizon_s = 0x1.4e1546120ff7dp+5;
  expect_true(e);
  EXPECT_EQ(conflicts_, 1);
}

// The reverse: heights hardly change, and the horizontal threshold is grazed at one instant.
TEST_F(ReportedTimes, AreTrueWhereHeightsHardlyChange) {
  Encounter e{{{0, 0, 0}, {}}, {{-8, 5, 0x1.fffffffffffffp+1}, {1, 0, 0x1p-52}}, {}};
  e.options.threshold_m = 5.0;
  e.options.vertical_m = 4.0;
  e.options.inclusive = true;
  e.options.horizon_s = 60.0;
  expect_true(e);  // on the level at 8 s, in height until 2 s
  EXPECT_EQ(conflicts_, 0);
  e.second.velocity.z = 0x1p-55;  // until 16 s
  expect_true(e);
  EXPECT_EQ(conflicts_, 1);
}

}  // namespace
}  // namespace beespace
