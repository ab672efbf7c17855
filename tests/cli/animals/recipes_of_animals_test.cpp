// What to type for files of programs that follow animals, which are not read; and places of animals
// that are given with few decimals.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// In the units of the file, which are not left to be guessed.
TEST(RecipesOfAnimals, TracksOfTrackMateCarryTheirUnits) {
  TemporaryFolder folder;
  const auto said = [&folder](const std::string& attributes) {
    return run({"replay", folder.file("tracks.xml", "<?xml version='1.0'?><Tracks nTracks='2' " +
                                                        attributes + ">")})
        .err;
  };
  const std::string known = said(R"(spaceUnits="micron" frameInterval="2.0" timeUnits="sec")");
  expect_parts(known, {"print('id,time_s,x_um,y_um,z_um')", "float(d.get('t')) * 2.0,"});
  EXPECT_EQ(known.find("--fps"), std::string::npos);
  EXPECT_EQ(known.find("--scale"), std::string::npos);
  expect_parts(said("spaceUnits='pixel' frameInterval='1.0' timeUnits='frame'"),
               {"print('id,frame,x,y,z')", "--scale (how long one pixel is) and --fps"});
}

// Of a folder with as many files as fish, whose names are far behind the beginning of the file.
TEST(RecipesOfAnimals, AFolderOfFilesOfTrexHasOneLine) {
  TemporaryFolder folder;
  std::string bytes("PK\x03\x04", 4);
  bytes += std::string(22, '\0') + std::string("\x06\0\0\0", 4) + "id.npy";
  bytes += std::string(9000, '\0') + "X#wcentroid (cm).npy";
  folder.file("fish0.npz", bytes);
  folder.file("fish1.npz", bytes);
  const std::string said = run({"replay", folder.path("")}).err;
  expect_parts(said, {"a file of TRex (.npz)", "for n in sys.argv[1:]", "/*.npz"});
  EXPECT_EQ(said.find("with the names of the others"), std::string::npos) << said;
  EXPECT_EQ(said.find("likewise"), std::string::npos) << said;
}

// Two elephants that are 133 m apart: by places of 3 decimals it might be less than 50 m.
TEST(RoundedPlaces, CoarserThanTheThresholdAreNoAllClear) {
  const auto elephants = [](int decimals) {
    const double unit = std::pow(10.0, decimals);
    std::string table = "timestamp,location-long,location-lat,individual-local-identifier\n";
    for (int i = 0; i < 80; ++i) {
      for (int who = 0; who < 2; ++who) {
        const double lon = 37.1 + 0.0007 * i + 0.004 * std::sin(0.3 * i);
        const double lat = -2.3 + 0.003 * std::cos(0.2 * i) + (who == 0 ? 0.0 : 0.0012);
        table += "2024-05-03 " + std::string(i < 40 ? "0" : "1") + std::to_string(i / 4 % 10) +
                 ":" + std::to_string(i % 4 * 15 + 100).substr(1) + ":00.000," +
                 std::to_string(std::round(lon * unit) / unit) + "," +
                 std::to_string(std::round(lat * unit) / unit) +
                 (who == 0 ? ",Jumbo\n" : ",Asha\n");
      }
    }
    return table;
  };
  const Arguments replay = {"replay", "--threshold", "50", "--fail-on-risk"};
  const Finished coarse = run(replay, elephants(3));
  EXPECT_EQ(coarse.exit_code, 1);
  expect_parts(coarse.err, {"no conflict in the known time; 2 bees have places written in steps of",
                            "few decimals"});
  const Finished fine = run(replay, elephants(6));
  EXPECT_EQ(fine.exit_code, 0) << fine.err;
  expect_parts(fine.err, {"keeps its distance"});
  TemporaryFolder folder;
  const Finished large = run({"replay", folder.file("e.csv", elephants(3)), "--threshold", "50",
                              "--fail-on-risk", "--memory", "40MB"});
  EXPECT_EQ(large.exit_code, 1) << large.err;
}

// As pandas writes the sheet of a workbook.
TEST(RecipesOfAnimals, ADayMayBeWrittenAsItsMidnight) {
  const Finished finished = run({"replay", "--threshold", "50", "--time-zone", "UTC"},
                                "id,Date,Time,Latitude,Longitude\n"
                                "Ada,2024-05-03 00:00:00,01:00:00,52.7,23.85\n"
                                "Bo,2024-05-03 00:00:00,01:00:00,52.7001,23.85\n"
                                "Ada,2024-05-03 00:00:00,02:00:00,52.7,23.85\n"
                                "Bo,2024-05-03 00:00:00,02:00:00,52.7001,23.85\n");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"from       2024-05-03T01:00:00.000Z to 2024-05-03T02:00:00.000Z"});
  const Finished noon = run({"replay", "--threshold", "50", "--time-zone", "UTC"},
                            "id,Date,Time,Latitude,Longitude\n"
                            "Ada,2024-05-03 12:00:00,01:00:00,52.7,23.85\n");
  EXPECT_NE(noon.exit_code, 0);
}

TEST(RecipesOfAnimals, TheSessionOfIdtrackerHasNoPlaces) {
  const Finished session =
      run({"replay", "--threshold", "2cm"},
          R"({"session": "fish", "number_of_animals": 3, "frames_per_second": 25})");
  EXPECT_EQ(session.exit_code, 3);
  expect_parts(session.err, {"a session of idtracker.ai", "idtrackerai_csv FOLDER"});
}

// How Lotek's processing found a place.
TEST(RecipesOfAnimals, LotekSaysHowItFoundAPlace) {
  const auto deer = [](const std::string& status) {
    return "Device ID,Date & Time [GMT],Latitude,Longitude,Fix Status\n"
           "1,2024-05-03 01:00:00,52.7,23.85," +
           status +
           "\n2,2024-05-03 01:00:00,52.7001,23.85,3-D least-squares\n"
           "1,2024-05-03 02:00:00,52.7,23.85,3-D least-squares\n"
           "2,2024-05-03 02:00:00,52.7001,23.85,2-D least-squares\n";
  };
  const Arguments replay = {"replay", "--threshold", "50"};
  for (const char* const fix : {"3-D least-squares", "4 or more SV KF", "3_SV KF"}) {
    const Finished found = run(replay, deer(fix));
    EXPECT_EQ(found.exit_code, 0) << found.err;
    EXPECT_EQ(found.err.find("had no fix"), std::string::npos) << found.err;
  }
  expect_parts(run(replay, deer("DR")).err,
               {"1 record of receivers that say that they had no fix"});
}

}  // namespace
}  // namespace beespace::cli_test
