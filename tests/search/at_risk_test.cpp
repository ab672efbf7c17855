// The guarantees for points at risk, case by case.
#include "tests/support/search_scenes.hpp"

#include <beespace/at_risk.hpp>
#include <beespace/brute_force.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace beespace {
namespace {

using Ids = std::vector<PointId>;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The paper: "all 26 adjacent cubes are empty, but there is a bee in the following layer". With
// cubes of diagonal 100 m (side 57.735 m) these two are two cubes apart and 60 m from each other.
TEST(AtRisk, NeighbourTwoLayersAwayIsFound) {
  const double side = 100.0 / std::sqrt(3.0);
  const std::vector<Point> points = {{side - 1.0, 10, 10}, {2.0 * side + 1.0, 10, 10}};
  EXPECT_EQ(std::floor(points[1].x / side) - std::floor(points[0].x / side), 2.0);
  EXPECT_EQ(*find_at_risk(points, {100.0}), (Ids{0, 1}));
}

TEST(AtRisk, OutlierTenToTheTwelveThresholdsAwayHidesNoPoint) {
  const double x = 100.0;
  const std::vector<Point> points = {
      {0, 0, 0}, {0.999 * x, 0, 0}, {5 * x, 0, 0}, {6.001 * x, 0, 0}, {1e12 * x, 1e12 * x, 0}};
  EXPECT_EQ(*find_at_risk(points, {x}), (Ids{0, 1}));
}

TEST(AtRisk, PointsABillionMetresApartWithAThresholdOfOneMetre) {
  const std::vector<Point> points = {
      {-1e9, 0, 0}, {-1e9 + 0.5, 0, 0}, {1e9, 1e9, 1e9}, {1e9, 1e9, 1e9 + 1.5}, {0, 0, 0}};
  EXPECT_EQ(*find_at_risk(points, {1.0}), (Ids{0, 1}));
}

TEST(AtRisk, DuplicatesAreAtRisk) {
  EXPECT_EQ(*find_at_risk(std::vector<Point>{{1, 1, 1}, {9, 9, 9}, {1, 1, 1}}, {1e-6}),
            (Ids{0, 2}));
}

TEST(AtRisk, NothingIsCapped) {
  const std::vector<Point> crowd(100'000, Point{3, 3, 3});
  EXPECT_EQ(find_at_risk(crowd, {1.0}).value().size(), crowd.size());
}

TEST(AtRisk, StrictByDefaultAndInclusiveOnRequest) {
  const std::vector<Point> points = {{0, 0, 0}, {100, 0, 0}};
  EXPECT_EQ(*find_at_risk(points, {100.0}), Ids{});
  EXPECT_EQ(*find_at_risk(points, {100.0, true}), (Ids{0, 1}));
}

TEST(AtRisk, OneUlpDecides) {
  const double closer = std::nextafter(100.0, 0.0);
  const double farther = std::nextafter(100.0, 200.0);
  EXPECT_EQ(find_at_risk(std::vector<Point>{{0, 0, 0}, {closer, 0, 0}}, {100.0}).value().size(),
            2U);
  EXPECT_EQ(
      find_at_risk(std::vector<Point>{{0, 0, 0}, {farther, 0, 0}}, {100.0, true}).value().size(),
      0U);
}

TEST(AtRisk, DecidesOnTheGivenDoublesNotOnTheDecimals) {
  const std::vector<Point> points = {{0.1, 0, 0}, {0.3, 0, 0}};
  // Exactly: 0.3 - 0.1 = 0.1999999999999999833..., and the double 0.2 is 0.200000000000000011...
  EXPECT_EQ(find_at_risk(points, {0.2}).value().size(), 2U);
}

TEST(AtRisk, DoesNotDependOnTheOrderOfThePoints) {
  test::SceneMaker make(99);
  std::vector<Point> points = make.box(4000, {0, 0, 0}, {1000, 1000, 1000});
  const Ids before = *find_at_risk(points, {60.0});
  std::reverse(points.begin(), points.end());
  Ids after = *find_at_risk(points, {60.0});
  for (PointId& id : after) id = static_cast<PointId>(points.size()) - 1 - id;
  std::reverse(after.begin(), after.end());
  EXPECT_EQ(after, before);
  EXPECT_FALSE(before.empty());
  EXPECT_LT(before.size(), points.size());
}

TEST(AtRisk, GrowsWithTheThreshold) {
  test::SceneMaker make(5);
  const std::vector<Point> points = make.box(3000, {0, 0, 0}, {1000, 1000, 1000});
  Ids smaller;
  for (double threshold = 5.0; threshold < 300.0; threshold *= 1.3) {
    const Ids larger = *find_at_risk(points, {threshold});
    EXPECT_TRUE(std::includes(larger.begin(), larger.end(), smaller.begin(), smaller.end()));
    smaller = larger;
  }
  EXPECT_EQ(smaller.size(), points.size());
}

class InvalidThreshold : public testing::TestWithParam<double> {};

TEST_P(InvalidThreshold, IsAnErrorForEverySearch) {
  const std::vector<Point> points = {{0, 0, 0}};
  EXPECT_EQ(find_at_risk(points, {GetParam()}).error().code, ErrorCode::kInvalidThreshold);
  EXPECT_EQ(brute_force::find_at_risk(points, {GetParam()}).error().code,
            ErrorCode::kInvalidThreshold);
  EXPECT_EQ(find_nearest_within(points, {GetParam()}).error().code, ErrorCode::kInvalidThreshold);
}
INSTANTIATE_TEST_SUITE_P(Values, InvalidThreshold,
                         testing::Values(0.0, -1.0, kNan, kInfinity, -kInfinity, 1e-200, 1e200));

TEST(AtRisk, CoordinatesThatAreNotFiniteAreErrorsWithTheirPlace) {
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    std::vector<Point> points(20'000, Point{1, 2, 3});
    points[12'345].y = bad;
    points[15'000].x = bad;
    for (const unsigned threads : {1U, 3U}) {
      const auto result = find_at_risk(points, {100.0, false, threads});
      ASSERT_FALSE(result.has_value());
      EXPECT_EQ(result.error().code, ErrorCode::kNotFinite);
      EXPECT_EQ(result.error().location.record, 12'345U);
      EXPECT_NE(result.error().message.find("y is"), std::string::npos);
    }
    EXPECT_EQ(find_closest_pair(points).error().code, ErrorCode::kNotFinite);
    EXPECT_EQ(find_nearest_within(points, {100.0}).error().code, ErrorCode::kNotFinite);
  }
}

TEST(AtRisk, TheCoordinateDomainIsCheckedAtBothEnds) {
  const auto code_for = [](double coordinate) {
    return find_at_risk(std::vector<Point>{{0, 0, 0}, {0, 0, coordinate}}, {1.0});
  };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_TRUE(code_for(sign * kLargestCoordinate_m).has_value());
    EXPECT_TRUE(code_for(sign * kSmallestCoordinate_m).has_value());
    const double above = std::nextafter(kLargestCoordinate_m, kInfinity);
    const double below = std::nextafter(kSmallestCoordinate_m, 0.0);
    EXPECT_EQ(code_for(sign * above).error().code, ErrorCode::kOutsideDomain);
    EXPECT_EQ(code_for(sign * below).error().code, ErrorCode::kOutsideDomain);
    EXPECT_EQ(code_for(sign * below).error().location.record, 1U);
  }
}

TEST(AtRisk, MorePointsThanIdsIsAnError) {
  const double zero = 0.0;
  const auto view = PointsView::strided(&zero, &zero, &zero, std::size_t{1} << 32, 0);
  EXPECT_EQ(find_at_risk(view, {100.0}).error().code, ErrorCode::kTooManyPoints);
}

// Larger than one crew member's minimum, so that threads really share the work.
TEST(AtRisk, SameAnswerForOneToEightThreads) {
  test::SceneMaker make(7);
  for (const double threshold : {30.0, 68.0, 400.0}) {
    const std::vector<Point> points = make.box(100'000, {0, 0, 0}, {4000, 4000, 4000});
    const auto one = find_at_risk(points, {threshold, false, 1});
    ASSERT_TRUE(one.has_value());
    for (unsigned threads = 2; threads <= 8; ++threads) {
      EXPECT_EQ(*find_at_risk(points, {threshold, false, threads}), *one) << threads;
    }
  }
}

TEST(AtRisk, EqualsBruteForceOnManyRandomSwarms) {
  for (std::uint32_t seed = 0; seed < 200; ++seed) {
    test::SceneMaker make(seed);
    const double side = make.between(1.0, 1000.0);
    const std::vector<Point> points =
        make.box(150, {-side, -side, 0.0}, {side, side, make.between(0.0, side)});
    const SearchOptions options{make.between(0.001, 0.4) * side, seed % 2 == 0, seed % 3};
    EXPECT_EQ(*find_at_risk(points, options), *brute_force::find_at_risk(points, options)) << seed;
  }
}

}  // namespace
}  // namespace beespace
