// Values too small for the motion domain count as zero: they are not refused, and no bees come too
// close because of them.
#include "tests/avoidance/flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Flock;

constexpr double kTiny[] = {0x1p-101, -9e-32, 1e-200, -1e-300, 1e-320, -0x1p-1074};

TEST(TinyValues, AreTakenAsZeroWhereverTheyAre) {
  const Mover still{{0, 0, 0}, {0, 0, 0}};
  std::vector<Mover> movers = {still, {{100, 0, 0}, {1, 0, 0}}};
  std::vector<Velocity> wishes = {{}, {1, 2, 3}};
  const std::vector<FlightLimits> limits(2, FlightLimits{10.0, 5.0});
  std::vector<Mover> intruders = {{{0, 300, 0}, {}}};
  std::vector<UnknownAgent> unknown = {{{0, 0, 500}, 0.0, 0.0, {}}};
  AdviseOptions options{.threshold_m = 5.0};
  options.intruders = intruders;
  options.unknown = unknown;
  const auto plain = advise(movers, wishes, limits, options);
  ASSERT_TRUE(plain);
  for (const double tiny : kTiny) {
    movers[0] = {{tiny, -tiny, tiny}, {-tiny, tiny, tiny}};
    wishes[0] = {tiny, tiny, -tiny};
    intruders[0] = {{tiny, 300, -tiny}, {tiny, tiny, tiny}};
    unknown[0] = {{tiny, -tiny, 500}, std::abs(tiny), std::abs(tiny), {}};
    const auto advised = advise(movers, wishes, limits, options);
    ASSERT_TRUE(advised) << tiny << ": " << advised.error().message;
    EXPECT_TRUE(advised->refused.empty()) << tiny;
    EXPECT_EQ(advised->advice, plain->advice) << tiny;
    EXPECT_TRUE(advised->advice[0].certified);
  }
}

// A velocity that loses a tenth of itself in each step is below the domain after 66 seconds.
TEST(TinyValues, ADecayingVelocityIsNotRefused) {
  for (const bool at_once : {false, true}) {
    Flock flock;
    flock.options.threshold_m = 5.0;
    for (int bee = 0; bee < 6; ++bee) {
      flock.movers.push_back({{20.0 * bee, 0, 0}, {0.0, 4.0, at_once ? 1.0 : -2.0}});
      flock.limits.push_back({10.0, at_once ? test::kNoLimit : 5.0});
    }
    Adviser adviser;
    Advised advised;
    for (int step = 0; step < 9000; ++step) {
      std::vector<Velocity> wishes;
      for (const Mover& mover : flock.movers) wishes.push_back(test::scaled(mover.velocity, 0.9));
      const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
      ASSERT_TRUE(verdict.holds());
      ASSERT_TRUE(test::all_certified(advised)) << "step " << step;
      ASSERT_TRUE(advised.refused.empty()) << "step " << step;
    }
  }
}

// What a hostile bee may prefer: a velocity, none, a decaying one, or almost none.
Velocity hostile_wish(RandomStream& random, const Flock& flock, std::size_t bee) {
  const Mover& mover = flock.movers[bee];
  const double tiny = kTiny[random.index(6)];
  switch (random.index(6)) {
    case 0:
      return test::random_velocity(random, flock.limits[bee].max_speed_mps);
    case 1:
      return test::scaled(mover.velocity, 0.1);
    case 2:
      return {tiny, -tiny, random.uniform(0.0, 1.0) * tiny};
    case 3:
      return {mover.velocity.x * 1e-25, mover.velocity.y, tiny};
    default:
      return test::towards(mover.position, {tiny, 0, 0}, flock.limits[bee].max_speed_mps);
  }
}

// All bees are around the origin, which most prefer to fly into, where coordinates are almost zero;
// thresholds are usual ones, or almost zero themselves.
TEST(TinyValues, HostileFlightsAroundTheOriginLoseNothing) {
  int flown = 0;
  for (int start = 0; start < (test::kSanitized ? 4 : 60); ++start) {
    const std::uint64_t seed = 7100U + static_cast<unsigned>(start);
    SCOPED_TRACE("start " + std::to_string(seed));
    RandomStream random(seed);
    Flock flock = test::random_flock(12, seed);
    if (flock.size() < 3) continue;
    // Some begin where the smallest values matter.
    const double scale = start % 3 == 0 ? 0x1p-60 : start % 3 == 1 ? 0x1p-86 : 1.0;
    const Point middle = flock.movers[0].position;
    flock.options.threshold_m *= scale;
    for (std::size_t bee = 0; bee < flock.size(); ++bee) {
      auto& [p, v] = flock.movers[bee];
      p = {(p.x - middle.x) * scale, (p.y - middle.y) * scale, (p.z - middle.z) * scale};
      v = test::scaled(v, scale);
      flock.limits[bee].max_speed_mps *= scale;
      flock.limits[bee].max_acceleration_mps2 *= scale;
    }
    Adviser adviser;
    Advised advised;
    for (int step = 0; step < 150; ++step) {
      std::vector<Velocity> wishes;
      for (std::size_t bee = 0; bee < flock.size(); ++bee) {
        wishes.push_back(hostile_wish(random, flock, bee));
      }
      const Verdict verdict = test::fly_a_step(flock, adviser, wishes, advised);
      ASSERT_TRUE(advised.refused.empty());
      // Bees that are certified in a step keep their separation in it.
      for (const Loss& loss : verdict.first_losses) {
        ASSERT_FALSE(advised.advice[loss.pair.first].certified) << "step " << step;
        ASSERT_FALSE(advised.advice[loss.pair.second].certified) << "step " << step;
      }
      if (scale == 1.0) {
        ASSERT_EQ(verdict.losses, 0U) << "step " << step;
        ASSERT_TRUE(test::all_certified(advised)) << "step " << step;
      }
      if (HasFailure()) return;
      ++flown;
    }
  }
  EXPECT_GT(flown, test::kSanitized ? 100 : 3000);
}

}  // namespace
}  // namespace beespace
