// Numbers without rounding, against fractions of any size.
#include "exact/exact_number.hpp"

#include "tests/motion/random_formula.hpp"
#include "tests/support/exact_motion_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace beespace::motion {
namespace {

using test::Fraction;

// A number only shows its sign. So the expected value is subtracted, 53 bits at a time, the highest
// first, and the sign of the rest must be right until nothing is left.
void expect_equal(ExactNumber number, Fraction truly, int seed) {
  for (int parts = 0; parts < 1000; ++parts) {
    ASSERT_EQ(*number.sign(), truly.sign()) << "formula " << seed << " less " << parts << " parts";
    if (truly == 0) return;
    const auto part = truly.convert_to<double>();
    ASSERT_TRUE(part != 0.0 && std::isfinite(part));
    number = number - ExactNumber(part);
    truly -= Fraction(part);
  }
  FAIL() << "formula " << seed << " has no end";
}

TEST(ExactNumber, IsWhatFractionsSayOfRandomFormulas) {
  int zeros = 0;
  int compared = 0;
  for (int seed = 0; seed < test::rounds(20'000) && !testing::Test::HasFatalFailure(); ++seed) {
    const test::RandomFormula formula(static_cast<std::uint32_t>(seed), seed % 2 == 0 ? 9 : 40);
    const auto truly = formula.value<Fraction>();
    // Up to 2^6 factors: what leaves the range of doubles could not be taken off.
    const Fraction size = abs(truly);
    if (size > Fraction(0x1p+900) || msb(denominator(truly)) > 1000) continue;
    ++compared;
    if (truly == 0) ++zeros;
    expect_equal(formula.value<ExactNumber>(), truly, seed);
  }
  EXPECT_GT(zeros, test::rounds(500));
  EXPECT_GT(compared, test::rounds(15'000));
}

TEST(ExactNumber, KnowsTheSignWhereDoublesOverflowAndUnderflow) {
  for (int seed = 0; seed < test::rounds(4000); ++seed) {
    const test::RandomFormula formula(static_cast<std::uint32_t>(seed), 900);
    ASSERT_EQ(*formula.value<ExactNumber>().sign(), formula.value<Fraction>().sign()) << seed;
  }
}

TEST(ExactNumber, TakesEveryPowerOfTwoAndItsNeighbours) {
  for (int exponent = -1074; exponent <= 1023; ++exponent) {
    const double power = std::ldexp(1.0, exponent);
    const ExactNumber number(power);
    ASSERT_EQ(*number.sign(), 1);
    ASSERT_EQ(*(-number).sign(), -1);
    ASSERT_EQ(*(number * ExactNumber(std::ldexp(1.0, -exponent / 2)) *
                    ExactNumber(std::ldexp(1.0, exponent / 2 - exponent)) -
                ExactNumber(1.0))
                   .sign(),
              0)
        << exponent;
    const double above = std::nextafter(power, std::numeric_limits<double>::max());
    const double below = std::nextafter(power, 0.0);
    ASSERT_EQ(*(number - ExactNumber(above)).sign(), exponent == 1023 && above == power ? 0 : -1);
    ASSERT_EQ(*(number - ExactNumber(below)).sign(), 1);
    // An ulp is the same from a to b as from b to a.
    ASSERT_EQ(*((number - ExactNumber(above)) + (ExactNumber(above) - number)).sign(), 0);
  }
}

TEST(ExactNumber, HasOneZero) {
  const ExactNumber zero;
  for (const ExactNumber& also :
       {ExactNumber(0.0), ExactNumber(-0.0), -zero, ExactNumber(3.0) - ExactNumber(3.0),
        zero * ExactNumber(-7.0), ExactNumber(-7.0) * zero, ExactNumber(0x1p-1074) * zero}) {
    EXPECT_EQ(*also.sign(), 0);
    EXPECT_EQ(*(also + zero).sign(), 0);
    EXPECT_EQ(*(zero - also).sign(), 0);
    EXPECT_EQ(*(also + ExactNumber(-2.0)).sign(), -1);
    EXPECT_EQ(*(also - ExactNumber(-2.0)).sign(), 1);
  }
}

// Carries and borrows that run through everything: (2^k - 1) + 1 and 2^k - 1, of many digits.
TEST(ExactNumber, CarriesAndBorrowsThroughAllDigits) {
  ExactNumber ones;  // 2^530 - 1
  ExactNumber power(1.0);
  const double chunk = 0x1p+53 - 1.0;
  for (int digits = 0; digits < 10; ++digits) {
    ones = ones + ExactNumber(chunk) * power;
    power = power * ExactNumber(0x1p+53);
    ASSERT_EQ(*(ones + ExactNumber(1.0) - power).sign(), 0) << digits;
    ASSERT_EQ(*(power - ExactNumber(1.0) - ones).sign(), 0) << digits;
    ASSERT_EQ(*(ones - power).sign(), -1) << digits;
    // (2^k - 1)^2 = 2^2k - 2^(k+1) + 1
    const ExactNumber square = power * power - power - power + ExactNumber(1.0);
    ASSERT_EQ(*(ones * ones - square).sign(), 0) << digits;
    ASSERT_EQ(*(ones * -ones + square).sign(), 0) << digits;
  }
}

}  // namespace
}  // namespace beespace::motion
