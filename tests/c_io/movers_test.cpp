// Where agents of a file are at its last time, and how fast they fly: what beespace_predict()
// takes.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

struct Movers {
  std::vector<double> xyz;
  std::vector<double> velocities;
  std::vector<std::uint8_t> known;
  double time_s = -1.0;
  beespace_code code = BEESPACE_OK;
  beespace_io_error error = io_error();
};

Movers movers_of(const Recording& recording, double max_age_s = 30.0) {
  const auto agents = static_cast<std::size_t>(beespace_io_recording_agents(recording.get()));
  Movers movers;
  movers.xyz.resize(3 * agents);
  movers.velocities.resize(3 * agents);
  movers.known.resize(agents);
  movers.code = beespace_io_recording_movers(recording.get(), max_age_s, movers.xyz.data(),
                                             movers.velocities.data(), movers.known.data(),
                                             &movers.time_s, &movers.error);
  return movers;
}

class CMovers : public testing::Test {
 protected:
  ReadRecording read(const std::string& rows) {
    auto recording = read_recording({folder_.file("flight.csv", rows)});
    EXPECT_EQ(recording.code, BEESPACE_OK) << text_of(recording.error);
    return recording;
  }
  static void expect_row(const std::vector<double>& numbers, std::size_t row,
                         const std::vector<double>& expected) {
    EXPECT_EQ(std::vector<double>(numbers.begin() + static_cast<std::ptrdiff_t>(3 * row),
                                  numbers.begin() + static_cast<std::ptrdiff_t>(3 * row + 3)),
              expected);
  }
  static void expect_unknown(const std::vector<double>& numbers, std::size_t row) {
    for (std::size_t i = 3 * row; i < 3 * row + 3; ++i) EXPECT_TRUE(std::isnan(numbers[i])) << i;
  }

  TestFolder folder_;
};

constexpr const char* kMixed =
    "id,time_s,x,y,z,vx,vy,vz\n"
    "stated,0,0,0,0,9,9,9\nstated,100,10,0,0,1,2,3\n"
    "earlier,96,0,0,0,2,0,-1\n"                          // 4 s before
    "estimated,90,0,0,0,5,5,5\nestimated,98,8,0,4,,,\n"  // 2 s before, by two fixes
    "stale,60,7,8,9,1,1,1\n"
    "once,100,1,2,3,,,\n"
    "apart,50,0,0,0,1,1,1\napart,99,4,5,6,,,\n";

TEST_F(CMovers, AreWhereTheyAreAtTheLastTime) {
  const auto recording = read(kMixed);
  const Movers movers = movers_of(recording.recording);
  ASSERT_EQ(movers.code, BEESPACE_OK) << text_of(movers.error);
  EXPECT_EQ(movers.time_s, 100.0);
  EXPECT_EQ(movers.known,
            (std::vector<std::uint8_t>{
                BEESPACE_IO_STATED, BEESPACE_IO_STATED, BEESPACE_IO_ESTIMATED, BEESPACE_IO_STALE,
                BEESPACE_IO_WITHOUT_VELOCITY, BEESPACE_IO_WITHOUT_VELOCITY}));
  expect_row(movers.xyz, 0, {10, 0, 0});
  expect_row(movers.velocities, 0, {1, 2, 3});
  expect_row(movers.xyz, 1, {8, 0, -4});
  expect_row(movers.velocities, 1, {2, 0, -1});
  expect_row(movers.xyz, 2, {10, 0, 5});
  expect_row(movers.velocities, 2, {1, 0, 0.5});
  // Where they were last heard of, and it is not known where they go.
  expect_row(movers.xyz, 3, {7, 8, 9});
  expect_row(movers.xyz, 4, {1, 2, 3});
  expect_row(movers.xyz, 5, {4, 5, 6});
  for (const std::size_t row : {3U, 4U, 5U}) expect_unknown(movers.velocities, row);
}

TEST_F(CMovers, AreAskedHowOldIsTooOld) {
  const auto recording = read(kMixed);
  const Movers all = movers_of(recording.recording, std::numeric_limits<double>::infinity());
  ASSERT_EQ(all.code, BEESPACE_OK) << text_of(all.error);
  EXPECT_EQ(all.known[3], BEESPACE_IO_STATED);
  expect_row(all.xyz, 3, {47, 48, 49});
  EXPECT_EQ(all.known[5], BEESPACE_IO_ESTIMATED);
  const Movers now = movers_of(recording.recording, 0.0);
  EXPECT_EQ(now.known, (std::vector<std::uint8_t>{
                           BEESPACE_IO_STATED, BEESPACE_IO_STALE, BEESPACE_IO_STALE,
                           BEESPACE_IO_STALE, BEESPACE_IO_WITHOUT_VELOCITY, BEESPACE_IO_STALE}));
}

