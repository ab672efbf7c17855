// No bee comes closer to an obstacle than the clearance, whatever velocities the bees prefer.
#include "tests/avoidance/obstacle_course.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Course;
using test::Flock;

using Wishes = std::vector<Velocity>;

struct Adversary {
  const char* name;
  std::function<Velocity(const Course&, std::size_t bee, RandomStream&)> wish;
};

// By default gtest prints the bytes of a parameter: of pointers, which change from run to run.
void PrintTo(const Adversary& adversary, std::ostream* out) {  // NOLINT(*-identifier-naming)
  *out << adversary.name;
}

Velocity at_random(const Course& course, std::size_t bee, RandomStream& random) {
  return test::random_velocity(random, 10.0 * course.flock.limits[bee].max_speed_mps);
}

Velocity at_the_obstacle(const Course& course, std::size_t bee, RandomStream& /*random*/) {
  const Point& at = course.flock.movers[bee].position;
  const auto nearest = course.map.nearest(at);
  const double speed = 3.0 * course.flock.limits[bee].max_speed_mps;
  return nearest ? test::towards(at, nearest->surface.point, speed) : Velocity{};
}

// Straight at one of the obstacles at full speed, whatever is between.
Velocity at_some_obstacle(const Course& course, std::size_t bee, RandomStream& /*random*/) {
  const auto obstacles = course.map.obstacles();
  const Point& at = course.flock.movers[bee].position;
  const auto surface = nearest_surface(obstacles[bee % obstacles.size()], at);
  const double speed = course.flock.limits[bee].max_speed_mps;
  return surface ? test::towards(at, surface->point, speed) : Velocity{};
}

Velocity at_the_neighbor(const Course& course, std::size_t bee, RandomStream& /*random*/) {
  const Flock& flock = course.flock;
  const std::size_t other = bee % 2 == 0 ? (bee + 1) % flock.size() : bee - 1;
  return test::towards(flock.movers[bee].position, flock.movers[other].position,
                       flock.limits[bee].max_speed_mps);
}

// Along the wall, and a little into it: the stopping segment is almost parallel to it.
Velocity along_the_wall(const Course& course, std::size_t bee, RandomStream& random) {
  const Velocity into = at_the_obstacle(course, bee, random);
  const double speed = course.flock.limits[bee].max_speed_mps;
  const double far = test::length_of(into);
  if (!(far > 0.0)) return {};
  const Velocity n = test::scaled(into, 1.0 / far);
  const double level = std::hypot(n.x, n.y);
  const Velocity aside = level > 1e-6 ? Velocity{n.y / level, -n.x / level, 0} : Velocity{1, 0, 0};
  const double press = bee % 3 == 0 ? 0.3 : 1e-3;
  return {speed * (aside.x + press * n.x), speed * (aside.y + press * n.y),
          speed * (aside.z + press * n.z)};
}

Velocity each_otherwise(const Course& course, std::size_t bee, RandomStream& random) {
  switch (bee % 5) {
    case 0:
      return at_random(course, bee, random);
    case 1:
      return at_the_obstacle(course, bee, random);
    case 2:
      return at_the_neighbor(course, bee, random);
    case 3:
      return along_the_wall(course, bee, random);
    default:
      return {};
  }
}

const Adversary kAdversaries[] = {{"Random", at_random},
                                  {"AtTheObstacle", at_the_obstacle},
                                  {"AtSome", at_some_obstacle},
                                  {"AtTheNeighbor", at_the_neighbor},
                                  {"AlongTheWall", along_the_wall},
                                  {"Mixed", each_otherwise}};

class AmongObstacles : public testing::TestWithParam<Adversary> {};

// Flies a step; the closest distance of any bee to an obstacle, at samples.
double fly_a_step(Course& course, Adviser& adviser, const Adversary& adversary,
                  RandomStream& random) {
  Flock& flock = course.flock;
  Wishes wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    wishes.push_back(adversary.wish(course, bee, random));
  }
  const std::vector<Mover> before = flock.movers;
  Advised advised;
  const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
  EXPECT_EQ(verdict.losses, 0U) << verdict.closest_m.value_or(0.0);
  EXPECT_EQ(verdict.clearance_losses, 0U) << verdict.first_clearance_losses[0].closest_m;
  EXPECT_TRUE(test::all_certified(advised));
  EXPECT_TRUE(advised.near_obstacle.empty())
      << advised.near_obstacle[0].agent << " to " << advised.near_obstacle[0].obstacle << " "
      << advised.near_obstacle[0].gap_m;
  double closest_m = test::kNoLimit;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    closest_m =
        std::min(closest_m, test::clearance_in_step(course.map, before[bee], flock.movers[bee],
                                                    flock.at_once(bee), flock.options.step_s, 3));
  }
  EXPECT_GE(closest_m, flock.options.clearance_m);
  return closest_m;
}

TEST_P(AmongObstacles, ClearanceAndThresholdAreKept) {
  int starts = 0;
  int pressed = 0;
  for (int start = 0; start < (test::kSanitized ? 2 : 24); ++start) {
    const std::uint64_t seed = 5000U + static_cast<unsigned>(start);
    SCOPED_TRACE("start " + std::to_string(seed));
    Course course;
    test::make_course(course, 12 + seed % 3 * 8, seed);
    if (course.flock.size() < 2) continue;
    ++starts;
    RandomStream random(seed);
    Adviser adviser;
    double closest_m = test::kNoLimit;
    for (int step = 0; step < 200; ++step) {
      SCOPED_TRACE("step " + std::to_string(step));
      closest_m = std::min(closest_m, fly_a_step(course, adviser, GetParam(), random));
      if (HasFailure()) return;
    }
    pressed += closest_m < 1.01 * course.flock.options.clearance_m ? 1 : 0;
  }
  // The obstacles were in the way.
  EXPECT_GE(starts, test::kSanitized ? 1 : 20);
  EXPECT_GE(pressed, starts / 2);
}

INSTANTIATE_TEST_SUITE_P(Adversary, AmongObstacles, testing::ValuesIn(kAdversaries),
                         [](const auto& adversary) { return std::string(adversary.param.name); });

}  // namespace
}  // namespace beespace
