// PX4 logs whose drone has lost its place: dead reckoning, or an error of hundreds of metres.
#include "tests/io/px4/ulog_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace beespace::io {
namespace {

constexpr unsigned kNewerNumber = 30;

// A place each second for 20 s; from 10 s on as said.
Recording told(double eph_m, double epv_m, bool dead_reckoning) {
  UlogMaking log;
  log.flags(0).format(
      "vehicle_global_position:uint64_t timestamp;double lat;double lon;float alt;float eph;"
      "float epv;bool dead_reckoning;");
  log.subscribe(kNewerNumber, "vehicle_global_position");
  for (std::uint64_t second = 1; second <= 20; ++second) {
    const bool later = second > 10;
    log.data(kNewerNumber, UlogBody()
                               .u64(second * 1'000'000)
                               .f64(47.25 + 1e-5 * static_cast<double>(second))
                               .f64(8.5)
                               .f32(512.0)
                               .f32(later ? eph_m : 0.5)
                               .f32(later ? epv_m : 0.75)
                               .u8(later && dead_reckoning ? 1 : 0));
  }
  return recording_of(load_recording_from_memory(log.bytes(), "north.ulg", {}));
}

TEST(UlogGuessed, APlaceByDeadReckoningIsNotKnown) {
  const Recording recording = told(0.5, 0.75, true);
  EXPECT_EQ(recording.bees[0].fixes.size(), 10u);
  EXPECT_EQ(recording.missing.count, 10u);
  EXPECT_TRUE(has_note(recording, "has lost its place"));
}

TEST(UlogGuessed, APlaceThatMayBeHundredsOfMetresOffIsNotKnown) {
  EXPECT_EQ(told(300.0, 0.75, false).bees[0].fixes.size(), 10u);
  EXPECT_EQ(told(0.5, 300.0, false).bees[0].fixes.size(), 10u);
  EXPECT_TRUE(told(3.0, 4.0, false).missing.none());
}

// A place each second, with the receiver's fix; from 10 s on for 5 s as said.
Recording with_fix(unsigned fix_type, unsigned before) {
  constexpr unsigned kReceiver = 31;
  UlogMaking log;
  log.flags(0).format(
      "vehicle_global_position:uint64_t timestamp;double lat;double lon;float alt;");
  log.format("vehicle_gps_position:uint64_t timestamp;uint64_t time_utc_usec;uint8_t fix_type;");
  log.subscribe(kNewerNumber, "vehicle_global_position")
      .subscribe(kReceiver, "vehicle_gps_position");
  for (std::uint64_t second = 1; second <= 20; ++second) {
    const bool lost = second > 10 && second <= 15;
    log.data(kReceiver, UlogBody()
                            .u64(second * 1'000'000 - 1000)
                            .u64(1'700'000'000'000'000 + second * 1'000'000)
                            .u8(lost ? fix_type : before));
    log.data(kNewerNumber, UlogBody()
                               .u64(second * 1'000'000)
                               .f64(47.25 + 1e-5 * static_cast<double>(second))
                               .f64(8.5)
                               .f32(512.0));
  }
  return recording_of(load_recording_from_memory(log.bytes(), "north.ulg", {}));
}

TEST(UlogGuessed, APlaceOnTheEarthWithoutAFixAnyMoreIsNotKnown) {
  const Recording lost = with_fix(0, 3);
  EXPECT_EQ(lost.bees[0].fixes.size(), 15u);
  EXPECT_EQ(lost.missing.count, 5u);
  EXPECT_TRUE(has_note(lost, "no fix of satellites any more"));
  EXPECT_TRUE(with_fix(3, 6).missing.none());
  // It never had one, and knows its place otherwise.
  EXPECT_TRUE(with_fix(0, 1).missing.none());
}

}  // namespace
}  // namespace beespace::io
