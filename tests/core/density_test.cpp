#include "core/density.hpp"

#include "tests/support/search_scenes.hpp"

#include <gtest/gtest.h>

namespace beespace::core {
namespace {

TEST(MeanCellMates, IsAboutRightForUniformPoints) {
  test::SceneMaker make(6);
  const std::vector<Point> points = make.box(200'000, {0, 0, 0}, {100, 100, 100});
  EXPECT_NEAR(mean_cell_mates(points, 10.0), 200.0, 20.0);
  EXPECT_NEAR(mean_cell_mates(points, 5.0), 25.0, 6.0);
}

TEST(MeanCellMates, SeesACrowdThatTheAverageOverSpaceHides) {
  test::SceneMaker make(6);
  std::vector<Point> points = make.box(50'000, {0, 0, 0}, {1e6, 1e6, 1e6});
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] = {5.5, 5.5, 5.5};
  EXPECT_NEAR(mean_cell_mates(points, 1.0), 12'500.0, 1500.0);
}

TEST(MeanCellMates, IsZeroForLonelyPoints) {
  test::SceneMaker make(6);
  EXPECT_EQ(mean_cell_mates(make.box(5000, {0, 0, 0}, {1e6, 1e6, 1e6}), 1.0), 0.0);
  EXPECT_EQ(mean_cell_mates(std::vector<Point>{{1, 1, 1}}, 1.0), 0.0);
}

}  // namespace
}  // namespace beespace::core
