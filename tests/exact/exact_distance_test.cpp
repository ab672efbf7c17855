// Every decision against rational arithmetic, where rounding does not exist.
#include "exact/exact_distance.hpp"

#include <boost/multiprecision/cpp_int.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace beespace::core {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational squared(const Point& p, const Point& q) {
  const auto square = [](double a, double b) {
    const Rational difference = Rational(a) - Rational(b);
    return Rational(difference * difference);
  };
  return square(p.x, q.x) + square(p.y, q.y) + square(p.z, q.z);
}

int sign_of(const Rational& value) {
  return value.sign();
}

class RandomPoints {
 public:
  explicit RandomPoints(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  // Bits all over: differences of such numbers do not round nicely.
  Point point(double scale) {
    const auto coordinate = [&] {
      return between(-1, 1) * scale * (1.0 + between(0, 1) * 0x1p-30);
    };
    return {coordinate(), coordinate(), coordinate()};
  }

 private:
  std::mt19937 random_;
};

TEST(CompareExactly, AgreesWithRationalsNearTheThreshold) {
  RandomPoints random(1);
  int ties_or_ulps = 0;
  for (int i = 0; i < 4000; ++i) {
    const double scale = std::ldexp(1.0, i % 80 - 40);
    const Point p = random.point(scale);
    const Point q = random.point(scale);
    const double near = std::sqrt(squared_distance(p, q));
    double distance = near;
    for (int step = 0; step < i % 4; ++step) distance = std::nextafter(distance, 0.0);
    const Rational exact = squared(p, q) - Rational(distance) * Rational(distance);
    ASSERT_EQ(compare_exactly(p, q, distance), sign_of(exact)) << i;
    ties_or_ulps += i % 4 < 2 ? 1 : 0;
  }
  EXPECT_GT(ties_or_ulps, 1000);
}

TEST(CompareExactly, SeesWhatADoubleCannotHold) {
  // 1 + 2^-200 is beyond a double, but not beyond two points.
  const Point p = {1.0, 0, 0};
  const Point q = {-0x1p-200, 0, 0};
  EXPECT_EQ(compare_exactly(p, q, 1.0), 1);
  EXPECT_EQ(compare_exactly(p, {0x1p-200, 0, 0}, 1.0), -1);
  EXPECT_EQ(compare_exactly(p, {0.0, 0, 0}, 1.0), 0);
  // And where leading terms cancel between axes.
  EXPECT_EQ(compare_exactly({3, 4, 0x1p-300}, {0, 0, 0}, 5.0), 1);
}

// Below some 2^-98 of the square, two doubles do not tell any more.
TEST(CompareExactly, AgreesWithRationalsWhereTwoDoublesAreNotEnough) {
  RandomPoints random(5);
  for (int i = 0; i < 4000; ++i) {
    // |p - q|^2 - 25 is about 6 tiny, or exactly 0; the terms of the axes cancel.
    const double tiny = std::ldexp(random.between(-1, 1), -(40 + i % 90));
    const Point p = {3.0, 4.0, std::ldexp(random.between(-1, 1), -(20 + i % 37))};
    const Point q = {i % 5 == 0 ? 0.0 : -tiny, i % 7 == 0 ? 0.0 : 0.75 * tiny,
                     i % 3 == 0 ? 0.0 : p.z};
    ASSERT_EQ(compare_exactly(p, q, 5.0), sign_of(squared(p, q) - 25)) << i;
  }
}

TEST(CompareExactly, HoldsAtBothEndsOfTheDomain) {
  for (const double unit : {kSmallestCoordinate_m, kLargestCoordinate_m / 16.0}) {
    EXPECT_EQ(compare_exactly({3 * unit, 4 * unit, 12 * unit}, {0, 0, 0}, 13 * unit), 0);
    const double more = std::nextafter(12 * unit, 16 * unit);
    const double less = std::nextafter(12 * unit, 0.0);
    EXPECT_EQ(compare_exactly({3 * unit, 4 * unit, more}, {0, 0, 0}, 13 * unit), 1);
    EXPECT_EQ(compare_exactly({3 * unit, 4 * unit, less}, {0, 0, 0}, 13 * unit), -1);
  }
  // Both ends in one comparison.
  EXPECT_EQ(compare_exactly({kLargestCoordinate_m, 0, 0}, {kSmallestCoordinate_m, 0, 0},
                            kLargestCoordinate_m),
            -1);
}

TEST(CompareDistances, AgreesWithRationals) {
  RandomPoints random(2);
  for (int i = 0; i < 3000; ++i) {
    const Point p = random.point(100.0);
    const Point q = random.point(100.0);
    // A second pair as far apart as doubles allow, turned by swapping axes.
    Point r = {p.y, p.z, p.x};
    Point s = {q.y, q.z, q.x};
    if (i % 3 == 1) r.x = std::nextafter(r.x, 1e9);
    if (i % 3 == 2) s = random.point(100.0);
    const Rational exact = squared(p, q) - squared(r, s);
    ASSERT_EQ(compare_distances(p, q, r, s), sign_of(exact)) << i;
    ASSERT_EQ(compare_distances(r, s, p, q), -sign_of(exact)) << i;
  }
}

TEST(ProximityTest, AgreesWithRationalsAtTheThresholdAndOneUlpEitherSide) {
  RandomPoints random(3);
  for (int i = 0; i < 3000; ++i) {
    const Point p = random.point(1000.0);
    const Point q = random.point(1000.0);
    const double near = std::sqrt(squared_distance(p, q));
    for (const double threshold :
         {near, std::nextafter(near, 0.0), std::nextafter(near, 1e9), near * 0.5, near * 2.0}) {
      const int sign = sign_of(squared(p, q) - Rational(threshold) * Rational(threshold));
      ASSERT_EQ(ProximityTest(threshold, false)(p, q), sign < 0);
      ASSERT_EQ(ProximityTest(threshold, true)(p, q), sign <= 0);
    }
  }
}

// The bound that all filters rest on: 5 roundings, relative to the exact square.
TEST(SquaredDistance, StaysWithinItsProvenBound) {
  RandomPoints random(4);
  const Rational bound = Rational(5) * Rational(0x1p-53);
  for (int i = 0; i < 3000; ++i) {
    const Point p = random.point(1e6);
    const Point q = random.point(i % 2 == 0 ? 1e6 : 1e-3);
    const Rational exact = squared(p, q);
    const Rational error = abs(Rational(squared_distance(p, q)) - exact);
    ASSERT_LE(error, exact * bound * Rational(1001, 1000)) << i;
  }
}

}  // namespace
}  // namespace beespace::core
