#include "grid/density.hpp"

#include "tests/support/own_resources.hpp"
#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace beespace::core {
namespace {

std::vector<Point> crowd_in_wide_space() {
  test::SceneMaker make(6);
  std::vector<Point> points = make.box(50'000, {0, 0, 0}, {1e6, 1e6, 1e6});
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] = {5.5, 5.5, 5.5};
  return points;
}

TEST(DensitySample, IsAboutRightForUniformPoints) {
  test::SceneMaker make(6);
  Memory memory;
  const std::vector<Point> points = make.box(200'000, {0, 0, 0}, {100, 100, 100});
  const DensitySample sample(points, memory);
  EXPECT_NEAR(sample.expected_neighbors(10.0), 200.0, 20.0);
  EXPECT_NEAR(sample.expected_neighbors(5.0), 25.0, 6.0);
}

TEST(DensitySample, SeesACrowdThatTheAverageOverSpaceHides) {
  Memory memory;
  EXPECT_NEAR(DensitySample(crowd_in_wide_space(), memory).expected_neighbors(1.0), 12'500.0,
              1500.0);
}

TEST(DensitySample, IsZeroForLonelyPoints) {
  test::SceneMaker make(6);
  Memory memory;
  const std::vector<Point> lonely = make.box(5000, {0, 0, 0}, {1e6, 1e6, 1e6});
  EXPECT_EQ(DensitySample(lonely, memory).expected_neighbors(1.0), 0.0);
  EXPECT_EQ(DensitySample(std::vector<Point>{{1, 1, 1}}, memory).expected_neighbors(1.0), 0.0);
  EXPECT_EQ(DensitySample(std::vector<Point>{}, memory).expected_neighbors(1.0), 0.0);
}

double share_apart(const std::vector<Point>& points, const std::vector<Point>* asked = nullptr) {
  test::OwnResources own;
  const DensitySample sample(points, own.memory);
  const Bounds bounds = *measure(points, own.with);
  const double side = sample.side_for(12.0, bounds);
  const double widest = bounds.high[0] - bounds.low[0];
  if (asked == nullptr) return sample.share_apart(nullptr, 4.5 * side, widest);
  const PointsView view(*asked);
  return sample.share_apart(&view, 4.5 * side, widest);
}

TEST(DensitySample, SeesNoPointApartInEvenSwarmsOfAnyDimension) {
  for (const std::size_t size : {1'000U, 30'000U, 200'000U}) {
    SCOPED_TRACE(size);
    test::SceneMaker make(8);
    EXPECT_LT(share_apart(make.box(size, {0, 0, 0}, {1e3, 1e3, 1e3})), 0.05);
    EXPECT_LT(share_apart(make.box(size, {0, 0, 5}, {1e3, 1e3, 5})), 0.05);
    EXPECT_LT(share_apart(make.box(size, {0, 3, 5}, {1e3, 3, 5})), 0.05);
    const std::vector<Point> asked = make.box(size, {0, 0, 0}, {1e3, 1e3, 1e3});
    EXPECT_LT(share_apart(make.box(size, {0, 0, 0}, {1e3, 1e3, 1e3}), &asked), 0.05);
  }
}

TEST(DensitySample, SeesWhatIsApartFromAClump) {
  test::SceneMaker make(9);
  std::vector<Point> points = make.box(50'000, {0, 0, 0}, {1e6, 1e6, 1e6});
  for (std::size_t i = 0; i < points.size(); i += 2) {
    points[i] = {make.between(0, 1), make.between(0, 1), make.between(0, 1)};
  }
  EXPECT_NEAR(share_apart(points), 0.5, 0.1);
  const std::vector<Point> far = make.box(1'000, {5e6, 0, 0}, {6e6, 1e6, 1e6});
  EXPECT_EQ(share_apart(points, &far), 1.0);
}

TEST(DensitySample, FindsTheSideThatHoldsSome) {
  test::SceneMaker make(7);
  test::OwnResources own;
  const std::vector<Point> cube = make.box(100'000, {0, 0, 0}, {1000, 1000, 1000});
  const std::vector<Point> plane = make.box(100'000, {0, 0, 5}, {1000, 1000, 5});
  const auto side_of = [&](const std::vector<Point>& points) {
    const DensitySample sample(points, own.memory);
    const double side = sample.side_for(12.0, *measure(points, own.with));
    EXPECT_GT(sample.expected_neighbors(side), 6.0);
    EXPECT_LT(sample.expected_neighbors(side), 24.0);
    return side;
  };
  EXPECT_NEAR(side_of(cube), std::cbrt(12.0 / 100'000) * 1000, 15.0);
  EXPECT_NEAR(side_of(plane), std::sqrt(12.0 / 100'000) * 1000, 4.0);
}

// Twins meet in cells of any size: they must not drive the side down to nothing.
TEST(DensitySample, TwinsDoNotCountForTheSide) {
  test::OwnResources own;
  const std::vector<Point> points = crowd_in_wide_space();
  const DensitySample sample(points, own.memory);
  EXPECT_GT(sample.side_for(12.0, *measure(points, own.with)), 1e4);
  const std::vector<Point> one_place(1000, Point{3, 3, 3});
  const DensitySample twins(one_place, own.memory);
  EXPECT_EQ(twins.side_for(12.0, *measure(one_place, own.with)), 0.0);
}

}  // namespace
}  // namespace beespace::core
