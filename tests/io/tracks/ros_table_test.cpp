// Tables as tools of ROS write them: two columns of a time, whose position, in which frame.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;

// As bagpy writes odometry, but for columns that are like these.
constexpr std::string_view kOdometry =
    "Time,header.seq,header.stamp.secs,header.stamp.nsecs,header.frame_id,child_frame_id,"
    "pose.pose.position.x,pose.pose.position.y,pose.pose.position.z,pose.pose.orientation.x,"
    "pose.pose.orientation.y,pose.pose.orientation.z,pose.pose.orientation.w,pose.covariance,"
    "twist.twist.linear.x,twist.twist.linear.y,twist.twist.linear.z\n"
    "1700000000.9,1,1700000000,250000000,map,base_link,1,2,3,0,0,0,1,0,9,9,9\n"
    "1700000001.9,2,1700000001,0,map,base_link,4,5,6,0,0,0,1,0,9,9,9\n";

TEST(RosTable, ThePoseAndTheStampOfTheHeaderAreTaken) {
  const auto recording = recording_of(record(kOdometry));
  ASSERT_EQ(ids_of(recording), Ids{"base_link"});
  const RecordedBee& bee = recording.bees[0];
  EXPECT_EQ(times_of(bee), (Times{1700000000.25, 1700000001}));
  EXPECT_EQ(bee.fixes[1].position, (Point{4, 5, 6}));
  EXPECT_TRUE(bee.velocities.empty());
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_TRUE(has_note(recording, "in seconds and column 4 'header.stamp.nsecs' in ns"));
  EXPECT_TRUE(has_note(recording, "not from column 1 'Time'; --columns time=1 would change that"));
}

TEST(RosTable, TopicsBesideEachOtherAreBees) {
  const std::string header =
      "Time,topic,header.stamp.secs,header.stamp.nsecs,header.frame_id,child_frame_id,"
      "pose.pose.position.x,pose.pose.position.y,pose.pose.position.z\n";
  const auto row = [](const std::string& topic, int second, int x) {
    return "170000000" + std::to_string(second) + "," + topic + ",170000000" +
           std::to_string(second) + ",0,map,base_link," + std::to_string(x) + ",2,3\n";
  };
  const std::string one = row("/uav0/odom", 1, 0) + row("/uav0/odom", 2, 1);
  const std::string other = row("/uav1/odom", 1, 5) + row("/uav1/odom", 2, 6);
  const auto both = recording_of(record(header + one + other));
  EXPECT_EQ(ids_of(both), (Ids{"/uav0/odom", "/uav1/odom"}));
  EXPECT_TRUE(has_note(both, "each topic is taken for a bee"));
  EXPECT_EQ(ids_of(recording_of(record(header + one))), Ids{"base_link"});
}

TEST(RosTable, SeveralThatBeginAtZeroAreAskedAbout) {
  const TemporaryFolder folder;
  const std::string header =
      "header.stamp.secs,header.stamp.nsecs,header.frame_id,pose.position.x,pose.position.y,"
      "pose.position.z\n";
  const std::string at_zero = header + "1700000001,0,map,0.0,0,-0.0\n1700000002,0,map,1,0,0\n";
  const std::string first = folder.write("a.csv", at_zero);
  const std::string second = folder.write("b.csv", at_zero);
  const std::string elsewhere = folder.write("c.csv", header + "1700000001,0,map,1,0,0\n");
  expect_error(load_recording({first, second}),
               {ErrorCode::kUnknownFrame, second, "both begin at 0, 0, 0, or within 0.1 m"});
  EXPECT_TRUE(load_recording({first, elsewhere}));
  const std::string noisy = folder.write("d.csv", header + "1700000001,0,map,0.06,-0.02,0.01\n");
  expect_error(load_recording({first, noisy}), {ErrorCode::kUnknownFrame, noisy, "both begin at"});
  RecordingOptions said;
  said.frame = Frame::kMetres;
  EXPECT_TRUE(load_recording({first, second}, said));
}

TEST(RosTable, OfFramesThatCannotBeComparedNothingIsAsked) {
  const TemporaryFolder folder;
  const auto odometry = [&folder](const std::string& robot) {
    return folder.write(robot + ".csv",
                        "header.stamp.secs,header.stamp.nsecs,header.frame_id,pose.position.x,"
                        "pose.position.y,pose.position.z\n1700000001,0," +
                            robot + "/odom,0,0,0\n1700000002,0," + robot + "/odom,1,0,0\n");
  };
  const std::string first = odometry("uav1");
  const std::string second = odometry("uav2");
  expect_error(load_recording({first, second}),
               {ErrorCode::kUnknownFrame, second + ":2", "is in the frame 'uav2/odom' of ROS"});
}

