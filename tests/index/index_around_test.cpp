// The points around a place: equal to comparing every distance exactly.
#include "tests/index/index_scenes.hpp"
#include "tests/index/plain_index.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace beespace {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

void expect_same(const Index& index, const test::PlainIndex& plain, const Point& place,
                 double radius) {
  const bool in_domain = radius >= kSmallestCoordinate_m && radius <= kLargestCoordinate_m;
  if (!in_domain && radius != 0.0) return;
  for (const bool inclusive : {false, true}) {
    ASSERT_EQ(*index.find_around(place, radius, inclusive),
              plain.find_around(place, radius, inclusive))
        << "radius " << radius << (inclusive ? " inclusive" : "");
  }
}

TEST(IndexAround, EqualsPlainSearchOnEveryScene) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const test::PlainIndex plain(scene.points);
    for (const Point& place : test::places_around(scene, 40)) {
      for (const double factor : {0.25, 1.0, 4.0}) {
        expect_same(index, plain, place, factor * scene.threshold_m);
      }
    }
  }
}

TEST(IndexAround, IsExactAtTheDistanceOfAPointAndOneUlpBesideIt) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    if (scene.points.empty()) continue;
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const test::PlainIndex plain(scene.points);
    const std::vector<Point> places = test::places_around(scene, 12);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double radius = distance(places[i], scene.points[i * 31 % scene.points.size()]);
      expect_same(index, plain, places[i], radius);
      expect_same(index, plain, places[i], std::nextafter(radius, kInfinity));
      if (radius > 0.0) expect_same(index, plain, places[i], std::nextafter(radius, 0.0));
    }
  }
}

TEST(IndexAround, ARadiusOfZeroFindsPointsAtTheVeryPlace) {
  const Index index =
      test::built({{1, 2, 3}, {0, 0, -0.0}, {1, 2, 3}, {1, 2, std::nextafter(3, 4)}});
  EXPECT_EQ(*index.find_around({1, 2, 3}, 0.0, true), (std::vector<PointId>{0, 2}));
  EXPECT_EQ(*index.find_around({-0.0, 0, 0}, 0.0, true), (std::vector<PointId>{1}));
  EXPECT_TRUE(index.find_around({1, 2, 3}, 0.0).value().empty());
}

TEST(IndexAround, TheLargestRadiusHoldsAllNearPoints) {
  const std::vector<Point> points = test::SceneMaker(1).box(1000, {0, 0, 0}, {1e6, 1e6, 1e6});
  EXPECT_EQ(test::built(points).find_around({5e5, 5e5, 5e5}, kLargestCoordinate_m).value().size(),
            1000U);
}

TEST(IndexAround, AnEmptyIndexFindsNone) {
  EXPECT_TRUE(Index().find_around({1, 2, 3}, 1e9, true).value().empty());
  EXPECT_TRUE(test::built({}).find_around({1, 2, 3}, 1e9, true).value().empty());
}

TEST(IndexAround, ManyPlacesEqualOneByOneForAnyNumberOfThreads) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const std::vector<Point> places = test::places_around(scene, 300);
    IdRows expected;
    expected.offsets.push_back(0);
    for (const Point& place : places) {
      const std::vector<PointId> row = *index.find_around(place, scene.threshold_m);
      expected.ids.insert(expected.ids.end(), row.begin(), row.end());
      expected.offsets.push_back(expected.ids.size());
    }
    for (const unsigned threads : {1U, 3U}) {
      EXPECT_EQ(*index.find_around(places, {scene.threshold_m, false, threads}), expected);
    }
  }
}

