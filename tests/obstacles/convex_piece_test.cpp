// The interface of a piece that the certificate uses: its nearest point, and its extent along a
// direction.
//
// A place q of a convex set is the nearest to p if and only if the set reaches no farther towards p
// than q does, so that the two prove each other.
#include "obstacles/convex_piece.hpp"

#include "scenes/random_velocity.hpp"
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace beespace::obstacles {
namespace {

using scenes::RandomStream;
using test::kEndless;
using test::Real;
using test::real;

Vector3 direction(RandomStream& random) {
  switch (random.index(4)) {
    case 0:
      return {0, 0, random.index(2) == 0 ? 1.0 : -1.0};
    case 1: {
      const Point d = scenes::random_direction(random);
      const double across = std::hypot(d.x, d.y);
      return {d.x / across, d.y / across, 0};
    }
    default:
      return vector_of(scenes::random_direction(random));
  }
}

Point point_of(const Vector3& a) {
  return {a.x, a.y, a.z};
}

std::vector<ConvexPiece> pieces_of(const Obstacle& obstacle) {
  std::vector<ConvexPiece> pieces;
  append_pieces(solid_of(obstacle), 7, pieces);
  return pieces;
}

Real long_dot(const Vector3& n, Real x, Real y, Real z) {
  return real(n.x) * x + real(n.y) * y + real(n.z) * z;
}

// How far heights reach, where that is looked at.
Real reach_of(const Heights& heights, double normal) {
  if (normal == 0.0) return 0.0L;
  return real(normal) * real(normal > 0.0 ? heights.high_m : heights.low_m);
}

// Corner by corner; of round ones by their definition.
struct TrueSupport {
  Vector3 n;

  Real operator()(const Sphere& s) const {
    return long_dot(n, real(s.center.x), real(s.center.y), real(s.center.z)) +
           real(s.radius_m) * std::sqrt(long_dot(n, real(n.x), real(n.y), real(n.z)));
  }
  Real operator()(const Box& box) const {
    Real most = -real(kEndless);
    for (const double x : {box.low.x, box.high.x}) {
      for (const double y : {box.low.y, box.high.y}) {
        for (const double z : {box.low.z, box.high.z}) {
          most = std::max(most, long_dot(n, real(x), real(y), real(z)));
        }
      }
    }
    return most;
  }
  Real operator()(const Ground& ground) const {
    const bool up = n.x == 0.0 && n.y == 0.0 && n.z >= 0.0;
    return up ? real(n.z) * real(ground.height_m) : real(kEndless);
  }
  Real operator()(const UprightCylinder& c) const {
    return long_dot(n, real(c.x), real(c.y), 0.0L) +
           real(c.radius_m) * std::hypot(real(n.x), real(n.y)) + reach_of(c.heights, n.z);
  }
  Real operator()(const UprightPrism& prism) const {
    Real most = -real(kEndless);
    for (const Corner& corner : prism.outline) {
      most = std::max(most, long_dot(n, real(corner.x), real(corner.y), 0.0L));
    }
    return most + reach_of(prism.heights, n.z);
  }
};

TEST(ConvexPiece, ReachesAsFarAsItsCorners) {
  RandomStream random(1);
  int endless = 0;
  int with_end = 0;
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const double scale = std::exp(random.uniform(-5.0, 10.0));
    const Obstacle obstacle =
        test::random_obstacle(random, static_cast<std::size_t>(round) % test::kKinds, scale);
    const Vector3 normal = direction(random) * std::exp(random.uniform(-5.0, 5.0));
    const Real truth = std::visit(TrueSupport{normal}, obstacle);
    double found = -kEndless;
    for (const ConvexPiece& piece : pieces_of(obstacle)) {
      EXPECT_EQ(piece.obstacle(), 7U);
      found = std::max(found, piece.support(normal));
    }
    if (std::isinf(truth)) {
      ASSERT_EQ(real(found), truth) << "round " << round;
      ++endless;
    } else {
      // The obstacles reach to 15 times their scale.
      ASSERT_NEAR(static_cast<double>(real(found) - truth), 0.0,
                  1e-15 * 15.0 * scale * length(normal))
          << "round " << round;
      ++with_end;
    }
  }
  EXPECT_GT(endless, test::rounds(100'000) / 20);
  EXPECT_GT(with_end, test::rounds(100'000) / 4);
}

struct Tally {
  int inside = 0;
  int outside = 0;
};

void expect_nearest(const ConvexPiece& piece, const Vector3& place, double rounding, Tally& tally) {
  const Vector3 nearest = piece.nearest_to(place);
  const Facing facing = piece.facing(place);
  ASSERT_NEAR(length(facing.normal), 1.0, 1e-15);
  const double reach = piece.support(facing.normal);
  ASSERT_NEAR(dot(facing.normal, vector_of(facing.surface.point)), reach, rounding);
  ASSERT_NEAR(dot(facing.normal, place) - reach, facing.surface.distance_m, rounding);
  if (facing.surface.distance_m <= 0.0) {
    ASSERT_EQ(nearest, place);
    ++tally.inside;
    return;
  }
  ++tally.outside;
  ASSERT_EQ(nearest, vector_of(facing.surface.point));
  const Vector3 between = place - nearest;
  const double apart = length(between);
  if (!(apart > 0.0)) return;
  ASSERT_NEAR(length(between * (1.0 / apart) - facing.normal), 0.0, rounding / apart);
  // No point of the piece is beyond the nearest one, which belongs to the piece.
  ASSERT_LE(dot(between, between) - dot(between, place) + piece.support(between),
            rounding * (1.0 + apart));
  ASSERT_NEAR(length(piece.nearest_to(nearest) - nearest), 0.0, rounding);
}

TEST(ConvexPiece, HasNothingNearerThanTheNearestPlace) {
  RandomStream random(2);
  Tally tally;
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const std::size_t kind = static_cast<std::size_t>(round) % test::kKinds;
    for (const ConvexPiece& piece : pieces_of(test::random_obstacle(random, kind, 1.0))) {
      const Vector3 place =
          vector_of(test::random_place(random, random.index(2) == 0 ? 12.0 : 4.0));
      ASSERT_NO_FATAL_FAILURE(expect_nearest(piece, place, 2e-13, tally)) << "round " << round;
      // Closer and closer, and as close as doubles get: the normal stays right.
      const Facing facing = piece.facing(place);
      const double close = std::exp(random.uniform(-36.0, 0.0));
      const Vector3 beside = vector_of(facing.surface.point) + facing.normal * close;
      ASSERT_NO_FATAL_FAILURE(expect_nearest(piece, beside, 2e-13, tally)) << "round " << round;
    }
  }
  EXPECT_GT(tally.inside, test::rounds(100'000) / 20);
  EXPECT_GT(tally.outside, test::rounds(100'000) / 2);
}

TEST(ConvexPiece, TogetherTheyAreTheObstacle) {
  RandomStream random(3);
  Tally tally;
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const Obstacle obstacle =
        test::random_obstacle(random, static_cast<std::size_t>(round) % test::kKinds, 1.0);
    const Vector3 place = vector_of(test::random_place(random, random.index(2) == 0 ? 12.0 : 4.0));
    const double truth = static_cast<double>(test::true_distance(obstacle, point_of(place)));
    double least = kEndless;
    for (const ConvexPiece& piece : pieces_of(obstacle)) {
      least = std::min(least, length(place - piece.nearest_to(place)));
    }
    ASSERT_NEAR(least, std::max(truth, 0.0), 1e-13) << "round " << round;
    ++(truth > 0.0 ? tally.outside : tally.inside);
  }
  EXPECT_GT(tally.inside, test::rounds(50'000) / 100);
  EXPECT_GT(tally.outside, test::rounds(50'000) / 10);
}

}  // namespace
}  // namespace beespace::obstacles
