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
    ASSERT_EQ(bee.fixes.size(), 61u) << "others may fly close to it";
    ASSERT_EQ(bee.landed.size(), 2u);
    EXPECT_EQ(bee.landed[0].begins_s, kNoon_s);
    EXPECT_EQ(bee.landed[0].ends_s, kNoon_s + 8.5);
    EXPECT_EQ(bee.landed[1].begins_s, kNoon_s + 20.0);
    EXPECT_EQ(bee.landed[1].ends_s, kNoon_s + 30.0);
    EXPECT_TRUE(recording.missing.none());
    EXPECT_TRUE(has_note(recording, "two that both stand are no conflict"));
  }
  RecordingOptions grounded;
  grounded.grounded = true;
  EXPECT_TRUE(recording_of(load(flight(by_state(1, 2)), grounded)).bees[0].landed.empty());
}

// As each does from when it is switched on until it has satellites.
TEST(VehicleLandings, WhoStandsWhereItsPlaceIsFirstKnownWasNowhereElseBefore) {
  const std::string early =
      logged(kNoon - 2'000'000, frame_v2(1, 33, global_payload(0, 0, 0, 0, 0, 0))) +
      logged(kNoon - 1'000'000, frame_v2(1, 33, global_payload(0, 0, 0, 0, 0, 0)));
  const auto stands = recording_of(load(early + flight(by_state(1, 2))));
  EXPECT_TRUE(stands.missing.none());
  EXPECT_TRUE(has_note(stands, "2 records of drones that know no position yet"));
  EXPECT_TRUE(has_note(stands, "stand on the ground once they do"));
  EXPECT_EQ(recording_of(load(early + flight(by_state(2, 2)))).missing.count, 2u);
}

TEST(VehicleLandings, RoversAndBoatsStayOnTheSurface) {
  for (const auto& [type, stays] :
       {std::pair{10, true}, {11, true}, {12, false}, {2, false}, {0, false}}) {
    const auto says = [type = type](int) { return frame_v2(1, 0, heartbeat(type, 12, 128, 4)); };
    EXPECT_EQ(recording_of(load(flight(says))).bees[0].on_surface, stays) << type;
  }
}

