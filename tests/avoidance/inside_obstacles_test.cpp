// Bees that begin in an obstacle, or too close to one, are named, and they get out.
#include "tests/avoidance/obstacle_course.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Course;

// The time limit: straight out of the obstacle, from rest to rest.
double seconds_out(const FlightLimits& limits, double way_m) {
  const double a = limits.max_acceleration_mps2;
  return 2.0 * way_m / limits.max_speed_mps +
         (std::isinf(a) ? 0.0 : limits.max_speed_mps / a + 3.0 * std::sqrt(way_m / a));
}

// The number of steps until all are certified; -1 if that takes more than `most`.
int steps_to_clear(Course& course, const Velocity& wish, int most) {
  Adviser adviser;
  Advised advised;
  const std::vector<Velocity> wishes(course.flock.size(), wish);
  for (int step = 0; step <= most; ++step) {
    test::fly_a_step(course.flock, adviser, wishes, advised);
    if (testing::Test::HasFailure()) return -1;
    if (test::all_certified(advised)) return step;
  }
  return -1;
}

// One bee that stands `deep_m` below the surface.
void expect_gets_out(Course& course, double deep_m, const Velocity& wish) {
  const test::Flock& flock = course.flock;
  const double way_m = deep_m + flock.options.clearance_m;
  const double step_s = flock.options.step_s;
  const int most = 15 + static_cast<int>(seconds_out(flock.limits[0], way_m) / step_s);
  const int steps = steps_to_clear(course, wish, most);
  ASSERT_GE(steps, 1) << "not in " << most << " steps, " << deep_m << " m deep; now at "
                      << test::clearance_at(course.map, course.flock.movers[0].position);
  EXPECT_GE(test::clearance_at(course.map, course.flock.movers[0].position),
            course.flock.options.clearance_m);
}

FlightLimits random_limits(RandomStream& random, double scale_m) {
  const double speed = scale_m * test::log_uniform(random, 0.02, 5.0);
  return {speed,
          random.index(2) == 0 ? test::kNoLimit : speed * test::log_uniform(random, 0.1, 5.0)};
}

Obstacle random_convex(RandomStream& random, double scale_m) {
  const auto size = [&] { return scale_m * random.uniform(0.5, 2.0); };
  const Point at = test::random_place(random, 10.0 * scale_m);
  const Heights heights{at.z, random.index(3) == 0 ? test::kNoLimit : at.z + size()};
  switch (random.index(5)) {
    case 0:
      return Sphere{at, size()};
    case 1:
      return Box{at, {at.x + size(), at.y + size(), at.z + size()}};
    case 2:
      return Ground{at.z};
    case 3:
      return UprightCylinder{at.x, at.y, size(), heights};
    default:
      return UprightPrism{test::moved({{0, 0}, {2, 0}, {2, 1}, {1, 2}}, scale_m, {at.x, at.y}),
                          heights};
  }
}

