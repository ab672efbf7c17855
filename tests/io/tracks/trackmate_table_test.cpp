#include "io/tracks/trackmate_table.hpp"

#include "tests/io/tracks/recording_loading.hpp"

#include <string>

namespace beespace::io {
namespace {

const std::string kNames =
    "LABEL,ID,TRACK_ID,QUALITY,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME\n";
const std::string kMoreNames =
    "Label,Spot ID,Track ID,Quality,X,Y,Z,T,Frame\nLabel,Spot ID,Track ID,Quality,X,Y,Z,T,Frame\n";
const std::string kSpots =
    "ID0,0,0,5,10,20,0,0,0\nID1,1,1,5,25,6,0,0,0\nID2,2,0,5,10.5,20,0,0.5,1\nID3,3,,5,1,1,0,0.5,"
    "1\n";

TEST(TrackMateTable, TracksAreAnimalsAndUnitsAreThoseOfTheirRow) {
  const std::string units = ",,,(quality),(micron),(micron),(micron),(sec),\n";
  ASSERT_TRUE(is_trackmate_table(kNames + kMoreNames + units + kSpots));
  const auto read = recording_of(record(kNames + kMoreNames + units + kSpots));
  ASSERT_EQ(ids_of(read), (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(times_of(read.bees[0]), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(read.bees[0].fixes[1].position, (Point{10.5e-6, 20e-6, 0}));
  EXPECT_EQ(read.missing.without_id, 1u);
  EXPECT_TRUE(has_note(read, "1 record of spots that are on no track is left out"));
  EXPECT_TRUE(has_note(read, "a table of spots, as TrackMate writes them: each track is a bee"));
  expect_error(record(kNames + kMoreNames + units + "ID0,0,0,5,x,20,0,0,0\n" + kSpots),
               {ErrorCode::kNotANumber, "bees.csv:5", "'x' is not a number"});
}

TEST(TrackMateTable, WithoutARowOfUnitsTheyAreAskedFor) {
  expect_error(record(kNames + kSpots),
               {ErrorCode::kInvalidArgument, "bees.csv",
                "no row says the unit of places: say it, as in --units position=um, or how long a "
                "pixel is, as in --scale 0.1mm; and no row says the unit of times: say how many "
                "frames there are in a second, as in --fps 25, or the unit, as in --time-unit s"});
  RecordingOptions options;
  options.units.position = Unit::kMicrometre;
  options.time_unit = Unit::kSecond;
  const auto read = recording_of(record(kNames + kSpots, options));
  EXPECT_EQ(read.bees[1].fixes[0].position, (Point{25e-6, 6e-6, 0}));
}

// Films of hours are in minutes.
TEST(TrackMateTable, MinutesAreTurnedIntoSeconds) {
  const auto read = recording_of(
      record(kNames + kMoreNames + ",,,(quality),(\u00b5m),(\u00b5m),(\u00b5m),(min),\n" + kSpots));
  EXPECT_EQ(times_of(read.bees[0]), (std::vector<double>{0, 30.0}));
  EXPECT_TRUE(has_note(read, "times of the table are in min, and are turned into seconds"));
  EXPECT_TRUE(read.y_is_down);
}

// Of a video that is not calibrated.
TEST(TrackMateTable, PixelsAndFramesAreAskedForAtOnce) {
  const std::string spots =
      kNames + kMoreNames + ",,,(quality),(pixel),(pixel),(pixel),(frame),\n" + kSpots;
  expect_error(record(spots), {ErrorCode::kInvalidArgument, "bees.csv",
                               "in pixels: say how long one is, as in --scale 0.1mm (--scale 1 "
                               "takes it for a metre); and times are numbers of frames: say how "
                               "many there are in a second, as in --fps 25"});
  RecordingOptions options;
  options.pixel = StatedLength{1e-4, 0.1, Unit::kMillimetre};
  options.frames_per_second = 4.0;
  const auto read = recording_of(record(spots, options));
  EXPECT_EQ(times_of(read.bees[0]), (std::vector<double>{0, 0.25}));
  EXPECT_NEAR(read.bees[0].fixes[1].position.x, 1.05e-3, 1e-12);
}

// Fiji's table of results numbers its rows, and labels spots.
TEST(TrackMateTable, TheTableOfResultsIsOneToo) {
  const std::string spots =
      " ,Label,ID,TRACK_ID,QUALITY,POSITION_X,POSITION_Y,POSITION_Z,POSITION_T,FRAME\n"
      "1,ID0,0,0,5,10,20,0,0,0\n2,ID1,1,1,5,25,6,0,0,0\n3,ID2,2,0,5,10.5,20,0,0.5,1\n";
  expect_error(record(spots), {ErrorCode::kInvalidArgument, "bees.csv", "the unit of places"});
  RecordingOptions options;
  options.units.position = Unit::kMillimetre;
  options.frames_per_second = 2.0;
  const auto read = recording_of(record(spots, options));
  EXPECT_EQ(ids_of(read), (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(times_of(read.bees[0]), (std::vector<double>{0, 0.5}));
}

}  // namespace
}  // namespace beespace::io
