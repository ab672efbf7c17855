#include "scenes/moving_scenes.hpp"

#include <beespace/closest_approach.hpp>
#include <beespace/predict_conflicts.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

#include "scenes/random_velocity.hpp"
#include "tests/scenes/fingerprint.hpp"

namespace beespace::scenes {
namespace {

constexpr std::size_t kMany = 20'000;
constexpr Point kBox{1'000.0, 800.0, 120.0};
constexpr Speeds kSpeeds{5.0, 20.0};
constexpr EncounterPlan kPlan{kSpeeds, 30.0, 60.0, 500.0};

std::uint64_t fingerprint(const std::vector<Mover>& movers) {
  Fingerprint fingerprint;
  for (const auto& [p, v] : movers) fingerprint.take({p.x, p.y, p.z, v.x, v.y, v.z});
  return fingerprint.value();
}

double length(double x, double y, double z) {
  return std::sqrt(x * x + y * y + z * z);
}

double speed_of(const Mover& mover) {
  return length(mover.velocity.x, mover.velocity.y, mover.velocity.z);
}

// Within the range but for rounding, and not all at one end of it.
void expect_speeds(const std::vector<Mover>& movers, const Speeds& speeds) {
  double sum = 0.0;
  for (const Mover& mover : movers) {
    const double speed = speed_of(mover);
    ASSERT_GE(speed, speeds.slowest_mps * (1.0 - 1e-15));
    ASSERT_LE(speed, speeds.fastest_mps * (1.0 + 1e-15));
    sum += speed;
  }
  const double range = speeds.fastest_mps - speeds.slowest_mps;
  EXPECT_NEAR(sum / static_cast<double>(movers.size()),
              0.5 * (speeds.slowest_mps + speeds.fastest_mps), 0.03 * range);
}

void expect_in_box(const std::vector<Mover>& movers, const Point& size) {
  for (const auto& [p, v] : movers) {
    ASSERT_TRUE(p.x >= 0.0 && p.x <= size.x);
    ASSERT_TRUE(p.y >= 0.0 && p.y <= size.y);
    ASSERT_TRUE(p.z >= 0.0 && p.z <= size.z);
  }
}

// The stated encounters are those that closest_approach finds, except for rounding.
void expect_true(const Encounters& scene, double within_s, double rounding) {
  ASSERT_EQ(scene.movers.size(), 2 * scene.encounters.size());
  for (std::size_t i = 0; i < scene.encounters.size(); ++i) {
    const Encounter& encounter = scene.encounters[i];
    ASSERT_EQ(encounter.first, 2 * i);
    ASSERT_EQ(encounter.second, 2 * i + 1);
    ASSERT_GE(encounter.closest_s, 0.0);
    ASSERT_LE(encounter.closest_s, within_s);
    const auto found =
        closest_approach(scene.movers[encounter.first], scene.movers[encounter.second],
                         {.threshold_m = 1.0, .horizon_s = 2.0 * within_s});
    ASSERT_TRUE(found.has_value());
    ASSERT_NEAR(found->closest_s, encounter.closest_s, rounding) << "pair " << i;
    ASSERT_NEAR(found->closest_m, encounter.closest_m, rounding) << "pair " << i;
  }
}

TEST(RandomDirection, HasLengthOneAndNoSideThatItPrefers) {
  RandomStream random(1);
  Point sum;
  Point squares;
  for (std::size_t i = 0; i < kMany; ++i) {
    const auto [x, y, z] = random_direction(random);
    ASSERT_NEAR(length(x, y, z), 1.0, 1e-15);
    sum = {sum.x + x, sum.y + y, sum.z + z};
    squares = {squares.x + x * x, squares.y + y * y, squares.z + z * z};
  }
  for (const double mean : {sum.x / kMany, sum.y / kMany, sum.z / kMany}) {
    EXPECT_NEAR(mean, 0.0, 0.02);
  }
  for (const double mean : {squares.x / kMany, squares.y / kMany, squares.z / kMany}) {
    EXPECT_NEAR(mean, 1.0 / 3.0, 0.01);
  }
}

TEST(MovingScenes, TheSameSeedGivesTheseBitsOnEveryMachine) {
  EXPECT_EQ(fingerprint(random_flight(1'000, kBox, kSpeeds, 1)), 3'533'885'515'641'762'680u);
  EXPECT_EQ(fingerprint(crossing_streams(1'000, kBox, kSpeeds, 1)), 14'452'167'312'081'116'055u);
  EXPECT_EQ(fingerprint(sphere_swap(1'000, 250.0, kSpeeds, 1)), 12'343'836'569'273'765'023u);
  EXPECT_EQ(fingerprint(head_on_pairs(500, kBox, kSpeeds, 3.0, 60.0, 1).movers),
            11'927'921'849'913'649'424u);
  EXPECT_EQ(fingerprint(known_encounters(500, kPlan, 1).movers), 10'839'234'027'823'664'598u);
}

TEST(MovingScenes, AnotherSeedGivesOtherMovers) {
  EXPECT_NE(random_flight(9, kBox, kSpeeds, 1), random_flight(9, kBox, kSpeeds, 2));
  EXPECT_NE(crossing_streams(9, kBox, kSpeeds, 1), crossing_streams(9, kBox, kSpeeds, 2));
  EXPECT_NE(sphere_swap(9, 250.0, kSpeeds, 1), sphere_swap(9, 250.0, kSpeeds, 2));
  EXPECT_NE(head_on_pairs(9, kBox, kSpeeds, 3.0, 60.0, 1).movers,
            head_on_pairs(9, kBox, kSpeeds, 3.0, 60.0, 2).movers);
  EXPECT_NE(known_encounters(9, kPlan, 1).movers, known_encounters(9, kPlan, 2).movers);
}

TEST(MovingScenes, RandomFlightFillsItsBoxAndGoesEveryWay) {
  const auto movers = random_flight(kMany, kBox, kSpeeds, 2);
  ASSERT_EQ(movers.size(), kMany);
  expect_in_box(movers, kBox);
  expect_speeds(movers, kSpeeds);
  Point place;
  Point way;
  for (const auto& [p, v] : movers) {
    place = {place.x + p.x, place.y + p.y, place.z + p.z};
    way = {way.x + v.x, way.y + v.y, way.z + v.z};
  }
  EXPECT_NEAR(place.x / kMany, 0.5 * kBox.x, 0.02 * kBox.x);
  EXPECT_NEAR(place.y / kMany, 0.5 * kBox.y, 0.02 * kBox.y);
  EXPECT_NEAR(place.z / kMany, 0.5 * kBox.z, 0.02 * kBox.z);
  for (const double mean : {way.x / kMany, way.y / kMany, way.z / kMany}) {
    EXPECT_NEAR(mean, 0.0, 0.2);
  }
}

TEST(MovingScenes, OneSpeedForAllIsARangeToo) {
  for (const Mover& mover : random_flight(100, kBox, {12.0, 12.0}, 3)) {
    EXPECT_NEAR(speed_of(mover), 12.0, 1e-14);
  }
}

TEST(MovingScenes, StreamsCrossAtRightAnglesInTheSameBox) {
  const auto movers = crossing_streams(kMany, kBox, kSpeeds, 4);
  ASSERT_EQ(movers.size(), kMany);
  expect_in_box(movers, kBox);
  expect_speeds(movers, kSpeeds);
  for (std::size_t i = 0; i < kMany; ++i) {
    const Velocity& v = movers[i].velocity;
    EXPECT_EQ(v, i % 2 == 0 ? (Velocity{v.x, 0.0, 0.0}) : (Velocity{0.0, v.y, 0.0}));
    EXPECT_GT(v.x + v.y, 0.0);
  }
}

TEST(MovingScenes, OnTheSphereAllFlyThroughTheCentreToTheOppositePoint) {
  constexpr double kRadius = 250.0;
  const auto movers = sphere_swap(kMany, kRadius, kSpeeds, 5);
  ASSERT_EQ(movers.size(), kMany);
  expect_speeds(movers, kSpeeds);
  for (const auto& mover : movers) {
    const auto& [p, v] = mover;
    const Point out{p.x - kRadius, p.y - kRadius, p.z - kRadius};
    ASSERT_NEAR(length(out.x, out.y, out.z), kRadius, 1e-12);
    const double crossing_s = 2.0 * kRadius / speed_of(mover);
    const Point there{out.x + v.x * crossing_s, out.y + v.y * crossing_s, out.z + v.z * crossing_s};
    ASSERT_NEAR(length(there.x + out.x, there.y + out.y, there.z + out.z), 0.0, 1e-11);
  }
}

TEST(MovingScenes, OnTheSphereWithOneSpeedAllAreInTheCentreAtOnce) {
  const auto conflicts = predict_conflicts(sphere_swap(60, 250.0, {10.0, 10.0}, 6),
                                           {.threshold_m = 1e-9, .horizon_s = 50.0});
  ASSERT_TRUE(conflicts.has_value());
  EXPECT_EQ(conflicts->size(), 60u * 59u / 2u);
  for (const Conflict& conflict : *conflicts) EXPECT_NEAR(conflict.closest_s, 25.0, 1e-9);
}

TEST(MovingScenes, HeadOnPairsFlyAtEachOtherAndMissByWhatWasChosen) {
  const Encounters scene = head_on_pairs(kMany, kBox, kSpeeds, 3.0, 60.0, 7);
  ASSERT_EQ(scene.encounters.size(), kMany);
  expect_speeds(scene.movers, kSpeeds);
  expect_true(scene, 60.0, 1e-10);
  for (const Encounter& encounter : scene.encounters) {
    ASSERT_EQ(encounter.closest_m, 3.0);
    const Velocity& a = scene.movers[encounter.first].velocity;
    const Velocity& b = scene.movers[encounter.second].velocity;
    const double speeds = length(a.x, a.y, a.z) * length(b.x, b.y, b.z);
    ASSERT_NEAR(a.x * b.x + a.y * b.y + a.z * b.z, -speeds, 1e-12 * speeds);
  }
}

TEST(MovingScenes, HeadOnPairsMayBeMadeToCollide) {
  expect_true(head_on_pairs(100, kBox, kSpeeds, 0.0, 60.0, 8), 60.0, 1e-10);
}

TEST(MovingScenes, KnownEncountersAreAsTheyWereChosen) {
  const Encounters scene = known_encounters(kMany, kPlan, 9);
  ASSERT_EQ(scene.encounters.size(), kMany);
  expect_speeds(scene.movers, kSpeeds);
  expect_true(scene, kPlan.within_s, 1e-9);
  double times = 0.0;
  double distances = 0.0;
  for (const Encounter& encounter : scene.encounters) {
    ASSERT_LE(encounter.closest_m, kPlan.farthest_m);
    times += encounter.closest_s;
    distances += encounter.closest_m;
  }
  EXPECT_NEAR(times / kMany, 0.5 * kPlan.within_s, 1.0);
  EXPECT_NEAR(distances / kMany, 0.5 * kPlan.farthest_m, 0.5);
}

// With a threshold as large as the room between the pairs, only the pairs are in conflict.
TEST(MovingScenes, KnownEncountersAreTheOnlyOnes) {
  for (const std::size_t pairs : {1u, 8u, 9u, 3'000u}) {
    const Encounters scene = known_encounters(pairs, kPlan, 10);
    const auto found = predict_conflicts(
        scene.movers, {.threshold_m = kPlan.clear_m, .horizon_s = kPlan.within_s});
    ASSERT_TRUE(found.has_value());
    ASSERT_EQ(found->size(), pairs);
    for (std::size_t i = 0; i < pairs; ++i) {
      const Encounter& truth = scene.encounters[i];
      const Conflict& conflict = (*found)[i];
      ASSERT_EQ(std::tie(conflict.first, conflict.second), std::tie(truth.first, truth.second));
      ASSERT_NEAR(conflict.closest_s, truth.closest_s, 1e-9);
      ASSERT_NEAR(conflict.closest_m, truth.closest_m, 1e-9);
    }
  }
}

TEST(MovingScenes, NoBeesAreAnEmptyScene) {
  EXPECT_TRUE(random_flight(0, kBox, kSpeeds, 1).empty());
  EXPECT_TRUE(crossing_streams(0, kBox, kSpeeds, 1).empty());
  EXPECT_TRUE(sphere_swap(0, 1.0, kSpeeds, 1).empty());
  EXPECT_TRUE(head_on_pairs(0, kBox, kSpeeds, 1.0, 1.0, 1).movers.empty());
  EXPECT_TRUE(known_encounters(0, kPlan, 1).movers.empty());
}

}  // namespace
}  // namespace beespace::scenes
