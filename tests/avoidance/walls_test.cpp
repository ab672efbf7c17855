// One bee and a wall: along it at the clearance, into its corners, and never through it.
#include "tests/avoidance/obstacle_course.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Course;

struct Flown {
  double closest_m = test::kNoLimit;
  bool certified = true;
  std::uint64_t clearance_losses = 0;
};

// All bees prefer the same velocity in each step.
Flown fly(Course& course, const std::function<Velocity(const Mover&)>& wish, int steps) {
  test::Flock& flock = course.flock;
  Adviser adviser;
  Advised advised;
  Flown flown;
  for (int step = 0; step < steps; ++step) {
    std::vector<Velocity> wishes;
    for (const Mover& mover : flock.movers) wishes.push_back(wish(mover));
    const std::vector<Mover> before = flock.movers;
    flown.clearance_losses += test::fly_a_step(flock, adviser, wishes, advised).clearance_losses;
    flown.certified = flown.certified && test::all_certified(advised);
    for (std::size_t bee = 0; bee < flock.size(); ++bee) {
      flown.closest_m = std::min(
          flown.closest_m, test::clearance_in_step(course.map, before[bee], flock.movers[bee],
                                                   flock.at_once(bee), flock.options.step_s, 4));
    }
  }
  return flown;
}

void expect_clear(const Flown& flown, double clearance_m) {
  EXPECT_TRUE(flown.certified);
  EXPECT_EQ(flown.clearance_losses, 0U);
  EXPECT_GE(flown.closest_m, clearance_m);
}

struct Wall {
  const char* name;
  // The face is the plane through `at`, at right angles to the level direction (0.8, -0.6); or the
  // ground, with the normal (0, 0, 1).
  std::function<Obstacle(const Point& at)> of;
  Velocity out;
  Velocity along;
};

const Velocity kOut{0.8, -0.6, 0};
const Velocity kAlong{0.6, 0.8, 0};

Corner corner(const Point& at, double along_m, double out_m) {
  return {at.x + kAlong.x * along_m + kOut.x * out_m, at.y + kAlong.y * along_m + kOut.y * out_m};
}

const Wall kWalls[] = {
    {"Ground", [](const Point& at) -> Obstacle { return Ground{at.z}; }, {0, 0, 1}, kAlong},
    {"Roof",
     [](const Point& at) -> Obstacle {
       return Box{{at.x - 1e4, at.y - 1e4, at.z - 3.0}, {at.x + 1e4, at.y + 1e4, at.z}};
     },
     {0, 0, 1},
     kAlong},
    {"Box",
     [](const Point& at) -> Obstacle {
       return Box{{at.x - 7.0, at.y - 1e4, at.z - 9.0}, {at.x, at.y + 1e4, at.z + 9.0}};
     },
     {1, 0, 0},
     {0, 1, 0}},
    {"Prism",
     [](const Point& at) -> Obstacle {
       return UprightPrism{
           {corner(at, -1e4, 0), corner(at, -1e4, -5), corner(at, 1e4, -5), corner(at, 1e4, 0)},
           {}};
     },
     kOut, kAlong},
    // The wall consists of several pieces.
    {"Comb",
     [](const Point& at) -> Obstacle {
       UprightPrism comb{{}, {at.z - 9.0, test::kNoLimit}};
       for (int k = -8; k < 8; ++k) {
         comb.outline.push_back(corner(at, 1000.0 * k, -2.0));
         comb.outline.push_back(corner(at, 1000.0 * k + 900.0, -1.0));
       }
       comb.outline.push_back(corner(at, 8000.0, 0.0));
       comb.outline.push_back(corner(at, -8001.0, 0.0));
       return comb;
     },
     kOut, kAlong}};

void PrintTo(const Wall& wall, std::ostream* out) {  // NOLINT(*-identifier-naming)
  *out << wall.name;
}

class AlongAWall : public testing::TestWithParam<Wall> {};

