// `beespace detect --memory`: the answers of the whole, by cells.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/cli/detect/out_of_core_runs.hpp"

namespace beespace::cli_test {
namespace {

class OutOfCoreCommand : public OutOfCoreRuns {
 protected:
  // A table with a column of ids, some of which are empty or have quotes and tabs.
  [[nodiscard]] std::string with_ids(const std::string& table, const std::string& name) const {
    std::istringstream in(folder_.read(table));
    std::string text;
    std::size_t row = 0;
    for (std::string line; std::getline(in, line); ++row) {
      if (row == 0) {
        text += "name;";
      } else if (row % 1000 == 0) {
        text += ";";
      } else if (row % 999 == 0) {
        text += "\"a\t" + std::to_string(row) + ";\"\"\";";
      } else {
        text += "bee " + std::to_string(row * 7919) + ";";
      }
      for (const char c : line) text += c == ',' ? ';' : c;
      text += '\n';
    }
    return folder_.file(name, text);
  }
};

TEST_F(OutOfCoreCommand, AnswersAreThoseOfTheWhole) {
  const std::string text = swarm("swarm.csv");
  const std::string array = swarm("swarm.npy");
  // What follows the header of an .npy file is raw.
  const std::string npy = folder_.read("swarm.npy");
  const std::string raw = folder_.file(
      "swarm.bin", std::string_view(npy).substr(npy.size() - std::size_t{100'000} * 24));
  for (const std::string& file : {text, array, raw}) {
    for (const std::string report :
         {"at-risk", "pairs", "neighbors", "counts", "nearest", "closest-pair"}) {
      expect_same({file, "--crs", "metres", "--threshold", "0.9", "--report", report});
    }
  }
  const Finished found = small({text, "--crs", "metres"});
  EXPECT_NE(found.err.find("17.0 MB, "), std::string::npos);
  EXPECT_EQ(found.err.find(", 1 cell\n"), std::string::npos) << found.err;
}

TEST_F(OutOfCoreCommand, EveryFormHasTheIdsOfTheFile) {
  const std::string plain = swarm("swarm.csv");
  const std::string named = with_ids("swarm.csv", "named.csv");
  for (const std::string report :
       {"at-risk", "pairs", "neighbors", "counts", "nearest", "closest-pair"}) {
    for (const std::string form : {"--csv", "--json"}) {
      expect_same({plain, "--threshold", "0.8", "--report", report, form});
    }
    expect_same({named, "--threshold", "0.8", "--report", report});
    expect_same({named, "--threshold", "0.8", "--report", report, "--csv"});
  }
  // How many ids are empty or broken is said of all bees, not of those of the answer: the notes
  // differ.
  const Finished json = small({named, "--threshold", "0.8", "--report", "nearest", "--json"});
  const Finished whole =
      run({"detect", named, "--threshold", "0.8", "--report", "nearest", "--json"});
  const auto rows = [](const std::string& text) {
    return text.substr(text.find("\"nearest\": ["));
  };
  EXPECT_GT(rows(whole.out).size(), 100'000U);
  EXPECT_TRUE(rows(json.out) == rows(whole.out));
  EXPECT_NE(json.out.find("100 bees have an empty id"), std::string::npos);
}

TEST_F(OutOfCoreCommand, OfArraysRecordsAreTheirNumbers) {
  const std::string array = swarm("swarm.npy", 30'000);
  expect_same({array, "--crs", "metres", "--threshold", "1.2", "--report", "nearest", "--csv"});
  expect_same({array, "--crs", "metres", "--threshold", "1.2", "--csv"});
}

TEST_F(OutOfCoreCommand, WhoIsAtRiskOnly) {
  ASSERT_EQ(swarm("swarm.csv", 30'000), folder_.path("swarm.csv"));
  const std::string file = with_ids("swarm.csv", "named.csv");
  for (const std::string report : {"neighbors", "counts", "nearest"}) {
    for (const std::string form : {"--csv", "--output=-"}) {
      expect_same(
          {file, "--threshold", "1", "--at-risk-only", "--inclusive", "--report", report, form});
    }
  }
}

TEST_F(OutOfCoreCommand, FailsOnRiskInEveryReport) {
  const std::string file = swarm("swarm.csv", 20'000);
  for (const std::string report :
       {"at-risk", "pairs", "neighbors", "counts", "nearest", "closest-pair"}) {
    const Arguments what = {file, "--report", report, "--fail-on-risk", "--quiet"};
    EXPECT_EQ(small(what + Arguments{"--threshold", "0.7"}).exit_code, 1) << report;
    EXPECT_EQ(small(what + Arguments{"--threshold", "0.000001"}).exit_code, 0) << report;
  }
}

TEST_F(OutOfCoreCommand, MoreThanTheMostResultsIsAnErrorWithoutAnAnswer) {
  const std::string file = swarm("swarm.csv", 20'000);
  for (const std::string report : {"pairs", "neighbors"}) {
    const Arguments what = {file, "--threshold", "0.7", "--report", report};
    const std::size_t pairs =
        lines_of(run({"detect", file, "--threshold", "0.7", "--report", "pairs"}).out).size() - 1;
    ASSERT_GT(pairs, 100U);
    const std::size_t most = report == "pairs" ? pairs : 2 * pairs;
    expect_same(what + Arguments{"--max-results", std::to_string(most)});
    const Arguments fewer = what + Arguments{"--max-results", std::to_string(most - 1)};
    expect_refused(fewer, 3, "--max-results");
    EXPECT_EQ(small(fewer).err, run(Arguments{"detect"} + fewer).err);
  }
}

TEST_F(OutOfCoreCommand, DegreesAndHeightsInTheirUnits) {
  const std::string file =
      folder_.file("bees.csv",
                   "longitude,latitude,height_ft\n8,47,1000\n8.0001,47,1000\n9,47,1000\n"
                   "8,47,1100\n");
  for (const std::string report : {"pairs", "nearest", "counts"}) {
    for (const std::string form : {"--csv", "--json"}) {
      expect_same({file, "--report", report, "--threshold", "40", form});
    }
  }
  const std::string metres = folder_.file("metres.csv", "x_m,y_m,z_m\n0,0,0\n1,0,5\n0,1,9\n");
  for (const std::string report : {"at-risk", "pairs", "neighbors", "counts"}) {
    expect_same({metres, "--threshold", "2", "--vertical", "6", "--report", report});
  }
}

// Heights that are compared as they stand, exactly; and those above the ground.
TEST_F(OutOfCoreCommand, HeightsApartFromPositions) {
  const std::string feet =
      folder_.file("feet.csv", "x_m,y_m,z_ft\n0,0,0.1\n1,0,1000.1\n0,1,1000.099\n0,0,2000\n");
  for (const std::string vertical : {"1000ft", "304.8", "999.9999ft"}) {
    for (const std::string report : {"at-risk", "pairs", "neighbors", "counts"}) {
      for (const std::string inclusive : {"--inclusive", "--output=-"}) {
        expect_same(
            {feet, "--threshold", "2", "--vertical", vertical, "--report", report, inclusive}, {},
            0);
      }
    }
  }
  ASSERT_EQ(run({"generate", "--area", "medellin", "--points", "100000", "--seed", "7", "--quiet",
                 "--output", folder_.path("plain.csv")})
                .exit_code,
            0);
  const std::string named = with_ids("plain.csv", "named.csv");
  for (const std::string report : {"at-risk", "pairs", "neighbors", "counts"}) {
    for (const std::string form : {"--csv", "--output=-"}) {
      expect_same({named, "--columns", "id=1,lon=2,lat=3,height=4", "--crs", "wgs84", "--threshold",
                   "20", "--vertical", "8", "--report", report, form},
                  {}, 10'000);
    }
  }
  expect_refused({feet, "--vertical", "9", "--report", "nearest"}, 2, "--vertical with nearest");
  EXPECT_EQ(small({feet, "--vertical", "9", "--json"}).exit_code, 2);
}

TEST_F(OutOfCoreCommand, FewBees) {
  const std::string one = folder_.file("one.csv", "x_m,y_m,z_m\n1,2,3\n");
  const std::string two = folder_.file("two.csv", "x_m,y_m,z_m\n1,2,3\n\n1,2,3\n");
  for (const std::string report :
       {"at-risk", "pairs", "neighbors", "counts", "nearest", "closest-pair"}) {
    expect_same({one, "--report", report, "--json"});
    expect_same({two, "--report", report, "--json"});
    expect_same({two, "--report", report});
    expect_same({two, "--report", report, "--csv"});
  }
  expect_same({one, "--report", "nearest"});
  expect_same({one, "--report", "nearest", "--csv"});
}

TEST_F(OutOfCoreCommand, WhatItDoesNotTake) {
  const std::string plain = folder_.file("plain.csv", "1,2,3\n4,5,6\n");
  expect_refused({plain}, 3, "say --crs metres");
  const Arguments metres = {plain, "--crs", "metres"};
  expect_refused(metres + Arguments{"--report", "groups"}, 2, "groups");
  expect_refused(metres + Arguments{"--geojson"}, 2, "--csv or --json");
  expect_refused(metres + Arguments{"--others", plain}, 2, "--others");
  expect_refused(metres + Arguments{"--vertical", "5", "--report", "nearest"}, 2, "--vertical");
  expect_refused({folder_.file("bad.csv", "x_m,y_m,z_m\n1,2,3\n1,nan,3\n"), "--crs", "metres"}, 3,
                 "bad.csv:3:2");
  EXPECT_EQ(run({"detect", plain, "--memory", "4"}).exit_code, 2);
  EXPECT_EQ(run({"detect", plain, "--memory", "4XB"}).exit_code, 2);
  EXPECT_EQ(run({"detect", plain, "--temporary", "/tmp"}).exit_code, 2);
  const Finished little =
      run({"detect", plain, "--crs", "metres", "--memory", "1MB", "--threads", "1"});
  EXPECT_EQ(little.exit_code, 2);
  EXPECT_NE(little.err.find("16 MiB"), std::string::npos) << little.err;
  const Finished nowhere = run({"detect", plain, "--crs", "metres", "--memory", "1GB",
                                "--temporary", folder_.path("missing")});
  EXPECT_EQ(nowhere.exit_code, 4);
}

}  // namespace
}  // namespace beespace::cli_test
