// No two bees come closer than the threshold, whatever velocities they prefer.
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

using Wishes = std::vector<Velocity>;

struct Adversary {
  const char* name;
  // The preferred velocities of all bees for the next step.
  std::function<Wishes(const Flock&, RandomStream&)> wishes;
};

// By default gtest prints the bytes of a parameter: of pointers, which change from run to run.
void PrintTo(const Adversary& adversary, std::ostream* out) {  // NOLINT(*-identifier-naming)
  *out << adversary.name;
}

Velocity of_random(const Flock& flock, std::size_t bee, RandomStream& random) {
  return test::random_velocity(random, 10.0 * flock.limits[bee].max_speed_mps);
}

Wishes at_random(const Flock& flock, RandomStream& random) {
  Wishes wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    wishes.push_back(of_random(flock, bee, random));
  }
  return wishes;
}

Point middle_of(const Flock& flock) {
  Point sum;
  const double share = 1.0 / static_cast<double>(flock.size());
  for (const Mover& mover : flock.movers) {
    sum.x += mover.position.x * share;
    sum.y += mover.position.y * share;
    sum.z += mover.position.z * share;
  }
  return sum;
}

Wishes all_to_the_middle(const Flock& flock, RandomStream& /*random*/) {
  const Point middle = middle_of(flock);
  Wishes wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    wishes.push_back(
        test::towards(flock.movers[bee].position, middle, 10.0 * flock.limits[bee].max_speed_mps));
  }
  return wishes;
}

std::size_t nearest_to(const Flock& flock, std::size_t bee) {
  std::size_t nearest = bee;
  double least = test::kNoLimit;
  for (std::size_t other = 0; other < flock.size(); ++other) {
    const double far = test::distance_of(flock.movers[bee].position, flock.movers[other].position);
    if (other == bee || far >= least) continue;
    least = far;
    nearest = other;
  }
  return nearest;
}

Wishes each_at_its_neighbor(const Flock& flock, RandomStream& /*random*/) {
  Wishes wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    wishes.push_back(test::towards(flock.movers[bee].position,
                                   flock.movers[nearest_to(flock, bee)].position,
                                   flock.limits[bee].max_speed_mps));
  }
  return wishes;
}

Wishes all_at_the_first(const Flock& flock, RandomStream& random) {
  Wishes wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    wishes.push_back(test::towards(flock.movers[bee].position, flock.movers[0].position,
                                   flock.limits[bee].max_speed_mps));
  }
  wishes[0] = of_random(flock, 0, random);
  return wishes;
}

Wishes all_stand(const Flock& flock, RandomStream& /*random*/) {
  return Wishes(flock.size());
}

// The current velocities, each turned a little: stopping segments that are almost parallel.
Wishes all_the_same_way(const Flock& flock, RandomStream& random) {
  Wishes wishes;
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    const double speed = flock.limits[bee].max_speed_mps;
    wishes.push_back({speed, 1e-5 * random.uniform(-speed, speed), 1e-6 * speed});
  }
  return wishes;
}

Wishes mixed(const Flock& flock, RandomStream& random) {
  Wishes wishes = at_random(flock, random);
  const Wishes middle = all_to_the_middle(flock, random);
  const Wishes neighbor = each_at_its_neighbor(flock, random);
  for (std::size_t bee = 0; bee < flock.size(); ++bee) {
    if (bee % 4 == 1) wishes[bee] = middle[bee];
    if (bee % 4 == 2) wishes[bee] = neighbor[bee];
    if (bee % 4 == 3) wishes[bee] = {};
  }
  return wishes;
}

const Adversary kAdversaries[] = {{"Random", at_random},
                                  {"ToTheMiddle", all_to_the_middle},
                                  {"AtItsNeighbor", each_at_its_neighbor},
                                  {"AtTheFirst", all_at_the_first},
                                  {"Zero", all_stand},
                                  {"TheSameWay", all_the_same_way},
                                  {"Mixed", mixed}};

class AnyWish : public testing::TestWithParam<Adversary> {};

// The closest distance between any two bees, in thresholds.
double fly(Flock& flock, const Adversary& adversary, int steps, std::uint64_t seed) {
  RandomStream random(seed);
  Adviser adviser;
  Advised advised;
  double closest_m = test::kNoLimit;
  for (int step = 0; step < steps; ++step) {
    const Verdict verdict =
        test::fly_a_step(flock, adviser, adversary.wishes(flock, random), advised);
    closest_m = std::min(closest_m, verdict.closest_m.value_or(test::kNoLimit));
    EXPECT_EQ(verdict.losses, 0U) << "step " << step << ", " << *verdict.closest_m;
    EXPECT_TRUE(test::all_certified(advised)) << "step " << step;
    if (testing::Test::HasFailure()) break;
  }
  return closest_m / flock.options.threshold_m;
}