TEST_F(CMovers, OfWhichNothingIsKnownAreNeitherGuessedNorPassedOver) {
  const auto recording = read(kMixed);
  const Movers movers = movers_of(recording.recording);
  const auto count = static_cast<std::int64_t>(movers.known.size());
  const beespace_points places = beespace_points_interleaved(movers.xyz.data(), count);
  const beespace_points speeds = beespace_points_interleaved(movers.velocities.data(), count);
  beespace_search search{};
  search.struct_size = sizeof search;
  search.threshold_m = 5;
  beespace_error error{};
  error.struct_size = sizeof error;
  beespace_result* const result = beespace_result_create();
  EXPECT_EQ(beespace_predict(nullptr, &places, &speeds, &search, 60, nullptr, result, &error),
            BEESPACE_NOT_FINITE);
  EXPECT_EQ(error.record, 3);
  beespace_result_free(result);
}

TEST_F(CMovers, OfDegreesFlyAlongTheAxesOfEcef) {
  const auto recording =
      read("id,time_s,lon,lat,height_m,ve,vn,vu\na,0,90,0,0,8,0,3\nb,2,180,0,100,0,5,0\n");
  const Movers movers = movers_of(recording.recording);
  ASSERT_EQ(movers.code, BEESPACE_OK) << text_of(movers.error);
  constexpr double kA = 6378137.0;
  const std::vector<double> places = {-16, kA + 6, 0, -kA - 100, 0, 0};
  const std::vector<double> speeds = {-8, 3, 0, 0, 0, 5};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_NEAR(movers.xyz[i], places[i], 1e-8) << i;
    EXPECT_NEAR(movers.velocities[i], speeds[i], 1e-9) << i;
  }
}

TEST_F(CMovers, WithoutAnyVelocityAreAnErrorThatSaysSo) {
  const auto recording = read("id,time_s,x,y,z\na,0,0,0,0\nb,0,1,0,0\n");
  const Movers movers = movers_of(recording.recording);
  EXPECT_EQ(movers.code, BEESPACE_MISSING_COLUMN);
  EXPECT_NE(std::strstr(movers.error.message, "no velocity"), nullptr) << movers.error.message;
  const auto apart = read("id,time_s,x,y,z\na,0,0,0,0\na,99,1,0,0\n");
  const Movers none = movers_of(apart.recording);
  EXPECT_EQ(none.code, BEESPACE_MISSING_COLUMN);
  EXPECT_NE(std::strstr(none.error.message, "raise max_age"), nullptr) << none.error.message;
}

TEST_F(CMovers, AreNoneOfAShow) {
  const auto show = read_recording({BEESPACE_EXAMPLES "/show.skyc"});
  ASSERT_EQ(show.code, BEESPACE_OK) << text_of(show.error);
  EXPECT_EQ(beespace_io_recording_velocities(show.recording.get()), nullptr);
  const Movers movers = movers_of(show.recording);
  EXPECT_EQ(movers.code, BEESPACE_UNSUPPORTED_FORMAT);
  EXPECT_NE(std::strstr(movers.error.message, "curve of a show"), nullptr);
}

TEST_F(CMovers, ArgumentsThatMakeNoSenseAreRefused) {
  const auto recording = read(kMixed);
  std::vector<double> numbers(18);
  auto error = io_error();
  const auto* const r = recording.recording.get();
  double* const into = numbers.data();
  for (const double age : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(beespace_io_recording_movers(r, age, into, into, nullptr, nullptr, &error),
              BEESPACE_INVALID_ARGUMENT);
    EXPECT_STREQ(error.place, "max_age_s");
  }
  EXPECT_EQ(beespace_io_recording_movers(nullptr, 1, into, into, nullptr, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_recording_movers(r, 1, nullptr, into, nullptr, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_recording_movers(r, 1, into, nullptr, nullptr, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  std::vector<double> speeds(18);
  EXPECT_EQ(beespace_io_recording_movers(r, 1, into, speeds.data(), nullptr, nullptr, nullptr),
            BEESPACE_OK);
}

}  // namespace
}  // namespace beespace::test