TEST(RosTable, ObjectsThatWereFlattenedAreInMetres) {
  const auto line = [](const std::string& name, int second, int x) {
    return R"({"name":")" + name + R"(","header.stamp.sec":)" + std::to_string(second) +
           R"(,"header.stamp.nanosec":500000000,"header.frame_id":"map",)" +
           R"("child_frame_id":"base_link","pose.position.x":)" + std::to_string(x) +
           R"(,"pose.position.y":2,"pose.position.z":3})" + "\n";
  };
  const auto recording = recording_of(record(line("a", 1717250400, 1) + line("b", 1717250400, 5)));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_EQ(times_of(recording.bees[1]), Times{1717250400.5});
  EXPECT_TRUE(has_note(recording, "taken for a table of a topic of ROS"));
}

TEST(RosTable, TheTopicsTimeInOneColumn) {
  const auto recording =
      recording_of(record("%time,field.header.seq,field.header.stamp,field.header.frame_id,"
                          "field.pose.position.x,field.pose.position.y,field.pose.position.z,"
                          "field.pose.orientation.x\n"
                          "1700000009000000000,1,1700000000500000000,map,1,2,3,0\n"));
  EXPECT_EQ(times_of(recording.bees[0]), Times{1700000000.5});
  EXPECT_EQ(recording.bees[0].fixes[0].position, (Point{1, 2, 3}));
  EXPECT_TRUE(has_note(recording, "as their size tells, not from column 1 '%time'"));
}

TEST(RosTable, SecondsAndNanosecondsOfAnyTable) {
  for (const std::string names : {"sec,nanosec", "stamp.sec,stamp.nanosec", "secs,nsecs",
                                  "header.stamp.secs,header.stamp.nsecs", "t_sec,t_nsec"}) {
    const auto recording =
        recording_of(record("id," + names + ",x_m,y_m,z_m\na,7,5,1,2,3\nb,7,900000000,1,2,4\n"));
    EXPECT_EQ(ids_of(recording), (Ids{"a", "b"})) << names;
    EXPECT_EQ(times_of(recording.bees[0]), Times{7 + 5e-9}) << names;
    EXPECT_EQ(times_of(recording.bees[1]), Times{7.9}) << names;
    EXPECT_FALSE(recording.since_1970) << names;
  }
}

TEST(RosTable, OfTwoStampsOneMustBeSaid) {
  const std::string table = "id,a.sec,a.nanosec,b.sec,b.nanosec,x_m,y_m,z_m\nc,1,2,3,4,5,6,7\n";
  expect_error(record(table),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "look like the seconds of the time; say which with --columns time=2"});
  const auto said = recording_of(record(table, columns_are("time=4,x=6,y=7,z=8", Unit::kUnstated)));
  EXPECT_EQ(times_of(said.bees[0]), Times{3 + 4e-9});
}

TEST(RosTable, NanosecondsThatAreNoneAreBadRecords) {
  for (const std::string pair : {"1,1000000000", "1,-1", "1,0.5", "1.5,0", "1,", "one,1"}) {
    const auto loaded = record("id,sec,nanosec,x_m,y_m,z_m\na," + pair + ",1,2,3\n");
    ASSERT_FALSE(loaded) << pair;
    EXPECT_EQ(loaded.error().code, ErrorCode::kNotANumber) << pair;
  }
  expect_error(
      record("id,sec,nanosec,x_m,y_m,z_m\na,1,2,1,2,3\n", columns_are("", Unit::kMillisecond)),
      {ErrorCode::kInvalidArgument, "bees.csv", "leave --time-unit out"});
}

TEST(RosTable, PositionsInSeveralFramesAreNotCompared) {
  std::string mixed(kOdometry);
  mixed += "1700000002.9,2,1700000002,0,odom,base_link,4,5,6,0,0,0,1,0,9,9,9\n";
  expect_error(record(mixed),
               {ErrorCode::kUnknownFrame, "bees.csv:4", "is in the frame 'odom' of ROS"});
  expect_error(record(mixed),
               {ErrorCode::kUnknownFrame, "bees.csv:4",
                "or, of a table, read those of map alone, as by awk 'NR==1||/[,;\\t]map[,;\\t]/' "
                "FILE > map.csv"});
  const TemporaryFolder folder;
  std::string other(kOdometry);
  for (std::size_t at = 0; (at = other.find(",map,", at)) != std::string::npos;) {
    other.replace(at, 5, ",hall,");
  }
  expect_error(load_recording({folder.write("a.csv", kOdometry), folder.write("b.csv", other)}, {}),
               {ErrorCode::kUnknownFrame, folder.file("b.csv") + ":2", "are in 'map'"});
}

