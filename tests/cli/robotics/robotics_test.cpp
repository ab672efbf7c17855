// What robots and their tools write, by the first command that somebody would type. The files are
// made by the tools' own writers (see make-files): two fly towards each other and meet after 20 s.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr double kStarted_s = 1772373600.0;  // 2026-03-01T14:00:00Z

std::string made(const std::string& name) {
  return std::string(BEESPACE_ROBOT_FILES) + "/" + name;
}

std::string content_of(const std::string& name) {
  std::ifstream file(made(name), std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

void expect_no_part(const std::string& text, std::string_view part) {
  EXPECT_EQ(text.find(part), std::string::npos) << text;
}

// At 4 m/s each and 3 m above each other: closer than 5 m for a second.
void expect_the_meeting(const Finished& finished, const std::string& names) {
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.out << finished.err;
  EXPECT_EQ(rows[1].at(0) + " " + rows[1].at(1), names);
  EXPECT_NEAR(std::stod(rows[1].at(2)), kStarted_s + 19.5, 0.01);
  EXPECT_NEAR(std::stod(rows[1].at(3)), kStarted_s + 20, 0.01);
  EXPECT_NEAR(std::stod(rows[1].at(5)), kStarted_s + 20.5, 0.01);
  EXPECT_NEAR(std::stod(rows[1].at(4)), 3, 0.01);
}

TEST(Robotics, TwoLogsOfPx4AreTwoDronesOnOneClock) {
  const Finished finished =
      run({"replay", made("north.ulg"), made("south.ulg"), "--threshold", "5", "--csv"});
  expect_the_meeting(finished, "north south");
  expect_parts(finished.err, {"PX4 log (ULog)", "heights above mean sea level",
                              "the clocks of 2 logs are set by GPS, each by 81 times or more"});
}

TEST(Robotics, TwoLogsOfArduPilotAreTwoDronesOnOneClock) {
  const Finished finished =
      run({"replay", made("north.bin"), made("south.bin"), "--threshold", "5", "--csv"});
  expect_the_meeting(finished, "north south");
  expect_parts(finished.err, {"DataFlash log of ArduPilot", "heights above mean sea level",
                              "the clocks of 2 logs are set by GPS, each by 81 times or more",
                              "say that they have landed stand on the ground"});
}

// Logs count heights above the sea, and a limit is meant above the ground.
TEST(Robotics, ALimitOfHeightThatNoGroundCanKeepIsAskedAbout) {
  const Arguments verify = {"verify", made("north.bin"), made("south.bin"), "--threshold", "2"};
  const Finished asked = run(verify + Arguments{"--max-height", "120"});
  EXPECT_EQ(asked.exit_code, 2);
  expect_parts(asked.err, {"heights here count above mean sea level, and none is below 400 m",
                           "for 120 m above that say --max-height 520m"});
  EXPECT_EQ(run(verify + Arguments{"--max-height", "520m"}).exit_code, 0);
  EXPECT_EQ(run(verify + Arguments{"--max-height", "502m"}).exit_code, 1);
}

TEST(Robotics, ALocalPositionIsWhereTheGlobalOneIs) {
  TemporaryFolder folder;
  // Without global positions, whose topic gets a name that is not known.
  for (const std::string name : {"north.ulg", "south.ulg"}) {
    std::string log = content_of(name);
    for (std::size_t at = 0; (at = log.find("vehicle_global_position", at)) != std::string::npos;) {
      log.replace(at, 14, "unknown_global");
    }
    folder.file(name, log);
  }
  const Finished finished = run(
      {"replay", folder.path("north.ulg"), folder.path("south.ulg"), "--threshold", "5", "--csv"});
  expect_the_meeting(finished, "north south");
  expect_parts(finished.err, {"vehicle_local_position, brought to longitude and latitude"});
}

TEST(Robotics, LogsOfPx4CompressedAndFromStandardInput) {
  TemporaryFolder folder;
  const Finished one = run({"replay", "-", "--threshold", "5"}, content_of("north.ulg"));
  EXPECT_EQ(one.exit_code, 0) << one.err;
  expect_parts(one.err, {"bees       1"});
  const Finished predicted =
      run({"predict", made("north.ulg"), made("south.ulg"), "--threshold", "5"});
  EXPECT_EQ(predicted.exit_code, 0) << predicted.err;
  expect_parts(predicted.err, {"none", "2026-03-01"});
}

TEST(Robotics, ATelemetryLogIsReadByItself) {
  const Finished finished = run({"replay", made("both.tlog"), "--threshold", "5", "--csv"});
  expect_the_meeting(finished, "1 2");
}

TEST(Robotics, ATelemetryLogIsWatched) {
  const Arguments options = {"--threshold", "5", "--horizon", "0"};
  const Finished file = run(Arguments{"watch", made("both.tlog")} + options);
  EXPECT_EQ(file.exit_code, 0) << file.err;
  expect_parts(file.out, {R"("event": "entered")", R"("event": "left")", R"("first": "1")"});
  expect_parts(file.err, {"MAVLink telemetry", "above mean sea level"});
  const Finished piped = run(Arguments{"watch"} + options, content_of("both.tlog"));
  EXPECT_EQ(piped.out, file.out) << piped.err;
}

TEST(Robotics, ATelemetryLogHasOneDefaultThreshold) {
  const std::string threshold = "threshold  5 m (closer than), the default of logs of drones";
  expect_parts(run({"replay", made("both.tlog")}).err, {threshold});
  const Finished watched = run({"watch", made("both.tlog"), "--horizon", "0"});
  expect_parts(watched.err, {threshold});
  EXPECT_EQ(watched.out,
            run({"watch", made("both.tlog"), "--horizon", "0", "--threshold", "5"}).out);
  expect_parts(run({"watch", made("both.tlog"), "--threshold", "7"}).err,
               {"threshold  7 m (closer than)\n"});
}

// The frames of a log, as they come over the air: without the eight bytes of a time before each.
std::string stream_of(const std::string& log) {
  std::string stream;
  for (std::size_t at = 0; at + 8 < log.size();) {
    const auto magic = static_cast<unsigned char>(log[at + 8]);
    const std::size_t beside = magic == 0xFD ? 12 : 8;
    const std::size_t size = beside + static_cast<unsigned char>(log[at + 9]);
    stream += log.substr(at + 8, size);
    at += 8 + size;
  }
  return stream;
}

TEST(MavlinkOverTheAir, IsWatchedByTheTimeOfArrival) {
  const std::string stream = stream_of(content_of("both.tlog"));
  const Finished watched = run({"watch", "--clock", "arrival", "--threshold", "5"}, stream);
  expect_parts(watched.err, {"MAVLink telemetry"});
  EXPECT_EQ(watched.err.find("no frame of MAVLink"), std::string::npos) << watched.err;
  EXPECT_NE(watched.exit_code, 3);
  const Finished unasked = run({"watch", "--threshold", "5"}, stream);
  EXPECT_EQ(unasked.exit_code, 3);
  expect_parts(unasked.err, {"a stream of MAVLink without the times of a log", "--clock arrival"});
  const TemporaryFolder folder;
  const std::string file = folder.file("raw.mav", stream);
  const Finished of_file = run({"watch", file, "--threshold", "5"});
  EXPECT_EQ(of_file.exit_code, 3);
  expect_parts(of_file.err, {"name the .tlog beside it"});
  EXPECT_EQ(of_file.err.find("no text"), std::string::npos) << of_file.err;
}

// Drone 2 tells no position but that of its satellites; 3 one for unmanned traffic, and a receiver
// hears of an aircraft. None of the ground station and the devices is missed.
TEST(Robotics, PositionsByOtherMessagesOfMavlinkAreRead) {
  const Finished finished = run({"replay", made("ground.tlog"), "--threshold", "5", "--report",
                                 "bees", "--csv", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 5u) << finished.out;
  expect_parts(finished.out, {"abc012", "SWR12"});
  expect_parts(finished.err, {"message 24 (GPS_RAW_INT): 2", "message 340 (UTM_GLOBAL_POSITION): 3",
                              "1 conflict of 1 pair", "2.000 m apart at 2026-03-01T14:00:05.000Z"});
  expect_no_part(finished.err, "left out");
  const Finished apart = run({"replay", made("ground.tlog"), "--threshold", "1", "--fail-on-risk"});
  EXPECT_EQ(apart.exit_code, 0) << apart.err;
}

TEST(Robotics, AVehicleThatTellsNoPositionIsKnownNowhere) {
  for (const Arguments& command : {Arguments{"replay", "--fail-on-risk"}, Arguments{"verify"}}) {
    const Finished finished =
        run(command + Arguments{made("others.tlog"), "--threshold", "1", "--json"});
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.out, {R"("complete": false)", R"("known_nowhere": ["4"])"});
  }
}

// Two drones with one id, one of which meets a third: as from the factory.
TEST(Robotics, TwoBeesUnderOneIdAreNoAllClear) {
  TemporaryFolder folder;
  std::string table = "time_s,id,x,y,z\n";
  std::string lines;
  for (int i = 0; i < 100; ++i) {
    const double t = 0.05 * i;
    const auto add = [&](const std::string& id, double x, double y) {
      const std::string at = std::to_string(t);
      table += at + "," + id + "," + std::to_string(x) + "," + std::to_string(y) + ",10\n";
      lines += R"({"id": ")" + id + R"(", "time_s": )" + at + R"(, "x": )" + std::to_string(x) +
               R"(, "y": )" + std::to_string(y) + R"(, "z": 10})" + "\n";
    };
    add("alone", 0, 300);
    add("twice", i % 2 == 0 ? 5 * t : 40 - 5 * t, i % 2);
  }
  folder.file("bees.csv", table);
  folder.file("bees.ndjson", lines);
  for (const Arguments& command : {Arguments{"replay", "--fail-on-risk"}, Arguments{"verify"}}) {
    const Finished finished = run(command + Arguments{folder.path("bees.csv"), "--crs", "metres",
                                                      "--threshold", "2", "--json"});
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.out, {R"("complete": false)", R"("shared_ids": ["twice"])"});
  }
  const Finished watched = run({"watch", folder.path("bees.ndjson"), "--crs", "metres",
                                "--threshold", "2", "--horizon", "0", "--fail-on-risk"});
  EXPECT_EQ(watched.exit_code, 1) << watched.err;
  expect_parts(watched.err, {"twice is at two places in turn", "1 id seems to be of two bees"});
}

TEST(Robotics, VehiclesAreWatchedThatTellOtherPositionsOrNone) {
  const Arguments options = {"--threshold", "5", "--horizon", "0", "--fail-on-risk"};
  const Finished meeting = run(Arguments{"watch", made("ground.tlog")} + options);
  EXPECT_EQ(meeting.exit_code, 1) << meeting.err;
  expect_parts(meeting.out, {R"("event": "entered")", R"("first": "1")", R"("second": "2")"});
  expect_parts(meeting.err, {"message 340 (UTM_GLOBAL_POSITION)", "bees       4 heard of"});
  expect_no_part(meeting.err, "known nowhere");
  const Arguments closer = {"--threshold", "1", "--horizon", "0", "--fail-on-risk"};
  EXPECT_EQ(run(Arguments{"watch", made("ground.tlog")} + closer).exit_code, 0);
  const Finished unknown = run(Arguments{"watch", made("others.tlog")} + closer);
  EXPECT_EQ(unknown.exit_code, 1) << unknown.err;
  expect_parts(unknown.err, {"1 bee is known nowhere", "are left out: 4"});
  const Finished local = run(Arguments{"watch", made("others.tlog"), "--crs", "metres"} + closer);
  EXPECT_EQ(local.exit_code, 3) << local.err;
}

TEST(Robotics, WhatIsCompressedIsWatchedAsItComes) {
  const Arguments options = {"--threshold", "5", "--horizon", "0"};
  const Finished plain = run(Arguments{"watch", made("both.tlog")} + options);
  const Finished packed = run(Arguments{"watch", made("both.tlog.gz")} + options);
  EXPECT_EQ(packed.exit_code, 0) << packed.err;
  EXPECT_EQ(packed.out, plain.out);
  const std::string bytes = content_of("both.tlog.gz");
  EXPECT_EQ(run(Arguments{"watch"} + options, bytes).out, plain.out);
  const Finished cut = run(Arguments{"watch"} + options, bytes.substr(0, bytes.size() / 2));
  EXPECT_EQ(cut.exit_code, 3);
  expect_parts(cut.err, {"the gzip data ends too early"});
  // Reports that came whole are known at once, while more is awaited.
  Running running(Arguments{"watch"} + options);
  running.send(bytes.substr(0, bytes.size() - 20));
  EXPECT_NE(running.read_line().find("entered"), std::string::npos);
  running.send(bytes.substr(bytes.size() - 20));
  running.close_input();
  EXPECT_EQ(running.finish().exit_code, 0);
}

TEST(Robotics, LocalPositionsAreWatchedWhereMetresAreAskedFor) {
  const Finished finished = run({"watch", made("both.tlog"), "--crs", "metres"});
  EXPECT_EQ(finished.exit_code, 3) << finished.err;
  expect_parts(finished.err, {"LOCAL_POSITION_NED"});
}

TEST(Robotics, DamagedTelemetryIsWatchedAndCounted) {
  std::string log = content_of("both.tlog");
  log.insert(1000, "no frame at all");
  log.resize(log.size() - 10);  // cut short, which is no mistake
  const Finished finished = run({"watch", "--threshold", "5", "--horizon", "0"}, log);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out, {R"("event": "entered")"});
  expect_parts(finished.err, {"no frame of MAVLink, or a damaged one", "bad lines  1 left out"});
}

