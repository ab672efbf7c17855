// The tree holds every point once, and its boxes hold what is below them.
#include "tree/point_tree.hpp"

#include "tests/index/index_scenes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace beespace::core {
namespace {

using test::tree_of;

void expect_whole(const PointTree& tree, const std::vector<Point>& points) {
  ASSERT_EQ(tree.size(), points.size());
  std::set<PointId> seen;
  for (std::uint32_t slot = 0; slot < tree.size(); ++slot) {
    const PointId id = tree.id(slot);
    ASSERT_TRUE(seen.insert(id).second);
    ASSERT_LT(id, points.size());
    ASSERT_EQ(tree.point(slot), points[id]);
  }
}

// Each point must lie within the boxes of all nodes above it, with the promised margin.
void expect_boxes_hold(const PointTree& tree) {
  const TreeView& view = tree.view();
  for (std::uint32_t slot = 0; slot < tree.size(); ++slot) {
    const Point& point = tree.point(slot);
    const double at[3] = {point.x, point.y, point.z};
    std::size_t child = slot / kFanOut;
    for (unsigned level = 0; level <= view.top; ++level, child /= kFanOut) {
      const TreeNode& node = view.levels[level][child / kFanOut];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double local = (at[axis] - node.origin[axis]) * node.scale;
        if (std::abs(local) > kFarthest / 4) continue;
        const double margin = kBoxMargin / 2 * std::max(1.0, std::abs(local));
        ASSERT_LE(static_cast<double>(node.low[axis][child % kFanOut]), local - margin);
        ASSERT_GE(static_cast<double>(node.high[axis][child % kFanOut]), local + margin);
        if (level == 0) {
          ASSERT_LE(std::abs(local), 1.0);
        }
      }
    }
    ASSERT_EQ(child, 0U);
  }
}

TEST(PointTree, HoldsEveryPointOfEverySceneOnce) {
  Crew alone;
  for (const test::SearchScene& scene : test::search_scenes()) {
    if (scene.points.empty()) continue;
    SCOPED_TRACE(scene.name);
    const PointTree tree = tree_of(scene.points, alone);
    expect_whole(tree, scene.points);
    expect_boxes_hold(tree);
  }
}

TEST(PointTree, IsWholeForEveryNumberOfPoints) {
  Crew alone;
  for (std::size_t size = 1; size < 700; size = size < 40 ? size + 1 : size + 37) {
    SCOPED_TRACE(size);
    const std::vector<Point> points = test::SceneMaker(2).box(size, {0, 0, 0}, {9, 9, 9});
    const PointTree tree = tree_of(points, alone);
    expect_whole(tree, points);
    expect_boxes_hold(tree);
  }
}

TEST(PointTree, IsTheSameForAnyNumberOfWorkers) {
  const std::vector<Point> points = test::SceneMaker(3).box(70'000, {0, 0, 0}, {500, 500, 50});
  Crew alone;
  ThreadCrew three(3);
  const PointTree one = tree_of(points, alone);
  const PointTree other = tree_of(points, three);
  expect_whole(one, points);
  for (std::uint32_t slot = 0; slot < one.size(); ++slot) ASSERT_EQ(one.id(slot), other.id(slot));
}

TEST(PointTree, WhereAllAreAtOnePlaceTheLowestIdIsFirst) {
  std::vector<Point> points(5000, Point{1, 2, 3});
  points[4321] = {9, 9, 9};
  std::vector<PointId> ids(points.size());
  for (PointId i = 0; i < ids.size(); ++i) ids[i] = i * 7 % 5003;
  Crew alone;
  const PointTree tree = tree_of(points, alone, ids.data());
  const TreeView& view = tree.view();
  unsigned flagged = 0;
  for (unsigned level = 0; level <= view.top; ++level) {
    const std::size_t points_a_child = kFanOut << (4 * level);
    for (std::size_t child = 0; child * points_a_child < points.size(); ++child) {
      const TreeNode& node = view.levels[level][child / kFanOut];
      if ((node.same_place >> (child % kFanOut) & 1U) == 0) continue;
      ++flagged;
      const std::size_t begin = child * points_a_child;
      const std::size_t end = std::min(begin + points_a_child, points.size());
      for (std::size_t slot = begin; slot < end; ++slot) {
        ASSERT_LE(tree.id(static_cast<std::uint32_t>(begin)),
                  tree.id(static_cast<std::uint32_t>(slot)));
      }
    }
  }
  EXPECT_GT(flagged, 300U);
}

// A leaf must be about as small as its share of the volume.
TEST(PointTree, LeavesAreCompact) {
  const std::vector<Point> points = test::SceneMaker(4).box(65'536, {0, 0, 0}, {1, 1, 1});
  Crew alone;
  const PointTree tree = tree_of(points, alone);
  double sum = 0.0;
  for (std::uint32_t slot = 0; slot < tree.size(); slot += kFanOut) {
    Point low = tree.point(slot);
    Point high = low;
    for (std::uint32_t i = slot; i < slot + kFanOut; ++i) {
      const Point& p = tree.point(i);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    sum += high.x - low.x + high.y - low.y + high.z - low.z;
  }
  const double leaves = static_cast<double>(tree.size()) / kFanOut;
  const double side = std::cbrt(1.0 / leaves);
  EXPECT_LT(sum / leaves, 1.1 * 3.0 * side);
}

}  // namespace
}  // namespace beespace::core
