// Swarms with hostile intruders among them: the bees keep apart from each other, and those in
// danger are named.
#include "tests/avoidance/intruder.hpp"
#include "tests/avoidance/obstacle_course.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

// All who come too close if they do as advised are named; none that stays farther away than the
// step can bend its way.
void expect_conflicts(const Flock& flock, const Advised& advised,
                      const std::vector<Mover>& intruders) {
  const double threshold_m = flock.options.threshold_m + 2.0 * flock.options.uncertainty_m;
  for (PointId bee = 0; bee < flock.size(); ++bee) {
    const Mover& mover = flock.movers[bee];
    const Velocity& w = advised.advice[bee].velocity;
    const Velocity change{w.x - mover.velocity.x, w.y - mover.velocity.y, w.z - mover.velocity.z};
    const double strays_m =
        flock.at_once(bee) ? 0.0 : test::length_of(change) * flock.options.step_s / 8.0;
    for (std::size_t k = 0; k < intruders.size(); ++k) {
      const auto named =
          std::any_of(advised.intruder_conflicts.begin(), advised.intruder_conflicts.end(),
                      [&](const IntruderConflict& c) { return c.agent == bee && c.intruder == k; });
      if (!named && (bee + k) % 8 != 0) continue;  // some of the many
      const double apart_m = test::distance_of(mover.position, intruders[k].position);
      const double speeds = std::max(test::length_of(mover.velocity), test::length_of(w)) +
                            test::length_of(intruders[k].velocity);
      if (apart_m - speeds * flock.options.intruder_horizon_s > threshold_m + 1.0) {
        EXPECT_FALSE(named) << bee << ", " << k;
        continue;
      }
      const double closest_m =
          test::closest_as_advised(mover, w, intruders[k], flock.at_once(bee), flock.options.step_s,
                                   flock.options.intruder_horizon_s);
      if (closest_m < threshold_m - 1e-9) {
        EXPECT_TRUE(named) << bee << ", " << k << ": " << closest_m;
      } else if (closest_m > threshold_m + 2.0 * strays_m + 1e-9) {
        EXPECT_FALSE(named) << bee << ", " << k << ": " << closest_m;
      }
    }
  }
}

struct Raid {
  std::uint64_t conflicts = 0;
  double closest_m = test::kNoLimit;
};

// Each intruder flies at the bee that it has chosen, to ram it.
void chase(std::vector<Mover>& intruders, const Flock& flock, double speed) {
  for (std::size_t k = 0; k < intruders.size(); ++k) {
    const Point& target = flock.movers[(7 * k) % flock.size()].position;
    intruders[k].velocity = test::towards(intruders[k].position, target, speed);
  }
}

Raid raid(test::Course& course, int steps, std::uint64_t seed) {
  Flock& flock = course.flock;
  RandomStream random(seed);
  std::vector<Mover> intruders;
  const double threshold_m = flock.options.threshold_m;
  const double speed = 2.0 * flock.limits[0].max_speed_mps;
  for (int k = 0; k < 24; ++k) {
    const auto [x, y, z] = scenes::random_direction(random);
    const double far_m = threshold_m * random.uniform(4.0, 20.0);
    intruders.push_back({test::moved(flock.movers[0].position, {x, y, z}, far_m), {}});
  }
  flock.options.intruder_horizon_s = 30.0 * flock.options.step_s;
  Raid found;
  Adviser adviser;
  Advised advised;
  for (int step = 0; step < steps; ++step) {
    chase(intruders, flock, speed);
    flock.options.intruders = intruders;
    flock.options.threads = 1 + static_cast<unsigned>(step % 4);
    std::vector<Velocity> wishes;
    for (const FlightLimits& limits : flock.limits) {
      wishes.push_back(test::random_velocity(random, limits.max_speed_mps));
    }
    const Flock before = flock;
    const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
    EXPECT_EQ(verdict.losses, 0U) << "step " << step;
    EXPECT_EQ(verdict.clearance_losses, 0U) << "step " << step;
    EXPECT_TRUE(test::all_keep_apart(advised)) << "step " << step;
    for (PointId bee = 0; bee < flock.size(); ++bee) {
      const bool clear =
          std::none_of(advised.intruder_conflicts.begin(), advised.intruder_conflicts.end(),
                       [bee](const IntruderConflict& conflict) { return conflict.agent == bee; });
      EXPECT_EQ(advised.advice[bee].clear_of_intruders, clear) << "bee " << bee;
      EXPECT_EQ(advised.advice[bee].certified, clear) << "bee " << bee;
    }
    expect_conflicts(before, advised, intruders);
    found.conflicts += advised.intruder_conflicts.size();
    found.closest_m = std::min(found.closest_m, verdict.closest_m.value_or(test::kNoLimit));
    test::fly_on(intruders, flock.options.step_s);
    if (testing::Test::HasFailure()) break;
  }
  return found;
}

