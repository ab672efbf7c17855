// Poses as DeepLabCut and SLEAP write them.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

const std::string kMouse =
    "scorer,DLC_resnet50,DLC_resnet50,DLC_resnet50,DLC_resnet50,DLC_resnet50,DLC_resnet50\n"
    "bodyparts,snout,snout,snout,tailbase,tailbase,tailbase\n"
    "coords,x,y,likelihood,x,y,likelihood\n"
    "0,10,20,0.99,30,40,0.99\n"
    "1,11,20,0.5,30,40,0.99\n";

RecordingOptions of_video(const std::string& columns = {}) {
  RecordingOptions options;
  options.columns = columns;
  options.frames_per_second = 2.0;
  options.pixel = StatedLength{0.001, 1.0, Unit::kMillimetre};
  return options;
}

TEST(PoseTable, OneOfSeveralPlacesOfTheBodyIsAskedFor) {
  expect_error(record(kMouse, of_video()),
               {ErrorCode::kInvalidArgument, "bees.csv",
                "say which place of the body is where the animal is, as in --columns "
                "x=snout.x,y=snout.y (DeepLabCut has 'snout', 'tailbase')"});
  // What else pictures do not tell is asked for at once.
  expect_error(record(kMouse, {}),
               {ErrorCode::kInvalidArgument, "bees.csv",
                "has 'snout', 'tailbase'), and how many pictures there are in a second (--fps 25) "
                "and how long a pixel is (--scale 0.1mm)"});
  expect_error(record(kMouse, of_video("x=nose.x,y=nose.y")),
               {ErrorCode::kInvalidArgument, "bees.csv", "names no place of a body"});
  expect_error(record(kMouse, of_video("x=snout.x,y=tailbase.y")),
               {ErrorCode::kInvalidArgument, "bees.csv", "names no place of a body"});
  expect_error(record(kMouse, of_video("x=snout.x,y=snout.y,id=1")),
               {ErrorCode::kInvalidArgument, "bees.csv", "names no place of a body"});
}

TEST(PoseTable, OfOneAnimalTheFileIsTheName) {
  const Recording recording = recording_of(record(kMouse, of_video("x=snout.x,y=snout.y")));
  ASSERT_EQ(ids_of(recording), Ids{"bees"});
  EXPECT_EQ(times_of(recording.bees[0]), std::vector<double>{0.0});
  EXPECT_TRUE(recording.flat);
  EXPECT_TRUE(
      has_note(recording, "as DeepLabCut writes them: each animal is where its 'snout' is"));
  EXPECT_TRUE(has_note(recording, "1 place has a likelihood below 0.6 and is as if not there"));
  RecordingOptions unsure = of_video("x=snout.x,y=snout.y");
  unsure.least_likelihood = 0.0;
  const Recording all = recording_of(record(kMouse, unsure));
  EXPECT_EQ(times_of(all.bees[0]), (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(all.bees[0].fixes[1].position, (Point{0.011, 0.020, 0.0}));
  EXPECT_FALSE(has_note(all, "likelihood"));
  const Recording tail = recording_of(record(kMouse, of_video("x=tailbase.x,y=tailbase.y")));
  EXPECT_EQ(tail.bees[0].fixes[1].position, (Point{0.030, 0.040, 0.0}));
  EXPECT_FALSE(has_note(tail, "likelihood"));
}

TEST(PoseTable, FramesAndPixelsAreAskedFor) {
  RecordingOptions options = of_video("x=snout.x,y=snout.y");
  options.frames_per_second.reset();
  expect_error(record(kMouse, options), {ErrorCode::kInvalidArgument, "bees.csv", "--fps"});
  options = of_video("x=snout.x,y=snout.y");
  options.pixel.reset();
  expect_error(record(kMouse, options), {ErrorCode::kInvalidArgument, "bees.csv", "--scale"});
}

TEST(PoseTable, IndividualsOfDeepLabCutHaveARowOfTheirOwn) {
  const std::string table =
      "scorer,d,d,d,d,d,d,d,d,d\r\n"
      "individuals,m1,m1,m1,m2,m2,m2,single,single,single\r\n"
      "bodyparts,nose,nose,nose,nose,nose,nose,corner,corner,corner\r\n"
      "coords,x,y,likelihood,x,y,likelihood,x,y,likelihood\r\n"
      "0,1,2,0.9,3,4,0.9,0,0,1\r\n"
      "1,,,,5,6,0.9,0,0,1\r\n";
  const Recording recording = recording_of(record(table, of_video("x=nose.x,y=nose.y")));
  ASSERT_EQ(ids_of(recording), (Ids{"m1", "m2"}));
  EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
  EXPECT_EQ(recording.bees[1].fixes[1].position, (Point{0.005, 0.006, 0.0}));
  EXPECT_EQ(recording.missing.count, 0u);
  EXPECT_TRUE(has_note(recording, "1 record without a place"));
  // An animal without that place of its body is not as if it were not there.
  const std::string other =
      "scorer,d,d,d,d\nindividuals,m1,m1,m2,m2\nbodyparts,nose,nose,tail,tail\ncoords,x,y,x,y\n"
      "0,1,2,3,4\n";
  const Recording hidden = recording_of(record(other, of_video("x=nose.x,y=nose.y")));
  EXPECT_EQ(ids_of(hidden), Ids{"m1"});
  EXPECT_EQ(hidden.missing.nowhere_ids, Ids{"m2"});
}

TEST(PoseTable, ErrorsHaveTheLine) {
  expect_error(record(kMouse + "2,x,20,0.9,30,40,0.9\n", of_video("x=snout.x,y=snout.y")),
               {ErrorCode::kNotANumber, "bees.csv:6", "'x' is not a number"});
  expect_error(record(kMouse + "2,10,20\n", of_video("x=snout.x,y=snout.y")),
               {ErrorCode::kColumnCount, "bees.csv:6", "a row of 3 values"});
}

TEST(PoseTable, TracksOfSleapAreAnimals) {
  const std::string table =
      "track,frame_idx,instance.score,thorax.x,thorax.y,thorax.score\n"
      "track_0,0,0.9,1,2,0.9\ntrack_1,0,0.9,3,4,0.2\ntrack_0,2,0.9,1.5,2,0.9\n";
  const Recording recording = recording_of(record(table, of_video()));
  ASSERT_EQ(ids_of(recording), Ids{"track_0"});
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(recording.missing.nowhere_ids, Ids{"track_1"});
  EXPECT_TRUE(has_note(recording, "as SLEAP writes them: each animal is where its 'thorax' is"));
  EXPECT_TRUE(has_note(recording, "1 place has a likelihood below 0.6"));
  // Whose it is, is not known.
  expect_error(record(table + ",3,0.9,1,2,0.9\n", of_video()),
               {ErrorCode::kMalformedRecord, "bees.csv:5", "the id is empty"});
}

// Of a video in which none is tracked.
TEST(PoseTable, InstancesOfSleapOnNoTrackAreThoseOfOneAnimalOrAskedAbout) {
  const std::string header = "track,frame_idx,instance.score,thorax.x,thorax.y,thorax.score\n";
  const std::string one = header + ",0,0.9,1,2,0.9\n,1,0.9,3,4,0.9\n";
  EXPECT_EQ(ids_of(recording_of(record(one, of_video()))), Ids{"bees"});
  expect_error(record(one + ",1,0.9,5,4,0.9\n", of_video()),
               {ErrorCode::kMissingColumn, "bees.csv", "no instance is on a track"});
}

}  // namespace
}  // namespace beespace::io
