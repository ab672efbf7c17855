// A double and how wrong it may be: the truth, in fractions, is never outside.
#include "exact/bounded_number.hpp"

#include "tests/motion/random_formula.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::motion {
namespace {

using test::Fraction;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Tally {
  int known = 0;
  int unknown = 0;
};

// The doubles that a number is compared with: on either side of the truth, from the nearest ones to
// some 2^20 ulps away. If the truth were outside of the bounds, one of those between would show it.
void expect_true_comparisons(const BoundedNumber& number, const Fraction& truly, int seed,
                             Tally& tally) {
  const auto nearest = truly.convert_to<double>();
  if (!std::isfinite(nearest)) return;
  for (double ulps = 0.0; ulps < 0x1p+20; ulps = 1.5 * ulps + 0.5) {
    for (const double side : {-1.0, 1.0}) {
      const double step = std::nextafter(std::abs(nearest), kInfinity) - std::abs(nearest);
      const double other = nearest + side * std::floor(ulps) * step;
      if (!std::isfinite(other)) continue;
      const std::optional<int> sign = (number - BoundedNumber(other)).sign();
      ++(sign ? tally.known : tally.unknown);
      if (!sign) continue;
      ASSERT_EQ(*sign, Fraction(truly - Fraction(other)).sign()) << "formula " << seed;
    }
  }
}

TEST(BoundedNumber, NeverComparesWrongly) {
  Tally tally;
  for (int seed = 0; seed < test::rounds(12'000) && !testing::Test::HasFatalFailure(); ++seed) {
    const test::RandomFormula formula(static_cast<std::uint32_t>(seed), seed % 2 == 0 ? 4 : 30);
    expect_true_comparisons(formula.value<BoundedNumber>(), formula.value<Fraction>(), seed, tally);
  }
  EXPECT_GT(tally.known, test::rounds(200'000));
  EXPECT_GT(tally.unknown, test::rounds(20'000));
}

TEST(BoundedNumber, NeverComparesWronglyWhereNumbersOverflowOrUnderflow) {
  Tally tally;
  for (int seed = 0; seed < test::rounds(3000) && !testing::Test::HasFatalFailure(); ++seed) {
    const test::RandomFormula formula(static_cast<std::uint32_t>(seed), 480);
    const auto number = formula.value<BoundedNumber>();
    const auto truly = formula.value<Fraction>();
    const std::optional<int> sign = number.sign();
    ++(sign ? tally.known : tally.unknown);
    if (sign) {
      ASSERT_EQ(*sign, truly.sign()) << "formula " << seed;
    }
    expect_true_comparisons(number, truly, seed, tally);
  }
  EXPECT_GT(tally.unknown, test::rounds(1000));
  EXPECT_GT(tally.known, test::rounds(1000));
}

TEST(BoundedNumber, KnowsSignsThatRoundingLeavesNoDoubtAbout) {
  const BoundedNumber tenth(0.1);
  EXPECT_EQ((tenth * tenth - BoundedNumber(0.1 * 0.1)).sign(), std::nullopt);
  EXPECT_EQ((tenth * tenth - BoundedNumber(0.01 * (1.0 - 0x1p-48))).sign(), 1);
  EXPECT_EQ((tenth * tenth - BoundedNumber(0.01 * (1.0 + 0x1p-48))).sign(), -1);
  EXPECT_EQ((tenth - tenth).sign(), 0);
  EXPECT_EQ(BoundedNumber(0.0).sign(), 0);
  EXPECT_EQ((-tenth).sign(), -1);
}

TEST(BoundedNumber, HasNoSignAfterAnOverflow) {
  const BoundedNumber huge(0x1p+600);
  const BoundedNumber square = huge * huge;
  EXPECT_EQ(square.sign(), std::nullopt);
  EXPECT_EQ((-square).sign(), std::nullopt);
  EXPECT_EQ((square - square).sign(), std::nullopt);
  // Zero times anything.
  EXPECT_EQ((square * BoundedNumber(0.0)).sign(), 0);
  EXPECT_EQ((BoundedNumber(1.0) + square).sign(), std::nullopt);
}

TEST(BoundedNumber, HasNoSignWhereTooSmallForADouble) {
  const BoundedNumber tiny(0x1p-600);
  EXPECT_EQ((tiny * tiny).sign(), std::nullopt);
  EXPECT_EQ((tiny * tiny * BoundedNumber(0x1p+900)).sign(), std::nullopt);
  EXPECT_EQ((-(tiny * tiny)).sign(), std::nullopt);
  EXPECT_EQ((tiny * tiny + tiny).sign(), 1);
}

}  // namespace
}  // namespace beespace::motion
