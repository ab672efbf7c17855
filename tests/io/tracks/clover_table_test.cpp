// Paths of drones as clever-show plays them on COEX Clover.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kPath =
    "0,0.00000,0.00000,0.00000,0.0,255,0,0\n"
    "1,0.00000,0.00000,0.50000,0.0,255,0,0\n"
    "2,0.00000,3.00000,1.00000,0.0,255,128,0\n";

RecordingOptions frames_a_second(double frames) {
  RecordingOptions options;
  options.frames_per_second = frames;
  return options;
}

TEST(CloverTable, PathsAreShowsWithAndWithoutTheNameOfTheDrone) {
  for (const std::string& name : {std::string(), std::string("copter_1\n")}) {
    const auto recording = recording_of(record(name + std::string(kPath), frames_a_second(10)));
    EXPECT_EQ(ids_of(recording), std::vector<std::string>{"bees"}) << name;
    ASSERT_EQ(recording.bees.size(), 1u) << name;
    EXPECT_TRUE(recording.show) << name;
    EXPECT_EQ(recording.frame, Frame::kMetres) << name;
    EXPECT_TRUE(has_note(recording, "as clever-show plays it on COEX Clover")) << name;
  }
}

TEST(CloverTable, FramesASecondAreAskedFor) {
  expect_error(record(kPath), {ErrorCode::kInvalidArgument, "bees.csv:1:1",
                               "how many frames are there in a second? Say it, as in --fps 10"});
  expect_error(record("copter_1\n" + std::string(kPath)),
               {ErrorCode::kInvalidArgument, "bees.csv:2:1", "as in --fps 10"});
}

TEST(CloverTable, ABadRecordHasItsLine) {
  const std::string named = "copter_1\n" + std::string(kPath);
  expect_error(record(named + "3,0,x,0,0.0,255,0,0\n", frames_a_second(10)),
               {ErrorCode::kNotANumber, "bees.csv:5:3", "'x' is not a number"});
  std::string many = "copter_1\n";
  for (int frame = 0; frame < 120; ++frame) {
    many += std::to_string(frame) + ",0,0,1,0.0,255,0,0\n";
  }
  expect_error(record(many + "120,0,x,1,0.0,255,0,0\n", frames_a_second(10)),
               {ErrorCode::kNotANumber, "bees.csv:122:3", "'x'"});
}

TEST(CloverTable, OtherTablesOfEightColumnsAreNone) {
  // Frames that are left out, a brightness of 256, and a trajectory as of TUM.
  for (const std::string second : {"2,0,0,1,0.0,255,0,0\n", "1,0,0,1,0.0,256,0,0\n"}) {
    expect_error(record("0,0,0,0,0.0,255,0,0\n" + second, frames_a_second(10)),
                 {ErrorCode::kInvalidArgument, "bees.csv", "--fps"});
  }
  const auto poses = recording_of(record("0,1,2,3,0,0,0,1\n1,1,2,4,0,0,0,1\n"));
  EXPECT_TRUE(has_note(poses, "trajectory as of TUM"));
}

}  // namespace
}  // namespace beespace::io
