// Tables of collars and of what reads them: who is meant, and how far places and heights are off.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// A collar is one animal's after another's, so that its number stays the id.
TEST(Collars, CollarsAreCalledAfterTheirAnimals) {
  const Finished finished = run({"replay", "--threshold", "50", "--report", "pairs", "--csv"},
                                "CollarID,UTC_Date,UTC_Time,Latitude [°],Longitude [°],AnimalID\n"
                                "32145,24.10.2024,00:00:00,52.8970,9.0970,F1\n"
                                "32146,24.10.2024,00:00:00,52.8971,9.0970,M3\n"
                                "32145,24.10.2024,00:10:00,52.8970,9.0970,F1\n"
                                "32146,24.10.2024,00:10:00,52.8971,9.0970,M3\n");
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"'CollarID', not from column 6 'AnimalID'", "32145 (F1)"});
  expect_parts(finished.out, {"F1", "M3"});
}

// Packages of R write tables with names of their own.
TEST(Collars, AmtAndMove2AreOfAnimals) {
  for (const char* const header : {"id,t_,x_,y_", "individual_local_identifier,timestamp,x,y"}) {
    const std::string table = std::string(header) +
                              "\nF01,2024-05-03T00:00:00Z,692000,5843000\n"
                              "F02,2024-05-03T00:00:00Z,692020,5843000\n"
                              "F01,2024-05-03T01:00:00Z,692000,5843000\n"
                              "F02,2024-05-03T01:00:00Z,692020,5843000\n";
    expect_parts(run({"plot", "--threshold", "50"}, table).out, {"2 animals. 1 conflict"});
  }
}

// Heights by satellites say little of animals; replay says so, too.
TEST(Collars, WhoIsKeptApartByHeightsAloneIsNotVerified) {
  const std::string storks =
      "timestamp,location-long,location-lat,height-above-ellipsoid,individual-local-identifier\n"
      "2024-05-03 00:00:00.000,9.1,47.7,400,Ada\n2024-05-03 00:00:00.000,9.1,47.7001,480,Bo\n"
      "2024-05-03 00:10:00.000,9.1,47.7,400,Ada\n2024-05-03 00:10:00.000,9.1,47.7001,480,Bo\n";
  const Arguments of_pairs = {"--threshold", "50"};
  for (const Arguments& command : {Arguments{"verify"}, Arguments{"replay", "--fail-on-risk"}}) {
    const Finished finished = run(command + of_pairs, storks);
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    expect_parts(finished.err, {"1 pair of animals is kept apart by heights alone"});
  }
  const Finished over_ground = run({"verify", "--threshold", "50", "--vertical", "10m"}, storks);
  EXPECT_EQ(over_ground.exit_code, 0) << over_ground.err;
}

// By the estimate of the receiver itself.
TEST(Collars, PlacesThatAreOffByTheirOwnAccuracyAreNoAllClear) {
  const auto deer = [](const char* accuracy) {
    std::string table =
        "timestamp,location-long,location-lat,eobs:horizontal-accuracy-estimate,sensor-type,"
        "individual-local-identifier\n";
    for (const char* const name : {"A", "B"}) {
      for (int i = 0; i < 24; ++i) {
        table += "2024-05-03 00:" + std::to_string(10 + i) + ":00.000,9.20" +
                 std::to_string(10'000 + 37 * i % 41) + (*name == 'A' ? ",47.7000" : ",47.7006") +
                 std::to_string(100 + 53 * i % 61) + "," + accuracy + ",gps," + name + "\n";
      }
    }
    return table;
  };
  const Arguments replay = {"replay", "--threshold", "50", "--fail-on-risk"};
  const Finished rough = run(replay, deer("180.2"));
  EXPECT_EQ(rough.exit_code, 1) << rough.err;
  expect_parts(rough.err, {"2 bees have places that are off by up to 1",
                           "by 'eobs:horizontal-accuracy-estimate'", "in the known time"});
  for (const char* const accuracy : {"3.5", "", "NaN"}) {
    const Finished fine = run(replay, deer(accuracy));
    EXPECT_EQ(fine.exit_code, 0) << accuracy << fine.err;
    expect_parts(fine.err, {"keeps its distance"});
  }
  const TemporaryFolder folder;
  const Finished large = run({"replay", folder.file("deer.csv", deer("180.2")), "--threshold", "50",
                              "--fail-on-risk", "--memory", "40MB"});
  EXPECT_EQ(large.exit_code, 1) << large.err;
}

}  // namespace
}  // namespace beespace::cli_test
