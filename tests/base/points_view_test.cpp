// One answer for every layout of the same points.
#include "tests/support/search_scenes.hpp"

#include <beespace/at_risk.hpp>
#include <beespace/nearest.hpp>

#include <gtest/gtest.h>

#include <array>
#include <span>
#include <vector>

namespace beespace {
namespace {

class Layouts : public testing::Test {
 protected:
  Layouts() : points_(test::SceneMaker(3).box(1200, {0, 0, 0}, {600, 500, 400})) {}

  void expect_same(const PointsView& view) {
    ASSERT_EQ(view.size(), points_.size());
    EXPECT_EQ(*find_at_risk(view, {40.0}), *find_at_risk(points_, {40.0}));
    const auto pair = **find_closest_pair(view);
    const auto expected = **find_closest_pair(points_);
    EXPECT_EQ(pair.first, expected.first);
    EXPECT_EQ(pair.second, expected.second);
    EXPECT_EQ(pair.distance_m, expected.distance_m);
  }

  std::vector<Point> points_;
};

TEST_F(Layouts, SpanOfPoints) {
  expect_same(std::span<const Point>(points_));
}

TEST_F(Layouts, InterleavedDoubles) {
  std::vector<double> xyz;
  for (const Point& p : points_) xyz.insert(xyz.end(), {p.x, p.y, p.z});
  expect_same(PointsView::interleaved(xyz));
}

TEST_F(Layouts, SeparateArrays) {
  std::array<std::vector<double>, 3> axes;
  for (const Point& p : points_) {
    axes[0].push_back(p.x);
    axes[1].push_back(p.y);
    axes[2].push_back(p.z);
  }
  expect_same(PointsView::separate(axes[0], axes[1], axes[2]));
}

TEST_F(Layouts, MembersOfALargerStructure) {
  struct Bee {
    int number;
    double height;
    double east;
    double north;
    float battery;
  };
  std::vector<Bee> bees;
  for (const Point& p : points_) bees.push_back({1, p.z, p.x, p.y, 0.5F});
  expect_same(PointsView::strided(&bees[0].east, &bees[0].north, &bees[0].height, bees.size(),
                                  sizeof(Bee)));
}

TEST_F(Layouts, BackwardsWithANegativeStride) {
  const std::vector<Point> reversed(points_.rbegin(), points_.rend());
  const Point& last = reversed.back();
  expect_same(PointsView::strided(&last.x, &last.y, &last.z, reversed.size(),
                                  -static_cast<std::ptrdiff_t>(sizeof(Point))));
}

TEST_F(Layouts, AConstantHeightWithAStrideOfZero) {
  const double height = 120.0;
  for (Point& p : points_) p.z = height;
  expect_same(PointsView::strided({&points_[0].x, &points_[0].y, &height}, points_.size(),
                                  {sizeof(Point), sizeof(Point), 0}));
}

TEST(PointsView, IsEmptyByDefaultAndForNoPoints) {
  EXPECT_TRUE(PointsView().empty());
  EXPECT_TRUE(PointsView(std::vector<Point>{}).empty());
  EXPECT_EQ(find_at_risk(PointsView(), {1.0}).value().size(), 0U);
}

// Arrays that do not fit together are never read beyond their ends, and are an error of every
// query.
TEST(PointsView, RemembersThatItsArraysDoNotFitTogether) {
  const std::vector<double> xyz = {1, 2, 3, 4, 5};
  const std::vector<double> x = {1, 2, 3};
  const std::vector<double> y = {1, 2};
  const std::vector<double> z = {1};
  EXPECT_TRUE(PointsView::separate(x, x, x).fits());
  EXPECT_TRUE(PointsView::interleaved(std::span(xyz).first(3)).fits());
  for (const PointsView& view : {PointsView::interleaved(xyz), PointsView::separate(x, y, z)}) {
    EXPECT_EQ(view.size(), 1U);
    EXPECT_FALSE(view.fits());
  }
  const auto refused = find_at_risk(PointsView::separate(x, y, z), {.threshold_m = 100.0});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(refused.error().message,
            "3 numbers for x, 2 for y and 1 for z; give as many for each axis");
}

}  // namespace
}  // namespace beespace
