// `beespace detect --memory`: the answers of the whole, by cells.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::vector<std::string> sorted_lines(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  return lines;
}

class OutOfCoreCommand : public testing::Test {
 protected:
  Finished small(Arguments arguments) const {
    arguments.insert(arguments.begin(), "detect");
    arguments.insert(arguments.end(),
                     {"--memory", "17MB", "--threads", "1", "--temporary", folder_.path("")});
    return run(arguments);
  }
  void expect_refused(const Arguments& arguments, int exit_code, const std::string& message) const {
    const Finished finished = small(arguments);
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err.find(message), std::string::npos) << "'" << message << "' in\n"
                                                             << finished.err;
  }

  TemporaryFolder folder_;
};

// 200,000 points, so that there are several cells.
TEST_F(OutOfCoreCommand, AnswersAreThoseOfTheWhole) {
  const std::string text = folder_.path("swarm.csv");
  const std::string array = folder_.path("swarm.npy");
  const std::string raw = folder_.path("swarm.bin");
  ASSERT_EQ(run({"generate", "--points", "200000", "--size", "60", "--output", text}).exit_code, 0);
  ASSERT_EQ(run({"generate", "--points", "200000", "--size", "60", "--output", array}).exit_code,
            0);
  // What follows the header of an .npy file is raw.
  const std::string npy = folder_.read("swarm.npy");
  folder_.file("swarm.bin", std::string_view(npy).substr(npy.size() - std::size_t{200'000} * 24));
  for (const std::string& file : {text, array, raw}) {
    for (const std::string report : {"at-risk", "pairs", "closest-pair"}) {
      SCOPED_TRACE(file + " " + report);
      const Arguments what = {file, "--crs", "metres", "--threshold", "0.7", "--report", report};
      Arguments whole = what;
      whole.insert(whole.begin(), "detect");
      const Finished expected = run(whole);
      const Finished found = small(what);
      EXPECT_EQ(found.exit_code, 0) << found.err;
      EXPECT_GT(expected.out.size(), 30U);
      if (report == "pairs") {
        EXPECT_EQ(sorted_lines(found.out), sorted_lines(expected.out));
      } else {
        EXPECT_EQ(found.out, expected.out);
      }
      EXPECT_NE(found.err.find("17"), std::string::npos);
      EXPECT_EQ(found.err.find(", 1 cell\n"), std::string::npos) << found.err;
    }
  }
  EXPECT_EQ(small({text, "--crs", "metres", "--threshold", "0.7", "--fail-on-risk"}).exit_code, 1);
  EXPECT_EQ(small({text, "--crs", "metres", "--threshold", "0.000001", "--fail-on-risk"}).exit_code,
            0);
  // No temporary file has a name.
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"swarm.bin", "swarm.csv", "swarm.npy"}));
}

TEST_F(OutOfCoreCommand, DegreesAndHeightsInTheirUnits) {
  const std::string file =
      folder_.file("bees.csv",
                   "longitude,latitude,height_ft\n8,47,1000\n8.0001,47,1000\n9,47,1000\n"
                   "8,47,1100\n");
  const Arguments what = {file, "--report", "pairs", "--threshold", "40"};
  Arguments whole = what;
  whole.insert(whole.begin(), "detect");
  const Finished expected = run(whole);
  EXPECT_EQ(sorted_lines(expected.out).size(), 4U) << expected.out;
  EXPECT_EQ(sorted_lines(small(what).out), sorted_lines(expected.out));
}

TEST_F(OutOfCoreCommand, WhatItDoesNotTake) {
  const std::string plain = folder_.file("plain.csv", "1,2,3\n4,5,6\n");
  const std::string named = folder_.file("named.csv", "id,x_m,y_m,z_m\nmaya,2,3,4\n");
  expect_refused({plain}, 3, "say --crs metres");
  expect_refused({named}, 3, "leave the id out");
  expect_refused({plain, "--crs", "metres", "--report", "groups"}, 2, "at-risk, pairs and closest");
  expect_refused({plain, "--crs", "metres", "--csv"}, 2, "the answer is text");
  EXPECT_EQ(small({plain, "--crs", "metres", "--json"}).exit_code, 2);
  expect_refused({plain, "--crs", "metres", "--skip-bad"}, 2, "--skip-bad");
  expect_refused({plain, "--crs", "metres", "--others", plain}, 2, "--others");
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
