// Bees that are too close to an obstacle are named, in order, and other bees are not affected.
#include "tests/avoidance/obstacle_course.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Course;

// One bee is too fast to stop in front of a wall; those around it are not, and keep their
// clearance.
TEST(NearObstacle, OthersKeepTheirClearance) {
  RandomStream random(3);
  int named = 0;
  for (int start = 0; start < (test::kSanitized ? 3 : 40); ++start) {
    const std::uint64_t seed = 7000U + static_cast<unsigned>(start);
    SCOPED_TRACE("start " + std::to_string(seed));
    Course course;
    test::make_course(course, 16, seed);
    if (course.flock.size() < 4) continue;
    // The first bee is anywhere, at its greatest speed.
    Mover& first = course.flock.movers[0];
    const auto obstacles = course.map.obstacles();
    first.position = test::place_near(obstacles[0], course.flock.options.threshold_m, random);
    first.velocity = test::random_velocity(random, course.flock.limits[0].max_speed_mps);
    Adviser adviser;
    Advised advised;
    for (int step = 0; step < 60; ++step) {
      std::vector<Velocity> wishes;
      for (const FlightLimits& limits : course.flock.limits) {
        wishes.push_back(test::random_velocity(random, 3.0 * limits.max_speed_mps));
      }
      const Verdict verdict = test::fly_a_step(course.flock, adviser, wishes, advised);
      for (const ClearanceLoss& loss : verdict.first_clearance_losses) ASSERT_EQ(loss.agent, 0U);
      for (const NearObstacle& near : advised.near_obstacle) ASSERT_EQ(near.agent, 0U);
      for (std::size_t k = 1; k < advised.near_obstacle.size(); ++k) {
        ASSERT_LT(advised.near_obstacle[k - 1].obstacle, advised.near_obstacle[k].obstacle);
      }
      named += advised.near_obstacle.empty() ? 0 : 1;
      ASSERT_EQ(advised.advice[0].certified,
                advised.near_obstacle.empty() && advised.too_close.empty());
    }
  }
  EXPECT_GT(named, test::kSanitized ? 0 : 40);
}

// A bee that flies through an obstacle is named, wherever its stopping segment begins and ends.
TEST(NearObstacle, ASegmentThroughAnObstacleIsNamed) {
  Course course;
  course.map = test::map_of({Box{{0, -50, -50}, {1, 50, 50}}, Sphere{{0, 0, 200}, 1.0}});
  course.flock.options.clearance_m = 1.0;
  course.flock.limits = {{50.0, 5.0}};
  for (const double x : {-300.0, -251.0, -100.0, -20.0, -1.5, 0.0, 0.5, 1.0, 1.99, 2.5}) {
    SCOPED_TRACE(x);
    course.flock.movers = {{{x, 0, 0}, {50, 0, 0}}};
    const auto advised = advise(course.flock.movers, std::vector<Velocity>{{50, 0, 0}},
                                course.flock.limits, course.flock.options);
    ASSERT_TRUE(advised);
    // The bee needs 252.5 m.
    const bool is_late = x > -253.5 && x < 2.0;
    EXPECT_EQ(advised->near_obstacle.size(), is_late ? 1U : 0U);
    EXPECT_EQ(advised->advice[0].certified, !is_late);
    for (const NearObstacle& near : advised->near_obstacle) EXPECT_LE(near.gap_m, 1.0);
  }
}

// Exact to rounding. Uncertainty of positions widens the clearance, once.
TEST(NearObstacle, TheClearanceIsTheLimit) {
  Course course;
  course.map = test::map_of({Ground{10.0}});
  course.flock.options.clearance_m = 2.0;
  course.flock.limits = {{10.0, 5.0}};
  const auto is_certified = [&](double far_m) {
    course.flock.movers = {{{0, 0, 10.0 + far_m}, {}}};
    const auto advised = advise(course.flock.movers, std::vector<Velocity>(1), course.flock.limits,
                                course.flock.options);
    EXPECT_TRUE(advised);
    return test::all_certified(*advised);
  };
  EXPECT_TRUE(is_certified(2.000001));
  EXPECT_FALSE(is_certified(1.999999));
  course.flock.options.uncertainty_m = 0.25;
  EXPECT_TRUE(is_certified(2.250001));
  EXPECT_FALSE(is_certified(2.249999));
}

// One, some, or all of the bees; ascending by bee and obstacle, each once.
TEST(NearObstacle, AllAreNamedOnceInOrder) {
  Course course;
  // A letter U of several pieces, a ball in its bay, the ground.
  course.map =
      test::map_of({Ground{0.0}, UprightPrism{test::letter_u(), {}}, Sphere{{2.5, 2.5, 5}, 1.0}});
  course.flock.options.clearance_m = 2.0;
  course.flock.options.threshold_m = 0.1;
  course.flock.movers = {{{2.5, 2.5, 1}, {}},
                         {{50, 50, 9}, {}},
                         {{0.5, 0.5, 9}, {}},
                         {{2.5, 2.5, 5}, {}},
                         {{-9, -9, 1}, {}}};
  course.flock.limits.assign(5, {5.0, 3.0});
  const std::vector<std::pair<PointId, std::size_t>> expected = {{0, 0}, {0, 1}, {2, 1},
                                                                 {3, 1}, {3, 2}, {4, 0}};
  for (const unsigned threads : {1U, 2U, 4U}) {
    course.flock.options.threads = threads;
    const auto advised = advise(course.flock.movers, std::vector<Velocity>(5), course.flock.limits,
                                course.flock.options);
    ASSERT_TRUE(advised);
    std::vector<std::pair<PointId, std::size_t>> named;
    for (const NearObstacle& near : advised->near_obstacle) {
      named.emplace_back(near.agent, near.obstacle);
    }
    EXPECT_EQ(named, expected);
    EXPECT_NEAR(advised->near_obstacle[1].gap_m, 1.5, 1e-12);
    EXPECT_NEAR(advised->near_obstacle[4].gap_m, -1.0, 1e-12);
  }
}

}  // namespace
}  // namespace beespace
