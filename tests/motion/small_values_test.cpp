// Values that are too small for exact comparison count as zero in every function. What is too large
// or not a number is refused, and the bee is named.
#include <beespace/brute_force.hpp>
#include <beespace/closest_approach.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/predict_conflicts.hpp>
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace beespace {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A value that came out of advice, the largest value that is too small, and the smallest double.
std::vector<double> too_small() {
  const double denormal = std::numeric_limits<double>::denorm_min();
  return {-9e-32, std::nextafter(kSmallestInMotion, 0.0), -denormal, denormal, 1e-200};
}

void expect_alike(const std::vector<Mover>& given, const std::vector<Mover>& zeroed) {
  const PredictOptions options{.threshold_m = 5.0, .horizon_s = 10.0};
  const auto expected = predict_conflicts(zeroed, options);
  ASSERT_TRUE(expected.has_value());
  EXPECT_EQ(expected->size(), 1U);
  const auto conflicts = predict_conflicts(given, options);
  ASSERT_TRUE(conflicts.has_value()) << conflicts.error().message;
  EXPECT_EQ(*conflicts, *expected);
  EXPECT_EQ(*brute_force::predict_conflicts(given, options), *expected);
  EXPECT_EQ(*predict_pairs(given, options), *predict_pairs(zeroed, options));
  const auto approach = closest_approach(given[0], given[1], options.approach());
  ASSERT_TRUE(approach.has_value());
  EXPECT_EQ(approach->closest_m,
            closest_approach(zeroed[0], zeroed[1], options.approach()).value().closest_m);
}

TEST(SmallValues, AreZeroToPredictions) {
  for (const double small : too_small()) {
    SCOPED_TRACE(small);
    const std::vector<Mover> zeroed = {{{0, 0, 0}, {1, 0, 0}}, {{8, 3, 0}, {0, 0, 0}}};
    std::vector<Mover> given = zeroed;
    given[0].position.y = small;
    given[1].velocity.x = small;
    given[1].position.z = -small;
    expect_alike(given, zeroed);
  }
}

TEST(SmallValues, AreZeroToPredictionsWithHeightsApart) {
  for (const double small : too_small()) {
    const std::vector<Mover> movers = {{{0, 0, 0}, {1, 0, 0}}, {{8, 3, 0}, {small, 0, 0}}};
    const std::vector<double> heights = {small, 4.0};
    const std::vector<double> climbs = {0.0, -small};
    const MoversView straight(movers);
    const MoversView view(straight.positions(), straight.velocities(), heights, climbs);
    const auto found =
        predict_conflicts(view, {.threshold_m = 5.0, .vertical_m = 4.5, .horizon_s = 10.0});
    ASSERT_TRUE(found.has_value()) << found.error().message;
    EXPECT_EQ(found->size(), 1U);
  }
}

TEST(SmallValues, AreZeroToRecordings) {
  for (const double small : too_small()) {
    SCOPED_TRACE(small);
    const std::vector<Track> zeroed = {{{{0.0, {0, 0, 0}}, {10.0, {10, 0, 0}}}},
                                       {{{0.0, {8, 3, 0}}, {10.0, {8, 3, 0}}}}};
    std::vector<Track> given = zeroed;
    given[0].fixes[0].position.y = small;
    given[1].fixes[0].time_s = small;
    given[1].fixes[1].position.z = -small;
    const ConflictOptions options{.threshold_m = 5.0};
    const auto expected = find_conflicts(zeroed, options);
    const auto found = find_conflicts(given, options);
    ASSERT_TRUE(found.has_value()) << found.error().message;
    EXPECT_EQ(found->conflicts, expected->conflicts);
    EXPECT_EQ(found->conflicts.size(), 1U);
    EXPECT_EQ(brute_force::find_conflicts(given, options).value().conflicts, expected->conflicts);
    const auto closest = find_closest_encounter(given);
    ASSERT_TRUE(closest.has_value()) << closest.error().message;
    EXPECT_EQ((*closest)->closest_m, 3.0);
  }
}

// A bee whose velocity decays by a tenth each step does not stop a swarm.
TEST(SmallValues, AreZeroToSwarms) {
  Swarm swarm({.threshold_m = 5.0});
  double speed = 1.0;
  double x = 0.0;
  std::size_t entered = 0;
  for (int step = 0; step < 1000; ++step) {
    const double time_s = 0.1 * step;
    ASSERT_TRUE(swarm.update({1, time_s, {x, -9e-32, 0}, Velocity{speed, 0, -speed}}).has_value());
    ASSERT_TRUE(swarm.update({2, time_s, {30.0 - 0.3 * step, 0, 0}}).has_value());
    const auto events = swarm.advance(time_s);
    ASSERT_TRUE(events.has_value()) << events.error().message;
    for (const SwarmEvent& event : *events) entered += event.kind == EventKind::kEntered ? 1 : 0;
    x += 0.1 * speed;
    speed *= 0.1;
  }
  EXPECT_EQ(entered, 1U);
}

TEST(SmallValues, LetLargeOnesBeRefusedAllTheSame) {
  for (const double bad : {0x1.1p+100, -1e200, kNan}) {
    const std::vector<Mover> movers = {{{9e-32, 0, 0}, {1, 0, 0}}, {{8, bad, 0}, {9e-33, 0, 0}}};
    const auto found = predict_conflicts(movers, {.threshold_m = 5.0});
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().location.record, 1U);
    EXPECT_EQ(found.error().code,
              std::isnan(bad) ? ErrorCode::kNotFinite : ErrorCode::kOutsideDomain);
    const std::vector<Track> tracks = {{{{9e-32, {0, 0, 0}}}}, {{{0.0, {bad, 0, 0}}}}};
    const auto conflicts = find_conflicts(tracks, {.threshold_m = 5.0});
    ASSERT_FALSE(conflicts.has_value());
    EXPECT_EQ(conflicts.error().location.record, 1U);
  }
}

// Two times of one bee that are the same then.
TEST(SmallValues, DoNotMakeOneTimeOfTwo) {
  const std::vector<Track> tracks = {{{{0.0, {0, 0, 0}}, {1e-31, {1, 0, 0}}}}};
  const auto found = find_conflicts(tracks, {.threshold_m = 5.0});
  ASSERT_FALSE(found.has_value());
  EXPECT_EQ(found.error().code, ErrorCode::kTimeOrder);
}

}  // namespace
}  // namespace beespace
