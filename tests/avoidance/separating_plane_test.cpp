#include "avoidance/constraints/separating_plane.hpp"

#include "avoidance/velocity_solver.hpp"
#include "scenes/random_stream.hpp"
#include "tests/avoidance/long_vector.hpp"
#include "tests/avoidance/random_directions.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

namespace beespace::avoidance {
namespace {

using scenes::RandomStream;
using test::long_of;

double distance(const Segment& first, const Segment& second) {
  return static_cast<double>(test::distance_between({long_of(first.from), long_of(first.way)},
                                                    {long_of(second.from), long_of(second.way)}));
}

Segment random_way(RandomStream& random) {
  const double long_m = random.index(5) == 0 ? 0.0 : std::exp(random.uniform(-7.0, 4.0));
  return {direction(random) * random.uniform(0.0, 10.0), direction(random) * long_m};
}

void expect_parted(const Segment& first, const Segment& second, double apart_m, double lean) {
  const SeparatingPlane plane = separate(first, second);
  const double rounding = 1e-14 * (1.0 + length(first.from) + length(first.way) +
                                   length(second.from) + length(second.way));
  ASSERT_NEAR(length(plane.normal), 1.0, 1e-14);
  ASSERT_LE(plane.gap, distance(first, second) + rounding);
  const HalfSpace of_first = plane.of_first(apart_m, lean);
  const HalfSpace of_second = plane.of_second(apart_m, lean);
  for (const double share : {0.0, 0.3, 1.0}) {
    ASSERT_GE(of_first.inside_by(first.at(share)), -rounding);
    ASSERT_GE(of_second.inside_by(second.at(share)), -rounding);
  }
  // The two half-spaces are the gap apart.
  ASSERT_EQ(of_first.normal, -of_second.normal);
  ASSERT_NEAR(of_first.offset + of_second.offset, std::min(apart_m, plane.gap), rounding);
}

TEST(SeparatingPlane, EachSegmentLiesInItsHalfSpaceAndTheGapIsNotAboveTheDistance) {
  RandomStream random(1);
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const Segment first = random_way(random);
    const Segment second = random_way(random);
    ASSERT_NO_FATAL_FAILURE(
        expect_parted(first, second, random.uniform(0.1, 10.0), random.uniform(-1.0, 1.0)))
        << "round " << round;
  }
}

TEST(SeparatingPlane, TheGapIsTheDistanceOfSegmentsThatAreApart) {
  RandomStream random(2);
  int apart = 0;
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const Segment first = random_way(random);
    const Segment second = random_way(random);
    const double far = distance(first, second);
    if (far < 0.05) continue;
    ++apart;
    ASSERT_NEAR(separate(first, second).gap, far, 1e-9 * far) << "round " << round;
  }
  EXPECT_GT(apart, test::rounds(100'000) / 2);
}

// The same for segments that are almost parallel and cross over one another: long stopping segments
// of bees that fly side by side. Any error reduces the threshold, which is widened by 1e-7 for it.
TEST(SeparatingPlane, TheGapIsTheDistanceOfNearlyParallelSegments) {
  RandomStream random(3);
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const double angle = std::exp(random.uniform(std::log(1e-12), std::log(1e-2)));
    const double long_m = random.uniform(1.0, 200.0);
    const Vector3 way = direction(random) * long_m;
    Vector3 aside = cross(way, direction(random));
    aside = aside * (1.0 / length(aside));
    const Vector3 up = cross(way, aside) * (1.0 / long_m);
    const Vector3 turned = way + aside * (angle * long_m);
    const Segment first{way * -random.uniform(0.0, 0.5), way};
    const Segment second{up - turned * random.uniform(0.0, 0.5), turned};
    const double far = distance(first, second);
    ASSERT_NEAR(separate(first, second).gap, far, 1e-8 * far)
        << "angle " << angle << ", ways of " << long_m << " m, round " << round;
  }
}

// However long the segments are, the error is less than half of the allowance for the rounding of
// coordinates, which is 2^-44 of the farthest and so of the segment at least. (Of segments that are
// parallel to within 1e-8, long doubles do not give the distance.)
TEST(SeparatingPlane, TheGapOfVeryLongSegmentsIsRightToTheirRounding) {
  RandomStream random(5);
  for (int round = 0; round < test::rounds(100'000); ++round) {
    const double angle = std::exp(random.uniform(std::log(1e-8), std::log(1e-2)));
    const double long_m = std::exp(random.uniform(std::log(1e3), std::log(1e10)));
    const Vector3 way = direction(random) * long_m;
    Vector3 aside = cross(way, direction(random));
    aside = aside * (1.0 / length(aside));
    const Vector3 up = cross(way, aside) * (random.uniform(1.0, 10.0) / long_m);
    const Vector3 turned = way + aside * (angle * long_m);
    const Segment first{way * -random.uniform(0.2, 0.5), way};
    const Segment second{up - turned * random.uniform(0.2, 0.5), turned};
    const double far = distance(first, second);
    ASSERT_NEAR(separate(first, second).gap, far, 1e-8 * far + 0x1p-45 * long_m)
        << "angle " << angle << ", ways of " << long_m << " m, round " << round;
  }
}

TEST(SeparatingPlane, OfSegmentsThatMeetIsAtRightAnglesToBoth) {
  const Segment first{{-1, 0, 0}, {2, 0, 0}};
  const Segment second{{0, -1, 0}, {0, 2, 0}};
  const SeparatingPlane plane = separate(first, second);
  EXPECT_EQ(plane.normal, (Vector3{0, 0, 1}));
  EXPECT_EQ(plane.gap, 0.0);
  EXPECT_EQ(separate(second, first).normal, (Vector3{0, 0, -1}));  // turned with the roles
  expect_parted(first, second, 1.0, 0.0);
}

// Bees on one line, at one place, standing or not: there is a normal, and each is in its own
// half-space.
TEST(SeparatingPlane, OfSegmentsThatOverlap) {
  const std::vector<Segment> ways = {{{0, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {2, 0, 0}},
                                     {{1, 0, 0}, {2, 0, 0}}, {{3, 0, 0}, {-3, 0, 0}},
                                     {{1, 0, 0}, {0, 0, 0}}, {{0, 0, 0}, {0, 0, 2}}};
  for (const Segment& first : ways) {
    for (const Segment& second : ways) {
      if (distance(first, second) > 0.0) continue;
      ASSERT_NO_FATAL_FAILURE(expect_parted(first, second, 1.0, 0.0));
      EXPECT_LE(separate(first, second).gap, 0.0);
    }
  }
}

// Any velocity that a solver gives lies in the half-spaces, or brakes.
TEST(VelocitySolver, WhateverIsProposedKeepsToTheHalfSpacesOrBrakes) {
  RandomStream random(4);
  VelocitySolver solver;
  int deflected = 0;
  for (int round = 0; round < test::rounds(50'000); ++round) {
    const double step_s = 0.1;
    const FlightLimits limits{random.uniform(1.0, 10.0), std::exp(random.uniform(0.0, 4.0))};
    const AgentState agent{{},
                           direction(random) * random.uniform(0.0, limits.max_speed_mps),
                           Braking(limits, step_s),
                           limits.max_speed_mps};
    // Half-spaces that contain the stopping segment.
    std::vector<HalfSpace> hard;
    const Segment way = agent.stopping_segment();
    for (std::size_t i = random.index(8); i > 0; --i) {
      const Vector3 n = direction(random);
      const double low = std::min(dot(n, way.from), dot(n, way.at(1.0)));
      hard.push_back({n, low - random.uniform(0.0, 0.3) * random.uniform(0.0, 1.0)});
    }
    const Vector3 wish = direction(random) * random.uniform(0.0, 30.0);
    const auto [v, kind] = solver.solve(agent, wish, {hard, {}, {}});
    const Vector3 stop = agent.stop_after(v);
    if (kind == AdviceKind::kBraking) {
      ASSERT_EQ(v, agent.braking.braked(agent.velocity));
      continue;
    }
    deflected += kind == AdviceKind::kDeflected ? 1 : 0;
    if (kind == AdviceKind::kAsPreferred) {
      ASSERT_EQ(v, agent.able(wish));
    }
    for (const HalfSpace& side : hard) ASSERT_GE(side.inside_by(stop), 0.0) << "round " << round;
  }
  EXPECT_GT(deflected, test::rounds(50'000) / 20);
}

// A wall ahead: the bee gets as near to its preferred velocity as the wall allows.
TEST(VelocitySolver, GoesAlongAWall) {
  const AgentState agent{
      {}, {}, Braking({10.0, std::numeric_limits<double>::infinity()}, 0.1), 10.0};
  const std::vector<HalfSpace> wall = {{{-1, 0, 0}, -0.5}};  // x <= 0.5
  VelocitySolver solver;
  const auto [v, kind] = solver.solve(agent, {6, 8, 0}, {wall, {}, {}});
  EXPECT_EQ(kind, AdviceKind::kDeflected);
  EXPECT_NEAR(v.x, 5.0, 1e-9);
  EXPECT_NEAR(v.y, 8.0, 1e-9);
  EXPECT_NEAR(v.z, 0.0, 1e-9);
}

}  // namespace
}  // namespace beespace::avoidance