TEST(InsideObstacles, ABeeTooCloseIsNamedAndGetsOutAsFastAsItCan) {
  RandomStream random(1);
  int inside = 0;
  for (int round = 0; round < test::rounds(2'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Course course;
    const double scale_m = test::log_uniform(random, 0.1, 300.0);
    course.map = test::map_of({random_convex(random, scale_m)});
    const Obstacle& obstacle = course.map.obstacles()[0];
    course.flock.options.clearance_m = scale_m * test::log_uniform(random, 0.01, 1.0);
    course.flock.options.step_s = test::log_uniform(random, 0.01, 1.0);
    const Point at = test::place_near(obstacle, scale_m, random);
    course.flock.movers = {{at, {}}};
    course.flock.limits = {random_limits(random, scale_m)};
    const double clear_m = test::clearance_at(course.map, at);
    if (clear_m > 0.999 * course.flock.options.clearance_m) continue;
    const auto advised = advise(course.flock.movers, std::vector<Velocity>(1), course.flock.limits,
                                course.flock.options);
    ASSERT_TRUE(advised);
    EXPECT_FALSE(advised->advice[0].certified);
    ASSERT_EQ(advised->near_obstacle.size(), 1U);
    EXPECT_EQ(advised->near_obstacle[0].agent, 0U);
    EXPECT_EQ(advised->near_obstacle[0].obstacle, 0U);
    EXPECT_NEAR(advised->near_obstacle[0].gap_m, clear_m, 1e-11 * scale_m);
    EXPECT_NE(advised->advice[0].kind, AdviceKind::kAsPreferred);
    ASSERT_NO_FATAL_FAILURE(expect_gets_out(course, std::max(0.0, -clear_m), {}));
    inside += clear_m < 0.0 ? 1 : 0;
  }
  EXPECT_GT(inside, test::rounds(2'000) / 6);
}

// At the centre, on the surface, on an edge, on a corner: all ways out are equally good.
TEST(InsideObstacles, OneOfEquallyGoodWaysOutIsTaken) {
  const std::vector<Obstacle> obstacles = {
      Sphere{{0, 0, 0}, 3.0},
      Sphere{{0, 0, 0}, 0.0},
      Box{{-2, -2, -2}, {2, 2, 2}},
      Box{{-2, -2, 0}, {2, 2, 0}},
      Box{{0, 0, 0}, {0, 0, 0}},
      Ground{0.0},
      UprightCylinder{0, 0, 3.0, {-1, 1}},
      UprightCylinder{0, 0, 3.0, {}},
      UprightPrism{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}, {-2, 2}},
      UprightPrism{{{-2, -2}, {2, -2}, {0, 2}}, {}}};
  const std::vector<Point> places = {{0, 0, 0},  {2, 0, 0}, {0, 2, 0},   {0, 0, 2},  {2, 2, 0},
                                     {2, 2, 2},  {3, 0, 0}, {0, -3, 0},  {0, 0, -3}, {0, 0, 1},
                                     {0, -2, 0}, {3, 0, 1}, {-2, -2, 0}, {0, 0, -2}};
  for (std::size_t which = 0; which < obstacles.size(); ++which) {
    for (const Point& at : places) {
      for (const double acceleration : {test::kNoLimit, 2.0}) {
        SCOPED_TRACE(testing::Message() << which << " at " << at.x << ", " << at.y << ", " << at.z);
        Course course;
        course.map = test::map_of({obstacles[which]});
        course.flock.options.clearance_m = 0.5;
        course.flock.movers = {{at, {}}};
        course.flock.limits = {{4.0, acceleration}};
        const double clear_m = test::clearance_at(course.map, at);
        if (clear_m > 0.4) continue;
        const auto advised = advise(course.flock.movers, std::vector<Velocity>(1),
                                    course.flock.limits, course.flock.options);
        ASSERT_TRUE(advised);
        ASSERT_EQ(advised->near_obstacle.size(), 1U);
        EXPECT_NEAR(advised->near_obstacle[0].gap_m, clear_m, 1e-12);
        ASSERT_NO_FATAL_FAILURE(expect_gets_out(course, std::max(0.0, -clear_m), {}));
      }
    }
  }
}

// Outlines that are cut into pieces: the bee stands anywhere, in any piece, near any cut. (Some
// random outlines have notches that are too narrow for the clearance.)
// So near to the surface that doubles do not tell on which side of it: the bee still flies out.
TEST(InsideObstacles, ABeeOnTheSurfaceGetsOut) {
  RandomStream random(11);
  int inside = 0;
  for (int round = 0; round < test::rounds(2'000); ++round) {
    const Point middle{1e6, 1e6, 0.0};
    const double radius_m = random.uniform(1.0, 20.0);
    const auto [x, y, z] = scenes::random_direction(random);
    const Point bee{middle.x + radius_m * x, middle.y + radius_m * y, middle.z + radius_m * z};
    const ObstacleMap map = test::map_of({Sphere{middle, radius_m}});
    AdviseOptions options{.threshold_m = 5.0, .clearance_m = 1.0};
    options.obstacles = &map;
    const FlightLimits limits{10.0, 5.0};
    const auto advised = advise(std::vector<Mover>{{bee, {}}}, std::vector<Velocity>(1),
                                std::vector<FlightLimits>{limits}, options);
    ASSERT_TRUE(advised);
    ASSERT_EQ(advised->near_obstacle.size(), 1U);
    inside += advised->near_obstacle[0].gap_m < 0.0 ? 1 : 0;
    ASSERT_NEAR(advised->near_obstacle[0].gap_m, 0.0, 1e-8);
    const Velocity& v = advised->advice[0].velocity;
    ASSERT_NEAR(v.x * x + v.y * y + v.z * z, 0.5, 1e-3) << "as hard as it can, outward";
  }
  EXPECT_GT(inside, test::rounds(2'000) / 10);
}

TEST(InsideObstacles, TheyGetOutOfOutlinesThatAreNotConvex) {
  const test::Corners outlines[] = {test::letter_l(), test::letter_u(), test::star(),
                                    test::spiral(), test::comb()};
  RandomStream random(2);
  int inside = 0;
  for (int round = 0; round < test::rounds(4'000); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    Course course;
    const auto& outline = outlines[random.index(5)];
    course.map = test::map_of({UprightPrism{test::begun_anywhere(outline, random), {}}});
    course.flock.options.clearance_m = 0.01;
    const Point at{random.uniform(-5.0, 9.0), random.uniform(-5.0, 7.0), 0.0};
    course.flock.movers = {{at, {}}};
    course.flock.limits = {{2.0, round % 2 == 0 ? test::kNoLimit : 2.0}};
    const double clear_m = test::clearance_at(course.map, at);
    if (clear_m > 0.0) continue;
    ++inside;
    const auto advised = advise(course.flock.movers, std::vector<Velocity>(1), course.flock.limits,
                                course.flock.options);
    ASSERT_TRUE(advised);
    ASSERT_EQ(advised->near_obstacle.size(), 1U);
    EXPECT_NEAR(advised->near_obstacle[0].gap_m, clear_m, 1e-12);
    ASSERT_NO_FATAL_FAILURE(expect_gets_out(course, -clear_m, {})) << "at " << at.x << ", " << at.y;
  }
  EXPECT_GT(inside, test::rounds(4'000) / 10);
}

}  // namespace
}  // namespace beespace