TEST(IndexAround, ManyThreadsGiveWhatOneGivesForManyPlaces) {
  test::SceneMaker make(3);
  const std::vector<Point> points = make.box(60'000, {0, 0, 0}, {3000, 3000, 3000});
  const std::vector<Point> places = make.box(40'000, {-100, -100, -100}, {3100, 3100, 3100});
  const IdRows expected = *test::built(points).find_around(places, {90.0, true, 1});
  for (const unsigned threads : {2U, 4U, 7U}) {
    EXPECT_EQ(*test::built(points, threads).find_around(places, {90.0, true, threads}), expected);
  }
  for (std::size_t place = 0; place < places.size(); place += 1999) {
    const test::PlainIndex plain(points);
    const std::span<const PointId> row = expected[place];
    EXPECT_EQ(std::vector<PointId>(row.begin(), row.end()),
              plain.find_around(places[place], 90.0, true));
  }
}

TEST(IndexAround, NoPlacesGiveNoRows) {
  EXPECT_EQ(test::built({{1, 2, 3}}).find_around(std::vector<Point>{}, {1.0}).value().size(), 0U);
}

TEST(IndexAround, FillsTheCallersVectorAnew) {
  const Index index = test::built({{0, 0, 0}, {5, 0, 0}});
  std::vector<PointId> found{7, 7, 7};
  ASSERT_TRUE(index.find_around({5, 0, 0}, 1.0, false, found).has_value());
  EXPECT_EQ(found, (std::vector<PointId>{1}));
  ASSERT_TRUE(index.find_around({50, 0, 0}, 1.0, false, found).has_value());
  EXPECT_TRUE(found.empty());
}

TEST(IndexAround, HasARadiusForEachPlaceWhereThatIsGiven) {
  for (const test::SearchScene& scene : test::search_scenes()) {
    SCOPED_TRACE(scene.name);
    const Index index = test::built(scene.points);
    const test::PlainIndex plain(scene.points);
    const std::vector<Point> places = test::places_around(scene, 40);
    std::vector<double> radii;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double radius = 0.25 * static_cast<double>(i % 9) * scene.threshold_m;
      radii.push_back(radius >= kSmallestCoordinate_m && radius <= kLargestCoordinate_m ? radius
                                                                                        : 0);
    }
    for (const bool inclusive : {false, true}) {
      const auto rows = index.find_around(places, radii, {.inclusive = inclusive, .threads = 2});
      ASSERT_TRUE(rows.has_value());
      for (std::size_t i = 0; i < places.size(); ++i) {
        const auto row = (*rows)[i];
        EXPECT_EQ(std::vector<PointId>(row.begin(), row.end()),
                  plain.find_around(places[i], radii[i], inclusive))
            << "place " << i << ", radius " << radii[i];
      }
    }
  }
}

TEST(IndexAround, RefusesRadiiThatMakeNoSense) {
  const std::vector<Point> points = {{1, 2, 3}, {4, 5, 6}};
  const Index index = test::built(points);
  const auto negative = index.find_around(points, std::vector<double>{1.0, -1.0});
  ASSERT_FALSE(negative.has_value());
  EXPECT_EQ(negative.error().code, ErrorCode::kInvalidThreshold);
  EXPECT_EQ(negative.error().location.array, "radii");
  EXPECT_EQ(negative.error().location.record, 1U);
  const auto few = index.find_around(points, std::vector<double>{1.0});
  ASSERT_FALSE(few.has_value());
  EXPECT_EQ(few.error().code, ErrorCode::kInvalidArgument);
  const auto both = index.find_around(points, std::vector<double>{1.0, 1.0}, {.radius_m = 1.0});
  ASSERT_FALSE(both.has_value());
  EXPECT_EQ(both.error().code, ErrorCode::kInvalidArgument);
}

TEST(IndexAround, AllocatesNothingWhereTheCallersVectorHasRoom) {
  const std::vector<Point> points = test::SceneMaker(2).box(5000, {0, 0, 0}, {9, 9, 9});
  const Index index = test::built(points);
  for (const double radius : {0.5, 1.5, 4.0, 20.0}) {
    std::vector<PointId> found;
    found.reserve(2 * index.find_around({4, 4, 4}, radius).value().size() + 64);
    const PointId* const memory = found.data();
    ASSERT_TRUE(index.find_around({4, 4, 4}, radius, false, found).has_value());
    EXPECT_EQ(found.data(), memory) << radius;
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
  }
}

// A clump and a point so far away that floats do not resolve both.
TEST(IndexAround, AnOutlierDoesNotMergeAllOthers) {
  std::vector<Point> points = test::SceneMaker(4).box(20'000, {0, 0, 0}, {50, 50, 50});
  points[77] = {1e15, -1e15, 1e15};
  points[78] = {-1e100, 1e100, 0};
  const Index index = test::built(points);
  const test::PlainIndex plain(points);
  for (std::size_t i = 0; i < points.size(); i += 997) expect_same(index, plain, points[i], 3.0);
  expect_same(index, plain, points[77], 1e14);
  expect_same(index, plain, points[78], 1e100);
}

}  // namespace
}  // namespace beespace
