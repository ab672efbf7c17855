// Exports of Vicon and QTM: bodies beside each other under headers of several lines.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

const std::string kObjects =
    "Objects\r\n10\r\n"
    ",,robot1:robot1,,,,,,robot2:robot2,,,,,\r\n"
    "Frame,Sub Frame,RX,RY,RZ,TX,TY,TZ,RX,RY,RZ,TX,TY,TZ\r\n"
    ",,rad,rad,rad,mm,mm,mm,rad,rad,rad,mm,mm,mm\r\n"
    "1,0,0.1,0.2,0.3,-6000,0,35,0,0,0,6000,600,0\r\n"
    "2,0,0.1,0.2,0.3,-5980,0,35,,,,,,\r\n"
    "3,0,0.1,0.2,0.3,-5960,0,35,0,0,0,5960,600,0\r\n";

std::string trajectories(const std::string& first, const std::string& second) {
  return "Trajectories\n100\n,," + first + ",,," + second +
         ",,\nFrame,Sub Frame,X,Y,Z,X,Y,Z\n,,mm,mm,mm,mm,mm,mm\n1,0,1,2,3,4000,5,6\n"
         "2,0,1,2,3,4000,5,6\n";
}

const std::string kSixD =
    "NO_OF_FRAMES\t2\nNO_OF_CAMERAS\t8\nNO_OF_BODIES\t2\nFREQUENCY\t10\nDATA_INCLUDED\t6D\n"
    "BODY_NAMES\trobot1\trobot2\n"
    "Frame\tTime\trobot1 X\tY\tZ\tRoll\tPitch\tYaw\tResidual\tRot[0]\trobot2 X\tY\tZ\tRoll\tPitch\t"
    "Yaw\tResidual\tRot[0]\n"
    "1\t0.00000\t-6000.0\t0.0\t30.0\t0\t0\t0\t0.5\t1\t6000.0\t600.0\t0.0\t0\t0\t0\t0.5\t1\n"
    "2\t0.10000\t-5980.0\t0.0\t30.0\t0\t0\t0\t0.5\t1\t0.0\t0.0\t0.0\t0\t0\t0\t-1.0\t0\n";

Result<Recording> two(const std::string& text, const RecordingOptions& options = {}) {
  const TemporaryFolder folder;
  std::string other = text;
  for (std::size_t at = 0; (at = other.find("robot", at)) != std::string::npos; ++at) {
    other.replace(at, 5, "drone");
  }
  auto loaded =
      load_recording({folder.write("a.csv", text), folder.write("b.csv", other)}, options);
  if (loaded) return loaded;
  Error error = std::move(loaded).error();
  error.location.source.erase(0, error.location.source.rfind('/') + 1);
  return error;
}

TEST(ViconTable, ObjectsOfTrackerAreCalledByTheirNames) {
  std::string text = kObjects;
  for (const std::string name : {"robot1:robot1", "robot2:robot2"}) {
    text.insert(text.find(name), "Global Angle ");
  }
  EXPECT_EQ(ids_of(recording_of(record(text))), (Ids{"robot1", "robot2"}));
}

