// What a table says of a place that cannot be so, or that it doubts itself, is no all-clear.
#include <gtest/gtest.h>

#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two that meet at 4 s, of whom one is at `place` from 2 to 6 s.
std::string meeting(const std::string& place) {
  std::string text = "id,time_s,lon,lat,height_m\n";
  for (int t = 0; t < 9; ++t) {
    const std::string at = std::to_string(t);
    text += "a," + at + ",8.5,47.0000" + at + ",100\n";
    text += "b," + at + "," +
            (t < 2 || t > 6 ? "8.5,47.0000" + std::to_string(8 - t) + ",100" : place) + "\n";
  }
  return text;
}

void expect_no_all_clear(const Arguments& command, const std::string& place,
                         const std::string& said) {
  const Finished finished =
      run(command + Arguments{"--threshold", "0.5", "--max-gap", "10"}, meeting(place));
  EXPECT_EQ(finished.exit_code, 1) << command.front() << " " << place << "\n" << finished.err;
  expect_parts(finished.err, {said});
}

TEST(DoubtfulPlaces, ZerosAndJumpsAreNoAllClear) {
  for (const Arguments& command : {Arguments{"replay", "--fail-on-risk"},
                                   Arguments{"replay", "--fail-on-risk", "--memory", "64MiB"}}) {
    expect_no_all_clear(command, "0,0,0", "5 records were left out");
    expect_no_all_clear(command, "-180,-90,0", "5 records were left out");
    expect_no_all_clear(command, "9.5,47,100", "1 bee jumps");
  }
  expect_no_all_clear({"verify"}, "9.5,47,100", "1 bee jumps");
  expect_no_all_clear({"verify"}, "0,0,0", "5 records were left out");
}

TEST(DoubtfulPlaces, OfPredictionsAndLiveSwarmsToo) {
  const std::string header = "id,time_s,lon,lat,height_m\n";
  const Finished predicted = run({"predict", "--threshold", "5", "--fail-on-risk"},
                                 header + "a,0,8.5,47,1\na,1,8.5,47,1\nb,0,0,0,0\nb,1,0,0,0\n");
  EXPECT_EQ(predicted.exit_code, 1) << predicted.err;
  expect_parts(predicted.err, {"known nowhere: b"});
  for (const char* const place : {"0,0,0", "9.5,47,100"}) {
    const Finished watched =
        run({"watch", "--threshold", "0.5", "--horizon", "0", "--fail-on-risk"}, meeting(place));
    EXPECT_EQ(watched.exit_code, 1) << watched.err;
    expect_parts(watched.err, {place[0] == '0' ? "5 lines were left out" : "1 bee jumps"});
  }
}

}  // namespace
}  // namespace beespace::cli_test
