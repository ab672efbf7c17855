// DataFlash logs of ArduPilot: where and when a vehicle was.
#include "tests/io/ardupilot/dataflash_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

Result<Recording> load_dataflash(const DataflashMaking& log, const RecordingOptions& options = {}) {
  return load_recording_from_memory(log.bytes(), "flights/00000012.BIN", options);
}

TEST(Dataflash, TellsPlacesAboveMeanSeaLevelAtTimesOfGps) {
  const auto recording = recording_of(load_dataflash(small_dataflash_log()));
  ASSERT_EQ(recording.bees.size(), 1u);
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(bee.id, "00000012");
  EXPECT_EQ(times_of(bee), (std::vector<double>{kStarted_s, kStarted_s + 0.5}));
  EXPECT_EQ(bee.fixes[0].position.x, 8.5);
  EXPECT_EQ(bee.fixes[0].position.y, 47.25);
  EXPECT_EQ(bee.fixes[0].position.z, 512.0);
  EXPECT_EQ(bee.fixes[1].position.y, 47.2500001);
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_TRUE(recording.missing.none());
  EXPECT_TRUE(has_note(recording, "is set by 1 time of GPS"));
}

TEST(Dataflash, TimesOfGpsLackTheLeapSecondsOfTheirYear) {
  struct Known {
    unsigned week;
    std::uint32_t week_ms;
    double utc_s;
  };
  // The last second before a leap second came, and the first one behind it.
  const Known known[] = {
      {1930, 16'000, 1'483'228'799.0},       // 2016-12-31T23:59:59Z, GPS 17 s ahead
      {1930, 18'000, 1'483'228'800.0},       // 2017-01-01T00:00:00Z, 18 s
      {1851, 259'215'000, 1'435'708'799.0},  // 2015-06-30T23:59:59Z, 16 s
      {1851, 259'217'000, 1'435'708'800.0},  // 2015-07-01T00:00:00Z, 17 s
  };
  for (const Known& one : known) {
    DataflashMaking log = ardupilot_log();
    log.gps(5'000'000, one.week, one.week_ms).pos(5'000'000);
    EXPECT_EQ(times_of(recording_of(load_dataflash(log)).bees[0]), std::vector<double>{one.utc_s})
        << one.week_ms;
  }
}

TEST(Dataflash, WithoutATimeOfGpsTimesCountFromTheStart) {
  DataflashMaking log = ardupilot_log();
  log.gps(4'000'000, 0, 0, 1).pos(5'000'000).pos(6'000'000);
  const auto recording = recording_of(load_dataflash(log));
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{5, 6}));
  EXPECT_TRUE(has_note(recording, "seconds since the drone was switched on"));
}

