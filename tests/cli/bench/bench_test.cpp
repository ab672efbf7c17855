// `beespace bench`: its table, its document, and that both have every figure.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/json_check.hpp"

namespace beespace::cli_test {
namespace {

std::size_t occurrences(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Bench, TheTableHasAlignedFiguresForEveryQuestion) {
  const Finished finished = run({"bench", "--points", "1000", "--threads", "2"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  for (const char* question : {" at-risk ", " pairs ", " counts ", " nearest ", " groups "}) {
    EXPECT_EQ(occurrences(finished.out, question), 5u) << question << "in\n" << finished.out;
  }
  std::istringstream lines(finished.out.substr(finished.out.find("  scene")));
  std::string heading;
  std::getline(lines, heading);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(line.size(), heading.size()) << line;
  }
  EXPECT_NE(finished.err.find("compared with brute force"), std::string::npos) << finished.err;
}

TEST(Bench, OneThreadNeedsOneColumn) {
  const Finished finished = run({"bench", "--points", "1000", "--threads", "1", "--quiet"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(occurrences(finished.out, "ns/point"), 1u) << finished.out;
  EXPECT_EQ(finished.err, "");
}

TEST(Bench, JsonHasEveryFigureThatFitsIntoMemory) {
  const Finished finished = run({"bench", "--points", "1000", "--threads", "2", "--json"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  EXPECT_EQ(occurrences(finished.out, R"("floor_ns_per_point": )"), 5u);
  // Five scenes, five questions, two numbers of threads, less the pairs of the crowd.
  EXPECT_EQ(occurrences(finished.out, R"("ns_per_point": )"), 48u);
  EXPECT_NE(finished.out.find(R"("points": 1000)"), std::string::npos);
}

}  // namespace
}  // namespace beespace::cli_test
