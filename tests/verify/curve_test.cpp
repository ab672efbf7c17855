#include "verify/curve.hpp"

#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/support/rounds.hpp"
#include "tests/verify/curve_oracle.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace beespace::verify {
namespace {

using scenes::RandomStream;

Point at(const Curve& curve, double u) {
  const auto& c = curve.control;
  const double r = 1.0 - u;
  const double weights[] = {r * r * r, 3.0 * r * r * u, 3.0 * r * u * u, u * u * u};
  Point p;
  for (std::size_t k = 0; k < 4; ++k) {
    p = {p.x + weights[k] * c[k].x, p.y + weights[k] * c[k].y, p.z + weights[k] * c[k].z};
  }
  return p;
}

double least_distance(const Curve& curve) {
  const auto& c = curve.control;
  const auto distance = [&](long double u) {
    const long double r = 1.0L - u;
    const long double weights[] = {r * r * r, 3.0L * r * r * u, 3.0L * r * u * u, u * u * u};
    std::array<long double, 3> p{};
    for (std::size_t k = 0; k < 4; ++k) {
      p[0] += weights[k] * static_cast<long double>(c[k].x);
      p[1] += weights[k] * static_cast<long double>(c[k].y);
      p[2] += weights[k] * static_cast<long double>(c[k].z);
    }
    return std::hypot(p[0], p[1], p[2]);
  };
  return static_cast<double>(test::least_of(distance, 200));
}

Point random_point(RandomStream& random, double size) {
  return {random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
}

Curve random_curve(RandomStream& random, double off) {
  const double size = std::exp(random.uniform(-3.0, 3.0));
  const Point middle = random_point(random, off);
  Curve curve;
  for (Point& p : curve.control) {
    const auto [x, y, z] = random_point(random, size);
    p = {middle.x + x, middle.y + y, middle.z + z};
  }
  return curve;
}

TEST(Curve, HasTheGivenPlacesAndVelocitiesAtItsEnds) {
  const Mover from{{1, 2, 3}, {4, -5, 6}};
  const Mover to{{-7, 8, 9}, {1, 0, -2}};
  const double lasts_s = 0.5;
  const Curve curve = curve_of(from, to, lasts_s);
  EXPECT_EQ(at(curve, 0.0), from.position);
  EXPECT_EQ(at(curve, 1.0), to.position);
  const double little = 1e-6;
  const Point start = at(curve, little);
  const Point end = at(curve, 1.0 - little);
  const double scale = 1.0 / (little * lasts_s);
  EXPECT_NEAR((start.x - from.position.x) * scale, from.velocity.x, 1e-3);
  EXPECT_NEAR((start.y - from.position.y) * scale, from.velocity.y, 1e-3);
  EXPECT_NEAR((start.z - from.position.z) * scale, from.velocity.z, 1e-3);
  EXPECT_NEAR((to.position.x - end.x) * scale, to.velocity.x, 1e-3);
  EXPECT_NEAR((to.position.y - end.y) * scale, to.velocity.y, 1e-3);
  EXPECT_NEAR((to.position.z - end.z) * scale, to.velocity.z, 1e-3);
}

// p + v t + a t^2 / 2 is the curve between any two of its places.
TEST(Curve, OfEvenAccelerationIsThatMotion) {
  const Point p{1, -2, 3};
  const Velocity v{4, 5, -6};
  const Velocity a{-2, 1, 3};
  const double lasts_s = 0.8;
  const auto fix = [&](double t) {
    return Mover{{p.x + v.x * t + a.x * t * t / 2, p.y + v.y * t + a.y * t * t / 2,
                  p.z + v.z * t + a.z * t * t / 2},
                 {v.x + a.x * t, v.y + a.y * t, v.z + a.z * t}};
  };
  const Curve curve = curve_of(fix(0.0), fix(lasts_s), lasts_s);
  for (const double u : {0.1, 0.25, 0.5, 0.9}) {
    const Point expected = fix(u * lasts_s).position;
    const Point found = at(curve, u);
    EXPECT_NEAR(found.x, expected.x, 1e-14);
    EXPECT_NEAR(found.y, expected.y, 1e-14);
    EXPECT_NEAR(found.z, expected.z, 1e-14);
  }
}

TEST(Curve, ALineIsEven) {
  const Curve line = line_of({0, 0, 0}, {3, 6, -9});
  EXPECT_NEAR(
      length(difference(line, {{{{0, 0, 0}, {1, 2, -3}, {2, 4, -6}, {3, 6, -9}}}}).control[1]), 0.0,
      1e-15);
  const Point middle = at(line, 0.5);
  EXPECT_NEAR(middle.x, 1.5, 1e-15);
  EXPECT_NEAR(middle.y, 3.0, 1e-15);
  EXPECT_NEAR(middle.z, -4.5, 1e-15);
}

// Never above the truth, and never further below it than the tolerance; one object for all.
TEST(ClosestToOrigin, IsBelowTheClosestByLessThanTheTolerance) {
  RandomStream random(1);
  ClosestToOrigin closest;
  for (int round = 0; round < test::rounds(2'000); ++round) {
    const Curve curve = random_curve(random, random.uniform(0.0, 20.0));
    const double tolerance = std::exp(random.uniform(std::log(1e-10), 0.0));
    const double truth = least_distance(curve);
    const double found = closest(curve, tolerance);
    ASSERT_LE(found, truth + 1e-14 * (1.0 + truth)) << "round " << round;
    ASSERT_GE(found, truth - tolerance * (1.0 + 1e-3) - 1e-13) << "round " << round;
  }
}

TEST(ClosestToOrigin, OfCurvesThroughTheOriginIsNought) {
  RandomStream random(2);
  ClosestToOrigin closest;
  for (int round = 0; round < test::rounds(5'000); ++round) {
    Curve curve = random_curve(random, 3.0);
    const Point through = at(curve, random.uniform());
    for (Point& p : curve.control) p = {p.x - through.x, p.y - through.y, p.z - through.z};
    const double found = closest(curve, 1e-9);
    ASSERT_GE(found, 0.0);
    ASSERT_LE(found, 1e-13) << "round " << round;
  }
}

TEST(ClosestToOrigin, OfPointsLinesAndCusps) {
  ClosestToOrigin closest;
  const auto near = [&](const Curve& curve) { return closest(curve, 1e-12); };
  EXPECT_NEAR(near({{{{3, 4, 0}, {3, 4, 0}, {3, 4, 0}, {3, 4, 0}}}}), 5.0, 1e-12);
  EXPECT_EQ(near({}), 0.0);
  EXPECT_NEAR(near(line_of({-3, 2, 0}, {5, 2, 0})), 2.0, 2e-12);
  EXPECT_NEAR(near(line_of({1, 2, 2}, {5, 9, 9})), 3.0, 2e-12);
  // There and back again, to the origin and not quite.
  EXPECT_NEAR(near({{{{4, 0, 0}, {0, 0, 0}, {0, 0, 0}, {4, 0, 0}}}}), 1.0, 2e-12);
  // Within the hull of its control points, but not on the curve.
  EXPECT_NEAR(near({{{{-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}}}), 0.5, 2e-12);
}

}  // namespace
}  // namespace beespace::verify
