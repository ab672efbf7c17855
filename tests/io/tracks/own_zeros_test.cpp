// What each vehicle counts from a zero of its own: its clock, its origin, the height of its
// take-off. Several of them are compared only by what they have in common.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Texts = std::vector<std::string>;

RecordingOptions in_frame(Frame frame, RecordingOptions options = {}) {
  options.frame = frame;
  return options;
}

Result<Recording> several(const Texts& texts, const RecordingOptions& options = {}) {
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  for (const std::string& text : texts) {
    paths.push_back(folder.write(std::to_string(paths.size()) + ".csv", text));
  }
  return load_recording(paths, options);
}

void expect_problem(const Result<Recording>& loaded, std::string_view part) {
  ASSERT_FALSE(loaded);
  EXPECT_NE(loaded.error().message.find(part), std::string::npos) << loaded.error().message;
}

// ---- Heights ------------------------------------------------------------------------------------

std::string relative(const std::string& name, const std::string& latitude) {
  return "timestamp_s,lat,lon," + name + "\n1700000000," + latitude + ",8.5,1\n1700000001," +
         latitude + ",8.5,2\n";
}

TEST(OwnGround, HeightsAboveIt) {
  for (const std::string name : {"relative_alt_m", "altitudeRelative", "rel_alt",
                                 "height_above_takeoff_m", "alt_agl_m", "agl"}) {
    expect_problem(several({relative(name, "47.3"), relative(name, "47.4")}),
                   "counts from where each one took off, or from the ground, so that heights of "
                   "several cannot be compared; take heights above sea level, or, if all took off "
                   "at one height, say --columns lon=3,lat=2,height=4 --crs wgs84");
    const RecordingOptions named = columns_are("lon=3,lat=2,height=4", Unit::kUnstated);
    expect_problem(several({relative(name, "47.3"), relative(name, "47.4")}, named),
                   "those of several cannot be compared");
    const auto said =
        several({relative(name, "47.3"), relative(name, "47.4")}, in_frame(Frame::kWgs84, named));
    EXPECT_EQ(recording_of(said).heights, HeightDatum::kHome);
    EXPECT_TRUE(several({relative(name, "47.3")}, named));
  }
}

TEST(OwnGround, HeightsThatAreNotAboveIt) {
  for (const std::string name : {"alt_m", "altitude", "reliable_altitude_m"}) {
    const auto loaded = several({relative(name, "47.3"), relative(name, "47.4")},
                                columns_are("lon=3,lat=2,height=4", Unit::kUnstated));
    EXPECT_TRUE(loaded) << loaded.error().message;
  }
}

// ---- QGroundControl -----------------------------------------------------------------------------

TEST(QGroundControl, AltitudesAreAboveSeaLevelInTheUnitOfItsSettings) {
  const std::string table =
      "Timestamp,roll,groundSpeed,altitudeRelative,altitudeAMSL,gps.lat,gps.lon\n"
      "2024-05-21 14:00:00.000,0.1,2.0,0.0,488.0,47.397742,8.545594\n"
      "2024-05-21 14:00:00.100,0.1,2.0,0.1,488.1,47.397742,8.545594\n";
  expect_problem(record(table),
                 "column 5 'altitudeAMSL' holds the height, but in which unit? QGroundControl "
                 "writes it as its settings say, where it may be ft or m");
  RecordingOptions options;
  options.units.height = Unit::kFoot;
  const Recording recording = recording_of(record(table, options));
  EXPECT_EQ(recording.heights, HeightDatum::kMeanSeaLevel);
  EXPECT_NEAR(recording.bees[0].fixes[0].position.z, 488.0 * 0.3048, 1e-9);
  EXPECT_EQ(recording.bees[0].fixes[0].position.y, 47.397742);
}

// ---- PX4's local positions ----------------------------------------------------------------------

std::string local(const std::string& latitude, const std::string& north, const std::string& down,
                  const std::string& is_global = "1",
                  const std::string& first = "1700000000000000") {
  const std::string header =
      "timestamp,timestamp_sample,ref_timestamp,ref_lat,ref_lon,x,y,z,vx,vy,vz,ref_alt,xy_valid,"
      "xy_global,z_global\n";
  const std::string behind = ",0,0," + latitude + ",8.5," + north + ",30," + down +
                             ",1,2,-3,488.5,1," + is_global + ",1\n";
  std::string second = first;
  second[8] = '1';
  return header + first + behind + second + behind;
}