// What is not surely so counts as flight.
TEST(VehicleLandings, WhoDoesNotSaySoSurelyFlies) {
  const auto seldom = [](int second) {
    return second % 6 == 0 ? frame_v2(1, 245, landed_state(1)) : std::string();
  };
  const auto another = [](int) { return frame_v2(1, 245, landed_state(1), 191); };
  for (const Says& says :
       std::vector<Says>{[](int) { return std::string(); }, by_state(0, 2), by_state(4, 2),
                         by_heartbeat(128, 3), seldom, another}) {
    const auto recording = recording_of(load(flight(says)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 61u);
    EXPECT_TRUE(recording.bees[0].landed.empty());
  }
}

constexpr int kActive = 4;    // MAV_STATE
constexpr int kCritical = 5;  // as ArduPilot says in any failsafe

// Whatever else a heartbeat says: with its motors off it does not fly.
TEST(VehicleLandings, WhoIsDisarmedStands) {
  for (const int state : {0, kActive, kCritical}) {
    const auto recording = recording_of(load(flight(by_heartbeat(0, state))));
    ASSERT_EQ(recording.bees[0].landed.size(), 2u) << state;
    EXPECT_EQ(recording.bees[0].landed[0].begins_s, kNoon_s);
    EXPECT_EQ(recording.bees[0].landed[1].ends_s, kNoon_s + 30.0);
  }
  // The heartbeat of what is no autopilot says nothing of it, nor does that of another component.
  const auto camera = [](int) { return frame_v2(1, 0, heartbeat(2, 8, 0, kActive)); };
  const auto another = [](int) { return frame_v2(1, 0, heartbeat(2, 12, 0, kActive), 191); };
  for (const Says& says : std::vector<Says>{camera, another}) {
    EXPECT_TRUE(recording_of(load(flight(says))).bees[0].landed.empty());
  }
}

// A bit that is stuck would make drones in the air stand: not even before and behind that it is
// believed.
TEST(VehicleLandings, WhoMovesWhileItIsDisarmedFliesAllTheTime) {
  const auto stuck = [](int) { return frame_v2(1, 0, heartbeat(2, 12, 0, kActive)); };
  EXPECT_TRUE(recording_of(load(flight(stuck))).bees[0].landed.empty());
  EXPECT_TRUE(recording_of(load(flight(by_heartbeat(0, kActive), 300))).bees[0].landed.empty());
}

// Message 33 says how high it is above where it took off.
TEST(Telemetry, TellsFromWhichHeightADroneTookOff) {
  const auto up = [](int second, std::int32_t above_mm) {
    return logged(
        kNoon + static_cast<std::uint64_t>(second) * 1'000'000,
        frame_v2(1, 33,
                 global_payload(470'000'000, 80'000'000, 500'000 + above_mm, 0, 0, 0,
                                static_cast<std::uint32_t>(10'000 + 1000 * second), above_mm)));
  };
  std::string log;
  for (int second = 0; second <= 10; ++second) log += up(second, 2000 * second);
  const auto recording = recording_of(load(log));
  ASSERT_TRUE(recording.bees[0].took_off_at_m);
  EXPECT_NEAR(*recording.bees[0].took_off_at_m, 500.0, 1e-9);
  // Of one that is always there it is not known: it may be stuck.
  std::string still;
  for (int second = 0; second <= 10; ++second) still += up(second, 0);
  EXPECT_FALSE(recording_of(load(still)).bees[0].took_off_at_m);
}

// It is carried, or driven; or its autopilot is wrong.
TEST(VehicleLandings, WhoMovesAsNoneOnTheGroundFlies) {
  EXPECT_TRUE(recording_of(load(flight(by_state(1, 2), 300))).bees[0].landed.empty());
  EXPECT_EQ(recording_of(load(flight(by_state(1, 2), 100))).bees[0].landed.size(), 2u);
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

// The flag is stuck: 20 m above where it stood it flies, and so it does elsewhere.
TEST(VehicleLandings, WhoIsAwayFromWhereItStoodFliesWhateverItSays) {
  for (const Says& says :
       {by_state(1, 1), Says([](int) { return frame_v2(1, 0, heartbeat(2, 12, 0, 3)); })}) {
    const auto recording = recording_of(load(flight(says)));
    ASSERT_EQ(recording.bees[0].landed.size(), 2u);
    EXPECT_LE(recording.bees[0].landed[0].ends_s, kNoon_s + 10.0);
    EXPECT_GE(recording.bees[0].landed[1].begins_s, kNoon_s + 20.0);
  }
}

TEST(VehicleLandings, ARoverNeverLands) {
  const auto stands = [](int second) {
    return second % 2 == 0 ? frame_v2(1, 0, heartbeat(10, 12, 0, 3))
                           : frame_v2(1, 245, landed_state(1));
  };
  EXPECT_TRUE(recording_of(load(flight(stands))).bees[0].landed.empty());
}

TEST(VehicleLandings, WhoNeverTakesOffStandsAllTheTime) {
  const std::string still = global_payload(470'000'000, 80'000'000, 500'000, 0, 0, 0);
  std::string log;
  for (std::uint64_t second = 0; second < 4; ++second) {
    log += logged(kNoon + second * 1'000'000, frame_v2(1, 245, landed_state(1)));
    log += logged(kNoon + second * 1'000'000, frame_v2(1, 33, still));
  }
  const auto recording = recording_of(load(log));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes.size(), 4u);
  ASSERT_EQ(recording.bees[0].landed.size(), 1u);
  EXPECT_EQ(recording.bees[0].landed[0].ends_s, kNoon_s + 3.0);
}

}  // namespace
}  // namespace beespace::io
