// Columns for several vehicles beside each other: none of them is dropped silently.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace beespace::io {
namespace {

// A table of that header, all of whose values are 1.
Result<Recording> load_with(const std::string& header, const RecordingOptions& options = {}) {
  std::string row = "1";
  for (const char c : header) row += c == ',' ? ",1" : "";
  return record(header + "\n" + row + "\n", options);
}

TEST(SeveralVehicles, ASecondSetOfCoordinatesIsRefused) {
  for (const std::string header :
       {"time_s,x,y,z,x2,y2,z2", "time_s,x,y,z,follower_x,follower_y,follower_z",
        "time,A_x,A_y,A_z,B_x,B_y,B_z", "time_s,x_1,y_1,x_2,y_2",
        "time_s,x [m],y [m],x2 [m],y2 [m]", "time_s,lat,lon,alt_m,lat2,lon2,alt2_m",
        "time_s,leader_lat,leader_lon,leader_alt,follower_lat,follower_lon,follower_alt",
        "time_s,x,y,z,x,y,z", "time_s,id,lat,lon,alt_m,lat,lon,alt_m",
        "__time,/r1/odom/pose/pose/position/x,/r1/odom/pose/pose/position/y,/r2/odom/pose/pose/"
        "position/x,/r2/odom/pose/pose/position/y"}) {
    expect_error(load_with(header), {ErrorCode::kMissingColumn, "bees.csv:1",
                                     "places of several vehicles beside each other"});
  }
  expect_error(load_with("time_s,x,y,z,x2,y2,z2"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "'x', 'y' and 'x2', 'y2'; write a record for each vehicle and time"});
}

TEST(SeveralVehicles, ALineOfAwkMakesRecords) {
  expect_error(load_with("time_s,r1_x [mm],r1_y [mm],r2_x [mm],r2_y [mm]"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "as by awk -F',' '{sub(/\\r$/,\"\")}function p(i,a,b){if($a!=\"\")print "
                "$1\",\"i\",\"$a\",\"$b}NR==1{print \"time_s,id,x_mm,y_mm\"}NR>1{p(\"r1\",2,3);p("
                "\"r2\",4,5)}' FILE > long.csv, and then beespace replay long.csv --threshold "
                "YOUR_THRESHOLD; if"});
  expect_error(load_with("time,drone1_x,drone1_y,drone1_z,drone2_x,drone2_y,drone2_z"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "and then beespace replay long.csv --threshold YOUR_THRESHOLD --time-unit s; where "
                "'time' is not in seconds, the unit is ms, us or ns; if"});
}

// As rostopic writes /gazebo/model_states: velocities are no places, and names are in the table.
TEST(SeveralVehicles, StatesOfModelsHaveTheirNames) {
  std::string header = "%time,field.name0,field.name1";
  for (const std::string part : {"pose0.position", "pose1.position", "twist0.linear",
                                 "twist0.angular", "twist1.linear", "twist1.angular"}) {
    for (const std::string axis : {"x", "y", "z"}) {
      header.append(",field.").append(part).append(".").append(axis);
    }
  }
  std::string row = "1764331200000000000,ground_plane,robot1";
  for (int i = 0; i < 18; ++i) row += ",1";
  expect_error(record(header + "\n" + row + "\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "{if($a!=\"\"&&i!=\"ground_plane\")print "
                "$1\",\"i\",\"$a\",\"$b\",\"$c}NR==1{print \"time_ns,id,x,y,z\"}NR>1{p($2,4,5,6);"
                "p($3,7,8,9)}' FILE > long.csv, and then beespace replay long.csv --threshold "
                "YOUR_THRESHOLD; if"});
}

// Frames are not in tables of PlotJuggler: topics of odometry are taken for what they are called.
TEST(SeveralVehicles, OdometryOfSeveralIsInFramesOfTheirOwn) {
  expect_error(load_with("__time,/r1/odom/pose/pose/position/x,/r1/odom/pose/pose/position/y,/r2/"
                         "odom/pose/pose/position/x,/r2/odom/pose/pose/position/y"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "$1\",\"i\",\"$a\",\"$b\",odom\"}NR==1{print \"__time,id,x,y,header.frame_id\"}"});
  expect_error(record("__time,id,x,y,header.frame_id\n1,r1,0,0,odom\n1,r2,0,0,odom\n",
                      columns_are("", Unit::kSecond)),
               {ErrorCode::kUnknownFrame, "bees.csv:3", "are in a frame 'odom' of ROS"});
  expect_error(load_with("__time,/r1/pose/position/x,/r1/pose/position/y,/r2/pose/position/x,/r2/"
                         "pose/position/y"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "{print \"__time,id,x,y\"}"});
}

// As PlotJuggler writes what is told of all transforms; those within a robot place none.
TEST(SeveralVehicles, TransformsOfSeveralAreTheirPlaces) {
  std::string header = "__time";
  for (const std::string frames : {"map/r1/base_link", "map/r1/odom", "map/r2/base_link",
                                   "r1/base_link/r1/camera", "r2/base_link/r2/camera", "map/r3"}) {
    for (const std::string axis : {"rotation/w", "rotation/x", "rotation/y", "rotation/z",
                                   "translation/x", "translation/y", "translation/z"}) {
      header.append(",/tf/").append(frames).append("/").append(axis);
    }
  }
  expect_error(load_with(header),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "print \"__time,id,x,y,z\"}NR>1{p(\"r1\",6,7,8);p(\"r2\",20,21,22);p(\"r3\",41,"
                "42,43)}' FILE > long.csv, and then beespace replay long.csv"});
  // Of one alone its place is proposed, and not how it is turned.
  const std::string one = header.substr(0, header.find(",/tf/map/r1/odom"));
  expect_error(load_with(one), {ErrorCode::kMissingColumn, "bees.csv:1",
                                "perhaps with --columns time=1,x=6,y=7,z=8, or"});
}

TEST(SeveralVehicles, WhoSaysWhichColumnsIsBelieved) {
  EXPECT_TRUE(load_with("time_s,x,y,z,x2,y2,z2", columns_are("time=1,x=5,y=6,z=7")));
}

TEST(SeveralVehicles, WhatIsNoVehicleIsNoReason) {
  for (const std::string header :
       {"time_s,p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],b_w_RS_S_x [rad s^-1],b_w_RS_S_y [rad "
        "s^-1],b_w_RS_S_z [rad s^-1],b_a_RS_S_x [m s^-2],b_a_RS_S_y [m s^-2]",
        "time_s,id,x,y,z,vx,vy,vz,ax,ay,az", "time_s,x,y,z,goal_x,goal_y,goal_z",
        "time_s,x,y,z,q_x,q_y,q_z,q_w", "time_s,x,y,z,vel_x,vel_y,vel_z,acc_x,acc_y,acc_z",
        "time_s,pos_x,pos_y,pos_z,orientation_x,orientation_y,orientation_z",
        "time_s,lat,lon,alt_m,home_lat,home_lon", "time_s,x,y,z,raw_x,raw_y,raw_z",
        "__time,/r1/odom/pose/pose/position/x,/r1/odom/pose/pose/position/y,/r1/odom/pose/pose/"
        "orientation/x,/r1/odom/pose/pose/orientation/y,/r1/odom/twist/twist/linear/x,/r1/odom/"
        "twist/twist/linear/y,/r1/mocap/pose/position/x,/r1/mocap/pose/position/y",
        "__time,/odom/pose/pose/position/x,/odom/pose/pose/position/y,/amcl_pose/pose/pose/"
        "position/x,/amcl_pose/pose/pose/position/y"}) {
    const auto loaded = load_with(header);
    if (!loaded) {
      EXPECT_EQ(loaded.error().message.find("several vehicles"), std::string::npos) << header;
    }
  }
}

TEST(SeveralVehicles, NorthEastDownIsToldHow) {
  expect_error(load_with("time_s,vehicle,north,east,down"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "(NED); here x is east, y north and z up: write a column z that is the negative of "
                "'down', and say --columns x=4,y=3"});
}

TEST(SeveralVehicles, TrajectoriesOfPosesAreKnownByTheirQuaternions) {
  const auto recording =
      recording_of(record("# timestamp tx ty tz qx qy qz qw\n1700000000.0 1 2 3 0 0 0 "
                          "1\n1700000000.1 1.5 2 3 0 0 0.6 0.8\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes[1].position, (Point{1.5, 2, 3}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(has_note(recording, "taken for a trajectory as of TUM"));
  EXPECT_FALSE(record("0 1 2 3 4 5 6 7\n1 1 2 3 4 5 6 7\n"));
}

TEST(SeveralVehicles, StampsOfTrajectoriesTellTheirUnitByTheirSize) {
  for (const std::string zeros : {"", "000", "000000", "000000000"}) {
    const auto recording = recording_of(
        record("1700000000" + zeros + " 1 2 3 0 0 0 1\n1700000002" + zeros + " 2 2 3 0 0 0 1\n"));
    EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1.7e9, 1.7e9 + 2})) << zeros;
    EXPECT_TRUE(recording.since_1970);
  }
}

// Nothing follows itself ten million times a second.
TEST(SeveralVehicles, MillisecondsSince1970TellTheirUnitByTheirSizeAndSteps) {
  const auto table = [](const std::string& second, const std::string& third) {
    return "id,time,x_m,y_m,z_m\na,1790000000000,1,2,3\nb,1790000000000,9,2,3\na," + second +
           ",2,2,3\nb," + third + ",9,2,3\n";
  };
  const Recording recording = recording_of(record(table("1790000000100", "1790000000113")));
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{1.79e9, 1.79e9 + 0.1}));
  EXPECT_TRUE(recording.since_1970);
  EXPECT_TRUE(has_note(recording, "as their size tells"));
  // A hundred times a second, in nanoseconds since a boot half an hour ago; or in microseconds.
  for (const std::string later : {"1790010000000", "1790000010000", "1790000000000"}) {
    expect_error(record(table(later, later)),
                 {ErrorCode::kInvalidArgument, "bees.csv:1:2", "in which unit? Say it with"});
  }
}