TEST_P(AnyWish, LosesNoSeparationAndBreaksNoLimit) {
  double closest = test::kNoLimit;
  for (int start = 0; start < (test::kSanitized ? 2 : 20); ++start) {
    const auto seed = static_cast<std::uint64_t>(1000 + start);
    SCOPED_TRACE("start " + std::to_string(seed));
    Flock flock = test::random_flock(10 + seed % 4 * 8, seed);
    ASSERT_GE(flock.size(), 5U);
    ASSERT_GE(flock.least_ways_apart(),
              static_cast<long double>(flock.options.threshold_m) * 1.04L);
    closest = std::min(closest, fly(flock, GetParam(), 300, seed));
    if (HasFailure()) return;
  }
  // The bees were in each other's way. Sanitizers have time for so few starts that this may not
  // hold.
  if (!test::kSanitized && std::string(GetParam().name) != "Zero") {
    EXPECT_LT(closest, 1.01);
  }
}

INSTANTIATE_TEST_SUITE_P(Adversary, AnyWish, testing::ValuesIn(kAdversaries),
                         [](const auto& adversary) { return std::string(adversary.param.name); });

// Uncertainty widens the threshold by twice its value.
TEST(AnyWish, KeepsTheUncertaintyApartAsWell) {
  for (int start = 0; start < (test::kSanitized ? 1 : 4); ++start) {
    const auto seed = static_cast<std::uint64_t>(2000 + start);
    SCOPED_TRACE("start " + std::to_string(seed));
    Flock flock = test::random_flock(16, seed);
    const double widened_m = flock.options.threshold_m;
    flock.options.uncertainty_m = 0.2 * widened_m;
    flock.options.threshold_m = 0.6 * widened_m;
    const double closest = fly(flock, kAdversaries[2], 200, seed);
    EXPECT_GE(closest * flock.options.threshold_m, widened_m * (1.0 - 1e-9));
  }
}

// Two bees fly side by side at the threshold, on long stopping segments that cross over one another
// at a tiny angle, and press towards each other. Which direction separates their segments best is
// hard to compute, and any error in it reduces the separation.
Flock two_side_by_side(RandomStream& random, double tilt) {
  Flock flock;
  const double threshold_m = test::log_uniform(random, 0.05, 5.0);
  const double step_s = test::log_uniform(random, 0.02, 0.5);
  const double speed = test::log_uniform(random, 5.0, 40.0);
  const double acceleration = test::log_uniform(random, 0.5, 5.0);
  flock.options.threshold_m = threshold_m;
  flock.options.step_s = step_s;
  flock.limits.assign(2, {speed, acceleration});
  const double way_m = speed * (speed / (2.0 * acceleration) + step_s / 2.0);
  const double apart_m = threshold_m * (1.0 + 1.1e-7 + 1e-3 * random.index(2) * random.uniform());
  const double cross_m = way_m * tilt * random.uniform(0.2, 0.8);
  const double v = 0.999 * speed;
  flock.movers = {{{0, 0, 0}, {v, 0, 0.5 * tilt * v}},
                  {{0, apart_m, cross_m}, {v, 0, -0.5 * tilt * v}}};
  return flock;
}

TEST(AnyWish, NearlyParallelStoppingSegmentsStayApart) {
  RandomStream random(1);
  for (int start = 0; start < test::rounds(1'500); ++start) {
    SCOPED_TRACE(start);
    const double tilt = test::log_uniform(random, 1e-7, 2e-5);
    Flock flock = two_side_by_side(random, tilt);
    const auto threshold_m = static_cast<long double>(flock.options.threshold_m);
    const double v = flock.limits[0].max_speed_mps;
    const double press = v * (start % 3 == 0 ? 1e-5 : start % 3 == 1 ? 0.3 : 1.0);
    Adviser adviser;
    Advised advised;
    // The segments are farther apart than the threshold plus the allowance for rounding.
    if (flock.least_ways_apart() < threshold_m * (1.0L + 1.05e-7L)) continue;
    for (int step = 0; step < 60; ++step) {
      SCOPED_TRACE(step);
      const double half = 0.5 * tilt * v;
      const std::vector<Velocity> wishes = {{v, press, half}, {v, -press, -half}};
      ASSERT_EQ(test::fly_a_step(flock, adviser, wishes, advised).losses, 0U);
      ASSERT_TRUE(test::all_certified(advised));
      ASSERT_GE(flock.least_ways_apart(), threshold_m);
    }
  }
}

}  // namespace
}  // namespace beespace
