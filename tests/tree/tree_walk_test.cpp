// Every instruction set of this processor walks to the same points.
#include "kernels/tree_walk.hpp"

#include "tests/index/index_scenes.hpp"
#include "tests/index/plain_index.hpp"

#include <gtest/gtest.h>

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
