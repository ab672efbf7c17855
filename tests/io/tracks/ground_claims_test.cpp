// Aircraft that say that they are on the ground: who has landed is not in the air any more, and who
// goes on as no roll does flies.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>

namespace beespace::io {
namespace {

// Records of an aircraft every ten seconds, due north from where it is.
struct Leg {
  double begins_s = 0.0;
  double ends_s = 0.0;
  double speed_mps = 0.0;
  double height_ft = 0.0;
  bool on_ground = false;
};

std::string records_of(const std::string& id, std::initializer_list<Leg> legs) {
  constexpr double kMetresPerDegree = 111'200.0;
  constexpr double kEvery_s = 10.0;
  std::string text;
  double latitude = 47.0;
  for (const Leg& leg : legs) {
    for (double at = leg.begins_s; at < leg.ends_s; at += kEvery_s) {
      text += std::to_string(1.7e9 + at) + "," + id + "," + std::to_string(latitude) + ",8," +
              std::to_string(leg.height_ft) + (leg.on_ground ? ",True\n" : ",False\n");
      latitude += leg.speed_mps * kEvery_s / kMetresPerDegree;
    }
  }
  return text;
}

Recording flights(const std::string& records) {
  return recording_of(record("timestamp,icao24,lat,lon,alt_ft,onground\n" + records));
}

TEST(GroundClaims, WhoTaxiesAfterALandingIsOnTheGroundFromThereOn) {
  const auto recording =
      flights(records_of("4b1814", {{0, 300, 60, 1500, false}, {300, 400, 10, 1400, true}}));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].on_ground_from_s, 1.7e9 + 300);
  EXPECT_EQ(recording.bees[0].on_ground_until_s, std::nullopt);
  EXPECT_TRUE(recording.missing.none());
}

TEST(GroundClaims, WhoTaxiesBeforeATakeOffIsOnTheGroundUntilThen) {
  const auto recording =
      flights(records_of("4b1814", {{0, 100, 10, 1400, true}, {100, 300, 60, 1500, false}}));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].on_ground_until_s, 1.7e9 + 90);
  EXPECT_EQ(recording.bees[0].on_ground_from_s, std::nullopt);
}

// One claim, or some that go on as before, may be a fault of the sender.
TEST(GroundClaims, WhoIsNotSlowHasNotSurelyLanded) {
  const auto one =
      flights(records_of("4b1814", {{0, 300, 60, 1500, false}, {300, 310, 60, 1400, true}}));
  EXPECT_EQ(one.bees[0].on_ground_from_s, std::nullopt);
  const auto fast =
      flights(records_of("4b1814", {{0, 300, 60, 1500, false}, {300, 340, 60, 1400, true}}));
  EXPECT_EQ(fast.bees[0].on_ground_from_s, std::nullopt);
}

// At 60 kt for five minutes, low.
TEST(GroundClaims, WhoGoesOnAtTheSpeedOfALightAircraftFlies) {
  const std::string other = records_of("3c6444", {{0, 300, 100, 9000, false}});
  const auto slow_flight = flights(other + records_of("4b1814", {{0, 300, 31, 500, true}}));
  EXPECT_EQ(slow_flight.missing.count, 30u);
  EXPECT_EQ(slow_flight.missing.nowhere, 1u);
  const auto taxi = flights(other + records_of("4b1814", {{0, 300, 15, 500, true}}));
  EXPECT_TRUE(taxi.missing.none());
  // A landing: a fast minute, and then a slow one.
  const auto roll =
      flights(other + records_of("4b1814", {{0, 60, 35, 500, true}, {60, 300, 10, 500, true}}));
  EXPECT_TRUE(roll.missing.none());
}

}  // namespace
}  // namespace beespace::io
