// MAVLink logs: positions are of the moment that the vehicle's clock says, not of when they came.
#include "io/live/report_lines.hpp"
#include "tests/io/mavlink/telemetry_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::uint64_t kLaunch_us = 1714564800'000'000;

std::string place_of(int system, double at_s, std::uint32_t boot_ms, std::int32_t millidegrees) {
  const std::int32_t lon = 80'000'000 + 10'000 * millidegrees;
  return logged(kLaunch_us + static_cast<std::uint64_t>(1e6 * at_s),
                frame_v2(system, 33, global_payload(470'000'000, lon, 100'000, 0, 0, 0, boot_ms)));
}

std::vector<double> since_launch(const RecordedBee& bee) {
  std::vector<double> times;
  for (const Fix& fix : bee.fixes) times.push_back(fix.time_s - 1714564800.0);
  return times;
}

TEST(TelemetryClocks, ALatePlaceIsTimedByWhenItWasSent) {
  std::string log;
  for (int k = 0; k < 10; ++k) {
    if (k != 4) log += place_of(1, k, static_cast<std::uint32_t>(60'000 + 1'000 * k), k);
    if (k == 7) log += place_of(1, 7.3, 64'000, 4);
  }
  const auto recording = recording_of(load_recording_from_memory(log, "flight.tlog", {}));
  const std::vector<double> times = since_launch(recording.bees[0]);
  ASSERT_EQ(times.size(), 10u);
  for (std::size_t k = 0; k < times.size(); ++k) {
    EXPECT_NEAR(times[k], static_cast<double>(k), 0.001);
  }
  EXPECT_NEAR(recording.bees[0].fixes[4].position.x, 8.004, 1e-9);
  EXPECT_TRUE(has_note(recording, "times are those of each drone's own clock"));
  EXPECT_TRUE(has_note(recording, "flight.tlog: the latest position came 3.3 s after"));
}

TEST(TelemetryClocks, EachVehicleHasItsOwnAndMayBeStartedAnew) {
  std::string log;
  for (int k = 0; k < 40; ++k) {
    const auto ms = static_cast<std::uint32_t>(1'000 * k);
    log += place_of(1, k, 7'000'000 + ms, k);
    log += place_of(2, k + 0.5, k < 20 ? 30'000 + ms : ms - 19'000, k);
  }
  const auto recording = recording_of(load_recording_from_memory(log, "flight.tlog", {}));
  ASSERT_EQ(recording.bees.size(), 2u);
  for (std::size_t k = 0; k < 40; ++k) {
    EXPECT_EQ(since_launch(recording.bees[0])[k], static_cast<double>(k));
    EXPECT_EQ(since_launch(recording.bees[1])[k], static_cast<double>(k) + 0.5);
  }
  EXPECT_FALSE(has_note(recording, "does not go on"));
}

TEST(TelemetryClocks, AClockThatStandsStillIsSaid) {
  std::string log;
  for (int k = 0; k < 4; ++k) log += place_of(3, k, 5'000, k) + place_of(4, k, 0, k);
  const auto recording = recording_of(load_recording_from_memory(log, "flight.tlog", {}));
  for (const RecordedBee& bee : recording.bees) {
    EXPECT_EQ(since_launch(bee), (std::vector<double>{0, 1, 2, 3}));
  }
  EXPECT_TRUE(has_note(recording, "times are those at which the log was written: 3"));
  // It is not known when it was where it says: no all-clear.
  EXPECT_EQ(recording.missing.untimed, 1u);
  EXPECT_FALSE(recording.missing.none());
  ReportLines lines;
  for (int k = 0; k < 4; ++k) {
    ASSERT_TRUE(lines.take_frame(place_of(3, k, 5'000, k)));
    ASSERT_TRUE(lines.take_frame(place_of(4, k, 0, k)));
  }
  EXPECT_EQ(lines.untimed(), 1u);
}

std::string time_of(int system, double at_s, double unix_s, std::uint32_t boot_ms,
                    int component = 1) {
  const auto unix_us = kLaunch_us + static_cast<std::uint64_t>(1e6 * unix_s);
  return logged(kLaunch_us + static_cast<std::uint64_t>(1e6 * at_s),
                frame_v2(system, 2, system_time(unix_us, boot_ms), component));
}

// Two drones that are heard of each second; all that the second says comes so much later.
std::string flight_with_lag(double lag_s, double second_unix_s, bool second_tells) {
  std::string log;
  for (int k = 0; k < 20; ++k) {
    const auto ms = static_cast<std::uint32_t>(1'000 * k);
    log += place_of(1, k, 60'000 + ms, k) + time_of(1, k, k, 60'000 + ms);
    log += place_of(2, k + lag_s, 90'000 + ms, k);
    // Another part of it has another clock.
    log += time_of(2, k + lag_s, 7, 5'000, 191);
    if (second_tells) log += time_of(2, k + lag_s, k + second_unix_s, 90'000 + ms);
  }
  return log;
}

TEST(TelemetryClocks, ALinkThatIsAlwaysLateIsKnownByTheTimeOfSatellites) {
  const auto recording =
      recording_of(load_recording_from_memory(flight_with_lag(3.0, 0.0, true), "flight.tlog", {}));
  ASSERT_EQ(recording.bees.size(), 2u);
  for (std::size_t k = 0; k < 20; ++k) {
    EXPECT_EQ(since_launch(recording.bees[0])[k], static_cast<double>(k));
    EXPECT_EQ(since_launch(recording.bees[1])[k], static_cast<double>(k));
  }
  EXPECT_TRUE(has_note(recording, "the time of satellites (message 2) tells how much later"));
  EXPECT_TRUE(has_note(recording, "flight.tlog: the latest position came 3.0 s after"));
  EXPECT_TRUE(recording.missing.none());
}

TEST(TelemetryClocks, HowLateADroneIsThatDoesNotTellTheTimeIsNotKnownWhereOthersAreLate) {
  std::string log = flight_with_lag(3.0, 0.0, true);
  for (int k = 0; k < 20; ++k) log += place_of(3, k, static_cast<std::uint32_t>(k + 1) * 1'000, k);
  const auto recording = recording_of(load_recording_from_memory(log, "flight.tlog", {}));
  EXPECT_EQ(recording.missing.untimed, 1u);
  EXPECT_TRUE(has_note(recording, "as others are late: 3"));
  const auto alone =
      recording_of(load_recording_from_memory(flight_with_lag(3.0, 0.0, false), "flight.tlog", {}));
  EXPECT_EQ(since_launch(alone.bees[1])[0], 3.0);
}

// One drone that flies east and tells the time of satellites, or does not, as a computer writes it
// whose clock is ahead.
std::string flight_by_clock(double ahead_s, bool tells) {
  std::string log;
  for (int k = 0; k < 20; ++k) {
    const auto ms = static_cast<std::uint32_t>(60'000 + 1'000 * k);
    log += place_of(1, k + ahead_s, ms, k);
    if (tells) log += time_of(1, k + ahead_s, k, ms);
  }
  return log;
}

TEST(TelemetryClocks, LogsOfTwoComputersAreSetToTheTimeOfSatellites) {
  const TemporaryFolder folder;
  const std::string first = folder.write("a.tlog", flight_by_clock(5.0, true));
  const std::string second = folder.write("b.tlog", flight_by_clock(-90.0, true));
  const auto recording = recording_of(load_recording({first, second}));
  ASSERT_EQ(recording.bees.size(), 2u);
  for (const RecordedBee& bee : recording.bees) {
    EXPECT_EQ(since_launch(bee)[7], 7.0);
  }
  EXPECT_TRUE(has_note(recording, "the clock of " + second +
                                      " is set to the time of satellites (message 2), from which "
                                      "it is 90.0 s away"));
  EXPECT_TRUE(recording.missing.none());
  // Alone it has no other to agree with.
  EXPECT_EQ(since_launch(recording_of(load_recording({first})).bees[0])[7], 12.0);
}

TEST(TelemetryClocks, ALogWithoutTheTimeOfSatellitesBesideOthersIsNoAllClear) {
  const TemporaryFolder folder;
  const std::string first = folder.write("a.tlog", flight_by_clock(0.0, true));
  const std::string second = folder.write("b.tlog", flight_by_clock(0.0, false));
  const auto recording = recording_of(load_recording({first, second}));
  EXPECT_EQ(recording.missing.untimed, 1u);
  EXPECT_TRUE(has_note(recording, "no drone in it tells the time of satellites (message 2): b:1"));
  EXPECT_TRUE(recording_of(load_recording({second})).missing.none());
}

TEST(TelemetryClocks, TimesOfSatellitesThatCannotBeAreNotUsed) {
  const auto hours = recording_of(
      load_recording_from_memory(flight_with_lag(0.0, 3600.0, true), "flight.tlog", {}));
  EXPECT_EQ(since_launch(hours.bees[1])[0], 0.0);
  EXPECT_TRUE(has_note(hours, "more than a minute apart"));
}

TEST(TelemetryClocks, PlacesThatTellTheTimeOfSatellitesThemselvesNeedNoOther) {
  std::string log;
  for (int k = 0; k < 20; ++k) {
    for (const int system : {1, 2}) {
      const std::uint64_t unix_us = kLaunch_us + 1'000'000 * static_cast<std::uint64_t>(k);
      std::string payload = little_endian(static_cast<std::uint32_t>(unix_us), 4) +
                            little_endian(static_cast<std::uint32_t>(unix_us >> 32), 4) +
                            little_endian(470'000'000, 4) + little_endian(80'000'000, 4) +
                            little_endian(100'000, 4) + little_endian(0, 4) + little_endian(0, 4) +
                            '\x03' + '\x09';
      log += logged(unix_us + (system == 2 ? 2'500'000 : 0), frame_v2(system, 24, payload));
    }
  }
  const auto recording = recording_of(load_recording_from_memory(log, "flight.tlog", {}));
  ASSERT_EQ(recording.bees.size(), 2u);
  EXPECT_EQ(since_launch(recording.bees[0]), since_launch(recording.bees[1]));
}

TEST(TelemetryClocks, LiveALatePlaceIsTimedByWhenItWasSentToo) {
  ReportLines lines;
  for (int k = 0; k < 10; ++k) {
    for (const bool late : {false, true}) {
      if (late ? k != 7 : k == 4) continue;
      const auto boot_ms = static_cast<std::uint32_t>(late ? 64'000 : 60'000 + 1'000 * k);
      const auto report = lines.take_frame(place_of(1, late ? 7.3 : k, boot_ms, k));
      ASSERT_TRUE(report && *report);
      EXPECT_NEAR((*report)->time_s - 1714564800.0, late ? 4.0 : k, 0.002);
    }
  }
  const std::vector<std::string> notes = lines.notes();
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.starts_with("times are those of each drone's own clock");
  }));
}

TEST(TelemetryClocks, LiveALinkThatIsAlwaysLateIsKnownByTheTimeOfSatellitesToo) {
  ReportLines lines;
  std::vector<double> second;
  const auto take = [&](const std::string& logged) {
    const auto report = lines.take_frame(logged);
    ASSERT_TRUE(report);
    if (*report && (*report)->id == "2") second.push_back((*report)->time_s - 1714564800.0);
  };
  for (int k = 0; k < 20; ++k) {
    const auto ms = static_cast<std::uint32_t>(1'000 * k);
    take(place_of(1, k + 3.0, 60'000 + ms + 3'000, k));
    take(time_of(1, k + 3.0, k + 3.0, 60'000 + ms + 3'000));
    take(place_of(2, k + 3.0, 90'000 + ms, k));
    take(time_of(2, k + 3.0, 7, 5'000, 191));
    take(time_of(2, k + 3.0, k, 90'000 + ms));
    take(place_of(3, k + 3.0, 10'000 + ms, k));
  }
  ASSERT_EQ(second.size(), 20u);
  EXPECT_EQ(second[0], 3.0);  // nothing is known of it yet
  for (std::size_t k = 1; k < second.size(); ++k) {
    EXPECT_NEAR(second[k], static_cast<double>(k), 0.01);
  }
  // How late the third is that does not tell the time is not known.
  EXPECT_EQ(lines.untimed(), 1u);
  const std::vector<std::string> notes = lines.notes();
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.ends_with("as others are late: 3");
  }));
}

TEST(TelemetryLogs, AnArchiveOfThemIsReadAsAFolder) {
  const std::string one = place_of(1, 0, 1'000, 1) + place_of(1, 1, 2'000, 2);
  const std::string archive = zipped({{"b/flight.tlog", one},
                                      {"a.tlog", one},
                                      {"__MACOSX/._a.tlog", "x"},
                                      {"README.txt", "of today"},
                                      {"params.parm", "x"}});
  const auto recording = recording_of(load_recording_from_memory(archive, "logs.zip", {}));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"a:1", "flight:1"}));
  expect_error(
      load_recording_from_memory(zipped({{"a.bag", "x"}}), "logs.zip", {}),
      {ErrorCode::kUnsupportedFormat, "logs.zip", "nor any .csv, .tlog, .ulg or .bin file"});
}

}  // namespace
}  // namespace beespace::io
