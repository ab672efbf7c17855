// The Verifier's findings about obstacles, compared with sampling.
#include "scenes/random_stream.hpp"
#include "scenes/random_velocity.hpp"
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/support/rounds.hpp"
#include "tests/verify/clearance_verdict.hpp"
#include "tests/verify/curve_oracle.hpp"

#include <beespace/verify.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Real;

// How close a flight comes to an obstacle: its curve, or straight on.
Real closest(const Obstacle& obstacle, const Mover& from, const Mover& to, double step_s,
             int samples) {
  const auto distance = [&](Real u) {
    const auto at = test::place_at(from, to, step_s, u);
    return test::true_distance(obstacle, {static_cast<double>(at[0]), static_cast<double>(at[1]),
                                          static_cast<double>(at[2])});
  };
  return test::least_of(distance, samples);
}

Mover moved(const Mover& mover, const Point& by) {
  return {{mover.position.x + by.x, mover.position.y + by.y, mover.position.z + by.z},
          mover.velocity};
}

// A curve with a bend, of some metres in some seconds.
std::array<Mover, 2> random_flight(RandomStream& random, double step_s, bool straight) {
  const Point p = test::random_place(random, 5.0);
  const Point q = test::random_place(random, 5.0);
  const Velocity chord{(q.x - p.x) / step_s, (q.y - p.y) / step_s, (q.z - p.z) / step_s};
  if (straight) return {{{p, chord}, {q, chord}}};
  const auto bent = [&] {
    const auto [x, y, z] = scenes::random_direction(random);
    const double by = random.uniform(0.0, 15.0) / step_s;
    return Velocity{chord.x + by * x, chord.y + by * y, chord.z + by * z};
  };
  const Velocity v = bent();
  const Velocity w = bent();
  return {{{p, v}, {q, w}}};
}

// Pushed away from the obstacle until it passes at the clearance, within a rounding, mostly between
// its fixes: a millionth nearer is a loss, a millionth farther is none.
class AtTheClearance : public testing::TestWithParam<bool> {};

INSTANTIATE_TEST_SUITE_P(Verifier, AtTheClearance, testing::Bool(), [](const auto& straight) {
  return std::string(straight.param ? "Straight" : "Curved");
});

TEST_P(AtTheClearance, AMillionthLessIsLostAndAMillionthMoreIsNot) {
  RandomStream random(1);
  int between = 0;
  for (int round = 0; round < test::rounds(200); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    const Obstacle obstacle = test::random_obstacle(random, random.index(test::kKinds), 0.4);
    const ObstacleMap map = test::map_of({obstacle});
    const double clearance_m = std::exp(random.uniform(-3.0, 1.0));
    const double step_s = std::exp(random.uniform(-3.0, 3.0));
    const std::array<Mover, 2> flight = random_flight(random, step_s, GetParam());
    // Upwards there is always an end of it, or there is none at all.
    const auto [x, y, z] = scenes::random_direction(random);
    const Point aside =
        std::holds_alternative<Ground>(obstacle) ? Point{0, 0, 1} : Point{x, y, 0.1 * z};
    const auto closest_at = [&](double by) {
      const Point shift{aside.x * by, aside.y * by, aside.z * by};
      return closest(obstacle, moved(flight[0], shift), moved(flight[1], shift), step_s, 40);
    };
    double low = 0.0;
    double high = 300.0;
    if (closest_at(low) > test::real(clearance_m) || closest_at(high) < test::real(clearance_m)) {
      continue;
    }
    for (int halving = 0; halving < 50; ++halving) {
      const double middle = 0.5 * (low + high);
      (closest_at(middle) < test::real(clearance_m) ? low : high) = middle;
    }
    VerifyOptions options = test::options_of(map, clearance_m);
    options.straight = GetParam();
    const auto losses_at = [&](double by) {
      const Point shift{aside.x * by, aside.y * by, aside.z * by};
      return test::losses_of(moved(flight[0], shift), moved(flight[1], shift), step_s, options);
    };
    int known = 0;
    for (const double off : {1e-6, 1e-5, 1e-3}) {
      const double by = off * clearance_m;
      if (closest_at(low - by) < test::real(clearance_m * (1.0 - 1e-7))) {
        ++known;
        ASSERT_EQ(losses_at(low - by), 1U) << off;
      }
      if (closest_at(high + by) > test::real(clearance_m * (1.0 + 1e-7))) {
        ASSERT_EQ(losses_at(high + by), 0U) << off;
      }
    }
    const Point shift{aside.x * low, aside.y * low, aside.z * low};
    const Real ends = std::min(test::true_distance(obstacle, moved(flight[0], shift).position),
                               test::true_distance(obstacle, moved(flight[1], shift).position));
    if (known == 3 && ends > 1.001L * test::real(clearance_m)) ++between;
  }
  EXPECT_GT(between, test::rounds(200) / 10);
}

