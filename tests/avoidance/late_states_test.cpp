// What the promise requires of the given states (docs/prevention.md, condition 4). With states that
// are a step old it does not hold, however much is added for the distance flown in a step. With
// states that are predicted from the previous advice it holds, even if the bees deviate from them.
#include "scenes/random_velocity.hpp"
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

constexpr double kThreshold_m = 5.0;
constexpr double kSpeed = 10.0;
constexpr double kStep_s = 0.1;
constexpr double kSpare_m = kSpeed * kStep_s;  // "speed times delay"

struct Swap {
  Flock flock;
  std::vector<Point> goals;
};

// Bees on a ball, each of which prefers the place of another one.
Swap swap_of(std::size_t bees, std::uint64_t seed) {
  RandomStream random(seed);
  Swap swap;
  swap.flock.options.threshold_m = kThreshold_m;
  swap.flock.options.uncertainty_m = kSpare_m;
  while (swap.flock.size() < bees) {
    const auto [x, y, z] = scenes::random_direction(random);
    const Point start{40 * x, 40 * y, 40 * z};
    bool clear = true;
    for (const Mover& other : swap.flock.movers) {
      clear = clear && test::distance_of(start, other.position) > 2.0 * kThreshold_m;
    }
    if (!clear) continue;
    swap.flock.movers.push_back({start, {}});
    swap.flock.limits.push_back({kSpeed, 5.0});
    swap.goals.push_back({-start.x, -start.y, -start.z});
  }
  return swap;
}

std::vector<Velocity> wishes_of(const Swap& swap, const std::vector<Mover>& states) {
  std::vector<Velocity> wishes;
  for (std::size_t bee = 0; bee < states.size(); ++bee) {
    const auto wish =
        velocity_to_goal(states[bee].position, swap.goals[bee], swap.flock.limits[bee], kStep_s);
    EXPECT_TRUE(wish);
    wishes.push_back(wish ? *wish : Velocity{});
  }
  return wishes;
}

struct Flown {
  std::uint64_t losses = 0;
  bool all_certified = true;
};

// Advice from the states of the previous step, flown now, as far as a bee can.
Flown fly_by_old_states(Swap swap, int steps) {
  std::vector<Mover> old = swap.flock.movers;
  Verifier verifier({.threshold_m = kThreshold_m});
  EXPECT_TRUE(verifier.add(0.0, swap.flock.movers));
  Adviser adviser;
  Advised advised;
  for (int step = 1; step <= steps; ++step) {
    const Status status =
        adviser.advise(old, wishes_of(swap, old), swap.flock.limits, swap.flock.options, advised);
    EXPECT_TRUE(status);
    old = swap.flock.movers;
    for (std::size_t bee = 0; bee < old.size(); ++bee) {
      const Velocity& advised_velocity = advised.advice[bee].velocity;
      const Velocity& v = old[bee].velocity;
      const double most = swap.flock.limits[bee].max_acceleration_mps2 * kStep_s;
      const double change = test::length_of_change(v, advised_velocity);
      const double share = change > most ? most / change : 1.0;
      const Velocity next{v.x + (advised_velocity.x - v.x) * share,
                          v.y + (advised_velocity.y - v.y) * share,
                          v.z + (advised_velocity.z - v.z) * share};
      swap.flock.movers[bee] = test::flown(old[bee], next, false, kStep_s);
    }
    EXPECT_TRUE(verifier.add(step * kStep_s, swap.flock.movers));
  }
  return {verifier.verdict().losses, true};
}

// Advice from nominal states. In each step each bee is up to the spare away from its own.
Flown fly_by_nominal_states(Swap swap, int steps, std::uint64_t seed) {
  RandomStream random(seed);
  const auto strayed = [&](const std::vector<Mover>& nominal) {
    std::vector<Mover> bees = nominal;
    for (Mover& bee : bees) {
      const auto [x, y, z] = scenes::random_direction(random);
      const double far_m = kSpare_m * (1.0 - 1e-12);
      bee.position = {bee.position.x + x * far_m, bee.position.y + y * far_m,
                      bee.position.z + z * far_m};
    }
    return bees;
  };
  Flown flown;
  Verifier verifier({.threshold_m = kThreshold_m});
  EXPECT_TRUE(verifier.add(0.0, strayed(swap.flock.movers)));
  Adviser adviser;
  Advised advised;
  for (int step = 1; step <= steps; ++step) {
    test::fly_a_step(swap.flock, adviser, wishes_of(swap, swap.flock.movers), advised);
    flown.all_certified = flown.all_certified && test::all_certified(advised);
    EXPECT_TRUE(verifier.add(step * kStep_s, strayed(swap.flock.movers)));
  }
  flown.losses = verifier.verdict().losses;
  return flown;
}

TEST(LateStates, AMarginOfSpeedTimesDelayIsNotEnough) {
  const Flown flown = fly_by_old_states(swap_of(60, 4711), test::kSanitized ? 60 : 300);
  EXPECT_GT(flown.losses, 0U);
}

TEST(LateStates, PredictedFromThePreviousAdviceTheyKeepThePromise) {
  for (const std::uint64_t seed : {4711U, 4712U, 4713U}) {
    const Flown flown = fly_by_nominal_states(swap_of(60, seed), test::kSanitized ? 60 : 300, seed);
    EXPECT_TRUE(flown.all_certified);
    EXPECT_EQ(flown.losses, 0U);
  }
}

}  // namespace
}  // namespace beespace