TEST(SeveralVehicles, TrajectoriesFromZerosOfTheirOwnAreAskedAbout) {
  const TemporaryFolder folder;
  const std::string walk = "0.0 1 2 3 0 0 0 1\n1.0 2 2 3 0 0 0 1\n";
  const std::vector<std::string> both = {folder.write("a.txt", walk), folder.write("b.txt", walk)};
  expect_error(load_recording(both, {}),
               {ErrorCode::kInvalidArgument, both[1], "say so with --one-clock"});
  // Beside a table, too.
  const std::string table = folder.write("c.csv", "id,time_s,x_m,y_m,z_m\nc,0,1,2,3\nc,1,2,2,3\n");
  expect_error(load_recording({table, both[0]}, {}),
               {ErrorCode::kInvalidArgument, both[0], "say so with --one-clock"});
  RecordingOptions one_clock;
  one_clock.one_clock = true;
  EXPECT_EQ(recording_of(load_recording(both, one_clock)).bees.size(), 2u);
}

TEST(SeveralVehicles, NumbersOfRowsAreNoHeight) {
  const auto recording = recording_of(record(",id,time_s,x_m,y_m\n1,a,0,5,6\n2,a,1,7,8\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_TRUE(recording.flat);
  EXPECT_EQ(recording.bees[0].fixes[1].position, (Point{7, 8, 0}));
}

TEST(MotionCapture, IsToldWhatToWriteInstead) {
  const std::string motive =
      "Format Version,1.23,Take Name,Take 2026\n\n,Type,Rigid Body\n,Name,uav0\n"
      "Frame,Time (Seconds),X\n0,0.0,1\n";
  const std::string qtm = "NO_OF_FRAMES\t1200\nNO_OF_CAMERAS\t12\nMARKER_NAMES\tuav0\n1\t0.0\t1\n";
  const std::string nexus =
      "Model Outputs\r\n20\r\n,,uav0:LAnkleAngles,,\r\nFrame,Sub Frame,X,Y,Z\r\n,,deg,deg,deg\r\n"
      "1,0,1,2,3\r\n";
  for (const std::string& text : {motive, qtm, nexus}) {
    expect_error(record(text), {ErrorCode::kUnsupportedFormat, "bees.csv",
                                "with columns time_s, id, x_mm, y_mm"});
  }
}

}  // namespace
}  // namespace beespace::io