// Many obstacles, many bees: the losses are those that sampling sees, and their figures.
TEST(Clearance, OfManyAgreesWithSampling) {
  RandomStream random(2);
  std::uint64_t seen = 0;
  for (int round = 0; round < test::rounds(60); ++round) {
    SCOPED_TRACE("round " + std::to_string(round));
    std::vector<Obstacle> obstacles;
    for (std::size_t k = 1 + random.index(6); k > 0; --k) {
      const Point at = test::random_place(random, 6.0);
      std::size_t kind = random.index(test::kKinds);
      if (kind == 2) kind = 0;
      obstacles.push_back(test::random_obstacle(random, kind, 0.6, at));
    }
    const ObstacleMap map = test::map_of(obstacles);
    VerifyOptions options = test::options_of(map, 0.4);
    options.straight = round % 3 == 0;
    const double step_s = 0.7;
    std::vector<Mover> from;
    std::vector<Mover> to;
    for (int bee = 0; bee < 12; ++bee) {
      const Point at = test::random_place(random, 6.0);
      const auto flight = random_flight(random, step_s, options.straight);
      from.push_back(moved(flight[0], at));
      to.push_back(moved(flight[1], at));
    }
    const Verdict verdict = test::verdict_of({from, to}, step_s, options);
    EXPECT_EQ(verdict.holds(), verdict.losses == 0 && verdict.clearance_losses == 0);
    ASSERT_EQ(verdict.first_clearance_losses.size(), verdict.clearance_losses);
    std::size_t next = 0;
    for (PointId bee = 0; bee < from.size(); ++bee) {
      std::vector<Real> each;
      Real least = 1e30L;
      for (const Obstacle& obstacle : obstacles) {
        each.push_back(closest(obstacle, from[bee], to[bee], step_s, 150));
        least = std::min(least, each.back());
      }
      const bool reported = next < verdict.first_clearance_losses.size() &&
                            verdict.first_clearance_losses[next].agent == bee;
      if (!reported) {
        ASSERT_GE(least, 0.4L * (1.0L - 1e-9L)) << "missed: bee " << bee;
        continue;
      }
      const ClearanceLoss& loss = verdict.first_clearance_losses[next++];
      ++seen;
      ASSERT_LE(least, 0.4L * (1.0L + 1e-8L)) << "no loss: bee " << bee;
      EXPECT_EQ(loss.begins_s, 0.0);
      EXPECT_EQ(loss.ends_s, step_s);
      EXPECT_LE(each[loss.obstacle], 0.4L * (1.0L + 1e-8L)) << "bee " << bee;
      // The sampled distances, at a 64th of the curve each.
      EXPECT_GE(test::real(loss.closest_m), least - 1e-9L);
      EXPECT_LE(test::real(loss.closest_m), least + 0.7L);
    }
    ASSERT_EQ(next, verdict.first_clearance_losses.size());
  }
  EXPECT_GT(seen, static_cast<std::uint64_t>(test::rounds(60)));
}

}  // namespace
}  // namespace beespace
