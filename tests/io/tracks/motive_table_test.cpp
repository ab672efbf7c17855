// Takes of Motive: rigid bodies beside each other, with y upwards.
#include "tests/io/tracks/recording_loading.hpp"

#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

// Two bodies, a marker of one of them, and three pictures.
std::string take(const std::string& unit, const std::string& second = "uav2") {
  const std::string body =
      ",Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid "
      "Body,Rigid Body";
  const auto eight = [](const std::string& name) {
    std::string cells;
    for (int i = 0; i < 8; ++i) cells += "," + name;
    return cells;
  };
  return "Format Version,1.23,Take Name,Take 2026-03-04 02.35.59 PM,Capture Frame Rate,120.000000,"
         "Export Frame Rate,120.000000,Capture Start Time,2026-03-04 02.35.59.123 PM,Total Frames "
         "in Take,3,Rotation Type,Quaternion,Length Units," +
         unit +
         ",Coordinate Space,Global\n\n"
         "," +
         body + body +
         ",Rigid Body Marker,Rigid Body Marker,Rigid Body Marker\n"
         "," +
         eight("uav1") + eight(second) +
         ",uav1:Marker1,uav1:Marker1,uav1:Marker1\n"
         "," +
         eight("1F3A") + eight("1F3B") +
         ",1,1,1\n"
         ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,"
         "Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,"
         "Position,Position,Position\n"
         "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z,W,X,Y,Z,,X,Y,Z\n"
         "0,0.000000,0,0,0,1,1.5,2,-3,0.001,0,0,0,1,4,2,0.5,0.001,9,9,9\n"
         "1,0.500000,0,0,0,1,1.6,2,0.0,0.001,,,,,,,,,9,9,9\n"
         "2,1.000000,0,0,0,1,1.7,2,3,0.001,0,0,0,1,4,2.5,0.5,0.001,9,9,9\n";
}

TEST(MotiveTable, NotesNameNoColumnsThatTheFileHasNot) {
  const auto recording = recording_of(record(take("Meters")));
  for (const std::string& note : recording.notes) {
    EXPECT_EQ(note.find("read from column"), std::string::npos) << note;
  }
  ASSERT_FALSE(recording.units.empty());
  EXPECT_EQ(recording.units.front().reason, "exports of Motive (OptiTrack) have them so");
}

TEST(MotiveTable, ARowThatIsCutOffIsSaidSo) {
  expect_error(record(take("Meters") + "3,1.500000,0,0\n"),
               {ErrorCode::kColumnCount, "bees.csv:11",
                "this row has another number of values than the table has columns, 4, as where a "
                "file was cut off"});
}

TEST(MotiveTable, RigidBodiesAreBees) {
  const auto recording = recording_of(record(take("Meters")));
  ASSERT_EQ(ids_of(recording), (Ids{"uav1", "uav2"}));
  EXPECT_EQ(
      recording.bees[0].fixes,
      (std::vector<Fix>{{0.0, {1.5, 3.0, 2.0}}, {0.5, {1.6, 0.0, 2.0}}, {1.0, {1.7, -3.0, 2.0}}}));
  // Where it was not seen there is no place.
  EXPECT_EQ(recording.bees[1].fixes,
            (std::vector<Fix>{{0.0, {4.0, -0.5, 2.0}}, {1.0, {4.0, -0.5, 2.5}}}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(has_note(recording,
                       "positions of 2 rigid bodies as Motive exports them: y, which is "
                       "upwards there, is z here, and -z is y"));
  EXPECT_TRUE(has_note(recording, "markers and bones of the take are left out"));
}

TEST(MotiveTable, LengthsAreInTheUnitOfTheTake) {
  EXPECT_EQ(recording_of(record(take("Millimeters"))).bees[0].fixes[0].position,
            (Point{0.0015, 0.003, 0.002}));
  expect_error(record(take("Parsecs")), {ErrorCode::kInvalidArgument, "bees.csv",
                                         "'Parsecs'; export it with Length Units: Meters"});
}

TEST(MotiveTable, BodiesOfOneNameAreRefused) {
  expect_error(record(take("Meters", "uav1")),
               {ErrorCode::kInvalidArgument, "bees.csv", "two rigid bodies of this take"});
}

TEST(MotiveTable, WhatIsWrongIsToldWithItsLine) {
  std::string bad = take("Meters");
  bad.replace(bad.find("1.6"), 3, "one");
  expect_error(record(bad), {ErrorCode::kNotANumber, "bees.csv:9", "'one'"});
}

}  // namespace
}  // namespace beespace::io
