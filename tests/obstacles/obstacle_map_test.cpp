// A map against a loop over all that is in it.
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/obstacle.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::kEndless;

ObstacleMap map_of(const std::vector<Obstacle>& obstacles) {
  auto map = ObstacleMap::of(obstacles);
  EXPECT_TRUE(map) << map.error().message;
  return map ? *map : ObstacleMap();
}

std::optional<NearestObstacle> nearest_of_all(const std::vector<Obstacle>& obstacles,
                                              const Point& place, double within) {
  std::optional<NearestObstacle> best;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const NearestSurface surface = *nearest_surface(obstacles[i], place);
    if (!(surface.distance_m <= within)) continue;
    if (best && !(surface.distance_m < best->surface.distance_m)) continue;
    best = {i, surface};
  }
  return best;
}

struct Tally {
  int inside = 0;
  int outside = 0;
  int none = 0;
};

// The very same numbers.
void expect_same(const ObstacleMap& map, const Point& place, double within, Tally& tally) {
  const std::vector<Obstacle> all(map.obstacles().begin(), map.obstacles().end());
  const auto expected = nearest_of_all(all, place, within);
  const auto found = map.nearest(place, within);
  ASSERT_EQ(found.has_value(), expected.has_value());
  if (!found) {
    ++tally.none;
    return;
  }
  ASSERT_EQ(found->obstacle, expected->obstacle);
  ASSERT_EQ(found->surface.distance_m, expected->surface.distance_m);
  ASSERT_EQ(found->surface.point, expected->surface.point);
  ++(found->surface.distance_m < 0.0 ? tally.inside : tally.outside);
}

TEST(ObstacleMap, FindsWhatALoopFinds) {
  RandomStream random(1);
  Tally tally;
  for (int round = 0; round < test::rounds(400); ++round) {
    const double spread = std::exp(random.uniform(0.0, 6.0));
    const auto obstacles = test::random_obstacles(random, random.index(300), spread);
    const ObstacleMap map = map_of(obstacles);
    ASSERT_EQ(map.obstacles().size(), obstacles.size());
    for (int place = 0; place < 20; ++place) {
      const double within[] = {kEndless, 0.1 * spread, 0.0, -0.5};
      ASSERT_NO_FATAL_FAILURE(expect_same(map, test::random_place(random, 1.5 * spread),
                                          within[random.index(4)], tally))
          << "round " << round;
    }
  }
  EXPECT_GT(tally.inside, test::rounds(400));
  EXPECT_GT(tally.outside, test::rounds(400));
  EXPECT_GT(tally.none, test::rounds(400));
}

TEST(ObstacleMap, FindsTheFirstOfEquals) {
  RandomStream random(2);
  Tally tally;
  for (int round = 0; round < test::rounds(400); ++round) {
    // Few sizes and whole places, so that many are as near, and many are the same.
    std::vector<Obstacle> obstacles;
    const auto whole = [&] { return static_cast<double>(random.index(8)); };
    for (std::uint32_t left = 1 + random.index(200); left > 0; --left) {
      const Point at{whole(), whole(), whole()};
      if (random.index(2) == 0) {
        obstacles.push_back(Sphere{at, 0.5});
      } else {
        obstacles.push_back(Box{at, {at.x + 1.0, at.y + 1.0, at.z + 1.0}});
      }
    }
    const ObstacleMap map = map_of(obstacles);
    for (int place = 0; place < 20; ++place) {
      const Point at{0.5 * whole() + 2.0, 0.5 * whole() + 2.0, 0.5 * whole() + 2.0};
      ASSERT_NO_FATAL_FAILURE(expect_same(map, at, random.index(2) == 0 ? kEndless : 0.5, tally))
          << "round " << round;
    }
  }
  EXPECT_GT(tally.inside + tally.outside, test::rounds(400) * 10);
}

TEST(ObstacleMap, OfObstaclesOfVeryDifferentSizes) {
  RandomStream random(3);
  Tally tally;
  for (int round = 0; round < test::rounds(300); ++round) {
    std::vector<Obstacle> obstacles;
    for (int i = 0; i < 60; ++i) {
      std::size_t kind = random.index(test::kKinds);
      if (kind == 2) kind = 0;
      obstacles.push_back(test::random_obstacle(random, kind, std::exp(random.uniform(-20.0, 20.0)),
                                                {1e5, -1e5, 0}));
    }
    const ObstacleMap map = map_of(obstacles);
    for (int place = 0; place < 20; ++place) {
      const Point off = test::random_place(random, std::exp(random.uniform(-5.0, 25.0)));
      ASSERT_NO_FATAL_FAILURE(expect_same(map, {1e5 + off.x, -1e5 + off.y, off.z}, kEndless, tally))
          << "round " << round;
    }
  }
  EXPECT_GT(tally.inside, test::rounds(300));
  EXPECT_GT(tally.outside, test::rounds(300));
}

TEST(ObstacleMap, WithinIsInclusive) {
  const ObstacleMap map = map_of({Sphere{{0, 0, 0}, 1}});
  EXPECT_TRUE(map.nearest({3, 0, 0}, 2.0));
  EXPECT_FALSE(map.nearest({3, 0, 0}, std::nextafter(2.0, 0.0)));
  EXPECT_TRUE(map.nearest({0.5, 0, 0}, -0.5));
  EXPECT_FALSE(map.nearest({0.5, 0, 0}, -0.75));
  EXPECT_FALSE(map.nearest({0.5, 0, 0}, std::numeric_limits<double>::quiet_NaN()));
}

TEST(ObstacleMap, OfNothing) {
  EXPECT_FALSE(ObstacleMap().nearest({0, 0, 0}));
  EXPECT_TRUE(ObstacleMap().obstacles().empty());
  EXPECT_FALSE(map_of({}).nearest({0, 0, 0}));
}

TEST(ObstacleMap, FindsNothingNearAnInvalidPlace) {
  const ObstacleMap map = map_of({Ground{0}});
  for (const double none : {kEndless, -kEndless, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    EXPECT_FALSE(map.nearest({none, 0, 0}));
    EXPECT_FALSE(map.nearest({0, none, 0}));
    EXPECT_FALSE(map.nearest({0, 0, none}));
  }
  EXPECT_TRUE(map.nearest({1e30, -1e30, std::numeric_limits<double>::denorm_min()}));
}

TEST(ObstacleMap, IsSharedByItsCopies) {
  ObstacleMap first = map_of({Sphere{{0, 0, 0}, 1}});
  const ObstacleMap copy = first;
  const ObstacleMap moved = std::move(first);
  EXPECT_EQ(copy.obstacles().data(), moved.obstacles().data());
  EXPECT_EQ(first.obstacles().size(), 1U);  // NOLINT: one that was moved from is a map still
  first = ObstacleMap();
  EXPECT_TRUE(first.obstacles().empty());
  EXPECT_EQ(copy.nearest({0, 0, 3})->surface.distance_m, 2.0);
}

}  // namespace
}  // namespace beespace
