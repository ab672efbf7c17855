// PX4 logs whose drone says in vehicle_land_detected that it has landed.
#include "tests/io/px4/ulog_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

constexpr unsigned kLandNumber = 20;

Result<Recording> load(const UlogMaking& log, const RecordingOptions& options = {}) {
  return load_recording_from_memory(log.bytes(), "north.ulg", options);
}

UlogMaking log_with_landings() {
  UlogMaking log = px4_log();
  log.format("vehicle_land_detected:uint64_t timestamp;bool freefall;bool landed;");
  log.subscribe(kLandNumber, "vehicle_land_detected");
  log.data(kGpsNumber, gps_message(5'000'000, kNoon_us + 5'000'000));
  return log;
}

void say(UlogMaking& log, std::uint64_t micros, bool landed) {
  log.data(kLandNumber, UlogBody().u64(micros).u8(0).u8(landed ? 1 : 0));
}

// At 20 m it goes to the north with 5 m/s, on the ground it stands.
void be_there(UlogMaking& log, std::uint64_t micros, bool flies, double north_m) {
  constexpr double kMetresPerDegree = 111'195.0;
  log.data(kGlobalNumber, global_message({.micros = micros,
                                          .lat = 47.25 + north_m / kMetresPerDegree,
                                          .alt = flies ? 532.0 : 512.0}));
}

// It flies from 20 to 40 s and from 60 to 80 s, and ends at 100 s.
UlogMaking two_flights(bool every_second, bool stuck = false) {
  UlogMaking log = log_with_landings();
  double north_m = 0.0;
  bool flew = true;
  for (std::uint64_t tenth = 50; tenth <= 1000; ++tenth) {
    const bool flies = (tenth >= 200 && tenth < 400) || (tenth >= 600 && tenth < 800);
    const std::uint64_t micros = tenth * 100'000;
    if (flies != flew || (every_second && tenth % 10 == 0)) say(log, micros, stuck || !flies);
    flew = flies;
    if (flies) north_m += 0.5;
    if (tenth % 5 == 0) be_there(log, micros, flies, north_m);
  }
  return log;
}

TEST(UlogLanded, WhoHasLandedIsNotInTheAir) {
  const auto recording = recording_of(load(two_flights(true)));
  ASSERT_EQ(recording.bees.size(), 1u);
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.fixes.size(), 191u) << "others may fly close to it";
  ASSERT_EQ(bee.landed.size(), 3u);
  EXPECT_EQ(bee.landed[0].ends_s, kNoon_s + 18.5);
  EXPECT_EQ(bee.landed[1].begins_s, kNoon_s + 40.0);
  EXPECT_EQ(bee.landed[1].ends_s, kNoon_s + 58.5);
  EXPECT_EQ(bee.landed[2].begins_s, kNoon_s + 80.0);
  EXPECT_TRUE(recording.missing.none());
  EXPECT_TRUE(has_note(recording, "two that both stand are no conflict"));
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_TRUE(recording_of(load(two_flights(true), grounded)).bees[0].landed.empty());
}

// PX4 says it each second; what it said long ago may no more be so.
TEST(UlogLanded, WhatWasSaidLongAgoIsNotBelieved) {
  EXPECT_TRUE(recording_of(load(two_flights(false))).bees[0].landed.empty());
}

TEST(UlogLanded, WhoIsAboveWhereItStoodFliesWhateverTheFlagSays) {
  const auto recording = recording_of(load(two_flights(true, true)));
  for (const TimeSpan& span : recording.bees[0].landed) {
    EXPECT_TRUE(span.ends_s < kNoon_s + 20.0 || span.begins_s >= kNoon_s + 80.0)
        << span.begins_s - kNoon_s << " to " << span.ends_s - kNoon_s;
  }
}

TEST(UlogLanded, ARoverNeverLands) {
  UlogMaking log = two_flights(true);
  log.format("vehicle_status:uint64_t timestamp;uint8_t system_type;");
  log.subscribe(21, "vehicle_status");
  log.data(21, UlogBody().u64(6'000'000).u8(10));
  EXPECT_TRUE(recording_of(load(log)).bees[0].landed.empty());
}

TEST(UlogLanded, WhoMovesAsNoneOnTheGroundFlies) {
  UlogMaking log = log_with_landings();
  for (std::uint64_t second = 5; second < 30; ++second) {
    const std::uint64_t micros = second * 1'000'000;
    say(log, micros, true);
    log.data(kLocalNumber, local_message({.micros = micros, .vx = second < 15 ? 3.0 : 0.1}));
    be_there(log, micros, false, 0.0);
  }
  const auto recording = recording_of(load(log));
  EXPECT_EQ(recording.bees[0].fixes.size(), 25u);
  ASSERT_EQ(recording.bees[0].landed.size(), 1u);
  EXPECT_EQ(recording.bees[0].landed[0].begins_s, kNoon_s + 15.0);
}

}  // namespace
}  // namespace beespace::io
