// `beespace detect --memory`: too little room, full disks, signals. Nothing is left behind.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "tests/cli/detect/out_of_core_runs.hpp"

namespace beespace::cli_test {
namespace {

class OutOfCoreEnds : public OutOfCoreRuns {
 protected:
  // A run that has written to its temporary files, and waits for more input.
  [[nodiscard]] Arguments waiting() const {
    return {"detect",      "-",
            "--memory",    "17MB",
            "--threads",   "1",
            "--crs",       "metres",
            "--temporary", scratch_.path(""),
            "--output",    folder_.path("answer.txt")};
  }
  static void send_much(const Running& running, std::string text = "id,x_m,y_m,z_m\n",
                        std::string_view row = "a,1.25,2.5,3.75\n", int rows = 300'000) {
    for (int count = 0; count < rows; ++count) text += row;
    // What is read of a pipe that holds 64 KiB is more than waits in memory.
    running.send(text);
  }
};

TEST_F(OutOfCoreEnds, TooLittleRoomIsKnownBeforeTheSearch) {
  const std::string file = folder_.file("holes.bin", "");
  std::error_code cannot;
  std::filesystem::resize_file(file, 12'000'000'000'000, cannot);
  if (cannot) GTEST_SKIP() << "no file of 12 TB with holes can be made here";
  const Finished finished = small({file, "--crs", "metres"});
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_EQ(finished.out, "");
  expect_parts(finished.err, {"needs 14.0 TB", scratch_.path(""), "--temporary"});
}

TEST_F(OutOfCoreEnds, AFullDiskIsAnErrorThatLeavesNothing) {
  const std::string file = swarm("swarm.csv", 50'000);
  const std::string array = swarm("swarm.npy", 50'000);
  Surroundings narrow;
  narrow.file_bytes = 1'000'000;
  for (const std::string& input : {file, array}) {
    const Finished finished = small({input, "--crs", "metres", "--threshold", "1.5", "--report",
                                     "pairs", "--output", folder_.path("answer.txt")},
                                    {}, narrow);
    EXPECT_EQ(finished.exit_code, 4);
    expect_parts(finished.err,
                 {"cannot write a temporary file in", scratch_.path(""), "too large"});
  }
  // Cells fit, but not the rows of the answer.
  narrow.file_bytes = 2'000'000;
  const Finished rows = small({array, "--crs", "metres", "--threshold", "1.5", "--report", "pairs",
                               "--output", folder_.path("answer.txt")},
                              {}, narrow);
  EXPECT_EQ(rows.exit_code, 4);
  expect_parts(rows.err, {"cannot write a temporary file in"});
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"swarm.csv", "swarm.npy"}));
  EXPECT_TRUE(scratch_.names().empty());
}

TEST_F(OutOfCoreEnds, CtrlCEndsWith130AndLeavesNothing) {
  for (const auto& [signal, exit_code] : {std::pair(SIGINT, 130), std::pair(SIGTERM, 143)}) {
    folder_.file("answer.txt", "old");
    Running running(waiting());
    send_much(running);
    EXPECT_EQ(folder_.names().size(), 2U);
    running.signal(signal);
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"answer.txt"});
    EXPECT_EQ(folder_.read("answer.txt"), "old");
    EXPECT_TRUE(scratch_.names().empty());
  }
}

TEST_F(OutOfCoreEnds, KilledItLeavesNoTemporaryFilesAndNoAnswer) {
  folder_.file("answer.txt", "old");
  Running running(waiting());
  send_much(running);
  running.signal(SIGKILL);
  EXPECT_EQ(running.finish().exit_code, -1);
  EXPECT_EQ(folder_.read("answer.txt"), "old");
  EXPECT_TRUE(scratch_.names().empty());
}

// Points that are searched where they are must stay as they are.
TEST_F(OutOfCoreEnds, AnArrayThatChangesMeanwhileIsAnErrorWithoutAnAnswer) {
  for (const bool shorter : {false, true}) {
    const std::string array = swarm("swarm.npy", 20'000);
    Running running({"detect", array, "-", "--memory", "17MB", "--threads", "1", "--crs", "metres",
                     "--temporary", scratch_.path(""), "--output", folder_.path("answer.txt")});
    send_much(running, "x_m,y_m,z_m\n", "1,2,3\n");  // when this is read, the array is mapped
    if (shorter) {
      std::filesystem::resize_file(array, 200);
    } else {
      std::filesystem::last_write_time(
          array, std::filesystem::last_write_time(array) - std::chrono::seconds(5));
    }
    running.close_input();
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, 4);
    EXPECT_NE(finished.err.find(shorter ? "a file became shorter" : "was written to while"),
              std::string::npos)
        << finished.err;
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"swarm.npy"});
  }
}

// Several files are looked at first, and read later.
TEST_F(OutOfCoreEnds, ATableThatChangesBeforeItIsReadIsAnError) {
  const std::string table = folder_.file("table.csv", "x_m,y_m,z_m\n1,2,3\n");
  for (const bool replaced : {false, true}) {
    Running running({"detect", table, "-", "--memory", "17MB", "--threads", "1", "--temporary",
                     scratch_.path("")});
    // More than a pipe holds, and less than what a table is told by: it waits.
    send_much(running, "x_m,y_m,z_m\n", "1,2,3\n", 20'000);
    if (replaced) {
      std::filesystem::rename(folder_.file("other.csv", "x_m,y_m,z_m\n9,2,3\n"), table);
    } else {
      folder_.file("table.csv", "x_m,y_m,z_m\n1,2,3\n4,5,6\n");
    }
    running.close_input();
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, 4);
    EXPECT_EQ(finished.out, "");
    EXPECT_NE(finished.err.find("table.csv: this file was written to"), std::string::npos)
        << finished.err;
  }
}

TEST_F(OutOfCoreEnds, AClosedPipeEndsItQuietly) {
  const std::string file = swarm("swarm.csv", 20'000);
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  for (const std::string form : {"--csv", "--json", "--output=-"}) {
    const Finished finished =
        small({file, "--threshold", "1", "--report", "pairs", form}, {}, closed);
    EXPECT_EQ(finished.exit_code, 141);
    EXPECT_EQ(finished.err, "");
  }
}

}  // namespace
}  // namespace beespace::cli_test