TEST(RosTable, OdometryOfSeveralBeginsAnywhere) {
  const TemporaryFolder folder;
  std::string odometry(kOdometry);
  for (std::size_t at = 0; (at = odometry.find(",map,", at)) != std::string::npos;) {
    odometry.replace(at, 5, ",odom,");
  }
  const std::vector<std::string> files = {folder.write("a.csv", odometry),
                                          folder.write("b.csv", odometry)};
  EXPECT_TRUE(load_recording({files[0]}, {}));
  expect_error(load_recording(files, {}),
               {ErrorCode::kUnknownFrame, folder.file("b.csv") + ":2", "--crs metres"});
  // Of one file, too; whatever odometry is called.
  for (const char* const name : {",odom,r", ",/odom,r", ",odom_combined,r"}) {
    std::string two(kOdometry);
    std::size_t robot = 0;
    for (std::size_t at = 0; (at = two.find(",map,base_link", at)) != std::string::npos;) {
      two.replace(at, std::string(",map,base_link").size(), name + std::to_string(++robot));
    }
    expect_error(record(two), {ErrorCode::kUnknownFrame, "bees.csv:3", "was switched on"});
  }
  RecordingOptions said;
  said.frame = Frame::kMetres;
  EXPECT_TRUE(load_recording(files, said));
}

TEST(RosTable, WithoutAHeaderPosesAreKnownByTheirOrientation) {
  const std::string pose = "1700000000,5,map,1,2,3,0,0,0.6,0.8\n";
  const std::string odometry = "1700000000,5,map,base,1,2,3,0.5,-0.5,0.5,-0.5" + [] {
    std::string rest;
    for (int i = 0; i < 78; ++i) rest += ",0.25";
    return rest + "\n";
  }();
  for (const std::string& line : {pose, odometry}) {
    const auto recording = recording_of(record(line));
    EXPECT_EQ(recording.bees[0].fixes[0].position, (Point{1, 2, 3})) << line;
    EXPECT_EQ(times_of(recording.bees[0]), Times{1700000000 + 5e-9}) << line;
    EXPECT_TRUE(has_note(recording, "'ros2 topic echo --csv'")) << line;
  }
  // Nine numbers and a word that are no pose.
  for (const std::string line :
       {"1700000000,5,map,1,2,3,0,0,0.6,0.7\n", "1700000000,5.5,map,1,2,3,0,0,0.6,0.8\n",
        "1700000000,5,7,1,2,3,0,0,0.6,0.8\n"}) {
    expect_error(record(line), {ErrorCode::kMissingColumn, "bees.csv:1", "there is no header"});
  }
}

TEST(RosTable, EachChildIsABee) {
  const std::string header =
      "header.stamp.sec,header.stamp.nanosec,header.frame_id,child_frame_id,"
      "transform.translation.x,transform.translation.y,transform.translation.z\n";
  const std::string named = header +
                            "1772373600,0,map,d1,0,0,5\n"
                            "1772373600,500000000,map,d2,1,0,5\n"
                            "1772373601,0,map,d1,0,0,5\n"
                            "1772373601,500000000,map,,2,0,5\n";
  const std::string bare =
      "1772373600,0,map,d1,0,0,5,0,0,0,1\n"
      "1772373600,500000000,map,d2,1,0,5,0,0,0,1\n"
      "1772373601,0,map,d1,0,0,5,0,0,0,1\n"
      "1772373601,500000000,map,,2,0,5,0,0,0,1\n";
  for (const std::string& table : {named, bare}) {
    const auto recording = recording_of(record(table));
    EXPECT_EQ(ids_of(recording), (Ids{"d1", "d2", "bees"})) << table;
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u) << table;
    EXPECT_TRUE(has_note(recording, "each child_frame_id is taken for a bee")) << table;
  }
  // Every robot may call itself so.
  const TemporaryFolder folder;
  const auto both = load_recording({folder.write("north.csv", kOdometry),  //
                                    folder.write("south.csv", kOdometry)},
                                   {});
  EXPECT_EQ(ids_of(recording_of(both)), (Ids{"north:base_link", "south:base_link"}));
}

