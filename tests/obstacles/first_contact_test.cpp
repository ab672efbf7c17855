// When a ball first touches: it does so then, and never did before.
#include "scenes/random_stream.hpp"
#include "tests/obstacles/random_obstacles.hpp"
#include "tests/obstacles/surface_oracle.hpp"
#include "tests/support/rounds.hpp"

#include <beespace/obstacle.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::Real;
using test::real;

std::optional<double> contact(const Obstacle& obstacle, const Mover& ball, double radius,
                              double horizon) {
  const auto found = first_contact_s(obstacle, ball, radius, horizon);
  EXPECT_TRUE(found) << found.error().message;
  return found ? *found : std::nullopt;
}

struct Flight {
  Obstacle obstacle;
  Mover ball;
  double radius;
  double horizon;

  [[nodiscard]] double clearance(double time) const {
    const auto& [p, v] = ball;
    const Point at{p.x + v.x * time, p.y + v.y * time, p.z + v.z * time};
    return static_cast<double>(test::true_distance(obstacle, at) - real(radius));
  }
};

// Nowhere before `end` is less room than that: at many times, and at many close to the end.
void expect_clear(const Flight& flight, double end, double rounding) {
  constexpr int kTimes = 50;
  for (int i = 0; i < kTimes; ++i) {
    const double time = end * static_cast<double>(i) / kTimes;
    ASSERT_GT(flight.clearance(time), -rounding) << "at " << time << " s";
  }
  double before = end;
  for (int i = 0; i < kTimes; ++i) {
    before *= 0.5;
    ASSERT_GT(flight.clearance(end - before), -rounding) << before << " s before " << end << " s";
  }
}

// Over the whole flight, by repeated refinement around the minimum.
double least_clearance(const Flight& flight) {
  double begin = 0.0;
  double end = flight.horizon;
  double least = test::kEndless;
  for (int closer = 0; closer < 12; ++closer) {
    constexpr int kTimes = 40;
    const double step = (end - begin) / kTimes;
    double best = begin;
    for (int i = 0; i <= kTimes; ++i) {
      const double time = begin + step * static_cast<double>(i);
      const double clearance = flight.clearance(time);
      if (!(clearance < least)) continue;
      least = clearance;
      best = time;
    }
    begin = std::max(0.0, best - step);
    end = std::min(flight.horizon, best + step);
  }
  return least;
}

struct Tally {
  int at_once = 0;
  int later = 0;
  int never = 0;
};

void expect_first(const Flight& flight, double rounding, Tally& tally) {
  const auto found = contact(flight.obstacle, flight.ball, flight.radius, flight.horizon);
  if (!found) {
    ASSERT_GT(least_clearance(flight), -rounding);
    ++tally.never;
    return;
  }
  ASSERT_GE(*found, 0.0);
  ASSERT_LE(*found, flight.horizon);
  ASSERT_LE(flight.clearance(*found), rounding) << "not yet at " << *found << " s";
  ++(*found > 0.0 ? tally.later : tally.at_once);
  if (*found > 0.0) {
    ASSERT_NO_FATAL_FAILURE(expect_clear(flight, *found, rounding));
  }
}

Flight random_flight(RandomStream& random, std::size_t kind, double scale, const Point& middle) {
  const auto around = [&](double reach) {
    const Point off = test::random_place(random, reach * scale);
    return Point{middle.x + off.x, middle.y + off.y, middle.z + off.z};
  };
  const Obstacle obstacle = test::random_obstacle(random, kind, scale, middle);
  const Point from = around(random.index(4) == 0 ? 5.0 : 15.0);
  const Point through = around(6.0);
  const double haste = random.uniform(0.0, 0.3);
  const Velocity velocity{haste * (through.x - from.x), haste * (through.y - from.y),
                          haste * (through.z - from.z)};
  const double radius = random.index(3) == 0 ? 0.0 : scale * random.uniform(0.0, 3.0);
  return {obstacle, {from, velocity}, radius, random.uniform(0.0, 20.0)};
}

