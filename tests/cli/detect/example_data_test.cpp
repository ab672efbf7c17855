// The example file of the repository is what the command makes, and its answer stays the same.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/cli/run/command_run.hpp"

namespace beespace::cli_test {
namespace {

TEST(ExampleData, GeneratingItAgainGivesTheSameBytes) {
  std::ifstream file(BEESPACE_EXAMPLE_DATA, std::ios::binary);
  ASSERT_TRUE(file.is_open());
  const std::string stored{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  const Finished finished =
      run({"generate", "--area", "medellin", "--points", "1000", "--seed", "2018"});
  EXPECT_TRUE(finished.out == stored) << "the example differs from what generate makes";
}

TEST(ExampleData, ItsAnswerIsKnown) {
  const Finished finished = run({"detect", BEESPACE_EXAMPLE_DATA});
  EXPECT_EQ(finished.exit_code, 0);
  std::size_t lines = 0;
  for (const char c : finished.out) lines += c == '\n' ? 1 : 0;
  EXPECT_EQ(lines, 650u);
}

}  // namespace
}  // namespace beespace::cli_test