TEST(RosTable, ChildrenOfSeveralFilesAreCalledByTheirNamesAlone) {
  const TemporaryFolder folder;
  std::string other(kOdometry);
  for (std::size_t at = 0; (at = other.find("map,base_link,", at)) != std::string::npos; ++at) {
    other.insert(at + 4, "r2/");
  }
  const std::string one = folder.write("one.csv", kOdometry);
  const std::string two = folder.write("two.csv", other);
  EXPECT_EQ(ids_of(recording_of(load_recording({one, two}))), (Ids{"base_link", "r2/base_link"}));
  const std::string same = folder.write("same.csv", kOdometry);
  EXPECT_EQ(ids_of(recording_of(load_recording({one, same}))),
            (Ids{"one:base_link", "same:base_link"}));
  EXPECT_EQ(ids_of(recording_of(load_recording({one, two, same}))),
            (Ids{"one:base_link", "two:r2/base_link", "same:base_link"}));
}

TEST(RosTable, AFrameIsNoId) {
  const auto recording = recording_of(record("frame_id,time_s,x_m,y_m,z_m\nmap,0,1,2,3\n"));
  EXPECT_EQ(ids_of(recording), Ids{"bees"});
}

// ---- Units that speeds contradict -------------------------------------------------------------

// 20 fixes that lie so far apart in time and space.
std::string flown(const std::string& time, double step, double metres, const std::string& speed) {
  std::string table = "id," + time + ",x_m,y_m,z_m" + (speed.empty() ? "" : ",vx,vy,vz") + "\n";
  for (int i = 0; i < 20; ++i) {
    table += "a," + std::to_string(i * step) + "," + std::to_string(i * metres) + ",0,5";
    table += (speed.empty() ? "" : "," + speed + ",0,0") + "\n";
  }
  return table;
}

TEST(TimeDoubts, VelocitiesContradictTheHeader) {
  expect_error(
      record(flown("time[ms]", 100'000, 0.5, "5")),
      {ErrorCode::kInvalidArgument, "bees.csv", "but their velocities say otherwise; in us"});
  expect_error(record(flown("time_s", 100, 0.5, "5")),
               {ErrorCode::kInvalidArgument, "bees.csv", "--time-unit ms or --time-unit s"});
  expect_error(record(flown("time_us", 100, 0.5, "5")),
               {ErrorCode::kInvalidArgument, "bees.csv", "--time-unit ms or --time-unit us"});
  for (const Unit unit : {Unit::kMillisecond, Unit::kMicrosecond}) {
    EXPECT_TRUE(record(flown("time[ms]", 100'000, 0.5, "5"), columns_are("", unit)));
  }
}

TEST(TimeDoubts, WhatMayBeIsNotAsked) {
  EXPECT_TRUE(record(flown("time[ms]", 100, 0.5, "5")));          // all is right
  EXPECT_TRUE(record(flown("time[ms]", 100'000, 0.5, "0.005")));  // it is as slow as it says
  EXPECT_TRUE(record(flown("time[ms]", 100, 0.5, "")));
  EXPECT_TRUE(record(flown("time[ms]", 100'000, 0, "")));  // stands
  EXPECT_TRUE(record(flown("time_s", 3600, 10, "")));      // a tortoise
  EXPECT_TRUE(record(flown("time[ms]", 10, 0.0001, "")));  // slow, but followed closely
  expect_error(record(flown("time[ms]", 100'000, 0.5, "")),
               {ErrorCode::kInvalidArgument, "bees.csv", "in us it would be 5 m/s, every 0.1 s"});
}

TEST(RosTable, OfPandasMayBeWithoutAFrameInItsHeader) {
  const auto recording = recording_of(
      record(",pose.position.x,pose.position.y,pose.position.z\n2025-06-15 15:06:40.001000,1,2,3\n"
             "2025-06-15 15:06:40.101000,1,2,3\n2025-06-15 15:06:40.201000,1,2,3\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes[0].position, (Point{1, 2, 3}));
  EXPECT_NEAR(recording.bees[0].fixes[1].time_s - recording.bees[0].fixes[0].time_s, 0.1, 1e-6);
  // Numbers of rows are no times.
  EXPECT_FALSE(record(",pose.position.x,pose.position.y,pose.position.z\n0,1,2,3\n1,1,2,3\n"));
}

TEST(TrajectoriesOfTum, MayHavePosesThatAreNotKnown) {
  std::string text;
  for (int i = 0; i < 40; ++i) {
    text += "175000000" + std::to_string(i / 10) + "." + std::to_string(i % 10) +
            (i >= 10 && i < 20 ? " nan nan nan nan nan nan nan\n"
                               : " " + std::to_string(1 + 0.1 * i) + " 2 3 0 0 0 1\n");
  }
  const auto recording = recording_of(record(text));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes.size(), 30u);
  EXPECT_TRUE(has_note(recording, "taken for a trajectory as of TUM"));
  EXPECT_TRUE(has_note(recording, "10 records without a place"));
}

}  // namespace
}  // namespace beespace::io
