// Every kind of obstacle against its faces, one by one, in long doubles.
#include <beespace/obstacle.hpp>

#include "scenes/random_stream.hpp"
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::kEndless;
using test::true_distance;

double distance(const Obstacle& obstacle, const Point& place) {
  const auto nearest = nearest_surface(obstacle, place);
  EXPECT_TRUE(nearest) << nearest.error().message;
  return nearest ? nearest->distance_m : 0.0;
}

double between(const Point& a, const Point& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

// Right as a number, and the point is one of the surface that is so far away.
void expect_nearest(const Obstacle& obstacle, const Point& place, double tolerance) {
  const auto nearest = nearest_surface(obstacle, place);
  ASSERT_TRUE(nearest) << nearest.error().message;
  const double truth = static_cast<double>(true_distance(obstacle, place));
  ASSERT_NEAR(nearest->distance_m, truth, tolerance);
  ASSERT_NEAR(between(place, nearest->point), std::abs(truth), tolerance);
  ASSERT_NEAR(static_cast<double>(true_distance(obstacle, nearest->point)), 0.0, tolerance);
}

TEST(NearestSurface, OfEachKind) {
  const Sphere sphere{{1, 2, 3}, 2};
  EXPECT_EQ(distance(sphere, {1, 2, 8}), 3.0);
  EXPECT_EQ(distance(sphere, {1, 2, 5}), 0.0);
  EXPECT_EQ(distance(sphere, {1, 2, 3.5}), -1.5);
  EXPECT_EQ(distance(sphere, {1, 2, 3}), -2.0);

  const Box box{{0, 0, 0}, {4, 6, 8}};
  EXPECT_EQ(distance(box, {7, 3, 12}), 5.0);
  EXPECT_EQ(distance(box, {-2, -3, -6}), 7.0);
  EXPECT_EQ(distance(box, {1.5, 3, 4}), -1.5);
  EXPECT_EQ(distance(box, {4, 3, 4}), 0.0);

  EXPECT_EQ(distance(Ground{10}, {5, 5, 12}), 2.0);
  EXPECT_EQ(distance(Ground{10}, {5, 5, 3}), -7.0);

  const UprightCylinder cylinder{1, 1, 2, {0, 10}};
  EXPECT_EQ(distance(cylinder, {6, 1, 14}), 5.0);
  EXPECT_EQ(distance(cylinder, {6, 1, 5}), 3.0);
  EXPECT_EQ(distance(cylinder, {2, 1, 12}), 2.0);
  EXPECT_EQ(distance(cylinder, {2, 1, 5}), -1.0);
  EXPECT_EQ(distance(cylinder, {1, 1, 9.5}), -0.5);
  EXPECT_EQ(distance(UprightCylinder{1, 1, 2, {}}, {1, 1, 1e9}), -2.0);

  const UprightPrism corner{test::letter_l(), {0, 10}};
  EXPECT_EQ(distance(corner, {2, 3, 5}), 1.0);
  EXPECT_EQ(distance(corner, {0.5, 0.75, 5}), -0.5);
  EXPECT_EQ(distance(corner, {7, 5, 5}), 5.0);     // the end of an arm: its corner (4, 1)
  EXPECT_EQ(distance(corner, {0.5, 7, 14}), 5.0);  // the rim of its lid
  EXPECT_EQ(distance(corner, {0.5, 2, 9.75}), -0.25);
}

TEST(NearestSurface, OfRandomObstaclesIsTheNearestFace) {
  RandomStream random(1);
  int inside[test::kKinds] = {};
  int outside[test::kKinds] = {};
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const std::size_t kind = static_cast<std::size_t>(round) % test::kKinds;
    const Obstacle obstacle = test::random_obstacle(random, kind, 1.0);
    const Point place = test::random_place(random, random.index(2) == 0 ? 12.0 : 4.0);
    ASSERT_NO_FATAL_FAILURE(expect_nearest(obstacle, place, 1e-13))
        << "round " << round << ", kind " << kind;
    ++(true_distance(obstacle, place) < 0.0L ? inside : outside)[kind];
  }
  for (std::size_t kind = 0; kind < test::kKinds; ++kind) {
    EXPECT_GT(inside[kind], test::rounds(100'000) / 1000) << kind;
    EXPECT_GT(outside[kind], test::rounds(100'000) / 50) << kind;
  }
}

// To some 1e-14 of the coordinates, of places beside the surface too.
TEST(NearestSurface, FarFromTheOriginAndClose) {
  RandomStream random(2);
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const Point middle = test::random_place(random, 1e6);
    const double scale = std::exp(random.uniform(-3.0, 6.0));
    const std::size_t kind = static_cast<std::size_t>(round) % test::kKinds;
    const Obstacle obstacle = test::random_obstacle(random, kind, scale, middle);
    const Point off = test::random_place(random, 12.0 * scale);
    const Point place{middle.x + off.x, middle.y + off.y, middle.z + off.z};
    ASSERT_NO_FATAL_FAILURE(expect_nearest(obstacle, place, 1e-14 * 1e6)) << "round " << round;
    const auto surface = nearest_surface(obstacle, place);
    const double close = 1e-3 * scale;
    const Point beside{surface->point.x + random.uniform(-close, close),
                       surface->point.y + random.uniform(-close, close),
                       surface->point.z + random.uniform(-close, close)};
    ASSERT_NO_FATAL_FAILURE(expect_nearest(obstacle, beside, 1e-14 * 1e6)) << "round " << round;
    ASSERT_NO_FATAL_FAILURE(expect_nearest(obstacle, surface->point, 1e-14 * 1e6))
        << "round " << round;
  }
}

TEST(NearestSurface, DoesNotDependOnTheOrderOfTheOutline) {
  RandomStream random(3);
  for (int round = 0; round < test::rounds(5'000); ++round) {
    const test::Corners corners = test::random_outline(random);
    test::Corners closed = corners;
    closed.push_back(closed.front());
    const Point place = test::random_place(random, 8.0);
    const double once = distance(UprightPrism{corners, {-2, 2}}, place);
    const double again =
        distance(UprightPrism{test::begun_anywhere(corners, random), {-2, 2}}, place);
    ASSERT_NEAR(again, once, 1e-14) << "round " << round;
    ASSERT_EQ(distance(UprightPrism{closed, {-2, 2}}, place), once) << "round " << round;
  }
}

TEST(NearestSurface, OfAnObstacleOfNoSize) {
  EXPECT_EQ(distance(Sphere{{1, 1, 1}, 0}, {1, 1, 1}), 0.0);
  EXPECT_EQ(distance(Sphere{{1, 1, 1}, 0}, {1, 5, 4}), 5.0);
  EXPECT_EQ(distance(UprightCylinder{1, 1, 0, {0, 9}}, {1, 1, 5}), 0.0);
  EXPECT_EQ(distance(UprightCylinder{1, 1, 0, {0, 9}}, {4, 5, 5}), 5.0);
  const Box wall{{0, 0, 0}, {0, 10, 10}};
  EXPECT_EQ(distance(wall, {3, 5, 5}), 3.0);
  EXPECT_EQ(distance(wall, {0, 5, 5}), 0.0);
  EXPECT_EQ(distance(wall, {0, 13, 14}), 5.0);
  EXPECT_FALSE(std::signbit(distance(Sphere{{1, 1, 1}, 0}, {1, 1, 1})));
  EXPECT_FALSE(std::signbit(distance(wall, {0, 5, 5})));
  EXPECT_FALSE(std::signbit(distance(UprightPrism{test::square(), {}}, {0, 0.5, 0})));
}

// At the ends of the domain nothing overflows, and nothing is lost in the very middle.
TEST(NearestSurface, IsANumberEverywhereInTheDomain) {
  RandomStream random(4);
  const double sizes[] = {0.0, kSmallestInMotion, 1e-20, 1.0, 1e6, 1e20, kLargestInMotion};
  int asked = 0;
  const auto any = [&] {
    const double size = sizes[random.index(7)];
    return random.index(2) == 0 ? size : -size;
  };
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const double size = std::abs(any());
    const double low = any();
    const double more = std::abs(any());
    const double high = low < more ? more : kEndless;
    const Point at{any(), any(), any()};
    const Obstacle obstacles[] = {
        Sphere{at, size}, Ground{at.z}, UprightCylinder{at.x, at.y, size, {low, high}},
        Box{{-more, low, -size}, {more, std::max(low, more), size}},
        UprightPrism{{{0, 0}, {1e20, 0}, {0, kLargestInMotion}}, {low, high}}};
    const Point place{any(), any(), any()};
    for (const Obstacle& obstacle : obstacles) {
      const auto nearest = nearest_surface(obstacle, place);
      ASSERT_TRUE(nearest) << nearest.error().message;
      const double truth = static_cast<double>(true_distance(obstacle, place));
      ASSERT_NEAR(nearest->distance_m, truth, 1e-14 * kLargestInMotion) << "round " << round;
      ASSERT_TRUE(std::isfinite(nearest->point.x + nearest->point.y + nearest->point.z));
      ++asked;
    }
  }
  EXPECT_EQ(asked, 5 * test::rounds(50'000));
}

}  // namespace
}  // namespace beespace
