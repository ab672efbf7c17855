// The k nearest: equal to sorting all points by exact distance, ties by the lowest id.
#include "tests/index/index_scenes.hpp"
#include "tests/index/plain_index.hpp"

#include <gtest/gtest.h>

namespace beespace {
namespace {

void expect_same(const Index& index, const test::PlainIndex& plain, const Point& place,
                 std::size_t k) {
  const std::vector<Nearest> expected = plain.k_nearest(place, k);
  const std::vector<Nearest> found = *index.k_nearest(place, k);
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_EQ(found[i].id, expected[i].id) << "entry " << i << " of " << k;
    ASSERT_EQ(found[i].distance_m, expected[i].distance_m) << "entry " << i << " of " << k;
  }
}

TEST(IndexNearest, EqualsPlainSearchOnEveryScene) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const test::PlainIndex plain(scene.points);
    for (const Point& place : test::places_around(scene, 12)) {
      for (const std::size_t k : {1U, 2U, 8U, 17U, 150U}) expect_same(index, plain, place, k);
    }
  }
}

TEST(IndexNearest, EquallyNearPointsComeInTheOrderOfTheirIds) {
  // Shuffled, so that the order in the tree is not that of the ids.
  std::vector<Point> lattice = test::integer_lattice(12, 2.0, {-11, -11, -11});
  std::shuffle(lattice.begin(), lattice.end(), std::mt19937(5));
  const Index index = test::built(lattice);
  const test::PlainIndex plain(lattice);
  for (const Point& place : {Point{0, 0, 0}, Point{1, 1, 1}, Point{-11, 0, 5}, Point{40, 0, 0}}) {
    for (const std::size_t k : {1U, 3U, 8U, 27U, 300U}) expect_same(index, plain, place, k);
  }
}

// The other points, by brute force without the one.
void expect_same_of(const Index& index, test::PlainIndex plain, PointId id, std::size_t k) {
  const Point place = plain.points().at(id);
  plain.remove(id);
  const std::vector<Nearest> expected = plain.k_nearest(place, k);
  const std::vector<Nearest> found = *index.k_nearest_of(id, k);
  ASSERT_EQ(found, expected) << "point " << id << ", " << k << " nearest";
}

TEST(IndexNearest, OfAPointLeavesItOut) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    if (scene.points.size() > 3000) continue;
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const test::PlainIndex plain(scene.points);
    const std::size_t step = scene.points.size() / 7 + 1;
    for (std::size_t id = 0; id < scene.points.size(); id += step) {
      for (const std::size_t k : {1U, 5U, 30U}) {
        expect_same_of(index, plain, static_cast<PointId>(id), k);
      }
    }
  }
}

TEST(IndexNearest, OfAPointAmongCoincidentOnesAreTheOthers) {
  const std::vector<Point> points(9, Point{1, 2, 3});
  const Index index = test::built(points);
  const test::PlainIndex plain(points);
  for (PointId id = 0; id < 9; ++id) {
    for (std::size_t k = 0; k < 12; ++k) expect_same_of(index, plain, id, k);
  }
}

TEST(IndexNearest, OfAPointThatIsNotThereIsAnError) {
  Index index = test::built({{1, 2, 3}, {4, 5, 6}});
  ASSERT_TRUE(index.remove(1));
  EXPECT_EQ(index.k_nearest_of(1, 1).error().code, ErrorCode::kInvalidArgument);
  EXPECT_EQ(index.k_nearest_of(7, 1).error().code, ErrorCode::kInvalidArgument);
  EXPECT_TRUE(index.k_nearest_of(0, 5).value().empty());
}

TEST(IndexNearest, MoreThanThereAreGivesAll) {
  const std::vector<Point> points = test::SceneMaker(6).box(100, {0, 0, 0}, {9, 9, 9});
  const Index index = test::built(points);
  EXPECT_EQ(index.k_nearest({1, 2, 3}, 100).value().size(), 100U);
  EXPECT_EQ(*index.k_nearest({1, 2, 3}, 1'000'000'000'000), *index.k_nearest({1, 2, 3}, 100));
}

TEST(IndexNearest, OfNoneOrOfAnEmptyIndex) {
  EXPECT_TRUE(test::built({{1, 2, 3}}).k_nearest({1, 2, 3}, 0).value().empty());
  EXPECT_TRUE(Index().k_nearest({1, 2, 3}, 5).value().empty());
  EXPECT_EQ(Index().k_nearest(std::vector<Point>{{1, 2, 3}}, 5).value().size(), 0U);
}

TEST(IndexNearest, ManyPlacesEqualOneByOneForAnyNumberOfThreads) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const std::vector<Point> places = test::places_around(scene, 300);
    for (const std::size_t k : {1U, 9U}) {
      NearestRows expected{std::min(k, scene.points.size()), {}};
      for (const Point& place : places) {
        const std::vector<Nearest> row = *index.k_nearest(place, k);
        expected.entries.insert(expected.entries.end(), row.begin(), row.end());
      }
      EXPECT_EQ(*index.k_nearest(places, k, 1), expected);
      EXPECT_EQ(*index.k_nearest(places, k, 3), expected);
    }
  }
}

TEST(IndexNearest, ManyThreadsGiveWhatOneGivesForManyPlaces) {
  test::SceneMaker make(8);
  const std::vector<Point> points = make.box(50'000, {0, 0, 0}, {3000, 3000, 0});
  const std::vector<Point> places = make.box(30'000, {0, 0, 0}, {3000, 3000, 30});
  const NearestRows expected = *test::built(points).k_nearest(places, 5);
  for (const unsigned threads : {2U, 4U}) {
    EXPECT_EQ(*test::built(points, threads).k_nearest(places, 5, threads), expected);
  }
  const test::PlainIndex plain(points);
  for (std::size_t place = 0; place < places.size(); place += 2999) {
    const std::span<const Nearest> row = expected[place];
    EXPECT_EQ(std::vector<Nearest>(row.begin(), row.end()), plain.k_nearest(places[place], 5));
  }
}

// If all equally near points were visited, this would take hours.
TEST(IndexNearest, ManyAtOnePlaceStayCheap) {
  constexpr std::size_t kHalf = 50'000;
  std::vector<Point> points = test::SceneMaker(9).box(2 * kHalf, {0, 0, 0}, {1000, 1000, 1000});
  for (std::size_t i = 0; i < kHalf; ++i) points[2 * i] = {500, 500, 500};
  const Index index = test::built(points);
  const NearestRows rows = *index.k_nearest(points, 3);
  for (std::size_t i = 0; i < kHalf; ++i) {
    ASSERT_EQ(rows[2 * i][0].id, 0U);
    ASSERT_EQ(rows[2 * i][1].id, 2U);
    ASSERT_EQ(rows[2 * i][2].id, 4U);
  }
}

}  // namespace
}  // namespace beespace
