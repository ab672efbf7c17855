// Tables, of ROS or not, that say in a column in which frame of reference each position is.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>

namespace beespace::io {
namespace {

// Two robots, turn by turn, each in that frame.
std::string in_frames(const std::string& names, const std::string& first,
                      const std::string& second) {
  std::string text = names + "\n";
  for (int k = 0; k < 12; ++k) {
    const std::string at = "179500000" + std::to_string(k / 2) + ".0,";
    text += at + (k % 2 == 0 ? first : second) + (k % 2 == 0 ? ",a" : ",b") +
            (k % 2 == 0 ? ",0,0,0\n" : ",50,0,0\n");
  }
  return text;
}

TEST(FramesOfReference, ThatDifferAreNotCompared) {
  for (const std::string name : {"frame_id", "header.frame_id", "header_frame_id", "parent_frame",
                                 "parent_frame_id", "frame"}) {
    const std::string header = "time_s," + name + ",child_frame_id,x,y,z";
    RecordingOptions options = columns_are("id=3", Unit::kUnstated);
    const auto loaded = record(in_frames(header, "uav0/odom", "uav1/odom"), options);
    expect_error(loaded, {ErrorCode::kUnknownFrame, "bees.csv:3",
                          "in the frame 'uav1/odom' of ROS, but others, as in bees.csv, are in "
                          "'uav0/odom': they cannot be compared"});
    options.frame = Frame::kMetres;
    EXPECT_FALSE(record(in_frames(header, "uav0/odom", "uav1/odom"), options)) << name;
    EXPECT_TRUE(record(in_frames(header, "map", "map"), options)) << name;
  }
}

// One that begins where each robot was switched on.
TEST(FramesOfReference, OfOdometryAreAskedAbout) {
  RecordingOptions options = columns_are("id=3", Unit::kUnstated);
  const std::string text = in_frames("time_s,frame_id,robot,x,y,z", "odom", "odom");
  expect_error(record(text, options),
               {ErrorCode::kUnknownFrame, "bees.csv:3", "say so with --crs metres"});
  options.frame = Frame::kMetres;
  EXPECT_EQ(recording_of(record(text, options)).bees.size(), 2u);
}

TEST(FramesOfReference, AreNoIds) {
  const std::string header = "time_s,frame_id,child_frame_id,x,y,z";
  expect_error(record(in_frames(header, "uav0/odom", "uav1/odom")),
               {ErrorCode::kMissingColumn, "bees.csv:1", "say --columns id=3"});
  // Who says that they are may mean it.
  RecordingOptions options = columns_are("id=2", Unit::kUnstated);
  expect_error(record(in_frames(header, "uav0", "uav1"), options),
               {ErrorCode::kUnknownFrame, "bees.csv:3",
                "all have one origin and direction, say so with --crs metres"});
  options.frame = Frame::kMetres;
  EXPECT_EQ(recording_of(record(in_frames(header, "uav0", "uav1"), options)).bees.size(), 2u);
}

// As a message of ROS may have them.
TEST(FramesOfReference, OfAHeaderMayBeNumbers) {
  const std::string header = "time_s,header.frame_id,id,x,y,z";
  expect_error(record(in_frames(header, "0", "1")),
               {ErrorCode::kUnknownFrame, "bees.csv:3", "in the frame '1' of ROS, but others"});
  EXPECT_EQ(recording_of(record(in_frames(header, "0", "0"))).bees.size(), 2u);
}

TEST(FramesOfReference, AreNoneOfPicturesAndOfDegrees) {
  EXPECT_TRUE(record("time_s,id,frame_id,x,y,z\n1,a,10,1,2,0\n2,a,11,1,2,0\n2,b,11,4,2,0\n"));
  EXPECT_TRUE(record("time_s,id,frame_id,lon,lat\n1,a,gps_0,8.5,47.3\n1,b,gps_1,8.6,47.3\n"));
}

}  // namespace
}  // namespace beespace::io
