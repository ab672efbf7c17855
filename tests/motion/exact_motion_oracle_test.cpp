// The oracle itself: against results by hand, and against many sampled instants.
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/encounter_maker.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

namespace beespace::test {
namespace {

PredictOptions options_of(double threshold, double horizon, std::optional<double> vertical = {},
                          bool inclusive = false) {
  PredictOptions options;
  options.threshold_m = threshold;
  options.horizon_s = horizon;
  options.vertical_m = vertical;
  options.inclusive = inclusive;
  return options;
}

constexpr Mover kStill{{0, 0, 0}, {0, 0, 0}};

TEST(ExactMotionOracle, DoublesBecomeFractionsWithoutLoss) {
  EXPECT_EQ(Fraction(0.1) * Fraction(0x1p+55), Fraction(3'602'879'701'896'397));
  EXPECT_EQ(Fraction(0x1p-100) * Fraction(0x1p+100), Fraction(1));
  EXPECT_EQ(wide(Fraction(1) / 3) * 3, Wide(1));
}

TEST(ExactMotionOracle, AGrazeIsAConflictOnlyInclusively) {
  const Mover passing{{-8, 5, 0}, {2, 0, 0}};
  const auto witness = [&](double threshold, bool inclusive) {
    return ExactEncounter(kStill, passing, options_of(threshold, 10, {}, inclusive)).witness();
  };
  EXPECT_FALSE(witness(5, false));
  EXPECT_EQ(witness(5, true), Fraction(4));
  EXPECT_TRUE(witness(std::nextafter(5.0, 6.0), false));
  EXPECT_FALSE(witness(std::nextafter(5.0, 4.0), true));
}

TEST(ExactMotionOracle, ACylinderRequiresBothAtTheSameTime) {
  // Falls through heights 2 to -2 from 1 s to 5 s, and is within 3 m from 6 s on.
  const Mover falling{{9, 0, 3}, {-1, 0, -1}};
  EXPECT_FALSE(ExactEncounter(kStill, falling, options_of(3, 60, 2.0)).in_conflict());
  EXPECT_FALSE(ExactEncounter(kStill, falling, options_of(4, 60, 2.0)).in_conflict());
  EXPECT_EQ(ExactEncounter(kStill, falling, options_of(4, 60, 2.0, true)).witness(), Fraction(5));
  // From 5 s less a quarter on: the oracle finds an instant inside, where both are strict.
  const ExactEncounter both(kStill, falling, options_of(4.25, 60, 2.0));
  ASSERT_TRUE(both.in_conflict());
  EXPECT_GT(*both.witness(), Fraction(4.75));
  EXPECT_LT(*both.witness(), Fraction(5));
  EXPECT_EQ(both.conflict_span(), (std::pair<Wide, Wide>(4.75, 5)));
}

TEST(ExactMotionOracle, TimesAndDistancesAreThoseOfTheTriangle) {
  const Mover passing{{-40, 3, 0}, {8, 0, 0}};
  const ExactEncounter e(kStill, passing, options_of(5, 60));
  EXPECT_EQ(e.closest_time(), Fraction(5));
  EXPECT_EQ(e.squared_distance(5), Fraction(9));
  EXPECT_EQ(e.conflict_span(), (std::pair<Wide, Wide>(4.5, 5.5)));
}

// A witness is checked by the definition; so is its absence, at instants that split the lattice's
// own times into many parts.
TEST(ExactMotionOracle, NoInstantContradictsIt) {
  EncounterMaker make(11);
  int conflicts = 0;
  for (int round = 0; round < rounds(1500); ++round) {
    const Encounter e = make.on_lattice();
    const ExactEncounter exact(e.first, e.second, e.options);
    if (const auto witness = exact.witness()) {
      ++conflicts;
      ASSERT_GE(*witness, 0) << e;
      ASSERT_LE(*witness, Fraction(e.options.horizon_s)) << e;
      ASSERT_TRUE(exact.too_close_at(*witness)) << e;
      continue;
    }
    constexpr int kParts = 120;
    for (int part = 0; part <= kParts; ++part) {
      ASSERT_FALSE(exact.too_close_at(Fraction(e.options.horizon_s) * part / kParts)) << e;
    }
  }
  EXPECT_GT(conflicts, rounds(300));
}

}  // namespace
}  // namespace beespace::test
