// Drones of a telemetry log that say that they stand on the ground: they are not in the air then.
#include "tests/io/mavlink/telemetry_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::uint64_t kNoon = 1714564800'000'000;  // microseconds
constexpr double kNoon_s = 1714564800.0;

Result<Recording> load(std::string_view log, const RecordingOptions& options = {}) {
  return load_recording_from_memory(log, "flight.tlog", options);
}

// What is said at a second: "" is nothing.
using Says = std::function<std::string(int second)>;

// A place twice a second for 30 s, and each second what drone 1 says. It flies to the east from
// 10 s to 20 s, 20 m high, or all the time at `always_cm_s`.
std::string flight(const Says& says, int always_cm_s = 0) {
  std::string log;
  for (int half = 0; half <= 60; ++half) {
    const std::uint64_t at = kNoon + static_cast<std::uint64_t>(half) * 500'000;
    const bool flies = half > 20 && half < 40;
    const int speed_cm_s = flies ? 500 : always_cm_s;
    const int east = flies ? 330 * (half - 20) : half < 40 ? 0 : 330 * 20;
    if (half % 2 == 0) {
      if (const std::string frame = says(half / 2); !frame.empty()) log += logged(at, frame);
    }
    const auto boot_ms = static_cast<std::uint32_t>(10'000 + half * 500);
    log +=
        logged(at, frame_v2(1, 33,
                            global_payload(470'000'000, 80'000'000 + east,
                                           flies ? 520'000 : 500'000, 0, speed_cm_s, 0, boot_ms)));
  }
  return log;
}

Says by_state(int on_ground, int in_the_air) {
  return [=](int second) {
    return frame_v2(1, 245, landed_state(second < 10 || second >= 20 ? on_ground : in_the_air));
  };
}

Says by_heartbeat(int mode, int state) {
  return [=](int second) {
    const bool flies = second >= 10 && second < 20;
    return frame_v2(1, 0, heartbeat(2, 12, flies ? 128 + mode : mode, flies ? 4 : state));
  };
}

// Both before and behind a place it must say so: it may have taken off since the last time.
TEST(VehicleLandings, WhoSaysThatItHasLandedIsNotInTheAir) {
  constexpr int kStandby = 3;
  for (const Says& says : {by_state(1, 2), by_heartbeat(0, kStandby)}) {
    const auto recording = recording_of(load(flight(says)));
    ASSERT_EQ(recording.bees.size(), 1u);
    const RecordedBee& bee = recording.bees[0];
    ASSERT_EQ(bee.fixes.size(), 22u);
    EXPECT_EQ(bee.fixes.front().time_s, kNoon_s + 9.0);
    EXPECT_EQ(bee.fixes.back().time_s, kNoon_s + 19.5);
    EXPECT_EQ(bee.on_ground_until_s, kNoon_s + 8.5);
    EXPECT_EQ(bee.on_ground_from_s, kNoon_s + 20.0);
    ASSERT_EQ(bee.landed.size(), 2u);
    EXPECT_EQ(bee.landed[0].begins_s, kNoon_s);
    EXPECT_EQ(bee.landed[1].ends_s, kNoon_s + 30.0);
    EXPECT_TRUE(recording.missing.none());
    EXPECT_TRUE(has_note(recording,
                         "39 records of drones that say that they are on the ground are "
                         "left out; --grounded keeps them"));
  }
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_EQ(recording_of(load(flight(by_state(1, 2)), grounded)).bees[0].fixes.size(), 61u);
}

// What is not surely so counts as flight.
TEST(VehicleLandings, WhoDoesNotSaySoSurelyFlies) {
  constexpr int kActive = 4;
  const auto seldom = [](int second) {
    return second % 6 == 0 ? frame_v2(1, 245, landed_state(1)) : std::string();
  };
  const auto another = [](int) { return frame_v2(1, 245, landed_state(1), 191); };
  for (const Says& says :
       std::vector<Says>{[](int) { return std::string(); }, by_state(0, 2), by_state(4, 2),
                         by_heartbeat(0, kActive), by_heartbeat(128, 3), seldom, another}) {
    const auto recording = recording_of(load(flight(says)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 61u);
    EXPECT_TRUE(recording.bees[0].landed.empty());
  }
}

// It is carried, or driven; or its autopilot is wrong.
TEST(VehicleLandings, WhoMovesAsNoneOnTheGroundFlies) {
  EXPECT_EQ(recording_of(load(flight(by_state(1, 2), 300))).bees[0].fixes.size(), 61u);
  EXPECT_EQ(recording_of(load(flight(by_state(1, 2), 100))).bees[0].fixes.size(), 22u);
}

// Its estimator goes on to say where it was last, though it says that it moves.
TEST(Telemetry, APlaceThatStaysWhileTheDroneMovesIsNone) {
  std::string log;
  for (int second = 0; second <= 30; ++second) {
    const int east = second <= 10 ? 660 * second : second < 25 ? 6600 : 660 * second;
    const auto boot_ms = static_cast<std::uint32_t>(10'000 + second * 1000);
    log += logged(
        kNoon + static_cast<std::uint64_t>(second) * 1'000'000,
        frame_v2(1, 33,
                 global_payload(470'000'000, 80'000'000 + east, 520'000, 0, 500, 0, boot_ms)));
  }
  const auto recording = recording_of(load(log));
  // From 14 s, more than 3 s after it came there, to 24 s.
  EXPECT_EQ(recording.bees[0].fixes.size(), 20u);
  EXPECT_EQ(recording.missing.count, 11u);
  EXPECT_EQ(recording.bees[0].unplaced_from_s, kNoon_s + 14.0);
  EXPECT_EQ(recording.bees[0].unplaced_until_s, kNoon_s + 24.0);
  EXPECT_TRUE(has_note(recording, "11 records whose place stays exactly the same"));
}

// As of aircraft, and of shows.
TEST(VehicleLandings, OfWhoNeverTakesOffNothingIsLeft) {
  const auto loaded = load(flight(by_state(1, 1), 0));
  ASSERT_TRUE(loaded) << loaded.error().message;  // it moves from 10 s to 20 s
  const auto parked = load(logged(kNoon, frame_v2(1, 245, landed_state(1))) +
                           logged(kNoon, frame_v2(1, 33, somewhere())) +
                           logged(kNoon + 1'000'000, frame_v2(1, 245, landed_state(1))));
  ASSERT_TRUE(parked) << parked.error().message;  // 2.2 m/s
  const std::string still = global_payload(470'000'000, 80'000'000, 500'000, 0, 0, 0);
  const auto stands = load(logged(kNoon, frame_v2(1, 245, landed_state(1))) +
                           logged(kNoon, frame_v2(1, 33, still)) +
                           logged(kNoon + 1'000'000, frame_v2(1, 245, landed_state(1))));
  ASSERT_FALSE(stands);
  EXPECT_EQ(stands.error().code, ErrorCode::kNoPoints);
  EXPECT_NE(stands.error().message.find("--grounded"), std::string::npos);
}

}  // namespace
}  // namespace beespace::io
