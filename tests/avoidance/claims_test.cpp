// Claims: convex hulls of several places, with tubes, radii and shapes that stay free.
#include "tests/avoidance/claimed_flock.hpp"
#include "tests/support/rounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace {
namespace {

using scenes::RandomStream;
using test::ClaimedFlock;
using test::length;
using test::long_of;
using test::LongVector;

// How far within the shape an offset lies, as a share: 1 on its surface, more outside.
long double outside(const Separation& separation, long double horizontal_m, const LongVector& d) {
  switch (separation.shape) {
    case SeparationShape::kSphere:
      return length(d) / horizontal_m;
    case SeparationShape::kEllipsoid:
      return length(
                 LongVector{d.x, d.y, d.z / static_cast<long double>(separation.vertical_factor)}) /
             horizontal_m;
    case SeparationShape::kCylinder:
      return std::max(std::sqrt(d.x * d.x + d.y * d.y) / horizontal_m,
                      std::abs(d.z) / static_cast<long double>(separation.vertical_m));
  }
  return 0.0L;
}

// The places of one agent in the coming tick on one of its paths, and its last one.
std::vector<LongVector> places_of(const test::Path& path, const ClaimedFlock& flock) {
  std::vector<LongVector> places;
  const auto& first = path.states.front();
  const auto& next = path.states.size() > 1 ? path.states[1] : first;
  const long double step_s = flock.options.step_s;
  for (const long double s : {0.0L, 0.25L, 0.5L, 0.75L, 1.0L}) {
    // Evenly accelerated from one velocity to the other.
    const LongVector v = long_of(first.velocity);
    const LongVector change = long_of(next.velocity) - v;
    places.push_back(long_of(first.position) + v * (s * step_s) + change * (0.5L * s * s * step_s));
  }
  std::vector<Point> all;
  path.append_places(flock.limits, flock.options.step_s, all);
  places.push_back(long_of(all.back()));
  return places;
}

std::vector<LongVector> places_of(const test::ClaimedAgent& agent, const ClaimedFlock& flock) {
  std::vector<LongVector> places = places_of(agent.path, flock);
  for (const test::Path& path : agent.others) {
    for (const LongVector& place : places_of(path, flock)) places.push_back(place);
  }
  return places;
}

// The least share over all pairs, with both anywhere in their tubes: towards each other, and along
// the surface's normal.
long double least_outside(const ClaimedFlock& flock) {
  long double least = 1e9L;
  std::vector<std::vector<LongVector>> places;
  for (const auto& agent : flock.agents) places.push_back(places_of(agent, flock));
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = i + 1; j < places.size(); ++j) {
      const Claim& a = flock.claims[i];
      const Claim& b = flock.claims[j];
      const long double horizontal_m = std::max(flock.options.threshold_m, a.radius_m + b.radius_m);
      const long double tubes_m = a.tube_m + b.tube_m;
      for (const LongVector& p : places[i]) {
        for (const LongVector& q : places[j]) {
          const LongVector d = p - q;
          const double c = flock.options.separation.vertical_factor;
          const long double squash = 1.0L / static_cast<long double>(c * c);
          for (const LongVector& n : {d, LongVector{d.x, d.y, 0}, LongVector{0, 0, d.z},
                                      LongVector{d.x, d.y, d.z * squash}}) {
            const long double long_m = length(n);
            const long double share = long_m > 0.0L ? tubes_m / long_m : 0.0L;
            least = std::min(least, outside(flock.options.separation, horizontal_m, d - n * share));
          }
        }
      }
    }
  }
  return least;
}

struct Variant {
  std::string name;
  Separation separation;
  bool planar = false;
  double largest_radius_m = 0.0;
  double tube_m = 0.0;
};

void PrintTo(const Variant& variant, std::ostream* out) {
  *out << variant.name;
}

std::vector<Variant> variants() {
  const Separation ellipsoid{SeparationShape::kEllipsoid, 3.0};
  const Separation flat{SeparationShape::kEllipsoid, 0.4};
  const Separation cylinder{SeparationShape::kCylinder, 1.0, 3.0};
  return {{"sphere", {}, false, 0.0, 0.0},       {"tubes", {}, false, 0.0, 0.5},
          {"radii", {}, false, 4.0, 0.3},        {"ellipsoid", ellipsoid, false, 0.0, 0.0},
          {"flat", flat, false, 0.0, 0.4},       {"ellipsoid_tubes", ellipsoid, false, 3.0, 0.4},
          {"cylinder", cylinder, false, 0.0, 0}, {"cylinder_tubes", cylinder, false, 3.0, 0.4},
          {"planar", {}, true, 3.0, 0.4},        {"planar_cylinder", cylinder, true, 3.0, 0.4}};
}

