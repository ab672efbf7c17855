// The errors of an Index.
#include "tests/index/index_scenes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace beespace {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(IndexErrors, PointsOutsideTheDomainAreNamed) {
  const auto index = Index::build(std::vector<Point>{{1, 2, 3}, {1, kNaN, 3}});
  ASSERT_FALSE(index.has_value());
  EXPECT_EQ(index.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(index.error().location.record, 1U);
  const auto far = Index::build(std::vector<Point>{{1, 2, 0x1p+401}});
  ASSERT_FALSE(far.has_value());
  EXPECT_EQ(far.error().code, ErrorCode::kOutsideDomain);
}

TEST(IndexErrors, RadiiThatAreNoneAreRefused) {
  const Index index = test::built({{1, 2, 3}});
  for (const double radius : {-1.0, kNaN, kInfinity, 0x1p-401, 0x1p+401}) {
    const auto found = index.find_around({1, 2, 3}, radius);
    ASSERT_FALSE(found.has_value()) << radius;
    EXPECT_EQ(found.error().code, ErrorCode::kInvalidThreshold);
    EXPECT_FALSE(index.find_around(std::vector<Point>{{1, 2, 3}}, {radius}).has_value()) << radius;
  }
}

TEST(IndexErrors, PlacesOutsideTheDomainAreRefusedAndNamedAmongMany) {
  const Index index = test::built({{1, 2, 3}});
  EXPECT_EQ(index.find_around({kNaN, 0, 0}, 1.0).error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(index.k_nearest({0, 0, 0x1p-401}, 1).error().code, ErrorCode::kOutsideDomain);
  EXPECT_FALSE(index.k_nearest({kNaN, 0, 0}, 1).error().location.record.has_value());
  const std::vector<Point> places{{0, 0, 0}, {0, 0, 0}, {0, kInfinity, 0}};
  const auto around = index.find_around(places, {1.0});
  ASSERT_FALSE(around.has_value());
  EXPECT_EQ(around.error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(around.error().location.record, 2U);
  const auto nearest = index.k_nearest(places, 1);
  ASSERT_FALSE(nearest.has_value());
  EXPECT_EQ(nearest.error().location.record, 2U);
}

TEST(IndexErrors, MoreResultsThanAllowedAreRefused) {
  const Index index = test::built(std::vector<Point>(10, Point{1, 2, 3}));
  const std::vector<Point> places(3, Point{1, 2, 3});
  AroundOptions options{1.0};
  options.max_results = 30;
  EXPECT_TRUE(index.find_around(places, options).has_value());
  options.max_results = 29;
  const auto found = index.find_around(places, options);
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::kTooManyResults);
}

TEST(IndexErrors, UnknownIdsAreRefused) {
  Index index = test::built({{1, 2, 3}, {4, 5, 6}});
  ASSERT_TRUE(index.remove(0).has_value());
  for (const PointId id : {0U, 2U, Nearest::kNone}) {
    EXPECT_FALSE(index.contains(id));
    EXPECT_EQ(index.point(id).error().code, ErrorCode::kInvalidArgument) << id;
    EXPECT_EQ(index.move(id, {1, 1, 1}).error().code, ErrorCode::kInvalidArgument) << id;
    EXPECT_EQ(index.remove(id).error().code, ErrorCode::kInvalidArgument) << id;
  }
  EXPECT_EQ(index.size(), 1U);
}

TEST(IndexErrors, ChangesToPlacesOutsideTheDomainLeaveAllAsItWas) {
  Index index = test::built({{1, 2, 3}});
  EXPECT_EQ(index.insert({kNaN, 0, 0}).error().code, ErrorCode::kNotFinite);
  EXPECT_EQ(index.move(0, {0, 0, 0x1p+401}).error().code, ErrorCode::kOutsideDomain);
  EXPECT_EQ(index.size(), 1U);
  EXPECT_EQ(*index.point(0), (Point{1, 2, 3}));
  EXPECT_EQ(*index.insert({1, 2, 3}), 1U);
}

}  // namespace
}  // namespace beespace