// Old ones have degrees and heights as whole numbers, of other lengths.
TEST(Dataflash, FieldsAreReadAsTheirLettersSay) {
  DataflashMaking log;
  DataflashBody body;
  body.u64(9'000'000).i32(-1'234).i32(-85.5e7).i32(-33.25e7).u16(0xFFFF).u32(0).i32(0);
  log.define(7, 3 + 8 + 4 + 4 + 4 + 2 + 4 + 4, "POS", "QeLLcIi",
             "TimeUS,Alt,Lng,Lat,RelHomeAlt,None,More");
  const auto recording = recording_of(load_dataflash(log.data(7, body)));
  const Point& at = recording.bees[0].fixes[0].position;
  EXPECT_EQ(at.x, -85.5);
  EXPECT_EQ(at.y, -33.25);
  EXPECT_EQ(at.z, -12.34);
}

TEST(Dataflash, OptionsThatItHasNoUseForAreRefused) {
  RecordingOptions options;
  options.heights = HeightSource::kGeometric;
  expect_error(load_dataflash(small_dataflash_log(), options),
               {ErrorCode::kInvalidArgument, "flights/00000012.BIN", "leave --heights out"});
  options = {};
  options.frame = Frame::kMetres;
  expect_error(load_dataflash(small_dataflash_log(), options),
               {ErrorCode::kInvalidArgument, "flights/00000012.BIN", "leave --crs out"});
  options = {};
  options.time_unit = Unit::kSecond;
  expect_error(load_dataflash(small_dataflash_log(), options),
               {ErrorCode::kInvalidArgument, "flights/00000012.BIN",
                "the times of a DataFlash log have their unit; leave --time-unit out"});
}

TEST(Dataflash, WithoutAPlaceNothingIsTold) {
  expect_error(load_dataflash(ardupilot_log()),
               {ErrorCode::kNoPoints, "flights/00000012.BIN", "it has 0 messages of POS or GPS"});
  DataflashMaking log = ardupilot_log();
  expect_error(load_dataflash(log.pos(5'000'000, 0.0, 0.0)),
               {ErrorCode::kNoPoints, "flights/00000012.BIN",
                "1 message of POS or GPS, none of which can be taken"});
}

// Its receiver, and its estimator: the flags of a place on the Earth, held, off as its GPS is, dead
// reckoning.
TEST(Dataflash, PlacesThatAVehicleHasLostAreNotKnown) {
  constexpr unsigned kWell = 0x33F;
  const auto fixes = [](const DataflashMaking& log) {
    return recording_of(load_dataflash(log)).bees.at(0).fixes.size();
  };
  const auto made = [](unsigned flags, unsigned core, unsigned primary) {
    DataflashMaking log = small_dataflash_log();
    log.status(5'600'000, kWell, 0, primary).status(5'600'000, flags, core, primary);
    return log.pos(6'000'000);
  };
  EXPECT_EQ(fixes(made(kWell, 0, 0)), 3u);
  for (const unsigned flags : {kWell & ~16u, kWell | 128u, kWell | 1u << 14u, kWell | 1u << 18u}) {
    EXPECT_EQ(fixes(made(flags, 0, 0)), 2u) << flags;
    EXPECT_EQ(fixes(made(flags, 1, 0)), 3u) << "the vehicle heeds the other core";
    EXPECT_EQ(fixes(made(flags, 1, 1)), 2u);
    DataflashMaking long_ago = made(flags, 0, 0);
    EXPECT_EQ(fixes(long_ago.pos(10'700'000)), 3u) << "it has not said so for 5 s";
  }
  DataflashMaking lost = small_dataflash_log();
  lost.gps(5'700'000, kWeek, kWeekMs + 700, 1).pos(6'000'000);
  EXPECT_EQ(fixes(lost), 2u);
  const auto recording = recording_of(load_dataflash(lost));
  EXPECT_FALSE(recording.missing.none());
  DataflashMaking second = small_dataflash_log();
  second.gps(5'600'000, kWeek, kWeekMs + 600, 3, 1).gps(5'700'000, kWeek, kWeekMs + 700, 1);
  EXPECT_EQ(fixes(second.pos(6'000'000)), 3u) << "its second receiver has a fix";
}

// Of the first core where nothing says which one the vehicle heeds.
TEST(Dataflash, VelocitiesNeedNoStatusBesideThem) {
  DataflashMaking log = small_dataflash_log();
  const auto recording =
      recording_of(load_dataflash(log.pos(6'000'000).velocity(6'001'000, 5, 6, 7)));
  EXPECT_EQ(recording.bees.at(0).velocities.at(2).x, 6.0);
}

// With a place of its receiver alone: east at 2 m/s, climbing by 1 m/s.
TEST(Dataflash, WithoutPosPlacesAreThoseOfGps) {
  DataflashMaking log = ardupilot_log();
  log.gps(4'000'000, 0, 0, 1).gps(5'000'000, kWeek, kWeekMs, 3, 0, {2, 90, -1});
  log.gps(5'000'000, kWeek, kWeekMs, 3, 1);
  const auto recording = recording_of(load_dataflash(log));
  const RecordedBee& bee = recording.bees.at(0);
  ASSERT_EQ(times_of(bee), std::vector<double>{kStarted_s});
  EXPECT_EQ(bee.fixes[0].position.z, 512.0);
  EXPECT_EQ(bee.velocities.at(0).x, 2.0);
  EXPECT_NEAR(bee.velocities[0].y, 0.0, 1e-15);
  EXPECT_EQ(bee.velocities[0].z, 1.0);
  EXPECT_TRUE(has_note(recording, "are those of GPS, as there is no POS"));
}

// Of the same turn of its loop, and of the core that the vehicle heeds.
TEST(Dataflash, VelocitiesAreThoseOfItsEstimator) {
  DataflashMaking log = ardupilot_log();
  log.gps(5'000'000, kWeek, kWeekMs).status(4'900'000, 0x33F, 0, 1).status(4'900'000, 0x33F, 1, 1);
  log.velocity(4'979'000, 1, 1, 1, 1).velocity(4'999'000, 8, 8, 8, 0);
  log.velocity(4'998'000, 3, 4, -0.5, 1).pos(5'000'000).velocity(5'003'000, 2, 2, 2, 1);
  log.velocity(5'479'000, 1, 1, 1, 1).pos(5'500'000).velocity(5'521'000, 1, 1, 1, 1);
  log.pos(6'000'000).velocity(6'001'000, 5, 6, 7, 1);
  const auto recording = recording_of(load_dataflash(log));
  const auto& velocities = recording.bees.at(0).velocities;
  ASSERT_EQ(velocities.size(), 3u);
  EXPECT_EQ(velocities[0].x, 4.0);
  EXPECT_EQ(velocities[0].y, 3.0);
  EXPECT_EQ(velocities[0].z, 0.5);
  EXPECT_TRUE(std::isnan(velocities[1].x)) << "21 ms apart";
  EXPECT_EQ(velocities[2].x, 6.0);
}

TEST(Dataflash, PlacesThatCannotBeAreErrors) {
  DataflashMaking log = small_dataflash_log();
  log.pos(6'000'000, 98.0);
  expect_error(load_dataflash(log),
               {ErrorCode::kInvalidLatitude, "flights/00000012.BIN", "point 2: latitude 98"});
  EXPECT_EQ(recording_of(load_dataflash(log, skipping_bad())).bees[0].fixes.size(), 2u);
}

}  // namespace
}  // namespace beespace::io