TEST(Robotics, TablesOfPosesFromABag) {
  const Finished finished =
      run({"replay", made("poses.csv"), "--crs", "metres", "--threshold", "1", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.out << finished.err;
  EXPECT_EQ(rows[1].at(0) + rows[1].at(1), "/north/pose/south/pose");
  EXPECT_NEAR(std::stod(rows[1].at(3)), kStarted_s + 20, 0.01);
  EXPECT_NEAR(std::stod(rows[1].at(4)), 0.3, 1e-6);
}

TEST(Robotics, TablesAsRos2EchoesThemHaveNoHeader) {
  const Finished finished =
      run({"replay", made("north-echo.csv"), made("south-echo.csv"), "--threshold", "1", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.out << finished.err;
  EXPECT_EQ(rows[1].at(0) + " " + rows[1].at(1), "north-echo south-echo");
  EXPECT_NEAR(std::stod(rows[1].at(3)), kStarted_s + 20, 0.01);
  EXPECT_NEAR(std::stod(rows[1].at(4)), 0.3, 1e-6);
  expect_parts(finished.err, {"geometry_msgs/PoseStamped as 'ros2 topic echo --csv' writes it"});
}

// A recipe with the name that was given.
std::string with_file(std::string_view recipe, const std::string& file) {
  std::string text(recipe);
  const std::size_t at = text.find("FILE");
  return at == std::string::npos ? text : text.replace(at, 4, file);
}

TEST(Robotics, FilesOfOthersAreKnownAndTheRecipeIsTold) {
  struct Known {
    std::string_view bytes;
    std::string_view what;
    std::string_view type;
  };
  std::string recipe = content_of("bag-recipe.txt");
  recipe.erase(recipe.find_last_not_of('\n') + 1);
  const Known files[] = {
      {"#ROSBAG V2.0\nrest", "a bag of ROS 1", recipe},
      {"\x89MCAP0\r\nrest", "an MCAP file", recipe},
      {"SQLite format 3", "an SQLite database, as ROS 2 records (.db3)", recipe},
      {"FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns",
       "a DataFlash log of ArduPilot, as text (.log)",
       "--columns time=timestamp,lon=Lng,lat=Lat,height=Alt --threshold YOUR_THRESHOLD "},
      {"MATLAB 5.0 MAT-file, Platform", "a file of MATLAB (.mat)", "scipy.io.whosmat('FILE')"},
      {"\x89HDF\r\n\x1A\nrest", "an HDF5 file", "h5py.File('FILE').visititems(print)"},
      {"\x89HDF\r\n\x1A\n..pandas_type..bodyparts..", "an HDF5 file of DeepLabCut",
       "pandas.read_hdf('FILE').to_csv('poses.csv')"},
      {"\x89HDF\r\n\x1A\n..pandas_type..", "an HDF5 file of pandas",
       "pandas.read_hdf('FILE').to_csv('bees.csv', index=False)"},
      {"\x89HDF\r\n\x1A\n..instances..pred_points", "a file of SLEAP (HDF5)",
       "sleap-convert --format analysis.csv FILE"},
      {"\x89HDF\r\n\x1A\n..tracks..track_occupancy", "an analysis file of SLEAP (HDF5)",
       "sleap_io.save_csv(sleap_io.load_analysis_h5('FILE'), 'poses.csv', format='sleap')"},
      {"<?xml version=\"1.0\"?>\n<gpx version=\"1.1\">", "a track of a GPS receiver (GPX)",
       "E.parse(f).iterfind('.//{*}trkpt')"},
      {"\x89HDF\r\n\x1A\n..id_probabilities", "a file of idtracker.ai (HDF5)",
       "idtrackerai_csv FOLDER"},
      {"MATLAB 7.3 MAT-file, Platform", "an HDF5 file (also .mat of MATLAB 7.3)", "visititems"},
      {std::string_view("PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x08\0\0\0"
                        "arr0.npy",
                        38),
       "an archive of arrays of NumPy (.npz)", "numpy.load('FILE').items()"},
      {std::string_view("PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x0f\0\0\0"
                        "X#wcentroid.npy",
                        45),
       "a file of TRex (.npz)", "output_format csv"},
      {std::string_view("PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x13\0\0\0"
                        "[Content_Types].xml..xl/workbook.xml",
                        66),
       "an Excel workbook (.xlsx)",
       "pandas.read_excel('FILE', sheet_name=None, header=None).items()"},
      {std::string_view("PK\x03\x04\x14\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x08\0\0\0"
                        "mimetypeapplication/vnd.oasis.opendocument.spreadsheet",
                        84),
       "a spreadsheet of LibreOffice (.ods)", "save each of its sheets as CSV"},
      {"<?xml version='1.0'?><TrackMate version='7'>", "a file of TrackMate (XML)",
       "Export to CSV"},
      {"<?xml version='1.0'?><Tracks nTracks='2' spaceUnits='pixel'>",
       "an XML file of tracks that TrackMate exported", "iter('particle')"},
      {"\x80\x05\x95rest", "a pickle of Python (pandas, traffic)",
       "pandas.read_pickle('FILE').to_csv('bees.csv', index=False)"},
      {"PAR1rest", "a Parquet file", "pandas.read_parquet('FILE').to_csv('bees.csv', index=False)"},
      {"ULogEncrest", "a PX4 log that is encrypted", "decrypt it first"},
  };
  TemporaryFolder folder;
  for (const Known& known : files) {
    const std::string file = folder.file("log.bin", known.bytes);
    for (const std::string command : {"replay", "predict", "detect", "watch"}) {
      const Finished finished = run({command, file});
      EXPECT_EQ(finished.exit_code, 3) << command << known.what << finished.err;
      EXPECT_EQ(finished.out, "");
      if (command == "watch" && known.bytes.find('\n') != std::string_view::npos) continue;
      expect_parts(finished.err, {known.what, with_file(known.type, file)});
    }
  }
  const Finished snapshot = run({"detect", made("north.ulg")});
  EXPECT_EQ(snapshot.exit_code, 3);
  expect_parts(snapshot.err, {"a recording of bees that move (PX4 log (ULog))",
                              "ask 'beespace replay' about it"});
}

// With the threshold that was typed, not one of its own; of a folder of such logs at once.
TEST(Robotics, RecipesHaveTheThresholdThatWasTyped) {
  TemporaryFolder folder;
  folder.file("00000010.log", "FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n");
  const std::string second =
      folder.file("00000011.log", "FMT, 128, 89, FMT, BBnNZ, Type,Length,Name,Format,Columns\n");
  expect_parts(run({"replay", second, "--threshold", "8"}).err,
               {"lat=Lat,height=Alt --threshold 8 (", "--types POS " + second + " > pos.csv"});
  expect_parts(run({"replay", second}).err, {"height=Alt --threshold YOUR_THRESHOLD ("});
  expect_parts(run({"replay", folder.path(""), "--separation", "terminal"}).err,
               {"00000010.log: this is a DataFlash log of ArduPilot, as text (.log)",
                "--separation terminal (", "likewise 1 more in this folder"});
  const std::string wide = folder.file("a wide.csv",
                                       "__time,/drone1/pose/position/x,/drone1/pose/position/y,"
                                       "/drone2/pose/position/x,/drone2/pose/position/y\n"
                                       "0,1,2,3,4\n");
  expect_parts(run({"replay", wide, "--threshold", "0.3 m"}).err,
               {"' '" + wide + "' > long.csv",
                "' > long.csv, and then beespace replay long.csv "
                "--threshold '0.3 m' --time-unit s; where"});
}

TEST(Robotics, WhatRos2EchoesForReadingIsKnown) {
  const Finished echoed =
      run({"replay", "--threshold", "5"}, "header:\n  stamp:\n    sec: 1\n    nanosec: 2\n---\n");
  EXPECT_NE(echoed.exit_code, 0);
  expect_parts(echoed.err, {"this is what 'ros2 topic echo' writes", "ros2 topic echo --csv TOPIC",
                            "import yaml; docs = [m for m in yaml.load_all(open('FILE')"});
  const Finished of_gazebo = run({"replay", "--threshold", "5"},
                                 "header {\n  stamp {\n  }\n}\npose {\n  name: \"x500_0\"\n}\n");
  EXPECT_NE(of_gazebo.exit_code, 0);
  expect_parts(of_gazebo.err, {"poses as 'gz topic -e' prints them", "python3 -c \"import re; "});
}

TEST(Robotics, AFolderThatROS2RecordedIntoIsKnown) {
  TemporaryFolder folder;
  folder.file("metadata.yaml", "rosbag2_bagfile_information:\n");
  folder.file("bag_0.mcap", "\x89MCAP0\r\nrest");
  std::string recipe = content_of("bag-recipe.txt");
  recipe.erase(recipe.find_last_not_of('\n') + 1);
  const Finished finished = run({"replay", folder.path("")});
  EXPECT_EQ(finished.exit_code, 3);
  expect_parts(finished.err, {"this is a bag of ROS 2, a folder with metadata.yaml",
                              with_file(recipe, folder.path(""))});
}

TEST(Robotics, TimesInAnotherUnitThanTheHeaderSaysAreAsked) {
  std::string table = "id,time[ms],x_m,y_m,z_m\n";
  for (int i = 0; i < 20; ++i) {
    const std::string time = std::to_string(i * 100'000);
    table += "a," + time + "," + std::to_string(i * 0.5) + ",0,10\n";
    table += "b," + time + "," + std::to_string(i * 0.5) + ",30,10\n";
  }
  const Finished asked = run({"replay", "--threshold", "5"}, table);
  EXPECT_EQ(asked.exit_code, 2);
  expect_parts(asked.err,
               {"are the times in ms, as the header says?", "0.005 m/s",
                "in us it would be 5 m/s, every 0.1 s", "--time-unit us or --time-unit ms"});
  for (const std::string unit : {"us", "ms"}) {
    const Finished said = run({"replay", "--threshold", "5", "--time-unit", unit}, table);
    EXPECT_EQ(said.exit_code, 0) << said.err;
  }
}

}  // namespace
}  // namespace beespace::cli_test
