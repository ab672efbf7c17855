// Planes between stopping segments and obstacles: on the right side of both, with the full gap.
#include "avoidance/constraints/obstacle_separation.hpp"

#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/support/rounds.hpp"
#include "tests/verify/curve_oracle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::avoidance {
namespace {

using obstacles::ConvexPiece;
using scenes::RandomStream;
using test::Real;

double log_uniform(RandomStream& random, double low, double high) {
  return low * std::exp(random.uniform() * std::log(high / low));
}

Point point_of(const Vector3& v) {
  return {v.x, v.y, v.z};
}

std::vector<ConvexPiece> pieces_of(const Obstacle& obstacle) {
  std::vector<ConvexPiece> pieces;
  append_pieces(obstacles::solid_of(obstacle), 0, pieces);
  return pieces;
}

// A convex obstacle of some metres, near the origin.
Obstacle random_convex(RandomStream& random, const Vector3& middle) {
  const std::size_t kind = random.index(test::kKinds);
  if (kind != 4) return test::random_obstacle(random, kind, 1.0, point_of(middle));
  const test::Corners outline = {{0, 0}, {3, 0}, {4, 2}, {1, 5}};
  return UprightPrism{test::moved(outline, random.uniform(0.1, 3.0), {middle.x, middle.y}),
                      {middle.z - 2.0, random.index(2) == 0 ? test::kEndless : middle.z + 2.0}};
}

// The distance is convex along the segment, so ternary search finds the least.
Real distance_of(const Segment& way, const Obstacle& obstacle) {
  const auto at = [&](Real share) {
    const test::LongVector place = test::long_of(way.from) + test::long_of(way.way) * share;
    return test::true_distance(
        obstacle,
        {static_cast<double>(place.x), static_cast<double>(place.y), static_cast<double>(place.z)});
  };
  return test::least_of(at, 1);
}

// For any segment: it and all of the piece lie on their own sides.
TEST(ObstacleSeparation, ThePlaneLiesBetweenTheSegmentAndThePiece) {
  RandomStream random(1);
  int crossing = 0;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const Obstacle obstacle = random_convex(random, {});
    const Segment way{core::vector_of(test::random_place(random, 10.0)),
                      direction(random) * log_uniform(random, 0.01, 50.0)};
    const ConvexPiece piece = pieces_of(obstacle)[0];
    const ObstacleSeparation plane = separate(way, piece);
    ASSERT_NEAR(length(plane.normal), 1.0, 1e-14);
    ASSERT_EQ(plane.edge, piece.support(plane.normal));
    for (const double apart_m : {0.1, 5.0}) {
      const HalfSpace side = plane.of_way(apart_m);
      for (const double share : {0.0, 0.4, 1.0}) {
        ASSERT_GE(side.inside_by(way.at(share)), -1e-12);
      }
      ASSERT_NEAR(side.offset - plane.edge, std::min(apart_m, plane.gap), 1e-12);
    }
    ASSERT_LE(plane.gap, static_cast<double>(std::max(0.0L, distance_of(way, obstacle))) + 1e-12);
    crossing += plane.gap < 0.0 ? 1 : 0;
  }
  EXPECT_GT(crossing, test::rounds(20'000) / 10);
}

// Any error of the gap reduces the clearance. Allowed are half of 2^-44 of the coordinates and of
// 1e-7 of the clearance. Segments are up to thousands of times as long as the clearance.
TEST(ObstacleSeparation, TheGapIsTheDistanceOfASegmentThatIsClear) {
  RandomStream random(2);
  int clear = 0;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const double far_m = round % 3 == 0 ? 0.0 : log_uniform(random, 1.0, 1e7);
    const Vector3 middle = direction(random) * far_m;
    const Obstacle obstacle = random_convex(random, middle);
    const ConvexPiece piece = pieces_of(obstacle)[0];
    // The segment passes a point near the obstacle's surface.
    const Vector3 start = middle + core::vector_of(test::random_place(random, 20.0));
    const obstacles::Facing facing = piece.facing(start);
    const double off_m = log_uniform(random, 0.02, 5.0);
    const Vector3 by = core::vector_of(facing.surface.point) + facing.normal * off_m;
    const double long_m = log_uniform(random, 1.0, 1000.0);
    Vector3 along = direction(random);
    if (round % 2 == 0) along = cross(facing.normal, along);
    along = along * (long_m / length(along));
    const Segment way{by - along * random.uniform(), along};
    const auto distance = static_cast<double>(distance_of(way, obstacle));
    if (!(distance > 0.01)) continue;
    ++clear;
    const double gap = separate(way, piece).gap;
    const double spare_m = 1e-7 * distance + 0x1p-44 * (far_m + long_m + 30.0);
    ASSERT_LE(gap, distance + 0.25 * spare_m);
    ASSERT_GE(gap, distance - 0.25 * spare_m) << far_m << " m off, a way of " << long_m << " m";
  }
  EXPECT_GT(clear, test::rounds(20'000) / 4);
}

// From inside, the plane touches the whole obstacle, not only the piece.
TEST(ObstacleSeparation, FromInsideItIsStraightOut) {
  RandomStream random(3);
  int inside = 0;
  for (int round = 0; round < test::rounds(20'000); ++round) {
    const Obstacle obstacle = test::random_obstacle(random, random.index(test::kKinds), 1.0);
    const Segment way{core::vector_of(test::random_place(random, 6.0)),
                      direction(random) * random.uniform(0.0, 2.0)};
    const Real distance = test::true_distance(obstacle, point_of(way.from));
    if (!(distance < -1e-9L)) continue;
    ++inside;
    const auto out = obstacles::facing_of(obstacles::solid_of(obstacle), way.from);
    const ObstacleSeparation plane = part_inside(way, out);
    ASSERT_NEAR(core::length(plane.normal), 1.0, 1e-9);
    ASSERT_NEAR(part_inside({way.from, {}}, out).gap, static_cast<double>(distance), 1e-12);
    const HalfSpace side = plane.of_way(1.0);
    ASSERT_GE(side.inside_by(way.from), -1e-12);
    ASSERT_GE(side.inside_by(way.at(1.0)), -1e-12);
  }
  EXPECT_GT(inside, test::rounds(20'000) / 40);
}

}  // namespace
}  // namespace beespace::avoidance