// From the clearance plus the allowance for rounding, straight along the wall and a little into it:
// the bee makes progress as if there were no wall. Stopping distances of metres and of kilometres,
// near and far.
TEST_P(AlongAWall, AtTheClearanceGetsOn) {
  const auto& [name, of, out, along] = GetParam();
  for (const double far_m : {0.0, 1e6, 5e6}) {
    for (const double clearance_m : {0.05, 1.0, 30.0}) {
      for (const FlightLimits& limits : {FlightLimits{10.0, test::kNoLimit},
                                         FlightLimits{10.0, 5.0}, FlightLimits{100.0, 4.0}}) {
        SCOPED_TRACE(testing::Message() << far_m << " m off, clearance " << clearance_m << ", "
                                        << limits.max_speed_mps << " m/s");
        Course course;
        const Point at{far_m, -0.7 * far_m, 0.001 * far_m};
        course.map = test::map_of({of(at)});
        course.flock.options.clearance_m = clearance_m;
        course.flock.limits = {limits};
        const double off_m = clearance_m * (1.0 + 1.1e-7) + 1e-13 * (far_m + 1e4);
        const double v = limits.max_speed_mps;
        course.flock.movers = {
            {{at.x + out.x * off_m, at.y + out.y * off_m, at.z + out.z * off_m}, {}}};
        for (const double press : {0.0, 1e-6, 0.01, 0.3}) {
          SCOPED_TRACE(press);
          const Point from = course.flock.movers[0].position;
          const Velocity wish{v * (along.x - press * out.x), v * (along.y - press * out.y),
                              v * (along.z - press * out.z)};
          course.flock.movers[0].velocity = test::scaled(along, 0.99 * v);
          expect_clear(fly(
                           course, [&](const Mover&) { return wish; }, 30),
                       clearance_m);
          // 3 s: preferred velocities into the wall may cost a tenth.
          EXPECT_GT(test::distance_of(course.flock.movers[0].position, from), 0.9 * 3.0 * v);
          if (HasFailure()) return;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Wall, AlongAWall, testing::ValuesIn(kWalls),
                         [](const auto& wall) { return std::string(wall.param.name); });

// Into the corner of an L from all sides. A bee that makes no progress there turns, and presses on.
TEST(Walls, TheCornerOfAnLIsAvoided) {
  int cornered = 0;
  for (const double acceleration : {test::kNoLimit, 4.0}) {
    for (const double clearance_m : {0.3, 2.0}) {
      Course course;
      // Arms along x and y, 40 m long and 1 m thick.
      course.map = test::map_of(
          {UprightPrism{{{0, 0}, {40, 0}, {40, 1}, {1, 1}, {1, 40}, {0, 40}}, {-500, 500}}});
      course.flock.options.clearance_m = clearance_m;
      course.flock.limits = {{12.0, acceleration}};
      course.flock.movers = {{{30, 25, 3}, {}}};
      const auto wish = [&](const Mover& mover) {
        const auto& [x, y, z] = mover.position;
        cornered += std::max(x, y) < 1.0 + 1.01 * clearance_m ? 1 : 0;
        return test::towards(mover.position, {0.5, 0.5, 3}, 12.0);
      };
      expect_clear(fly(course, wish, 400), clearance_m);
    }
  }
  EXPECT_GT(cornered, 0);
}

// Walls and plates 10 cm thick, approached at a hundred metres a step.
TEST(Walls, NoBeeFliesThroughAThinOneInAStep) {
  const UprightPrism bent{{{0, -9e3}, {0.1, -9e3}, {0.1, 0}, {0.2, 9e3}, {0.1, 9e3}, {0, 0}}, {}};
  const Box plate{{-9e3, -9e3, 0}, {9e3, 9e3, 0}};
  const UprightCylinder mast{0, 0, 0.0, {}};
  const Sphere ball{{0, 0, 0}, 0.05};
  RandomStream random(1);
  int stopped = 0;
  for (int round = 0; round < test::rounds(300); ++round) {
    SCOPED_TRACE(round);
    Course course;
    const std::vector<Obstacle> all = {bent, plate, mast, ball};
    const std::size_t which = static_cast<std::size_t>(round) % all.size();
    course.map = test::map_of({all[which]});
    course.flock.options.step_s = 1.0;
    course.flock.options.clearance_m = test::log_uniform(random, 0.01, 3.0);
    course.flock.limits = {
        {100.0, round % 2 == 0 ? test::kNoLimit : test::log_uniform(random, 5.0, 200.0)}};
    const Point goal{random.uniform(-30.0, 0.0), random.uniform(-3.0, 3.0),
                     random.uniform(-30.0, 0.0)};
    course.flock.movers = {{{random.uniform(50.0, 900.0), 0.0, random.uniform(50.0, 900.0)}, {}}};
    const auto wish = [&](const Mover& mover) { return test::towards(mover.position, goal, 1e4); };
    expect_clear(fly(course, wish, 40), course.flock.options.clearance_m);
    const Point& at = course.flock.movers[0].position;
    if (which == 0) {
      EXPECT_GT(at.x, 0.1);
    } else if (which == 1) {
      EXPECT_GT(at.z, 0.0);
    }
    stopped += test::clearance_at(course.map, at) < 2.0 * course.flock.options.clearance_m ? 1 : 0;
    if (HasFailure()) return;
  }
  EXPECT_GT(stopped, test::rounds(300) / 3);
}

// The clearance of a planet is kept as well as that of a box.
TEST(Walls, LargeOnesAreAvoidedToo) {
  for (const double radius_m : {1e3, 6.4e6}) {
    for (const double clearance_m : {0.01, 1.0}) {
      SCOPED_TRACE(testing::Message() << radius_m << ", " << clearance_m);
      Course course;
      course.map = test::map_of(
          {Sphere{{0, 0, -radius_m}, radius_m}, UprightCylinder{-radius_m - 5.0, 0, radius_m, {}}});
      course.flock.options.clearance_m = clearance_m;
      course.flock.limits = {{10.0, 5.0}};
      course.flock.movers = {{{2, 0, 2}, {}}};
      const auto wish = [&](const Mover& mover) {
        return test::towards(mover.position, {-6, 300, -1}, 20.0);
      };
      expect_clear(fly(course, wish, 300), clearance_m);
    }
  }
}

}  // namespace
}  // namespace beespace