TEST(Raid, ASwarmThatIsRaidedKeepsItsSeparation) {
  Raid all;
  int starts = 0;
  for (int start = 0; start < (test::kSanitized ? 2 : 16); ++start) {
    const std::uint64_t seed = 8000U + static_cast<unsigned>(start);
    SCOPED_TRACE("start " + std::to_string(seed));
    test::Course course;
    if (start % 2 == 0) {
      course.flock = test::random_flock(30, seed);
      course.flock.options.uncertainty_m = 0.01 * course.flock.options.threshold_m;
      course.flock.options.threshold_m *= 0.98;
    } else {
      test::make_course(course, 30, seed);
    }
    if (course.flock.size() < 5) continue;
    ++starts;
    const Raid found = raid(course, 80, seed);
    all.conflicts += found.conflicts;
    all.closest_m = std::min(all.closest_m, found.closest_m / course.flock.options.threshold_m);
    if (HasFailure()) return;
  }
  EXPECT_GT(all.conflicts, static_cast<std::uint64_t>(100 * starts));
  EXPECT_LT(all.closest_m, 1.05);
}

TEST(Raid, ThreadsDoNotChangeTheAnswer) {
  RandomStream random(3);
  Flock flock;
  for (int i = 0; i < 17'000; ++i) {
    const auto at = [&] { return random.uniform(0.0, 300.0); };
    flock.movers.push_back({{at(), at(), at()}, test::random_velocity(random, 5.0)});
  }
  flock.limits = {{10.0, 5.0}};
  std::vector<Mover> intruders;
  for (int k = 0; k < 20; ++k) {
    const auto at = [&] { return random.uniform(0.0, 300.0); };
    intruders.push_back({{at(), at(), at()}, test::random_velocity(random, 20.0)});
  }
  const ObstacleMap map =
      test::map_of({Ground{20.0}, Sphere{{150, 150, 150}, 40.0},
                    UprightPrism{test::moved(test::comb(), 10.0, {80, 80}), {}}});
  flock.options.intruders = intruders;
  flock.options.obstacles = &map;
  const std::vector<Velocity> wishes(flock.size(), Velocity{3, 4, 0});
  const auto alone = advise(flock.movers, wishes, flock.limits, flock.options);
  ASSERT_TRUE(alone);
  EXPECT_GT(alone->intruder_conflicts.size(), 20U);
  EXPECT_GT(alone->near_obstacle.size(), 100U);
  for (const unsigned threads : {2U, 3U, 4U}) {
    flock.options.threads = threads;
    const auto advised = advise(flock.movers, wishes, flock.limits, flock.options);
    ASSERT_TRUE(advised);
    EXPECT_EQ(advised->advice, alone->advice);
    EXPECT_EQ(advised->too_close, alone->too_close);
    EXPECT_EQ(advised->near_obstacle, alone->near_obstacle);
    EXPECT_EQ(advised->intruder_conflicts, alone->intruder_conflicts);
  }
}

}  // namespace
}  // namespace beespace