TEST(LocalPositions, AreBroughtToDegreesFromTheOriginOfEach) {
  const Recording recording =
      recording_of(several({local("47.3", "0", "-10"), local("47.3001", "100", "-20")}));
  ASSERT_EQ(recording.bees.size(), 2u);
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.heights, HeightDatum::kMeanSeaLevel);
  EXPECT_TRUE(recording.since_1970);
  const Point one = recording.bees[0].fixes[0].position;
  EXPECT_NEAR(one.y, 47.3, 1e-7);
  EXPECT_NEAR(one.x, 8.5 + 30.0 / 111'194.9 / 0.678160, 1e-7);
  EXPECT_DOUBLE_EQ(one.z, 498.5);
  const Point other = recording.bees[1].fixes[0].position;
  EXPECT_NEAR(other.y, 47.3001 + 100.0 / 111'194.9, 1e-7);
  EXPECT_DOUBLE_EQ(other.z, 508.5);
  // To the east, north and up.
  const Velocity velocity = recording.bees[0].velocities[0];
  EXPECT_EQ(velocity.x, 2.0);
  EXPECT_EQ(velocity.y, 1.0);
  EXPECT_EQ(velocity.z, 3.0);
}

TEST(LocalPositions, WithoutAnOriginAreNone) {
  const Recording recording =
      recording_of(several({local("47.3", "0", "-10"), local("47.3001", "100", "-20", "0")}));
  EXPECT_GE(recording.missing.count, 2u);
  expect_problem(record(local("47.3", "0", "-10", "0")), "--crs metres takes all as counted from");
  EXPECT_EQ(recording_of(record(local("47.3", "0", "-10"), in_frame(Frame::kMetres))).frame,
            Frame::kMetres);
}

TEST(LocalPositions, ThatADroneSaysNotToKnowAreLeftOut) {
  for (const std::string known : {"0,1", "1,0", "False,True"}) {
    for (const std::string names : {"time_s,lon,lat,alt_m,lat_lon_valid,alt_valid\n",
                                    "time_s,x_m,y_m,z_m,xy_valid,z_valid\n"}) {
      const Recording recording = recording_of(
          record(names + "1700000000,8.5,47.3,400," + known + "\n1700000001,8.5,47.3,400,1,1\n"));
      EXPECT_EQ(recording.missing.count, 1u) << names << known;
      EXPECT_EQ(recording.bees[0].fixes.size(), 1u);
      EXPECT_TRUE(has_note(recording, "in which a drone says itself that it does not know its "));
    }
  }
  // Of heights that are not read nothing needs to be known.
  const Recording flat =
      recording_of(record("time_s,x_m,y_m,xy_valid,z_valid,v_xy_valid\n1,1,2,1,0,0\n",
                          columns_are("time=1,x=2,y=3", Unit::kUnstated)));
  EXPECT_EQ(flat.missing.count, 0u);
}

TEST(LocalPositions, WithTimesSinceEachWasSwitchedOnAreRefused) {
  const std::string boot = "0000000050000000";
  expect_problem(
      several({local("47.3", "0", "-10", "1", boot), local("47.3001", "100", "-20", "1", boot)}),
      "may be counted from a zero of each vehicle's own");
}

// ---- ROS ----------------------------------------------------------------------------------------

std::string odometry(const std::string& recorded, const std::string& stamp,
                     const std::string& child) {
  std::string text =
      "Time,header.seq,header.stamp.secs,header.stamp.nsecs,header.frame_id,child_frame_id,"
      "pose.pose.position.x,pose.pose.position.y,pose.pose.position.z\n";
  for (const std::string digit : {"1", "2", "3"}) {
    text += recorded + digit + ".5,1," + stamp + digit + ",250000000,map," + child + ",1,2,3\n";
  }
  return text;
}

TEST(StampsOfRos, ThatCountFromARobotsOwnZeroAreNotTaken) {
  const Recording recording =
      recording_of(several({odometry("170000000", "1", "a"), odometry("170000000", "3", "b")}));
  ASSERT_EQ(recording.bees.size(), 2u);
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(times_of(recording.bees[1])[0], 1700000001.5);
  EXPECT_TRUE(has_note(recording,
                       "the stamps of the header do not count from 1970: times are "
                       "those of recording, column 1 'Time'"));
}

TEST(StampsOfRos, OfClocksThatDifferAreRefused) {
  const Texts texts = {odometry("170000000", "170000000", "a"),
                       odometry("170000000", "170000001", "b")};
  expect_problem(several(texts), "the stamps of the header here are 10.000 s later than those of ");
  const Recording recording = recording_of(several(texts, columns_are("time=1", Unit::kUnstated)));
  EXPECT_EQ(times_of(recording.bees[0]), times_of(recording.bees[1]));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(several({texts[0], odometry("170000000", "170000000", "b")}));
}

// Without a time of the bag.
std::string stamped(const std::string& first, const std::string& second) {
  return "header.stamp.secs,header.stamp.nsecs,header.frame_id,pose.position.x,pose.position.y,"
         "pose.position.z\n" +
         first + ",0,map,1,2,3\n" + second + ",0,map,2,2,3\n";
}

TEST(StampsOfRos, ThatDoNotCountFrom1970AreAskedAbout) {
  const Texts texts = {stamped("0", "1"), stamped("0", "2")};
  expect_problem(several(texts), "if all have one clock, say so with --one-clock");
  EXPECT_TRUE(several(texts, on_one_clock()));
  EXPECT_TRUE(record(texts[0]));
}

TEST(StampsOfRos, AreLookedAtWhateverColumnsAreNamed) {
  for (const std::string columns : {"time=1,x=4,y=5,z=6", "x=pose.position.x,y=pose.position.y"}) {
    const RecordingOptions named = columns_are(columns, Unit::kUnstated);
    expect_problem(several({stamped("0", "1"), stamped("0", "2")}, named),
                   "may be counted from a zero of each vehicle's own");
    EXPECT_TRUE(
        several({stamped("1700000000", "1700000001"), stamped("1700000000", "1700000001")}, named));
    std::string other = stamped("1700000000", "1700000001");
    other.replace(other.find(",map,"), 5, ",hall,");
    expect_problem(several({stamped("1700000000", "1700000001"), other}, named), "'hall'");
  }
  expect_problem(
      several({odometry("170000000", "170000000", "a"), odometry("170000000", "170000001", "b")},
              columns_are("time=3,x=7,y=8,z=9", Unit::kUnstated)),
      "the stamps of the header here are 10.000 s later than those of ");
}

TEST(StampsOfRos, AreTheRowsOfPandas) {
  const Recording recording =
      recording_of(record(",header.frame_id,pose.position.x,pose.position.y,pose.position.z\n"
                          "1700000000250000000,world,1,2,3\n1700000001250000000,world,4,5,6\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_NEAR(times_of(recording.bees[0])[0], 1700000000.25, 1e-6);
  EXPECT_EQ(recording.frame, Frame::kMetres);
}

TEST(MessagesOfRos, WithoutAHeaderOfReceiversAndPoints) {
  const std::string behind = ",0.5,0,0,0,0.5,0,0,0,1.2,2\n";
  const Recording receivers =
      recording_of(several({"1700000000,250000000,gps_0,0,1,47.39,8.53,489.4" + behind +
                                "1700000001,250000000,gps_0,-1,1,47.39,8.53,489.4" + behind,
                            "1700000000,250000000,gps_1,0,1,47.39,8.54,489.6" + behind}));
  ASSERT_EQ(receivers.bees.size(), 2u);
  EXPECT_EQ(receivers.frame, Frame::kWgs84);
  EXPECT_EQ(receivers.bees[0].fixes.size(), 1u);  // the other one is none
  EXPECT_EQ(receivers.bees[0].fixes[0].time_s, 1700000000.25);
  EXPECT_EQ(receivers.bees[1].fixes[0].position, (Point{8.54, 47.39, 489.6}));
  const std::string point = "1700000000,250000000,world,1,2,3\n";
  const Recording points = recording_of(several({point, point}));
  ASSERT_EQ(points.bees.size(), 2u);
  EXPECT_EQ(points.frame, Frame::kMetres);
  EXPECT_EQ(points.bees[1].fixes[0].position, (Point{1, 2, 3}));
}

// ---- Trajectories as of TUM ---------------------------------------------------------------------

TEST(Trajectories, ThatEachBeginAtZeroAreAskedAbout) {
  const std::string own = "1700000000.0 0 0 0 0 0 0 1\n1700000001.0 1 0 0 0 0 0 1\n";
  const std::string placed = "1700000000.0 5 0 0 0 0 0 1\n1700000001.0 6 0 0 0 0 0 1\n";
  expect_problem(several({own, own}), "begin at 0, 0, 0, or within 0.1 m of it, as if each");
  EXPECT_TRUE(several({own, own}, in_frame(Frame::kMetres)));
  const std::string noisy = "1700000000.0 0.03 -0.02 0.01 0 0.001 0 0.999\n";
  expect_problem(several({own, noisy}), "begin at 0, 0, 0, or within 0.1 m of it");
  const Recording recording = recording_of(several({own, placed}));
  EXPECT_EQ(recording.frame_reason, "trajectories as of TUM are in metres");
  EXPECT_TRUE(has_note(recording, "in seconds, since 1970, as their size tells"));
}

// ---- Plain tables, a file a robot ---------------------------------------------------------------

TEST(PlainTables, ThatEachBeginAtTimeZeroAreAskedAbout) {
  const auto table = [](const std::string& time, const std::string& first) {
    return time + ",x_m,y_m,z_m\n" + first + ",1,2,3\n9,2,2,3\n";
  };
  for (const std::string time : {"time_s", "t_ms"}) {
    const std::string zero = table(time, "0.00");
    expect_problem(several({zero, table(time, "1"), zero}), "0.csv both begin at 0, and may be");
    expect_problem(several({zero, zero}), "if all have one clock, say so with --one-clock");
    EXPECT_TRUE(several({zero, zero}, on_one_clock()));
    EXPECT_TRUE(several({zero, table(time, "1")}));
  }
  // What is a plan has one clock.
  // Some programs write no colours; the header is that of Skybrush, all the same.
  for (const char* const header : {"Time [msec],x [m],y [m],z [m]\n", "Time_msec,x_m,y_m,z_m\n"}) {
    const std::string bare = std::string(header) + "0,1,2,3\n99,1,2,3\n";
    EXPECT_TRUE(recording_of(several({bare, bare})).show);
  }
  const std::string show = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n0,1,2,3,0,0,0\n99,1,2,3,0,0,0\n";
  EXPECT_TRUE(several({show, show}));
  const std::string colour = "time_s,x_m,y_m,z_m,color\n0,1,2,3,#000000\n1,1,2,3,#ff8000\n";
  EXPECT_TRUE(several({colour, colour}));
  const std::string dated = "time,x_m,y_m,z_m\n00:00:00,1,2,3\n00:00:01,1,2,3\n";
  EXPECT_TRUE(several({dated, dated}));
}

TEST(PlainTables, WithIdsThatEachBeginAtTimeZeroAreAskedAbout) {
  const std::string named = "id,time_s,x_m,y_m,z_m\n";
  const std::string first = named + "a,0,1,2,3\na,1,1,2,3\n";
  const std::string second = named + "b,0.0,4,5,6\nb,1,4,5,6\n";
  const std::string question =
      "0.csv both begin at 0, and may be counted from a zero of each file's own, as of several "
      "trials: then they cannot be compared; read the files each for itself, give times since "
      "1970, or, if all have one clock, say so with --one-clock";
  expect_problem(several({first, second}), question);
  expect_problem(several({first, named + "c,1,4,5,6\n", second}), question);
  EXPECT_EQ(recording_of(several({first, second}, on_one_clock())).bees.size(), 2u);
  // One goes on where the other ends, or is of the same moment by a clock that runs on.
  EXPECT_TRUE(several({first, named + "a,2,1,2,3\nb,2,4,5,6\n"}));
  // A file a vehicle, beside one of several: whose zero it is is not known either.
  expect_problem(several({first, "time_s,x_m,y_m,z_m\n0,4,5,6\n1,4,5,6\n"}), question);
  const std::string dated = "id,time,x_m,y_m,z_m\n";
  EXPECT_TRUE(several(
      {dated + "a,2024-05-01T00:00:00Z,1,2,3\n", dated + "b,2024-05-01T00:00:00Z,4,5,6\n"}));
}

// ---- Names of files -----------------------------------------------------------------------------

TEST(FilesOfOneName, AreCalledByWhatDiffersInTheirPaths) {
  const TemporaryFolder folder;
  std::vector<std::string> paths;
  const std::string table = "time_s,x_m,y_m,z_m\n1,1,2,3\n2,1,2,3\n";
  for (const std::string name : {"MAV0", "MAV1"}) {
    std::filesystem::create_directories(folder.file(name + "/state"));
    paths.push_back(folder.write(name + "/state/data.csv", table));
  }
  paths.push_back(folder.write("other.csv", table));
  EXPECT_EQ(ids_of(recording_of(load_recording(paths))), (Texts{"MAV0", "MAV1", "other"}));
  const std::string archive = zipped({{"a/log.csv", table}, {"b/log.csv", table}});
  EXPECT_EQ(ids_of(recording_of(load_recording_from_memory(archive, "logs.zip"))),
            (Texts{"a", "b"}));
}

// ---- Shows --------------------------------------------------------------------------------------

TEST(SkybrushCsv, WhoseTimesMayCountPicturesAreAskedAbout) {
  const std::string frames = "0,0,0,5,1,2,3\n1,0,1,5,1,2,3\n2,0,2,5,1,2,3\n";
  expect_problem(record(frames), "say --fps 24 for so many pictures a second");
  RecordingOptions options;
  options.frames_per_second = 2.0;
  EXPECT_EQ(times_of(recording_of(record(frames, options)).bees[0]).back(), 1.0);
  options.time_unit = Unit::kSecond;
  expect_problem(record(frames, options), "leave one of them out");
  options.frames_per_second.reset();
  EXPECT_EQ(times_of(recording_of(record(frames, options)).bees[0]).back(), 2.0);
}

TEST(OneTable, OfSeveralVehiclesThatCountFromWhenTheyWereSwitchedOnIsAskedAbout) {
  const std::string table =
      "sysid,time_boot_ms,x,y,z\n1,60000,0,0,5\n1,61000,1,0,5\n2,65000,0,1,5\n2,66000,1,1,5\n";
  const auto refused = several({table});
  expect_problem(refused, "say so with --one-clock");
  EXPECT_EQ(refused.error().location.line, 4U);
  expect_problem(several({table}, columns_are("", Unit::kMillisecond)), "say so with --one-clock");
  EXPECT_TRUE(several({table}, on_one_clock()));
}

// The answer to which unit is none to which zero.
TEST(OwnClocks, TheUnitThatTheCallerAloneSaysIsNoWordOfTheZero) {
  const auto begins = [](const std::string& time) {
    return "timestamp,x_m,y_m,z_m\n" + time + ",0,0,1\n" + time + "9,1,0,1\n";
  };
  RecordingOptions options;
  options.time_unit = Unit::kMicrosecond;
  for (const std::string first : {"0", "37000"}) {
    expect_problem(several({begins(first), begins("905000")}, options), "say so with --one-clock");
    RecordingOptions one_clock = options;
    one_clock.one_clock = true;
    EXPECT_TRUE(several({begins(first), begins("905000")}, one_clock));
    EXPECT_TRUE(several({begins(first)}, options));
  }
}

// ---- Times of several files ---------------------------------------------------------------------

std::string plain_from(double first_s, int fixes = 30) {
  std::string text = "time_s,x_m,y_m\n";
  for (int i = 0; i < fixes; ++i) {
    text += std::to_string(first_s + i) + "," + std::to_string(i) + ",0\n";
  }
  return text;
}

// Who begins at another time than the others may have been switched on then.
TEST(PlainTables, ThatAreTakenForOneClockAreSaidToBe) {
  const auto taken = recording_of(several({plain_from(35.2), plain_from(41.75)}));
  EXPECT_TRUE(has_note(taken,
                       "the times of these 2 files are taken for one clock (they begin at 35.2 and "
                       "41.75 s)"));
  EXPECT_TRUE(has_note(taken,
                       "as by awk -F',' -v OFS=',' -v behind=SECONDS "
                       "'NR>1{$1=sprintf(\"%.6f\",$1+behind)}1' FILE > set.csv"));
  const auto none = [](const Result<Recording>& loaded) {
    return !has_note(recording_of(loaded), "are taken for one clock");
  };
  EXPECT_TRUE(none(several({plain_from(35.2), plain_from(41.75)}, on_one_clock())));
  EXPECT_TRUE(none(several({plain_from(35.2), plain_from(35.3)})));    // as of one simulation
  EXPECT_TRUE(none(several({plain_from(35.2), plain_from(1035.2)})));  // one after the other
  EXPECT_TRUE(none(several({plain_from(1.7e9), plain_from(1.7e9 + 6)})));
  EXPECT_TRUE(none(several({plain_from(35.2)})));
}

// ---- Ids, and places of each vehicle's own ------------------------------------------------------

TEST(OneTable, OfCrazyfliesIsToldApartByTheirAddresses) {
  std::string text = "timestamp,uri,stateEstimate.x,stateEstimate.y,stateEstimate.z\n";
  for (const std::string radio : {"radio://0/80/2M/E7E7E7E7E1", "radio://0/80/2M/E7E7E7E7E2"}) {
    text += "12345," + radio + ",1,2,3\n12445," + radio + ",1.5,2,3\n";
  }
  expect_problem(record(text), "but here are several ('radio://0/80/2M/E7E7E7E7E1', 'radio://0");
  EXPECT_EQ(recording_of(record(text, on_one_clock())).bees.size(), 2u);
}

TEST(OneTable, OfRigidBodiesHasTheirNames) {
  std::string text = "ros_time,rigid_body,px,py,pz,qx,qy,qz,qw\n";
  for (const std::string time : {"1777629600.0", "1777629600.1", "1777629600.2"}) {
    text += time + ",cf1,1,2,3,0,0,0,1\n" + time + ",cf2,4,5,6,0,0,0,1\n";
  }
  for (const std::string columns : {"", "id=2"}) {
    const auto recording = recording_of(record(text, columns_are(columns, Unit::kUnstated)));
    ASSERT_EQ(ids_of(recording), (std::vector<std::string>{"cf1", "cf2"}));
    EXPECT_EQ(recording.bees[1].fixes[0].position, (Point{4, 5, 6}));
  }
}

TEST(Airsim, CountsPlacesFromWhereEachBeganAndDownward) {
  const std::string header =
      "VehicleName\tTimeStamp\tPOS_X\tPOS_Y\tPOS_Z\tQ_W\tQ_X\tQ_Y\tQ_Z\tImageFile\n";
  const std::string one = header +
                          "Drone1\t1777629600000\t1\t2\t-3\t1\t0\t0\t0\t\n"
                          "Drone1\t1777629600100\t1.5\t2\t-3\t1\t0\t0\t0\t\n";
  const std::string two = one + "Drone2\t1777629600100\t7\t8\t-9\t1\t0\t0\t0\t\n";
  expect_problem(record(two),
                 "AirSim counts the places of each vehicle from where it began, and here are "
                 "several ('Drone1', 'Drone2')");
  expect_problem(record(two),
                 "OFS='\\t' '$1==\"Drone1\"{$3+=<X>;$4+=<Y>;$5+=<Z>}$1==\"Drone2\"{$3+=<X>;$4+=<Y>;"
                 "$5+=<Z>}1' FILE > common.txt, with these numbers for <X>, <Y> and <Z>");
  const auto said = recording_of(record(two, in_frame(Frame::kMetres)));
  ASSERT_EQ(ids_of(said), (std::vector<std::string>{"Drone1", "Drone2"}));
  EXPECT_EQ(said.bees[0].fixes[0].position, (Point{2, 1, 3}));
  EXPECT_EQ(said.bees[1].fixes[0].position, (Point{8, 7, 9}));
  EXPECT_TRUE(has_note(said, "x is east, y north and z up here"));
  EXPECT_EQ(recording_of(record(one)).bees.size(), 1u);
}

}  // namespace
}  // namespace beespace::io
