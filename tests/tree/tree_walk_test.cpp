// Every instruction set of this processor walks to the same points.
#include "kernels/tree_walk.hpp"

#include "tests/index/index_scenes.hpp"
#include "tests/index/plain_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>

namespace beespace::cpu {
namespace {

class TreeWalk : public testing::TestWithParam<InstructionSet> {};

std::vector<PointId> collected(const TreeWalks& walks, const core::PointTree& tree,
                               const Ball& ball) {
  std::vector<PointId> ids(tree.size() + core::kFanOut);
  IdSink sink{ids.data(), ids.data() + ids.size(), [](IdSink&) { FAIL(); }};
  walks.collect(tree.view(), ball, sink);
  ids.resize(static_cast<std::size_t>(sink.next - ids.data()));
  std::sort(ids.begin(), ids.end());
  return ids;
}

TEST_P(TreeWalk, FindsWhatPlainSearchFinds) {
  const TreeWalks walks = tree_walks(GetParam());
  Crew alone;
  for (const test::SearchScene& scene : test::search_scenes()) {
    if (scene.points.empty()) continue;
    SCOPED_TRACE(scene.name);
    const core::PointTree tree = test::tree_of(scene.points, alone);
    const test::PlainIndex plain(scene.points);
    for (const Point& place : test::places_around(scene, 10)) {
      for (const bool inclusive : {false, true}) {
        EXPECT_EQ(collected(walks, tree, {place, scene.threshold_m, inclusive}),
                  plain.find_around(place, scene.threshold_m, inclusive));
      }
      core::NearestList list;
      list.start(place, 5, std::numeric_limits<double>::infinity());
      walks.find_nearest(tree.view(), place, list);
      std::vector<Nearest> nearest(5);
      nearest.resize(list.write(nearest.data()));
      EXPECT_EQ(nearest, plain.k_nearest(place, 5));
    }
  }
}

// The rows of a leaf, and of how many of its points the walk gave up.
struct LeafRows {
  std::array<std::vector<std::uint32_t>, core::kFanOut> slots;
  std::size_t given_up = 0;
};

LeafRows rows_of_leaf(const TreeWalks& walks, const core::PointTree& tree, std::size_t leaf,
                      std::size_t wanted) {
  const std::size_t room = wanted + 30;
  std::vector<std::uint32_t> slots(core::kFanOut * room);
  LeafNeighbors found{slots.data(), room, {}};
  walks.find_nearest_of_leaf(tree.view(), leaf, wanted, found);
  LeafRows rows;
  const std::size_t points = std::min(core::kFanOut, tree.size() - leaf * core::kFanOut);
  for (std::size_t place = 0; place < core::kFanOut; ++place) {
    const auto row = slots.begin() + static_cast<std::ptrdiff_t>(place * room);
    rows.slots[place].assign(row, row + found.counts[place]);
    rows.given_up += place < points && found.counts[place] == 0 ? 1 : 0;
    EXPECT_TRUE(place < points || found.counts[place] == 0);
  }
  return rows;
}

TEST_P(TreeWalk, FindsAllThatMayBeNearestOfThePointsOfALeaf) {
  const TreeWalks walks = tree_walks(GetParam());
  Crew alone;
  for (const test::SearchScene& scene : test::search_scenes()) {
    if (scene.points.empty()) continue;
    SCOPED_TRACE(scene.name);
    const core::PointTree tree = test::tree_of(scene.points, alone);
    const test::PlainIndex plain(scene.points);
    const std::size_t leaves = (tree.size() + core::kFanOut - 1) / core::kFanOut;
    for (const std::size_t wanted : {1U, 8U, 15U, 16U, 40U, 192U}) {
      for (std::size_t leaf = 0; leaf < leaves; leaf += 1 + leaves / 7) {
        const LeafRows rows = rows_of_leaf(walks, tree, leaf, wanted);
        for (std::size_t place = 0; place < core::kFanOut; ++place) {
          if (rows.slots[place].empty()) continue;
          const auto self = static_cast<std::uint32_t>(leaf * core::kFanOut + place);
          std::vector<PointId> ids;
          for (const std::uint32_t slot : rows.slots[place]) ids.push_back(tree.id(slot));
          std::sort(ids.begin(), ids.end());
          EXPECT_EQ(std::adjacent_find(ids.begin(), ids.end()), ids.end());
          EXPECT_FALSE(std::binary_search(ids.begin(), ids.end(), tree.id(self)));
          std::vector<Nearest> nearest = plain.k_nearest(tree.point(self), wanted + 1);
          std::erase_if(nearest, [&](const Nearest& each) { return each.id == tree.id(self); });
          nearest.resize(std::min(nearest.size(), wanted));
          for (const Nearest& each : nearest) {
            EXPECT_TRUE(std::binary_search(ids.begin(), ids.end(), each.id))
                << each.id << " of " << tree.id(self) << ", " << wanted << " wanted";
          }
        }
      }
    }
  }
}

// Nodes of very different size side by side, so that floats of one are coarse in the frame of the
// other; what floats of one frame could tell is then not what floats of the other tell.
TEST_P(TreeWalk, GivesUpSeldomWhereDensityChanges) {
  const TreeWalks walks = tree_walks(GetParam());
  Crew alone;
  std::vector<Point> points = test::SceneMaker(8).box(4000, {0, 0, 0}, {100, 100, 100});
  for (const Point& p : test::SceneMaker(9).box(4000, {50, 50, 50}, {3, 3, 3})) points.push_back(p);
  const core::PointTree tree = test::tree_of(points, alone);
  const test::PlainIndex plain(points);
  std::size_t given_up = 0;
  for (std::size_t leaf = 0; leaf < tree.size() / core::kFanOut; ++leaf) {
    const LeafRows rows = rows_of_leaf(walks, tree, leaf, 8);
    given_up += rows.given_up;
    for (std::size_t place = leaf % 5; place < core::kFanOut; place += 5) {
      if (rows.slots[place].empty()) continue;
      const auto self = static_cast<std::uint32_t>(leaf * core::kFanOut + place);
      for (const Nearest& each : plain.k_nearest(tree.point(self), 9)) {
        const auto is_it = [&](std::uint32_t slot) { return tree.id(slot) == each.id; };
        EXPECT_TRUE(each.id == tree.id(self) ||
                    std::any_of(rows.slots[place].begin(), rows.slots[place].end(), is_it));
      }
    }
  }
  EXPECT_LT(given_up, points.size() / 10);
}

// A node so dense that its frame has no place among the floats of another: nothing of it is lost.
TEST_P(TreeWalk, KeepsWhatIsDenserThanFloatsCanTell) {
  const TreeWalks walks = tree_walks(GetParam());
  Crew alone;
  std::vector<Point> points = test::SceneMaker(3).box(512, {0, 0, 0}, {1, 1, 1});
  for (const Point& p : test::SceneMaker(4).box(512, {0, 0, 0}, {1, 1, 1})) {
    points.push_back({p.x * 1e-50, p.y * 1e-50, p.z * 1e-50});
  }
  const core::PointTree tree = test::tree_of(points, alone);
  const test::PlainIndex plain(points);
  for (std::size_t leaf = 0; leaf < tree.size() / core::kFanOut; ++leaf) {
    const LeafRows rows = rows_of_leaf(walks, tree, leaf, 3);
    for (std::size_t place = 0; place < core::kFanOut; ++place) {
      if (rows.slots[place].empty()) continue;
      const auto self = static_cast<std::uint32_t>(leaf * core::kFanOut + place);
      for (const Nearest& each : plain.k_nearest(tree.point(self), 4)) {
        const auto is_it = [&](std::uint32_t slot) { return tree.id(slot) == each.id; };
        EXPECT_TRUE(each.id == tree.id(self) ||
                    std::any_of(rows.slots[place].begin(), rows.slots[place].end(), is_it));
      }
    }
  }
}

TEST_P(TreeWalk, DoesNotFindDiscardedPoints) {
  const TreeWalks walks = tree_walks(GetParam());
  const std::vector<Point> points = test::SceneMaker(5).box(900, {0, 0, 0}, {9, 9, 9});
  Crew alone;
  core::PointTree tree = test::tree_of(points, alone);
  test::PlainIndex plain(points);
  for (std::uint32_t slot = 0; slot < tree.size(); slot += 1 + slot % 3) {
    tree.discard(slot);
    plain.remove(tree.id(slot));
  }
  for (const Point& place : test::SceneMaker(6).box(50, {0, 0, 0}, {9, 9, 9})) {
    EXPECT_EQ(collected(walks, tree, {place, 2.0, false}), plain.find_around(place, 2.0, false));
  }
  EXPECT_EQ(collected(walks, tree, {{0, 0, 0}, 1e300, true}).size(), plain.points().size());
}

std::vector<InstructionSet> available() {
  std::vector<InstructionSet> sets;
  for (const InstructionSet set : kInstructionSets) {
    if (is_available(set)) sets.push_back(set);
  }
  return sets;
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, TreeWalk, testing::ValuesIn(available()),
                         [](const auto& test_case) { return name_of(test_case.param); });

}  // namespace
}  // namespace beespace::cpu
