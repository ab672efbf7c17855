// MAVLink telemetry logs, made here byte by byte: framing, checksums, damage, units and axes.
#include "io/live/report_lines.hpp"
#include "io/mavlink/mavlink_frame.hpp"
#include "io/mavlink/telemetry_log.hpp"
#include "tests/io/mavlink/telemetry_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;

Result<Recording> load(std::string_view log, const RecordingOptions& options = {}) {
  return load_recording_from_memory(log, "flight.tlog", options);
}

constexpr std::uint64_t kNoon = 1714564800'000'000;  // microseconds

TEST(Mavlink, TheChecksumIsThatOfTheStandard) {
  EXPECT_EQ(mavlink_checksum("123456789"), 0x6F91);
}

TEST(Telemetry, GlobalPositionsInUnitsAndAxesOfOurs) {
  const auto recording = recording_of(load(
      logged(kNoon + 250'000,
             frame_v2(7, 33, global_payload(472'500'001, -85'000'000, 512'345, 150, -275, 50)))));
  ASSERT_EQ(ids_of(recording), Ids{"7"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(times_of(bee), Times{1714564800.25});
  EXPECT_EQ(bee.fixes[0].position, (Point{-8.5, 47.2500001, 512.345}));
  EXPECT_EQ(bee.velocities[0], (Velocity{-2.75, 1.5, -0.5}));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.heights, HeightDatum::kMeanSeaLevel);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.format_description, "MAVLink telemetry log");
  EXPECT_TRUE(has_note(recording, "GLOBAL_POSITION_INT"));
}

// As MAVProxy writes it to .tlog.raw.
TEST(Telemetry, AStreamWithoutTimesIsRefused) {
  std::string stream;
  std::string log;
  for (int i = 0; i < 4; ++i) {
    for (const std::string& frame : {frame_v2(1, 0, heartbeat(2)), frame_v2(1, 33, somewhere())}) {
      stream += frame;
      log += logged(kNoon, frame);
    }
  }
  for (const std::string& text : {stream, stream.substr(7), "noise" + stream}) {
    const auto loaded = load(text);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().code, ErrorCode::kUnsupportedFormat);
    EXPECT_NE(loaded.error().message.find("a stream of MAVLink without the times of a log"),
              std::string::npos);
  }
  EXPECT_TRUE(load(log));
  EXPECT_TRUE(load(log.substr(7)));
  const TemporaryFolder folder;
  const std::vector<std::string> files = {folder.write("mav.tlog", log),
                                          folder.write("mav.tlog.raw", stream),
                                          folder.write("mav.parm", "A 1\n")};
  const std::string parent = std::filesystem::path(files[0]).parent_path().string();
  EXPECT_EQ(recording_of(load_recording({parent})).missing.files, 0u);
}

TEST(Telemetry, LocalPositionsAreTurnedToEastNorthUp) {
  const auto recording = recording_of(
      load(logged(kNoon, frame_v1(3, 32, local_payload(1.5F, 2.5F, -10.0F, 4.0F, 5.0F, -6.0F)))));
  ASSERT_EQ(ids_of(recording), Ids{"3"});
  EXPECT_EQ(recording.bees[0].fixes[0].position, (Point{2.5, 1.5, 10}));
  EXPECT_EQ(recording.bees[0].velocities[0], (Velocity{5, 4, 6}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_EQ(recording.heights, HeightDatum::kHome);
  EXPECT_TRUE(has_note(recording, "only if all drones have the same one"));
}

TEST(Telemetry, BothVersionsSignedAndCutZerosAreOneLog) {
  const std::string payload = global_payload(470'000'000, 80'000'000, 1000, 0, 0, 0);
  const std::string log = logged(kNoon, frame_v1(1, 33, payload)) +
                          logged(kNoon + 1'000'000, frame_v2(2, 33, payload)) +
                          logged(kNoon + 2'000'000, frame_v2(3, 33, payload, 1, true)) +
                          logged(kNoon + 3'000'000, frame_v2(1, 33, payload));
  EXPECT_LT(frame_v2(2, 33, payload).size(), 12 + payload.size());  // the zeros are gone
  const auto recording = recording_of(load(log));
  EXPECT_EQ(ids_of(recording), (Ids{"1", "2", "3"}));
  for (const RecordedBee& bee : recording.bees) {
    EXPECT_EQ(bee.fixes[0].position, (Point{8, 47, 1}));
    EXPECT_EQ(bee.velocities[0], (Velocity{0, 0, 0}));
  }
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
}

TEST(Telemetry, OtherMessagesArePassedOver) {
  const auto recording = recording_of(load(logged(kNoon, frame_v2(1, 0, "heartbeat")) +
                                           logged(kNoon, frame_v1(1, 30, "attitude")) +
                                           logged(kNoon, frame_v2(1, 33, somewhere())) +
                                           logged(kNoon + 5, frame_v2(1, 12'901, "drone id"))));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_FALSE(has_note(recording, "passed over"));
}

// Who is heard and tells no place is known nowhere, whatever the messages are.
TEST(Telemetry, AVehicleWithoutAPositionIsKnownNowhere) {
  const std::string placed = logged(kNoon, frame_v2(1, 33, somewhere()));
  constexpr int kQuadrotor = 2;
  for (const std::string& frame : {frame_v2(3, 0, heartbeat(kQuadrotor)), frame_v1(3, 30, "x"),
                                   frame_v2(3, 331, "odometry")}) {
    const auto recording = recording_of(load(placed + logged(kNoon, frame) + placed));
    EXPECT_EQ(ids_of(recording), Ids{"1"});
    EXPECT_EQ(recording.missing.nowhere_ids, Ids{"3"});
    EXPECT_EQ(recording.missing.count, 1u);
    EXPECT_TRUE(has_note(recording, "1 record of vehicles that tell no position that is read"));
  }
}

TEST(Telemetry, WhatIsNoVehicleIsNotMissed) {
  constexpr int kGroundStation = 6;
  constexpr int kCamera = 30;
  constexpr int kNoAutopilot = 8;
  const std::string placed = logged(kNoon, frame_v2(1, 33, somewhere()));
  for (const auto& [system, component, message, payload] :
       std::vector<std::tuple<int, int, std::uint32_t, std::string>>{
           {255, 190, 0, heartbeat(kGroundStation, kNoAutopilot)},
           {255, 1, 0, heartbeat(kGroundStation, kNoAutopilot)},
           {254, 190, 21, "parameters, please"},
           {9, 154, 30, "attitude of a gimbal"},
           {9, 1, 0, heartbeat(kCamera)},
           {9, 1, 0, heartbeat(0, kNoAutopilot)},
           {51, 68, 109, "a radio"},
           {10, 1, 109, "a radio"}}) {
    const auto recording = recording_of(
        load(placed + logged(kNoon, frame_v2(system, message, payload, component)) + placed));
    EXPECT_EQ(recording.missing.count, 0u) << system << ", " << component;
  }
  // What it is is said late.
  const auto late =
      recording_of(load(placed + logged(kNoon, frame_v2(255, 21, "x")) +
                        logged(kNoon, frame_v2(255, 0, heartbeat(kGroundStation, kNoAutopilot)))));
  EXPECT_EQ(late.missing.count, 0u);
}

// Whatever it says of its own place; what else is no vehicle may be aboard one.
TEST(Telemetry, AGroundStationIsNoBee) {
  constexpr int kOnBoard = 18;
  constexpr int kNoAutopilot = 8;
  const std::string placed = logged(kNoon, frame_v2(1, 33, somewhere()));
  const std::string station = logged(kNoon, frame_v2(255, 33, somewhere(), 190));
  for (const int type : {5, 6, 31}) {
    const std::string beat = logged(kNoon, frame_v2(255, 0, heartbeat(type, kNoAutopilot), 190));
    for (const std::string& log : {beat + station + placed, station + placed + beat}) {
      const auto recording = recording_of(load(log));
      EXPECT_EQ(ids_of(recording), Ids{"1"});
      EXPECT_EQ(recording.missing.count, 0u);
      EXPECT_TRUE(has_note(recording,
                           "the own position of a ground station or antenna tracker, which its "
                           "HEARTBEAT says that it is, is left out: 255"));
    }
  }
  const auto aboard = recording_of(
      load(placed + station + logged(kNoon, frame_v2(255, 0, heartbeat(kOnBoard, 8), 190))));
  EXPECT_EQ(aboard.bees.size(), 2u);
  // A program aboard says so beside the autopilot.
  const auto beside =
      recording_of(load(placed + logged(kNoon, frame_v2(1, 0, heartbeat(2, 3))) +
                        logged(kNoon, frame_v2(1, 0, heartbeat(6, kNoAutopilot), 190))));
  EXPECT_EQ(ids_of(beside), Ids{"1"});
}

TEST(Telemetry, AGroundStationIsNoBeeAsItComes) {
  const std::string placed = logged(kNoon, frame_v2(255, 33, somewhere(), 190));
  const std::string beat = logged(kNoon, frame_v2(255, 0, heartbeat(6, 8), 190));
  ReportLines early;
  EXPECT_FALSE(early.take_frame(beat).value());
  EXPECT_FALSE(early.take_frame(placed).value());
  // One that was taken for a vehicle leaves once it says what it is.
  ReportLines late;
  ASSERT_TRUE(late.take_frame(placed).value());
  const auto said = late.take_frame(beat).value();
  ASSERT_TRUE(said);
  EXPECT_TRUE(said->leaves);
  EXPECT_EQ(said->id, "255");
  EXPECT_FALSE(late.take_frame(placed).value());
  for (const ReportLines* const lines : {&early, &late}) {
    const std::vector<std::string> notes = lines->notes();
    EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
      return note.ends_with("is left out: 255");
    }));
  }
}

TEST(Telemetry, ADroneThatAnotherHasHeardByItsIdentificationIsKnownNowhere) {
  const std::string placed = logged(kNoon, frame_v2(1, 33, somewhere()));
  const auto identified = [](char first) {
    return std::string(32, '\0') + first + std::string(19, '\0') + std::string(7, '\1');
  };
  const auto own = recording_of(load(placed + logged(kNoon, frame_v2(1, 12901, identified('\0')))));
  EXPECT_EQ(own.missing.count, 0u);
  const auto heard =
      recording_of(load(placed + logged(kNoon, frame_v2(1, 12901, identified('A')))));
  EXPECT_EQ(heard.missing.nowhere_ids, Ids{"remote id 41"});
}

TEST(Telemetry, DamageIsSkippedAndReported) {
  std::string damaged = logged(kNoon + 1'000'000, frame_v2(1, 33, somewhere()));
  damaged[30] = static_cast<char>(damaged[30] ^ 1);
  const auto recording =
      recording_of(load("garbage" + logged(kNoon, frame_v2(1, 33, somewhere())) + damaged +
                        "\xFD\xFE more" + logged(kNoon + 2'000'000, frame_v2(1, 33, somewhere()))));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{1714564800, 1714564802}));
  EXPECT_TRUE(has_note(
      recording, "flight.tlog: " + std::to_string(7 + damaged.size() + 7) + " bytes in 2 places"));
}

TEST(Telemetry, ALastFrameThatIsCutShortIsNoMistake) {
  const std::string whole = logged(kNoon, frame_v2(1, 33, somewhere()));
  const std::string next = logged(kNoon + 1'000'000, frame_v2(1, 33, somewhere()));
  for (std::size_t length = 1; length < next.size(); ++length) {
    const auto recording = recording_of(load(whole + next.substr(0, length)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 1u) << length;
    EXPECT_TRUE(has_note(recording, "the last frame is cut short")) << length;
  }
}

TEST(Telemetry, AWrongChecksumIsNoPosition) {
  std::string log = logged(kNoon, frame_v2(1, 33, somewhere()));
  log.back() = static_cast<char>(log.back() ^ 1);
  const auto recording = recording_of(load(log + logged(kNoon + 1, frame_v1(2, 33, somewhere()))));
  EXPECT_EQ(ids_of(recording), Ids{"2"});
}

TEST(Telemetry, FlagsThatAreNotKnownMakeAFrameUnreadable) {
  std::string frame = frame_v2(1, 33, somewhere());
  frame[2] = 2;
  const auto recording =
      recording_of(load(logged(kNoon, frame) + logged(kNoon, frame_v1(2, 33, somewhere()))));
  EXPECT_EQ(ids_of(recording), Ids{"2"});
}

TEST(Telemetry, GlobalPositionsAreTakenBeforeLocalOnes) {
  const std::string local = local_payload(1, 2, 3, 0, 0, 0);
  const std::string log = logged(kNoon, frame_v2(1, 32, local)) +
                          logged(kNoon, frame_v2(1, 33, somewhere())) +
                          logged(kNoon, frame_v2(2, 32, local));
  const auto recording = recording_of(load(log));
  EXPECT_EQ(ids_of(recording), Ids{"1"});
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_TRUE(has_note(recording, "1 record of drones that tell local positions only"));
  EXPECT_EQ(recording.missing.nowhere_ids, Ids{"2"});
  RecordingOptions metres;
  metres.frame = Frame::kMetres;
  EXPECT_EQ(ids_of(recording_of(load(log, metres))), (Ids{"1", "2"}));
}

TEST(Telemetry, AVehicleWithoutAPositionYetIsLeftOut) {
  const auto recording =
      recording_of(load(logged(kNoon, frame_v2(1, 33, global_payload(0, 0, 0, 0, 0, 0))) +
                        logged(kNoon + 1, frame_v2(1, 33, somewhere()))));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_TRUE(has_note(recording, "1 record of drones that know no position yet"));
  EXPECT_EQ(recording.missing.count, 1u);
  EXPECT_EQ(recording.missing.nowhere, 0u);
}

TEST(Telemetry, LocalPositionsOfSeveralDronesHaveAnOriginEach) {
  const std::string local = local_payload(1, 2, 3, 0, 0, 0);
  const std::string log =
      logged(kNoon, frame_v2(1, 32, local)) + logged(kNoon, frame_v2(2, 32, local));
  expect_error(load(log), {ErrorCode::kUnknownFrame, "flight.tlog",
                           "say --crs metres if all drones have the same origin"});
  RecordingOptions metres;
  metres.frame = Frame::kMetres;
  EXPECT_EQ(recording_of(load(log, metres)).bees.size(), 2u);
}

TEST(Telemetry, WithoutLocalPositionsADroneIsKnownNowhereInMetres) {
  RecordingOptions metres;
  metres.frame = Frame::kMetres;
  const auto recording =
      recording_of(load(logged(kNoon, frame_v2(1, 32, local_payload(1, 2, 3, 0, 0, 0))) +
                            logged(kNoon, frame_v2(2, 33, somewhere())),
                        metres));
  EXPECT_EQ(ids_of(recording), Ids{"1"});
  EXPECT_EQ(recording.missing.nowhere_ids, Ids{"2"});
  EXPECT_TRUE(has_note(recording, "1 record of drones that tell no local positions"));
}

TEST(Telemetry, OneComponentSpeaksForASystem) {
  const auto recording =
      recording_of(load(logged(kNoon, frame_v2(1, 33, somewhere(), 1)) +
                        logged(kNoon + 1, frame_v2(1, 33, somewhere(), 191)) +
                        logged(kNoon + 2'000'000, frame_v2(1, 33, somewhere(), 1))));
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
  EXPECT_TRUE(has_note(recording, "1 record of another component"));
}

TEST(Telemetry, SeveralLogsTellTheirSystemsApart) {
  const TemporaryFolder folder;
  EXPECT_FALSE(folder.write("b.tlog", logged(kNoon, frame_v2(1, 33, somewhere()))).empty());
  EXPECT_FALSE(folder.write("a.tlog", logged(kNoon, frame_v2(1, 33, somewhere()))).empty());
  EXPECT_EQ(ids_of(recording_of(load_recording({folder.file("")}))), (Ids{"a:1", "b:1"}));
  RecordingOptions options;
  options.time_unit = Unit::kMillisecond;
  expect_error(load_recording({folder.file("")}, options),
               {ErrorCode::kInvalidArgument, folder.file("a.tlog"),
                "the times of MAVLink telemetry have their unit; leave --time-unit out"});
  const TemporaryFolder other;
  const std::string same = other.write("a.tlog", logged(kNoon, frame_v2(1, 33, somewhere())));
  const auto name = [](const TemporaryFolder& of) {
    return std::filesystem::path(of.file("a.tlog")).parent_path().filename().string();
  };
  EXPECT_EQ(ids_of(recording_of(load_recording({folder.file("a.tlog"), same}))),
            (Ids{name(folder) + ":1", name(other) + ":1"}));
}

TEST(Telemetry, WhatIsWrongIsBlamedOnTheFrame) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::string first = logged(kNoon, frame_v2(1, 0, "x"));
  for (const auto& [frame, code, message] :
       std::vector<std::tuple<std::string, ErrorCode, std::string>>{
           {frame_v2(2, 32, local_payload(nan, 0, 0, 0, 0, 0)), ErrorCode::kNotFinite,
            "system 2: its position is not a number"},
           {frame_v2(2, 32, local_payload(1e38F, 0, 0, 0, 0, 0)), ErrorCode::kOutsideDomain,
            "cannot be computed with"},
           {frame_v2(2, 33, global_payload(910'000'000, 0, 0, 0, 0, 0)),
            ErrorCode::kInvalidLatitude, "latitude 91 is beyond 90 degrees"},
           {frame_v2(2, 33, global_payload(1, 1, 2'000'000'000, 0, 0, 0)),
            ErrorCode::kInvalidHeight, "is no height of a bee"}}) {
    const auto loaded = load(first + logged(kNoon, frame));
    expect_error(loaded, {code, "flight.tlog", message});
    if (!loaded) {
      EXPECT_EQ(loaded.error().location.record, 1u);
    }
  }
}

TEST(Telemetry, VelocitiesThatAreNoNumbersAreUnknown) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto recording =
      recording_of(load(logged(kNoon, frame_v2(1, 32, local_payload(1, 2, 3, nan, 0, 1e-40F)))));
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities[0].y));
  EXPECT_EQ(recording.bees[0].velocities[0].z, 0.0);
}

TEST(Telemetry, ALogWithoutPositionsIsAnError) {
  const std::string log = logged(kNoon, frame_v2(1, 0, "x"));
  expect_error(load(log), {ErrorCode::kNoPoints, "flight.tlog", "tells no position"});
  RecordingOptions metres;
  metres.frame = Frame::kMetres;
  expect_error(load(logged(kNoon, frame_v2(1, 33, somewhere())), metres),
               {ErrorCode::kNoPoints, "flight.tlog", "LOCAL_POSITION_NED (32); leave --crs out"});
  expect_error(load(log, columns_are("id=1", Unit::kUnstated)),
               {ErrorCode::kInvalidArgument, "flight.tlog", "--columns"});
}

TEST(Telemetry, OtherBytesAreNoLog) {
  EXPECT_FALSE(is_telemetry_log("id,time_s,x,y,z\n0,0,1,2,3\n"));
  EXPECT_FALSE(is_telemetry_log(""));
  EXPECT_FALSE(is_telemetry_log(std::string(100, '\0')));
}

}  // namespace
}  // namespace beespace::io
