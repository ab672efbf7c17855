// The independent check of true positions, against dense samples and at exactly the threshold.
#include "sim/true_separation.hpp"

#include "scenes/random_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace beespace::sim {
namespace {

constexpr Separation kSphere{};
constexpr Separation kEllipsoid{SeparationShape::kEllipsoid, 3.0};
constexpr Separation kCylinder{SeparationShape::kCylinder, 1.0, 3.0};
constexpr std::array kShapes = {kSphere, kEllipsoid, kCylinder};

Vector3 random_vector(scenes::RandomStream& random, double most) {
  return uniform_in_ball(random, false) * most;
}

Stretch random_stretch(scenes::RandomStream& random) {
  return {random_vector(random, 8.0), random_vector(random, 30.0), random_vector(random, 60.0)};
}

// The factor of the shape that is touched, at one time.
long double factor_at(const Stretch& a, const Stretch& b, long double t, const FreeSpace& space) {
  const auto axis = [&](double Vector3::*c) {
    const auto at = [&](const Stretch& s) {
      return static_cast<long double>(s.position.*c) + t * static_cast<long double>(s.velocity.*c) +
             t * t / 2 * static_cast<long double>(s.acceleration.*c);
    };
    return at(a) - at(b);
  };
  const long double wide = std::hypot(axis(&Vector3::x), axis(&Vector3::y)) / space.free_m;
  const long double z = std::abs(axis(&Vector3::z));
  const Separation& shape = space.separation;
  if (shape.shape == SeparationShape::kCylinder) {
    return std::max(wide, z / static_cast<long double>(shape.vertical_m));
  }
  const long double factor = shape.shape == SeparationShape::kEllipsoid
                                 ? static_cast<long double>(shape.vertical_factor)
                                 : 1.0L;
  return std::hypot(wide, z / (factor * space.free_m));
}

TEST(TrueSeparation, AgreesWithDenseSamples) {
  scenes::RandomStream random(1);
  constexpr int kSamples = 2'000;
  constexpr long double kLasts_s = 0.5L;
  for (int round = 0; round < 150; ++round) {
    const Stretch a = random_stretch(random);
    const Stretch b = random_stretch(random);
    for (const Separation& shape : kShapes) {
      const FreeSpace space{shape, 5.0L};
      long double sampled = std::numeric_limits<long double>::infinity();
      for (int k = 0; k <= kSamples; ++k) {
        sampled = std::min(sampled, factor_at(a, b, kLasts_s * k / kSamples, space));
      }
      const long double found = closest_in(a, b, kLasts_s, space);
      EXPECT_LE(found, sampled + 1e-15L);
      // No two samples are farther apart than this in any direction.
      EXPECT_GE(found, sampled - 100.0L * kLasts_s / kSamples / 3.0L);
    }
  }
}

// Two that pass each other: closest in the middle of the instant.
TEST(TrueSeparation, FindsExactlyTheThresholdWithinAnInstant) {
  struct Passing {
    Separation shape;
    Vector3 off;
  };
  for (const auto& [shape, off] :
       {Passing{kSphere, {0.0, 5.0, 0.0}}, Passing{kSphere, {0.0, 3.0, 4.0}},
        Passing{kEllipsoid, {0.0, 0.0, 15.0}}, Passing{kEllipsoid, {0.0, 3.0, 12.0}},
        Passing{kCylinder, {0.0, 5.0, 1.0}}, Passing{kCylinder, {0.0, 1.0, 3.0}}}) {
    const Stretch a{{-1.0, 0.0, 0.0}, {8.0, 0.0, 0.0}, {}};
    const Stretch b{off, {}, {}};
    EXPECT_NEAR(static_cast<double>(closest_in(a, b, 0.25L, {shape, 5.0L})), 1.0, 1e-15);
    for (const double share : {1.0 - 1e-9, 1.0, 1.0 + 1e-9}) {
      const Stretch near{off * share, {}, {}};
      TrueSeparation check(
          {.threshold_m = 5.0, .separation = shape, .instant_s = 0.25, .instants = 1});
      const std::array both = {a, near};
      EXPECT_EQ(check.look(0.0, both, {}).size(), share < 1.0 ? 1U : 0U) << share;
      EXPECT_NEAR(check.verdict().closest_m.value(), 5.0 * share, 1e-12);
    }
  }
}

// All pairs, without any grid.
TEST(TrueSeparation, OverlooksNoPair) {
  scenes::RandomStream random(2);
  constexpr std::size_t kAgents = 120;
  for (const Separation& shape : kShapes) {
    std::vector<Stretch> flown;
    std::vector<double> radii;
    for (std::size_t i = 0; i < kAgents; ++i) {
      for (int k = 0; k < 2; ++k) {
        flown.push_back({random_vector(random, 40.0), random_vector(random, 20.0),
                         random_vector(random, 20.0)});
      }
      radii.push_back(random.uniform(1.0, 4.0));
    }
    std::size_t lost = 0;
    long double closest = std::numeric_limits<long double>::infinity();
    for (std::size_t i = 0; i < kAgents; ++i) {
      for (std::size_t j = i + 1; j < kAgents; ++j) {
        const FreeSpace space{shape, std::max(5.0, radii[i] + radii[j])};
        const long double least =
            std::min(closest_in(flown[2 * i], flown[2 * j], 0.1L, space),
                     closest_in(flown[2 * i + 1], flown[2 * j + 1], 0.1L, space));
        if (least < 1.0L) ++lost;
        closest = std::min(closest, least * space.free_m);
      }
    }
    TrueSeparation check(
        {.threshold_m = 5.0, .separation = shape, .instant_s = 0.1, .instants = 2});
    EXPECT_EQ(check.look(0.0, flown, radii).size(), lost);
    EXPECT_GT(lost, 10U);
    EXPECT_NEAR(check.verdict().closest_m.value(), static_cast<double>(closest), 1e-9);
  }
}

TEST(TrueSeparation, WidensToTheSumOfTheRadii) {
  const std::array both = {Stretch{}, Stretch{{6.0, 0.0, 0.0}, {}, {}}};
  TrueSeparation check({.threshold_m = 5.0, .instants = 1});
  EXPECT_EQ(check.look(0.0, both, std::array{3.0, 3.0}).size(), 0U);
  EXPECT_EQ(check.look(0.0, both, std::array{3.0, 3.1}).size(), 1U);
  EXPECT_EQ(check.look(0.0, both, std::array{1.0, 1.0}).size(), 0U);
}

TEST(TrueSeparation, CountsWhoGoesBeyondAFenceWithinAnInstant) {
  TrueSeparationOptions options;
  options.instants = 1;
  options.instant_s = 1.0;
  options.fences = {{{0.0, 0.0, 1.0}, 10.0}};
  options.clearance_m = 1.0;
  TrueSeparation check(options);
  // Down by 1 m and up again.
  const auto dip = [](double height) {
    return std::array{Stretch{{0.0, 0.0, height}, {0.0, 0.0, -4.0}, {0.0, 0.0, 8.0}}};
  };
  check.look(0.0, dip(12.0), {});
  EXPECT_EQ(check.verdict().fence_losses, 0U);
  check.look(1.0, dip(11.999), {});
  EXPECT_EQ(check.verdict().fence_losses, 1U);
}

// The first ones obey no rules of the fleet.
TEST(TrueSeparation, FencesAndPlanesAreNotThoseOfIntruders) {
  TrueSeparation check({.threshold_m = 1.0,
                        .instants = 1,
                        .fences = {{{0.0, 0.0, 1.0}, 0.0}},
                        .planar = true,
                        .intruders = 1});
  const std::array radii = {0.0, 0.0};
  const Stretch beyond{{0.0, 0.0, -5.0}, {0.0, 0.0, -1.0}, {}};
  const Stretch level{{50.0, 0.0, 3.0}, {}, {}};
  check.look(0.0, std::array{beyond, level}, radii);
  check.look(1.0, std::array{beyond, level}, radii);
  EXPECT_EQ(check.verdict().fence_losses + check.verdict().heights_left, 0U);
  check.look(2.0, std::array{level, beyond}, radii);
  EXPECT_EQ(check.verdict().fence_losses, 1U);
  EXPECT_EQ(check.verdict().heights_left, 1U);
}

TEST(TrueSeparation, NoticesAHeightThatIsLeft) {
  TrueSeparation check({.instants = 1, .planar = true});
  const std::array level = {Stretch{{0.0, 0.0, 3.0}, {1.0, 2.0, 0.0}, {}}};
  check.look(0.0, level, {});
  check.look(0.1, level, {});
  EXPECT_EQ(check.verdict().heights_left, 0U);
  check.look(0.2, std::array{Stretch{{0.0, 0.0, 3.0}, {1.0, 2.0, 0.1}, {}}}, {});
  EXPECT_EQ(check.verdict().heights_left, 1U);
}

}  // namespace
}  // namespace beespace::sim
