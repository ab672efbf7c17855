// What is different when a person watches: colour, and a progress bar for long work.
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kTwo = "x,y,z\n0,0,0\n1,0,0\n";
constexpr std::string_view kWipeLine = "\r\x1b[K";

class Terminal : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  }
};

TEST_F(Terminal, TheSummaryHasColour) {
  const TemporaryFolder folder;
  const Finished finished = run_on_terminal({"detect", folder.file("bees.csv", kTwo)});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.err.find("\x1b[1;31m2 (100.0 %)\x1b[0m"), std::string::npos) << finished.err;
}

TEST_F(Terminal, NoColorIsRespected) {
  const TemporaryFolder folder;
  const Finished finished = run_on_terminal({"detect", folder.file("bees.csv", kTwo)}, "1");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.err.find("2 (100.0 %)"), std::string::npos) << finished.err;
  EXPECT_EQ(finished.err.find('\x1b'), std::string::npos) << finished.err;
}

TEST_F(Terminal, ACommandDoesNotWaitForInputFromATerminal) {
  Surroundings surroundings;
  surroundings.input_on_terminal = true;
  Running running({"detect"}, surroundings);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 2);
  EXPECT_NE(finished.err.find("say which file to read"), std::string::npos) << finished.err;
}

std::string messages_of_slow_run(const Arguments& arguments, bool terminal) {
  Surroundings surroundings;
  surroundings.error_on_terminal = terminal;
  Running running(arguments, surroundings);
  running.send(kTwo);
  std::this_thread::sleep_for(std::chrono::milliseconds(1'500));
  running.close_input();
  return running.finish().err;
}

TEST_F(Terminal, WorkOfMoreThanASecondShowsProgressAndWipesIt) {
  const std::string messages = messages_of_slow_run({"detect"}, true);
  EXPECT_NE(messages.find(std::string(kWipeLine) + "reading"), std::string::npos) << messages;
  const std::size_t last = messages.rfind(kWipeLine);
  EXPECT_EQ(messages.substr(last + kWipeLine.size(), 7), "  input") << messages;
}

TEST_F(Terminal, ProgressIsForTerminalsAndNotForQuietRuns) {
  EXPECT_EQ(messages_of_slow_run({"detect"}, false).find("reading"), std::string::npos);
  EXPECT_EQ(messages_of_slow_run({"detect", "--quiet"}, true), "");
}

}  // namespace
}  // namespace beespace::cli_test