TEST(ViconTable, TranslationsAreThePlacesOfObjects) {
  const auto recording = recording_of(record(kObjects));
  ASSERT_EQ(ids_of(recording), (Ids{"robot1", "robot2"}));
  EXPECT_EQ(recording.bees[0].fixes, (std::vector<Fix>{{0.1, {-6.0, 0.0, 0.035}},
                                                       {0.2, {-5.98, 0.0, 0.035}},
                                                       {0.3, {-5.96, 0.0, 0.035}}}));
  // Where it was not seen there is no place.
  EXPECT_EQ(recording.bees[1].fixes,
            (std::vector<Fix>{{0.1, {6.0, 0.6, 0.0}}, {0.3, {5.96, 0.6, 0.0}}}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(has_note(recording, "positions of 2 bodies as Vicon exports them, 10 pictures a"));
}

TEST(ViconTable, ObjectsComeBeforeTheirMarkers) {
  EXPECT_EQ(ids_of(recording_of(record(trajectories("robot1:m1", "robot2:m1") + "\n" + kObjects))),
            (Ids{"robot1", "robot2"}));
  const auto recording = recording_of(record(kObjects + "\r\n" + trajectories("a:1", "a:2")));
  EXPECT_EQ(ids_of(recording), (Ids{"robot1", "robot2"}));
  EXPECT_EQ(recording.bees[0].fixes.size(), 3U);
}

TEST(ViconTable, MarkersOfBodiesOfTheirOwnAreRead) {
  const auto recording = recording_of(record(trajectories("fly1:m1", "fly2:m1")));
  ASSERT_EQ(ids_of(recording), (Ids{"fly1", "fly2"}));
  EXPECT_EQ(recording.bees[1].fixes.front(), (Fix{0.01, {4.0, 0.005, 0.006}}));
  expect_error(record(trajectories("fly1:m1", "fly1:m2")),
               {ErrorCode::kInvalidArgument, "bees.csv",
                "markers 'fly1:m1' and 'fly1:m2' are both of 'fly1'"});
}

TEST(ViconTable, TheLineOfABadRecordIsNamed) {
  std::string text = kObjects;
  text.replace(text.find("-5980"), 5, "oops!");
  expect_error(record(text), {ErrorCode::kNotANumber, "bees.csv:7", "'oops!'"});
}

TEST(ViconTable, EachRecordingHasAClockOfItsOwn) {
  expect_error(two(kObjects), {ErrorCode::kInvalidArgument, "a.csv", "say --one-clock"});
  RecordingOptions options;
  options.one_clock = true;
  EXPECT_EQ(recording_of(two(kObjects, options)).bees.size(), 4U);
}

TEST(ViconTable, AUnitThatIsNotOneOfLengthIsRefused) {
  std::string text = kObjects;
  for (std::size_t at = 0; (at = text.find("mm", at)) != std::string::npos;) text.erase(at, 2);
  expect_error(record(text), {ErrorCode::kInvalidArgument, "bees.csv", "export them in mm"});
}

TEST(QtmTable, BodiesAreInMillimetres) {
  const auto recording = recording_of(record(kSixD));
  ASSERT_EQ(ids_of(recording), (Ids{"robot1", "robot2"}));
  EXPECT_EQ(recording.bees[0].fixes,
            (std::vector<Fix>{{0.0, {-6.0, 0.0, 0.03}}, {0.1, {-5.98, 0.0, 0.03}}}));
  // A residual of -1 says that it was not seen.
  EXPECT_EQ(recording.bees[1].fixes, (std::vector<Fix>{{0.0, {6.0, 0.6, 0.0}}}));
  EXPECT_TRUE(has_note(recording, "positions of 2 rigid bodies as QTM exports them"));
}

TEST(QtmTable, EmptyLinesAboveTheColumnsAreNoColumns) {
  const auto right = recording_of(record(kSixD));
  for (const char* empty : {"\n", "\r\n", "\n\n"}) {
    std::string text = kSixD;
    text.insert(text.find("Frame\t"), empty);
    const auto recording = recording_of(record(text));
    ASSERT_EQ(ids_of(recording), (Ids{"robot1", "robot2"}));
    EXPECT_EQ(recording.bees[0].fixes, right.bees[0].fixes);
    EXPECT_EQ(recording.bees[1].fixes, right.bees[1].fixes);
  }
  std::string nothing = kSixD;
  nothing.resize(nothing.find("Frame\t"));
  expect_error(record(nothing + "\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "an export of QTM (Qualisys)"});
}

// Of two markers, with the lines and the columns that stand before the coordinates.
std::string markers(const std::string& names, const std::string& columns, const char* first,
                    const char* second, const std::string& rate = "FREQUENCY\t10\n") {
  return "NO_OF_FRAMES\t2\nNO_OF_MARKERS\t2\n" + rate +
         "TIME_STAMP\t2024-06-01, 14:00:00.000\t1234.5\nDATA_INCLUDED\t3D\nEVENT\tStart\t1\t0.0\n"
         "MARKER_NAMES\t" +
         names + "\nTRAJECTORY_TYPES\tMeasured\tMeasured\n" + columns + first +
         "-6000.0\t0.0\t30.0\t6000.0\t600.0\t0.0\n" + second +
         "-5980.0\t0.0\t30.0\t5980.0\t600.0\t0.0\n";
}

TEST(QtmTable, MarkersAreBeesWithAndWithoutColumnsOfTimeAndALineOfColumns) {
  const std::string named = "m1 X\tm1 Y\tm1 Z\tm2 X\tm2 Y\tm2 Z\n";
  for (const std::string& text :
       {markers("m1\tm2", "", "", ""), markers("m1\tm2\t", named, "", ""),
        markers("m1\tm2", "Frame\tTime\t" + named, "1\t0.0\t", "2\t0.1\t")}) {
    const auto recording = recording_of(record(text));
    ASSERT_EQ(ids_of(recording), (Ids{"m1", "m2"})) << text;
    EXPECT_EQ(recording.bees[0].fixes,
              (std::vector<Fix>{{0.0, {-6.0, 0.0, 0.03}}, {0.1, {-5.98, 0.0, 0.03}}}));
    EXPECT_EQ(recording.bees[1].fixes,
              (std::vector<Fix>{{0.0, {6.0, 0.6, 0.0}}, {0.1, {5.98, 0.6, 0.0}}}));
    EXPECT_TRUE(has_note(recording, "positions of 2 markers as QTM exports them, in mm"));
  }
}

TEST(QtmTable, APictureInWhichNothingWasSeenTakesItsTime) {
  const std::string rows = markers("m1\tm2", "", "\t\t\t\t\t\n", "");
  const auto recording = recording_of(record(rows));
  EXPECT_EQ(recording.bees[0].fixes,
            (std::vector<Fix>{{0.1, {-6.0, 0.0, 0.03}}, {0.2, {-5.98, 0.0, 0.03}}}));
}

TEST(QtmTable, BodiesWithoutColumnsOfTimeAreTimedByTheFrequency) {
  std::string text = kSixD;
  for (const char* part : {"Frame\tTime\t", "1\t0.00000\t", "2\t0.10000\t"}) {
    text.erase(text.find(part), std::string(part).size());
  }
  const auto recording = recording_of(record(text));
  EXPECT_EQ(recording.bees[0].fixes,
            (std::vector<Fix>{{0.0, {-6.0, 0.0, 0.03}}, {0.1, {-5.98, 0.0, 0.03}}}));
  EXPECT_EQ(recording.bees[1].fixes.size(), 1U);
  EXPECT_TRUE(has_note(recording, "2 rigid bodies as QTM exports them, in mm, 10 pictures a"));
}

TEST(QtmTable, MarkersOfOneBodyOrWithoutNamesOrTimesAreRefused) {
  expect_error(record(markers("uav - 1\tuav - 2", "", "", "")),
               {ErrorCode::kInvalidArgument, "bees.csv", "several markers are of 'uav', one of"});
  expect_error(record(markers("m1\tm1", "", "", "")),
               {ErrorCode::kInvalidArgument, "bees.csv", "have one name, or none"});
  for (const std::string& text :
       {markers("m1\tm2", "", "", "", ""), markers("m1\tm2", "", "1\t0.0\t", "2\t0.1\t"),
        markers("m1\tm2\tm3", "", "", "")}) {
    expect_error(record(text),
                 {ErrorCode::kUnsupportedFormat, "bees.csv", "an export of QTM (Qualisys)"});
  }
}

}  // namespace
}  // namespace beespace::io
