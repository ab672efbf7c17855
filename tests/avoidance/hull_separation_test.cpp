// The plane between two hulls, against a search in long doubles that shares no arithmetic with it.
#include "avoidance/constraints/hull_separation.hpp"

#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace beespace::avoidance {
namespace {

using scenes::RandomStream;
using test::long_of;
using test::LongVector;

Hull hull_of(const std::vector<Vector3>& points) {
  Hull hull{points, {points[0], points[1 % points.size()] - points[0]}, 0.0};
  for (const Vector3& p : points) {
    hull.beside_m = std::max(hull.beside_m, length(p - hull.axis.closest_to(p)));
  }
  return hull;
}

// The point of the hull of all differences that is closest to the origin, by moving weight from the
// highest point that has some to the lowest (Mitchell, Demyanov, Malozemov 1974). Gives a lower and
// an upper limit of the distance.
struct Limits {
  long double low = 0.0L;
  long double high = 0.0L;
};

Limits distance_of(const std::vector<Vector3>& first, const std::vector<Vector3>& second) {
  std::vector<LongVector> all;
  for (const Vector3& a : first) {
    for (const Vector3& b : second) all.push_back(long_of(a) - long_of(b));
  }
  std::vector<long double> weight(all.size(), 0.0L);
  weight[0] = 1.0L;
  LongVector at = all[0];
  Limits limits{0.0L, length(at)};
  for (int k = 0; k < 4000; ++k) {
    std::size_t lowest = 0;
    std::size_t highest = all.size();
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (dot(at, all[i]) < dot(at, all[lowest])) lowest = i;
      const bool higher = highest == all.size() || dot(at, all[i]) > dot(at, all[highest]);
      if (weight[i] > 0.0L && higher) highest = i;
    }
    const long double far = length(at);
    if (!(far > 1e-12L)) return {0.0L, far};
    limits.low = std::max(limits.low, dot(at, all[lowest]) / far);
    limits.high = std::min(limits.high, far);
    if (limits.high - limits.low < 1e-13L * limits.high) break;
    const LongVector way = all[lowest] - all[highest];
    const long double squared = dot(way, way);
    if (!(squared > 0.0L)) break;
    const long double share = std::min(weight[highest], -dot(at, way) / squared);
    if (!(share > 0.0L)) break;
    weight[highest] -= share;
    weight[lowest] += share;
    at = at + way * share;
  }
  return limits;
}

// Points, collinear, coplanar, repeated, thin, and in general.
std::vector<Vector3> random_points(RandomStream& random, const Vector3& middle, double size_m) {
  std::vector<Vector3> points;
  const auto kind = random.index(6);
  const Vector3 along = direction(random);
  const Vector3 across = direction(random);
  const std::size_t count = kind == 0 ? 1 : 2 + random.index(9);
  for (std::size_t k = 0; k < count; ++k) {
    const double s = random.uniform(-size_m, size_m);
    const double t = random.uniform(-size_m, size_m);
    if (kind == 1) points.push_back(middle + along * s);
    if (kind == 2) points.push_back(middle + along * s + across * t);
    if (kind == 3) points.push_back(middle + along * s + across * (1e-6 * t));
    if (kind == 4 && k > 0 && random.index(2) == 0) {
      points.push_back(points[0]);
    } else if (kind == 0 || kind >= 4) {
      points.push_back(middle + direction(random) * s);
    }
  }
  return points;
}

void expect_widest(const std::vector<Vector3>& first, const std::vector<Vector3>& second,
                   double spare_m) {
  const FreeBetween between{{}, 1.0, 0.0, false};
  const HullSeparation found =
      separate(hull_of(first), hull_of(second), between, {}, std::numeric_limits<double>::max());
  const Limits limits = distance_of(first, second);
  ASSERT_NEAR(length(found.plane.normal), 1.0, 1e-14);
  ASSERT_LE(found.plane.gap, static_cast<double>(limits.high) + spare_m);
  ASSERT_GE(found.plane.gap, static_cast<double>(limits.low) * (1.0 - 1e-9) - spare_m);
}

TEST(HullSeparation, TheGapIsTheDistanceOfHullsThatAreApart) {
  RandomStream random(1);
  int apart = 0;
  for (int round = 0; round < test::rounds(3000); ++round) {
    const double off_m = random.index(3) == 0 ? 1e6 : 0.0;
    const double size_m = std::exp(random.uniform(-12.0, 4.0));
    const auto first = random_points(random, {off_m, 0.0, off_m}, size_m);
    const auto second = random_points(
        random, Vector3{off_m, 0.0, off_m} + direction(random) * random.uniform(1.0, 5.0) * size_m,
        size_m * random.uniform(0.1, 1.0));
    const Limits limits = distance_of(first, second);
    if (limits.high - limits.low > 1e-10L * limits.high || limits.low < 1e-3L * size_m) continue;
    ++apart;
    ASSERT_NO_FATAL_FAILURE(expect_widest(first, second, 0x1p-46 * (off_m + size_m)))
        << "round " << round << ", size " << size_m << ", offset " << off_m;
  }
  EXPECT_GT(apart, test::rounds(3000) / 3);
}

// For all shapes no direction of many leaves more than the one that is found.
TEST(HullSeparation, LeavesAsMuchAsTheBestOfManyDirections) {
  RandomStream random(2);
  const FreeShape shapes[] = {FreeShape({}, false),
                              FreeShape({SeparationShape::kEllipsoid, 3.0}, false),
                              FreeShape({SeparationShape::kEllipsoid, 0.3}, false),
                              FreeShape({SeparationShape::kCylinder, 1.0, 3.0}, false)};
  double worst = 0.0;
  for (int round = 0; round < test::rounds(4000); ++round) {
    const FreeBetween between{shapes[round % 4], 5.0, random.uniform(0.0, 2.0), false};
    const auto first = random_points(random, {}, 5.0);
    const auto second = random_points(random, direction(random) * random.uniform(5.0, 40.0), 5.0);
    const Hull a = hull_of(first);
    const Hull b = hull_of(second);
    const HullSeparation found = separate(a, b, between, {}, 1e300);
    const auto left = [&](const Vector3& n) {
      return a.lowest(n) - b.highest(n) - between.along(n);
    };
    ASSERT_NEAR(found.left_m(), left(found.plane.normal), 1e-12);
    Vector3 best = found.plane.normal;
    for (int k = 0; k < 300; ++k) {
      // Everywhere, and around the best.
      const double near = k < 100 ? 10.0 : std::exp(random.uniform(-12.0, 0.0));
      Vector3 n = best + direction(random) * near;
      n = n * (1.0 / length(n));
      if (left(n) > left(best)) best = n;
    }
    // Where the shape cannot be kept at all, the best direction is not searched for.
    if (left(best) < -between.beyond_m) continue;
    worst = std::max(worst, left(best) - found.left_m());
  }
  EXPECT_LE(worst, 1e-7);
}

}  // namespace
}  // namespace beespace::avoidance
