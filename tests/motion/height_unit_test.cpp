// Heights apart from positions may be in feet: they are compared with a vertical threshold in feet
// as they are, and distances are reported in metres all the same.
#include <beespace/find_conflicts.hpp>
#include <beespace/predict_conflicts.hpp>
#include <beespace/swarm.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace beespace {
namespace {

constexpr double kFoot_m = 0.3048;
constexpr double kGround_m = 400.0;
constexpr double kThreshold_m = 5000.0;
constexpr double kVertical_ft = 1000.0;

// Level flight of two, side by side, for ten seconds.
std::vector<Track> recording(double low_ft, double apart_ft) {
  std::vector<Track> tracks(2);
  for (std::size_t i = 0; i < 2; ++i) {
    const double y = i == 0 ? 0.0 : kGround_m;
    tracks[i].fixes = {{0.0, {0.0, y, 0.0}}, {10.0, {1000.0, y, 0.0}}};
    tracks[i].heights_m.assign(2, i == 0 ? low_ft : low_ft + apart_ft);
  }
  return tracks;
}

std::vector<Conflict> recorded(double low_ft, double apart_ft, bool inclusive) {
  const auto found = find_conflicts(recording(low_ft, apart_ft), {.threshold_m = kThreshold_m,
                                                                  .vertical_m = kVertical_ft,
                                                                  .inclusive = inclusive,
                                                                  .height_unit_m = kFoot_m});
  EXPECT_TRUE(found.has_value());
  return found ? found->conflicts : std::vector<Conflict>();
}

std::vector<Conflict> predicted(double low_ft, double apart_ft, bool inclusive) {
  const std::vector<Mover> movers = {{{0.0, 0.0, 0.0}, {100.0, 0.0, 0.0}},
                                     {{0.0, kGround_m, 0.0}, {100.0, 0.0, 0.0}}};
  const MoversView level(movers);
  const std::vector<double> heights = {low_ft, low_ft + apart_ft};
  const std::vector<double> climbs = {0.0, 0.0};
  const auto found = predict_conflicts({level.positions(), level.velocities(), heights, climbs},
                                       {.threshold_m = kThreshold_m,
                                        .vertical_m = kVertical_ft,
                                        .inclusive = inclusive,
                                        .height_unit_m = kFoot_m});
  EXPECT_TRUE(found.has_value());
  return found ? *found : std::vector<Conflict>();
}

std::vector<SwarmEvent> heard(double low_ft, double apart_ft) {
  Swarm swarm({.threshold_m = kThreshold_m,
               .vertical_m = kVertical_ft,
               .heights_apart = true,
               .horizon_s = 5.0,
               .height_unit_m = kFoot_m});
  for (const double time_s : {0.0, 1.0}) {
    for (PointId i = 0; i < 2; ++i) {
      PositionReport report{i, time_s, {100.0 * time_s, i == 0 ? 0.0 : kGround_m, 0.0}};
      report.height_m = i == 0 ? low_ft : low_ft + apart_ft;
      EXPECT_TRUE(swarm.update(report).has_value());
    }
  }
  auto events = swarm.advance(1.0);
  EXPECT_TRUE(events.has_value());
  return events ? *std::move(events) : std::vector<SwarmEvent>();
}

std::optional<SwarmEvent> entered(double low_ft, double apart_ft) {
  const auto events = heard(low_ft, apart_ft);
  const auto found = std::find_if(events.begin(), events.end(), [](const SwarmEvent& event) {
    return event.kind == EventKind::kEntered;
  });
  return found == events.end() ? std::nullopt : std::optional(*found);
}

// In metres, rounded, 16 of these would be in conflict.
TEST(HeightUnit, AThousandFeetApartAreNotCloserThanThatOnAnyFlightLevel) {
  for (int level = 10; level <= 490; level += 10) {
    const double low_ft = 100.0 * level;
    EXPECT_TRUE(recorded(low_ft, kVertical_ft, false).empty()) << level;
    EXPECT_EQ(recorded(low_ft, kVertical_ft, true).size(), 1U) << level;
    EXPECT_TRUE(predicted(low_ft, kVertical_ft, false).empty()) << level;
    EXPECT_EQ(predicted(low_ft, kVertical_ft, true).size(), 1U) << level;
    EXPECT_FALSE(entered(low_ft, kVertical_ft)) << level;
    EXPECT_TRUE(entered(low_ft, kVertical_ft - 0.25)) << level;
  }
}

TEST(HeightUnit, DistancesAreReportedInMetres) {
  const double apart_ft = 900.0;
  const double expected_m = std::hypot(kGround_m, apart_ft * kFoot_m);
  const auto in_recording = recorded(35000.0, apart_ft, false);
  ASSERT_EQ(in_recording.size(), 1U);
  EXPECT_NEAR(in_recording.front().closest_m, expected_m, 1e-9);
  const auto ahead = predicted(35000.0, apart_ft, false);
  ASSERT_EQ(ahead.size(), 1U);
  EXPECT_NEAR(ahead.front().closest_m, expected_m, 1e-9);
  const auto event = entered(35000.0, apart_ft);
  ASSERT_TRUE(event);
  EXPECT_NEAR(event->distance_m, expected_m, 1e-9);
}

TEST(HeightUnit, MustBeSomeLength) {
  for (const double unit : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    const auto found = find_conflicts(
        recording(0.0, 1.0), {.threshold_m = 1.0, .vertical_m = 1.0, .height_unit_m = unit});
    ASSERT_FALSE(found.has_value());
    EXPECT_EQ(found.error().code, ErrorCode::kInvalidArgument);
    const std::vector<Mover> movers(2);
    const auto ahead = predict_conflicts(movers, {.threshold_m = 1.0, .height_unit_m = unit});
    ASSERT_FALSE(ahead.has_value());
    EXPECT_EQ(ahead.error().code, ErrorCode::kInvalidArgument);
    Swarm swarm({.threshold_m = 1.0, .height_unit_m = unit});
    const auto events = swarm.advance(0.0);
    ASSERT_FALSE(events.has_value());
    EXPECT_EQ(events.error().code, ErrorCode::kInvalidArgument);
  }
}

}  // namespace
}  // namespace beespace
