// Inserted, moved, removed, rebuilt, in any order: the answers are those of a plain list.
#include "tests/index/index_scenes.hpp"
#include "tests/index/plain_index.hpp"

#include <gtest/gtest.h>

namespace beespace {
namespace {

// An Index and the reference list, changed and queried together.
class Twins {
 public:
  Twins(std::uint32_t seed, const std::vector<Point>& points)
      : make_(seed), random_(seed), index_(test::built(points)), plain_(points) {}

  void insert() {
    const Point point = somewhere();
    ASSERT_EQ(*index_.insert(point), plain_.insert(point));
  }
  void move() {
    if (plain_.points().empty()) return;
    const PointId id = any_id();
    const Point point = somewhere();
    ASSERT_TRUE(index_.move(id, point).has_value());
    plain_.move(id, point);
  }
  void remove() {
    if (plain_.points().empty()) return;
    const PointId id = any_id();
    ASSERT_TRUE(index_.remove(id).has_value());
    plain_.remove(id);
    ASSERT_FALSE(index_.contains(id));
  }
  void rebuild(unsigned threads) { index_.rebuild(threads); }

  void compare() {
    ASSERT_EQ(index_.size(), plain_.points().size());
    const Point place = somewhere();
    for (const double radius : {0.0, 1.0, 3.0, 40.0}) {
      ASSERT_EQ(*index_.find_around(place, radius, true), plain_.find_around(place, radius, true));
    }
    for (const std::size_t k : {1U, 7U, 40U}) {
      ASSERT_EQ(*index_.k_nearest(place, k), plain_.k_nearest(place, k));
    }
    if (plain_.points().empty()) return;
    const PointId id = any_id();
    ASSERT_TRUE(index_.contains(id));
    ASSERT_EQ(*index_.point(id), plain_.points().at(id));
  }

  [[nodiscard]] std::uint32_t below(std::uint32_t limit) {
    return static_cast<std::uint32_t>(random_()) % limit;
  }

 private:
  // Often a place of a small lattice, so that there are many ties and duplicates.
  Point somewhere() {
    if (below(3) == 0) return make_.box(1, {0, 0, 0}, {20, 20, 20})[0];
    return {double(below(12)), double(below(12)), double(below(3))};
  }
  PointId any_id() {
    auto entry = plain_.points().lower_bound(below(plain_.points().rbegin()->first + 1));
    return entry->first;
  }

  test::SceneMaker make_;
  std::mt19937 random_;
  Index index_;
  test::PlainIndex plain_;
};

void live(std::uint32_t seed, std::size_t first, int steps, std::uint32_t more_inserts) {
  SCOPED_TRACE("seed " + std::to_string(seed));
  Twins twins(seed, test::SceneMaker(seed).box(first, {0, 0, 0}, {20, 20, 20}));
  for (int step = 0; step < steps; ++step) {
    const std::uint32_t what = twins.below(100);
    if (what < more_inserts) {
      twins.insert();
    } else if (what < 75) {
      twins.move();
    } else if (what < 99) {
      twins.remove();
    } else {
      twins.rebuild(1 + seed % 3);
    }
    if (step % 7 == 0) twins.compare();
    if (testing::Test::HasFatalFailure()) return;
  }
  twins.compare();
}

TEST(IndexChanges, GrowingFromNothingEqualsAPlainList) {
  for (std::uint32_t seed = 1; seed <= 3; ++seed) live(seed, 0, 2500, 60);
}

TEST(IndexChanges, ShrinkingToNothingEqualsAPlainList) {
  for (std::uint32_t seed = 4; seed <= 6; ++seed) live(seed, 900, 3500, 2);
}

TEST(IndexChanges, MovingAmongManyEqualsAPlainList) {
  for (std::uint32_t seed = 7; seed <= 9; ++seed) live(seed, 1500, 1500, 15);
}

TEST(IndexChanges, ManyPlacesSeeTheChanges) {
  test::SceneMaker make(10);
  Index index = test::built(make.box(3000, {0, 0, 0}, {100, 100, 100}));
  for (const Point& point : make.box(700, {0, 0, 0}, {100, 100, 100})) (void)*index.insert(point);
  for (PointId id = 0; id < 3700; id += 5) ASSERT_TRUE(index.remove(id).has_value());
  const std::vector<Point> places = make.box(200, {0, 0, 0}, {100, 100, 100});
  const IdRows around = *index.find_around(places, {12.0});
  const NearestRows nearest = *index.k_nearest(places, 6);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::vector<PointId> ids = *index.find_around(places[i], 12.0);
    EXPECT_TRUE(std::equal(around[i].begin(), around[i].end(), ids.begin(), ids.end()));
    const std::vector<Nearest> row = *index.k_nearest(places[i], 6);
    EXPECT_TRUE(std::equal(nearest[i].begin(), nearest[i].end(), row.begin(), row.end()));
    for (const PointId id : ids) EXPECT_NE(id % 5, 0U);
  }
}

TEST(IndexChanges, IdsAreNeverUsedAgain) {
  Index index = test::built({{1, 1, 1}, {2, 2, 2}});
  ASSERT_TRUE(index.remove(1).has_value());
  EXPECT_EQ(*index.insert({2, 2, 2}), 2U);
  index.rebuild();
  EXPECT_EQ(*index.insert({3, 3, 3}), 3U);
  EXPECT_FALSE(index.contains(1));
  EXPECT_EQ(*index.find_around({2, 2, 2}, 1.0), (std::vector<PointId>{2}));
}

TEST(IndexChanges, AMovedIndexKeepsItsPoints) {
  Index index = test::built({{1, 1, 1}});
  Index other = std::move(index);
  EXPECT_EQ(other.size(), 1U);
  index = std::move(other);
  EXPECT_EQ(*index.find_around({1, 1, 1}, 1.0), (std::vector<PointId>{0}));
}

// Each change must cost about the same, however many points there are and however many changes
// there were.
TEST(IndexChanges, AHundredThousandOfEachStayCheap) {
  test::SceneMaker make(11);
  std::vector<Point> points = make.box(100'000, {0, 0, 0}, {1000, 1000, 1000});
  Index index = test::built(points);
  for (const Point& point : points) (void)*index.insert(point);
  for (PointId id = 0; id < 100'000; ++id) ASSERT_TRUE(index.move(id, points[id / 2]).has_value());
  for (PointId id = 0; id < 150'000; ++id) ASSERT_TRUE(index.remove(id).has_value());
  EXPECT_EQ(index.size(), 50'000U);
  EXPECT_EQ(index.k_nearest(points[60'000], 1).value().front(), (Nearest{160'000, 0.0}));
}

}  // namespace
}  // namespace beespace
