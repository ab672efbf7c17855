// Which pieces of a map are looked at: all that are near, in one order, and not many others.
#include "obstacles/obstacle_map.hpp"

#include "tests/obstacles/random_obstacles.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace beespace {
namespace {

using core::Vector3;
using core::vector_of;
using obstacles::ConvexPiece;
using scenes::RandomStream;
using test::kEndless;

using Pieces = std::vector<const ConvexPiece*>;

Pieces near(const ObstacleMap& map, const Vector3& center, double reach) {
  Pieces found;
  map.state().visit_near(center, reach, [&](const ConvexPiece& piece) { found.push_back(&piece); });
  return found;
}

double distance(const ConvexPiece& piece, const Vector3& place) {
  return length(place - piece.nearest_to(place));
}

TEST(VisitNear, LeavesOutNoneThatIsNear) {
  RandomStream random(1);
  int visited = 0;
  int left_out = 0;
  for (int round = 0; round < test::rounds(400); ++round) {
    const double spread = std::exp(random.uniform(0.0, 6.0));
    const auto map = *ObstacleMap::of(test::random_obstacles(random, random.index(200), spread));
    const Pieces all = near(map, {}, kEndless);
    ASSERT_GE(all.size(), map.obstacles().size());
    for (int place = 0; place < 10; ++place) {
      const Vector3 center = vector_of(test::random_place(random, 1.5 * spread));
      // Now and then exactly as far as one of them.
      double reach = random.uniform(0.0, 0.3 * spread);
      if (!all.empty() && random.index(2) == 0) {
        reach = distance(*all[random.index(static_cast<std::uint32_t>(all.size()))], center);
      }
      const Pieces found = near(map, center, reach);
      std::size_t next = 0;
      for (const ConvexPiece* piece : all) {
        const bool is_found = next < found.size() && found[next] == piece;
        if (is_found) ++next;
        ++(is_found ? visited : left_out);
        ASSERT_TRUE(is_found || distance(*piece, center) > reach) << "round " << round;
      }
      ASSERT_EQ(next, found.size()) << "another order, or one twice; round " << round;
    }
  }
  EXPECT_GT(visited, test::rounds(400) * 10);
  EXPECT_GT(left_out, test::rounds(400) * 100);
}

TEST(VisitNear, KnowsTheObstacleOfEachPiece) {
  RandomStream random(2);
  for (int round = 0; round < test::rounds(50); ++round) {
    const auto map = *ObstacleMap::of(test::random_obstacles(random, 100, 20.0));
    std::vector<int> pieces(100);
    for (const ConvexPiece* piece : near(map, {}, kEndless)) {
      ASSERT_LT(piece->obstacle(), 100U);
      ++pieces[piece->obstacle()];
      const Vector3 place = piece->nearest_to(vector_of(test::random_place(random, 30.0)));
      const Obstacle& obstacle = map.obstacles()[piece->obstacle()];
      ASSERT_LE(nearest_surface(obstacle, {place.x, place.y, place.z}).value().distance_m, 1e-12);
    }
    EXPECT_GE(*std::min_element(pieces.begin(), pieces.end()), 1);
    EXPECT_GT(*std::max_element(pieces.begin(), pieces.end()), 1);
  }
}

TEST(VisitNear, OfAMapBuiltAgainComesInTheSameOrder) {
  RandomStream random(3);
  const auto obstacles = test::random_obstacles(random, 500, 30.0);
  const auto first = *ObstacleMap::of(obstacles);
  const auto second = *ObstacleMap::of(obstacles);
  const Pieces one = near(first, {}, 15.0);
  const Pieces other = near(second, {}, 15.0);
  ASSERT_EQ(one.size(), other.size());
  EXPECT_GT(one.size(), 50U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i]->obstacle(), other[i]->obstacle());
    EXPECT_EQ(one[i]->extent().low, other[i]->extent().low);
  }
}

// In a city of ten thousand towers a query visits only the few that are near.
TEST(VisitNear, VisitsFewOfMany) {
  RandomStream random(5);
  std::vector<Obstacle> obstacles;
  for (int i = 0; i < 10'000; ++i) {
    obstacles.push_back(UprightCylinder{random.uniform(0.0, 1e4),
                                        random.uniform(0.0, 1e4),
                                        random.uniform(0.0, 5.0),
                                        {0.0, random.uniform(1, 100)}});
  }
  const auto map = *ObstacleMap::of(obstacles);
  std::size_t visited = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 center{random.uniform(0.0, 1e4), random.uniform(0.0, 1e4), 50.0};
    visited += near(map, center, 50.0).size();
  }
  EXPECT_LT(visited, 1000U * 3);  // one in 100 m by 100 m
  EXPECT_GT(visited, 500U);
}

}  // namespace
}  // namespace beespace