// So near to each other that all hinder each other, at rest.
ClaimedFlock crowd(const Variant& variant, int side, std::uint64_t seed) {
  RandomStream random(seed);
  ClaimedFlock flock;
  flock.limits = {10.0, 5.0};
  flock.options.threshold_m = 5.0;
  flock.options.separation = variant.separation;
  flock.options.planar = variant.planar;
  flock.options.step_s = 0.1;
  const double apart_m = std::max(5.0, 2.0 * variant.largest_radius_m) + 2.0 * variant.tube_m + 0.1;
  double up_m = apart_m;
  if (variant.separation.shape == SeparationShape::kEllipsoid) {
    up_m = apart_m * variant.separation.vertical_factor + 2.0 * variant.tube_m;
  }
  const double spacing = random.uniform(1.05, 1.6);
  for (int x = 0; x < side; ++x) {
    for (int y = 0; y < side; ++y) {
      for (int z = 0; z < (variant.planar ? 1 : side); ++z) {
        Claim claim;
        claim.tube_m = variant.tube_m * random.uniform(0.5, 1.0);
        claim.radius_m = variant.largest_radius_m * random.uniform(0.2, 1.0);
        claim.holds = random.index(12) == 0;
        const std::size_t ahead = 1 + random.index(4);
        flock.add({apart_m * spacing * x, apart_m * spacing * y, up_m * spacing * z}, ahead, claim);
      }
    }
  }
  return flock;
}

class Claims : public testing::TestWithParam<Variant> {};

// Whatever agents want, and whichever of their paths they follow, all that a claim contains stays
// apart, tick after tick.
TEST_P(Claims, StayApartInACrowdWithHostilePreferredVelocities) {
  const int ticks = test::rounds(400);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    ClaimedFlock flock = crowd(GetParam(), GetParam().planar ? 5 : 3, seed);
    RandomStream random(seed + 100);
    Adviser adviser;
    Advised advised;
    std::vector<Velocity> wishes(flock.agents.size());
    double flown_m = 0.0;
    for (int tick = 0; tick < ticks; ++tick) {
      for (std::size_t k = 0; k < wishes.size(); ++k) {
        if (tick % 25 != 0 && random.index(20) != 0) continue;
        wishes[k] = test::random_velocity(random, 15.0);
      }
      flock.prepare();
      const Status status =
          adviser.advise(flock.movers, wishes, {&flock.limits, 1}, flock.options, advised);
      ASSERT_TRUE(status) << status.error().message;
      ASSERT_TRUE(advised.refused.empty()) << advised.refused.front().error.message;
      ASSERT_TRUE(test::all_keep_apart(advised))
          << GetParam().name << ", seed " << seed << ", tick " << tick << ": pair "
          << advised.too_close.front().pair.first << " " << advised.too_close.front().pair.second
          << ", gap " << advised.too_close.front().gap_m;
      flock.advance(advised.advice, random);
      for (const Advice& advice : advised.advice) flown_m += test::length_of(advice.velocity) * 0.1;
      if (tick % 5 == 0) {
        ASSERT_GE(least_outside(flock), 1.0L)
            << GetParam().name << ", seed " << seed << ", tick " << tick;
      }
    }
    EXPECT_GT(flown_m / static_cast<double>(wishes.size()), 0.02 * ticks);
  }
}

// With planes that are remembered from tick to tick, too.
TEST_P(Claims, AnyNumberOfThreadsGivesTheSameBits) {
  for (const unsigned threads : {2U, 5U}) {
    ClaimedFlock one = crowd(GetParam(), GetParam().planar ? 5 : 3, 7);
    ClaimedFlock many = crowd(GetParam(), GetParam().planar ? 5 : 3, 7);
    one.options.threads = 1;
    many.options.threads = threads;
    RandomStream for_one(8);
    RandomStream for_many(8);
    RandomStream random(9);
    Adviser adviser_of_one;
    Adviser adviser_of_many;
    Advised by_one;
    Advised by_many;
    std::vector<Velocity> wishes(one.agents.size());
    for (int tick = 0; tick < test::rounds(100); ++tick) {
      for (Velocity& wish : wishes) {
        if (tick % 25 == 0 || random.index(20) == 0) wish = test::random_velocity(random, 15.0);
      }
      one.prepare();
      many.prepare();
      const std::span limits(&one.limits, 1);
      ASSERT_TRUE(adviser_of_one.advise(one.movers, wishes, limits, one.options, by_one));
      ASSERT_TRUE(adviser_of_many.advise(many.movers, wishes, limits, many.options, by_many));
      for (std::size_t k = 0; k < wishes.size(); ++k) {
        ASSERT_EQ(by_one.advice[k].velocity, by_many.advice[k].velocity) << tick << ", " << k;
        ASSERT_EQ(by_one.advice[k].kind, by_many.advice[k].kind) << tick << ", " << k;
        ASSERT_EQ(by_one.advice[k].keeps_apart, by_many.advice[k].keeps_apart);
      }
      one.advance(by_one.advice, for_one);
      many.advance(by_many.advice, for_many);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Claims, testing::ValuesIn(variants()),
                         [](const auto& about) { return about.param.name; });

}  // namespace
}  // namespace beespace