TEST(FirstContact, OfRandomFlights) {
  RandomStream random(1);
  Tally tallies[test::kKinds];
  for (int round = 0; round < test::rounds(10'000); ++round) {
    const std::size_t kind = static_cast<std::size_t>(round) % test::kKinds;
    const Flight flight = random_flight(random, kind, 1.0, {});
    ASSERT_NO_FATAL_FAILURE(expect_first(flight, 1e-12, tallies[kind])) << "round " << round;
  }
  for (const auto& [at_once, later, never] : tallies) {
    EXPECT_GT(at_once, test::rounds(10'000) / 1000);
    EXPECT_GT(later, test::rounds(10'000) / 100);
    EXPECT_GT(never, test::rounds(10'000) / 50);
  }
}

TEST(FirstContact, OfAllSizesFarFromTheOrigin) {
  RandomStream random(2);
  Tally tally;
  for (int round = 0; round < test::rounds(10'000); ++round) {
    const std::size_t kind = static_cast<std::size_t>(round) % test::kKinds;
    const double scale = std::exp(random.uniform(-3.0, 6.0));
    const Flight flight = random_flight(random, kind, scale, test::random_place(random, 1e6));
    ASSERT_NO_FATAL_FAILURE(expect_first(flight, 4e-14 * 1e6, tally)) << "round " << round;
  }
  EXPECT_GT(tally.at_once, test::rounds(10'000) / 100);
  EXPECT_GT(tally.later, test::rounds(10'000) / 10);
  EXPECT_GT(tally.never, test::rounds(10'000) / 10);
}

// By the formula, which tells how far off the time itself is.
TEST(FirstContact, OfSpheresIsTheRoot) {
  RandomStream random(3);
  int touched = 0;
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const Sphere sphere{{}, random.uniform(0.0, 3.0)};
    const Mover ball{{random.uniform(-9.0, -6.0), random.uniform(-3.0, 3.0), 0.5}, {1, 0.25, 0}};
    const double radius = random.uniform(0.0, 2.0);
    const auto& [p, v] = ball;
    const Real a = real(v.x) * real(v.x) + real(v.y) * real(v.y);
    const Real b = real(p.x) * real(v.x) + real(p.y) * real(v.y);
    const Real reach = real(sphere.radius_m) + real(radius);
    const Real c = real(p.x) * real(p.x) + real(p.y) * real(p.y) + 0.25L - reach * reach;
    const Real squared = b * b - a * c;
    const auto found = contact(sphere, ball, radius, 100.0);
    if (std::abs(squared) < 1e-3L) continue;  // grazing: the time is ill-conditioned
    ASSERT_EQ(found.has_value(), squared > 0.0L) << "round " << round;
    if (!found) continue;
    ++touched;
    const Real truth = (-b - std::sqrt(squared)) / a;
    ASSERT_NEAR(static_cast<double>(real(*found) - truth), 0.0, 1e-11) << "round " << round;
    ASSERT_LE(real(*found), truth) << "round " << round;
  }
  EXPECT_GT(touched, test::rounds(50'000) / 4);
}

TEST(FirstContact, ComesWithinTheHorizon) {
  const Box wall{{0, -5, -5}, {1, 5, 5}};
  const Mover ball{{-10, 0, 0}, {1, 0, 0}};
  ASSERT_TRUE(contact(wall, ball, 0.0, 10.0));
  EXPECT_NEAR(*contact(wall, ball, 0.0, 10.0), 10.0, 1e-13);
  EXPECT_NEAR(*contact(wall, ball, 2.5, 10.0), 7.5, 1e-13);
  EXPECT_FALSE(contact(wall, ball, 0.0, 9.99));
  EXPECT_FALSE(contact(wall, ball, 0.0, 0.0));
  EXPECT_EQ(contact(wall, ball, 10.0, 0.0), 0.0);  // touches as it stands
}

TEST(FirstContact, OfMoversThatStandOrFlyAway) {
  const Box wall{{0, -5, -5}, {1, 5, 5}};
  EXPECT_FALSE(contact(wall, {{-10, 0, 0}, {0, 0, 0}}, 9.9, 1e30));
  EXPECT_FALSE(contact(wall, {{-10, 0, 0}, {-1, 0, 0}}, 9.9, 1e30));
  EXPECT_EQ(contact(wall, {{0.5, 0, 0}, {0, 0, 0}}, 0.0, 1.0), 0.0);
  EXPECT_EQ(contact(wall, {{0.5, 0, 0}, {9, 0, 0}}, 0.0, 1.0), 0.0);
}

TEST(FirstContact, AlongAWall) {
  const Box wall{{0, 0, 0}, {1e4, 1, 100}};
  const Mover along{{-100, 3, 50}, {10, 0, 0}};
  EXPECT_FALSE(contact(wall, along, 2.0 - 1e-9, 1e4));
  const auto touches = contact(wall, along, 2.0 + 1e-9, 1e4);
  ASSERT_TRUE(touches);
  EXPECT_NEAR(*touches, 10.0, 1e-4);
}

TEST(FirstContact, ThatGrazes) {
  const UprightCylinder mast{0, 0, 1, {0, 50}};
  const auto passes = [&](double y) { return contact(mast, {{-10, y, 20}, {2, 0, 0}}, 2.0, 60.0); };
  EXPECT_TRUE(passes(3.0));  // to be on the safe side
  EXPECT_TRUE(passes(3.0 - 1e-9));
  EXPECT_FALSE(passes(3.0 + 1e-9));
  const auto above = [&](double z) { return contact(mast, {{-10, 0, z}, {2, 0, 0}}, 2.0, 60.0); };
  EXPECT_TRUE(above(52.0));
  EXPECT_FALSE(above(52.0 + 1e-9));
}

// A point comes down on a long wall at a small angle: a normal that is off by little would put the
// far end of the wall in between.
TEST(FirstContact, AtASmallAngleToALongWall) {
  RandomStream random(4);
  for (int round = 0; round < test::rounds(10'000); ++round) {
    const double angle = random.uniform(0.0, 6.28);
    const double x = std::cos(angle);
    const double y = std::sin(angle);
    const double far = std::exp(random.uniform(0.0, 14.0));
    const Corner ends[] = {{-far * x, -far * y}, {far * x, far * y}};
    const UprightPrism wall{
        {ends[0], ends[1], {ends[1].x + y, ends[1].y - x}, {ends[0].x + y, ends[0].y - x}}, {}};
    const double slope = std::exp(random.uniform(-7.0, 0.0));
    const Mover ball{{-y, x, 0}, {0.3 * x + slope * y, 0.3 * y - slope * x, 0.1}};
    const auto found = contact(wall, ball, 0.0, 2.0 / slope);
    if (far < 1.0 + 0.3 / slope) continue;  // passes the end of the wall
    ASSERT_TRUE(found) << "round " << round;
    const double rounding = 1e-14 * (10.0 + far);
    ASSERT_NEAR(*found, 1.0 / slope, rounding / slope) << "round " << round;
  }
}

// A lane that winds inwards: what is met first is not the nearest part of it.
TEST(FirstContact, OfAnOutlineWithDents) {
  const UprightPrism lane{test::spiral(), {0, 10}};
  EXPECT_NEAR(*contact(lane, {{-5, 1.5, 5}, {1, 0, 0}}, 0.25, 60.0), 10.75, 1e-12);
  EXPECT_NEAR(*contact(lane, {{1.5, 20, 5}, {0, -2, 0}}, 0.25, 60.0), 6.375, 1e-12);
  EXPECT_NEAR(*contact(lane, {{2.5, 3.5, 5}, {0, 1, 0}}, 0.25, 60.0), 2.25, 1e-12);
}

}  // namespace
}  // namespace beespace
