// Places that vehicles tell after they have lost them are not known.
#include "io/mavlink/lost_places.hpp"

#include "tests/io/mavlink/telemetry_making.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <string>

namespace beespace::io {
namespace {

constexpr std::uint64_t kStart_us = 1714564800'000'000;

// Message 24.
std::string receiver_says(int fix) {
  return std::string(28, '\0') + static_cast<char>(fix) + '\x0C';
}

// Message 230.
std::string estimator_says(float off_m, unsigned flags) {
  return std::string(32, '\0') + little_endian(std::bit_cast<std::uint32_t>(off_m), 4) +
         little_endian(std::bit_cast<std::uint32_t>(1.0F), 4) + little_endian(flags, 2);
}

// A place each second for 20 s, and before it what is said: one thing until 9 s, and another.
Recording told(const std::string& before, const std::string& later, std::uint32_t message) {
  std::string log;
  for (int second = 0; second < 20; ++second) {
    const auto at = kStart_us + static_cast<std::uint64_t>(second) * 1'000'000;
    log += logged(at, frame_v2(1, message, second < 10 ? before : later));
    const auto boot_ms = static_cast<std::uint32_t>(10'000 + second * 1000);
    log += logged(at, frame_v2(1, 33,
                               global_payload(470'000'000, 80'000'000 + 100 * second, 520'000, 0,
                                              100, 0, boot_ms)));
  }
  return recording_of(load_recording_from_memory(log, "flight.tlog", {}));
}

TEST(LostPlaces, WithoutAFixAnyMoreAPlaceIsNotKnown) {
  const Recording recording = told(receiver_says(3), receiver_says(0), 24);
  EXPECT_EQ(recording.bees[0].fixes.size(), 10u);
  EXPECT_EQ(recording.missing.count, 10u);
  EXPECT_TRUE(has_note(recording, "has lost its place"));
}

TEST(LostPlaces, WhoNeverHadAFixKnowsItsPlaceOtherwise) {
  const Recording recording = told(receiver_says(0), receiver_says(0), 24);
  EXPECT_EQ(recording.bees[0].fixes.size(), 20u);
  EXPECT_TRUE(recording.missing.none());
}

TEST(LostPlaces, AnEstimatorThatIsFarOffDoesNotKnow) {
  EXPECT_EQ(told(estimator_says(0.5F, 16), estimator_says(300.0F, 16), 230).bees[0].fixes.size(),
            10u);
  EXPECT_EQ(told(estimator_says(0.5F, 16), estimator_says(0.5F, 128), 230).bees[0].fixes.size(),
            10u);
  EXPECT_EQ(told(estimator_says(0.5F, 16), estimator_says(1.5F, 16), 230).bees[0].fixes.size(),
            20u);
}

}  // namespace
}  // namespace beespace::io
