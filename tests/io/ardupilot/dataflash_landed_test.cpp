// DataFlash logs of ArduPilot whose vehicle says when it has landed.
#include "tests/io/ardupilot/dataflash_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace beespace::io {
namespace {

constexpr unsigned kArmed = 10;
constexpr unsigned kDisarmed = 11;
constexpr unsigned kLandComplete = 18;
constexpr unsigned kNotLanded = 28;

Recording recorded(const DataflashMaking& log) {
  return recording_of(load_recording_from_memory(log.bytes(), "1.bin", {}));
}

// It stands until 20 s after it was switched on, flies north at 20 m until 40 s and stands.
struct Flight {
  std::string_view vehicle = "ArduCopter V4.5.7 (2a3dc4b7)";
  bool events = true;
  bool status = false;
};

DataflashMaking one_flight(const Flight& flight) {
  DataflashMaking log = ardupilot_log(flight.vehicle);
  log.gps(5'000'000, kWeek, kWeekMs);
  for (std::uint64_t tenth = 50; tenth <= 600; ++tenth) {
    const std::uint64_t micros = tenth * 100'000;
    const bool flies = tenth >= 200 && tenth < 400;
    if (tenth == 100) log.event(micros, kArmed);
    if (flight.events && tenth == 200) log.event(micros, kNotLanded);
    if (flight.events && tenth == 400) log.event(micros, kLandComplete);
    if (tenth == 420) log.event(micros, kDisarmed);
    if (flight.status && tenth % 10 == 0) log.flying(micros, flies);
    const double flown =
        tenth < 200 ? 0.0 : static_cast<double>(std::min<std::uint64_t>(tenth, 400) - 200);
    const double up = flies ? 20.0 : 0.0;
    log.pos(micros, 47.25 + flown * 5e-6, 8.5, 500.0 + up, up);
  }
  return log;
}

void expect_two_stays(const Recording& recording) {
  ASSERT_EQ(recording.bees.size(), 1u);
  const RecordedBee& bee = recording.bees[0];
  ASSERT_EQ(bee.landed.size(), 2u);
  EXPECT_EQ(bee.landed[0].begins_s, kStarted_s);
  EXPECT_NEAR(bee.landed[0].ends_s, kStarted_s + 14.9, 0.11);
  EXPECT_NEAR(bee.landed[1].begins_s, kStarted_s + 35.0, 0.11);
  EXPECT_EQ(bee.landed[1].ends_s, kStarted_s + 55.0);
  EXPECT_TRUE(has_note(recording, "two that both stand are no conflict"));
}

TEST(DataflashLanded, WhoIsSwitchedOnStandsUntilItSaysNotTo) {
  expect_two_stays(recorded(one_flight({})));
}

TEST(DataflashLanded, WhoFliesOnWingsSaysInStatWhetherItFlies) {
  expect_two_stays(recorded(one_flight({"ArduPlane V4.5.7 (2a3dc4b7)", false, true})));
}

TEST(DataflashLanded, WhoNeverSaysSoFlies) {
  // To be armed says nothing of who flies on wings.
  EXPECT_TRUE(
      recorded(one_flight({"ArduPlane V4.5.7 (2a3dc4b7)", false, false})).bees[0].landed.empty());
}

TEST(DataflashLanded, ARoverNeverLands) {
  const Recording recording = recorded(one_flight({"ArduRover V4.5.7 (2a3dc4b7)"}));
  EXPECT_TRUE(recording.bees[0].landed.empty());
}

TEST(DataflashLanded, WhoIsArmedAndNeverTakesOffStandsAllTheTime) {
  DataflashMaking log = ardupilot_log();
  log.gps(5'000'000, kWeek, kWeekMs).event(5'100'000, kArmed);
  for (std::uint64_t tenth = 52; tenth <= 100; ++tenth)
    log.pos(tenth * 100'000, 47.25, 8.5, 500.0, 0.0);
  const Recording recording = recorded(log);
  ASSERT_EQ(recording.bees[0].landed.size(), 1u);
  EXPECT_EQ(recording.bees[0].landed[0].ends_s, kStarted_s + 5.0);
}

// As after its computer began anew in flight: it is armed high above where it took off.
TEST(DataflashLanded, WhoIsArmedHighAboveHomeFlies) {
  DataflashMaking log = ardupilot_log();
  log.gps(5'000'000, kWeek, kWeekMs).event(5'100'000, kArmed);
  for (std::uint64_t tenth = 52; tenth <= 100; ++tenth) {
    log.pos(tenth * 100'000, 47.25, 8.5, 530.0, 30.0);
  }
  EXPECT_TRUE(recorded(log).bees[0].landed.empty());
}

TEST(DataflashLanded, GroundedTakesThemForFlying) {
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_TRUE(recording_of(load_recording_from_memory(one_flight({}).bytes(), "1.bin", grounded))
                  .bees[0]
                  .landed.empty());
}

}  // namespace
}  // namespace beespace::io
