// Positions in few bits: the error is never larger than stated.
#include "report/quantised.hpp"

#include "tests/support/rounds.hpp"
#include "tests/support/scene_maker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace beespace::report {
namespace {

using test::rounds;
using test::SceneMaker;

// The decoded position i.
Point decoded(const Quantised& all, std::size_t i) {
  const auto along = [&](std::size_t axis) {
    return all.low_m[axis] + all.step_m[axis] * double{static_cast<double>(all.codes[axis][i])};
  };
  return {along(0), along(1), along(2)};
}

double far_from(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

double largest_coordinate(const std::vector<Point>& points) {
  double largest = 0.0;
  for (const Point& p : points) {
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return largest;
}

// The error is an upper bound, at most what the steps explain, and the ends are exact except for
// rounding.
void expect_good(const std::vector<Point>& points, unsigned bits) {
  const Quantised all = quantised(points, bits);
  const double rounding_m =
      4.0 * std::numeric_limits<double>::epsilon() * largest_coordinate(points);
  const unsigned most = (1u << bits) - 1u;
  for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_EQ(all.codes[axis].size(), points.size());
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) ASSERT_LE(all.codes[axis][i], most);
    farthest_m = std::max(farthest_m, far_from(points[i], decoded(all, i)));
  }
  EXPECT_LE(farthest_m, all.error_m * (1.0 + 1e-14)) << bits << " bits";
  const double half_a_step_m = 0.5 * std::hypot(all.step_m[0], all.step_m[1], all.step_m[2]);
  EXPECT_LE(all.error_m, half_a_step_m * (1.0 + 1e-12) + 2.0 * rounding_m) << bits << " bits";
}

void expect_ends(const std::vector<Point>& points, unsigned bits) {
  const Quantised all = quantised(points, bits);
  const std::uint16_t most = static_cast<std::uint16_t>((1u << bits) - 1u);
  constexpr std::array<double Point::*, 3> kAxes = {&Point::x, &Point::y, &Point::z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto along = [&](const Point& a, const Point& b) {
      return a.*kAxes[axis] < b.*kAxes[axis];
    };
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), along);
    const double low_m = (*low).*kAxes[axis];
    const double high_m = (*high).*kAxes[axis];
    EXPECT_EQ(all.low_m[axis], low_m);
    EXPECT_NEAR(all.low_m[axis] + all.step_m[axis] * most, high_m,
                4.0 * std::numeric_limits<double>::epsilon() * largest_coordinate(points));
    const auto code = [&](auto at) {
      return all.codes[axis][static_cast<std::size_t>(at - points.begin())];
    };
    EXPECT_EQ(code(low), 0);
    EXPECT_EQ(code(high), low_m < high_m ? most : 0);
  }
}

TEST(Quantised, TheErrorIsAnUpperBoundAndHalfAStepAtMost) {
  SceneMaker make(1);
  for (int round = 0; round < rounds(400); ++round) {
    const double size_m = std::pow(10.0, make.between(-6.0, 7.0));
    const double flat_m = make.below(3) == 0 ? 0.0 : size_m;
    const auto points = make.ragged_box(1 + make.below(200), {-size_m, 0.0, 0.0},
                                        {size_m, make.between(0.1, 1.0) * size_m, flat_m});
    for (const unsigned bits : {1u, 2u, 15u, 16u}) {
      expect_good(points, bits);
      expect_ends(points, bits);
    }
  }
}

TEST(Quantised, FarFromTheOriginTheErrorHoldsTheRoundingToo) {
  SceneMaker make(2);
  for (int round = 0; round < rounds(200); ++round) {
    auto points = make.ragged_box(100, {0, 0, 0}, {1e-5, 1e-6, 1.0});
    for (Point& p : points) p = test::shifted(p, {1e9, -1e9, 1e9});
    for (const unsigned bits : {1u, 15u, 16u}) expect_good(points, bits);
  }
}

TEST(Quantised, OnePointIsWhereItIs) {
  for (const unsigned bits : {1u, 15u, 16u}) {
    const std::vector<Point> one = {{0.1, -7e8, 1e-300}};
    const Quantised all = quantised(one, bits);
    EXPECT_EQ(decoded(all, 0), one.front());
    EXPECT_EQ(all.error_m, 0.0);
  }
}

TEST(Quantised, ThoseAtOnePlaceAreWhereTheyAre) {
  const std::vector<Point> points(100, Point{0.1, -0.2, 1e9});
  const Quantised all = quantised(points, 16);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(decoded(all, i), points[i]);
  EXPECT_EQ(all.error_m, 0.0);
}

TEST(Quantised, NoPositionsAreNothing) {
  const Quantised all = quantised({}, 16);
  EXPECT_TRUE(all.codes[0].empty() && all.codes[1].empty() && all.codes[2].empty());
  EXPECT_EQ(all.error_m, 0.0);
}

TEST(Quantised, TwoBitsHaveFourPlaces) {
  const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}, {6, 0, 0}};
  const Quantised all = quantised(points, 2);
  EXPECT_EQ(all.codes[0], (std::vector<std::uint16_t>{0, 1, 2, 3}));  // half a step goes up
  EXPECT_EQ(all.step_m[0], 2.0);
  EXPECT_EQ(all.error_m, 1.0);
}

TEST(Quantised, TheWholeDomainFits) {
  const double huge = kLargestCoordinate_m;
  const double tiny = kSmallestCoordinate_m;
  for (const unsigned bits : {1u, 15u, 16u}) {
    expect_good({{-huge, huge, 0}, {huge, -huge, 0}, {0, 0, 0}}, bits);
    expect_good({{-tiny, tiny, 0}, {tiny, -tiny, 0}, {0, 0, 0}}, bits);
    expect_good({{1.0, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}}, bits);
  }
}

}  // namespace
}  // namespace beespace::report
