// Ctrl-C, termination, closed pipes and full disks: the right exit code, and nothing left behind.
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <string>
#include <thread>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/temporary_folder.hpp"
#include "tests/support/rounds.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kTwo = "x,y,z\n0,0,0\n1,0,0\n";

Surroundings closed_pipe() {
  Surroundings surroundings;
  surroundings.output = Surroundings::Output::kClosedPipe;
  return surroundings;
}

// Until the condition holds, or ten seconds have passed.
bool wait_for(const std::function<bool()>& condition) {
  for (int i = 0; i < 1'000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

// Starts a run on a standard input that never ends, waits until its temporary file is there, so
// that the signal surely finds it at work, and signals it.
void expect_clean_end(int signal, int exit_code) {
  const TemporaryFolder folder;
  folder.file("answer.txt", "old");
  Running running({"detect", "--output", folder.path("answer.txt")});
  running.send(kTwo);
  ASSERT_TRUE(wait_for([&folder] { return folder.names().size() == 2; }))
      << "no temporary file appeared";
  running.signal(signal);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, exit_code);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"answer.txt"});
  EXPECT_EQ(folder.read("answer.txt"), "old");
}

TEST(Interruption, CtrlCEndsWith130AndLeavesNothing) {
  expect_clean_end(SIGINT, 130);
}

TEST(Interruption, TerminationEndsWith143AndLeavesNothing) {
  expect_clean_end(SIGTERM, 143);
}

TEST(Interruption, AClosedTerminalEndsWith129AndLeavesNothing) {
  expect_clean_end(SIGHUP, 129);
}

TEST(Interruption, OtherSignalsThatEndItLeaveNothing) {
  for (const int signal : {SIGQUIT, SIGALRM, SIGXCPU}) expect_clean_end(signal, 128 + signal);
}

TEST(Interruption, AFileLongerThanAllowedIsAnErrorThatLeavesNothing) {
  const TemporaryFolder folder;
  Surroundings narrow;
  narrow.file_bytes = 65'536;
  const Finished finished =
      run({"generate", "--points", "200000", "--output", folder.path("bees.csv")}, {}, narrow);
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_NE(finished.err.find("File too large"), std::string::npos) << finished.err;
  EXPECT_TRUE(folder.names().empty());
}

TEST(Interruption, DetectEndsQuietlyWhenTheReaderIsGone) {
  Running running({"detect"}, closed_pipe());
  running.send(kTwo);
  running.close_input();
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 141);
  EXPECT_EQ(finished.err, "");
}

TEST(Interruption, EveryFormOfTheAnswerEndsQuietlyWhenTheReaderIsGone) {
  for (const char* report : {"at-risk", "pairs", "neighbors", "groups"}) {
    for (const char* form : {"--csv", "--json", "--quiet"}) {
      Running running({"detect", "--report", report, form}, closed_pipe());
      running.send(kTwo);
      running.close_input();
      const Finished finished = running.finish();
      EXPECT_EQ(finished.exit_code, 141) << report << form;
      EXPECT_EQ(finished.err, "") << report << form;
    }
  }
}

TEST(Interruption, GenerateHelpAndBenchEndQuietlyWhenTheReaderIsGone) {
  for (const Arguments& arguments :
       {Arguments{"generate", "--points", "200000"}, Arguments{"detect", "--help"},
        Arguments{"bench", "--points", "1000", "--quiet"}}) {
    Running running(arguments, closed_pipe());
    running.close_input();
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, 141);
    EXPECT_EQ(finished.err, "");
  }
}

void expect_disk_full(const Arguments& arguments, const std::string& file) {
  Surroundings surroundings;
  if (!file.empty()) {
    surroundings.output = Surroundings::Output::kFile;
    surroundings.file = file;
  }
  Running running(arguments, surroundings);
  running.send(kTwo);
  running.close_input();
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_NE(finished.err.find("beespace: error: "), std::string::npos) << finished.err;
}

TEST(Interruption, AFullDiskIsAnError) {
  expect_disk_full({"detect"}, "/dev/full");
  expect_disk_full({"detect", "--json"}, "/dev/full");
  expect_disk_full({"detect", "--output", "/dev/full"}, "");
  expect_disk_full({"generate", "--points", "10"}, "/dev/full");
  expect_disk_full({"generate", "--points", "10", "--format", "npy.gz"}, "/dev/full");
  expect_disk_full({"--help"}, "/dev/full");
}

TEST(Interruption, UsedUpMemoryIsAnErrorThatLeavesNothing) {
  if (test::kSanitized) GTEST_SKIP() << "memory cannot be limited under a sanitizer";
  const TemporaryFolder folder;
  Surroundings narrow;
  narrow.memory_bytes = std::size_t{200} << 20;
  for (const Arguments& arguments :
       {Arguments{"generate", "--points", "20000000", "--output", folder.path("bees.csv")},
        Arguments{"detect", "/dev/zero", "--format", "bin", "--output", folder.path("risk.txt")}}) {
    Running running(arguments, narrow);
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, 4);
    EXPECT_NE(finished.err.find("out of memory"), std::string::npos) << finished.err;
    EXPECT_TRUE(folder.names().empty());
  }
}

TEST(Interruption, AMissingFolderIsKnownBeforeTheInputIsRead) {
  const TemporaryFolder folder;
  Running running({"detect", "--output", folder.path("nowhere/answer.txt")});
  const Finished finished = running.finish();  // though the input has not ended
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_NE(finished.err.find("nowhere/answer.txt"), std::string::npos);
}

}  // namespace
}  // namespace beespace::cli_test
