// When `beespace watch` looks at the swarm.
#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

#include "tests/cli/command_run.hpp"
#include "tests/cli/expectations.hpp"

namespace beespace::cli_test {
namespace {

std::string tenths(int count) {
  std::ostringstream text;
  text << count / 10;
  if (count % 10 != 0) text << '.' << count % 10;
  return text.str();
}

// Two bees come to stand 1 m apart, far from all others, at each tenth of a second: what is
// predicted of them is so from the first look that sees them.
TEST(WatchLooks, NoneIsSkippedAndEachSeesTheReportsOfItsOwnTime) {
  constexpr int kLooks = 1'000;
  std::ostringstream table;
  table << "id,time_s,x,y,z,vx,vy,vz\n";
  for (int i = 0; i <= kLooks; ++i) {
    table << "a" << i << "," << tenths(i) << "," << 100 * i << ",0,0,0,0,0\n";
    table << "b" << i << "," << tenths(i) << "," << 100 * i + 1 << ",0,0,0,0,0\n";
  }
  const Finished finished = run({"watch", "--threshold", "5", "--max-age", "1000"}, table.str());
  std::vector<std::string> predicted;
  for (const std::string& line : lines_of(finished.out)) {
    if (line.starts_with(R"({"event": "predicted")")) predicted.push_back(line);
  }
  ASSERT_EQ(predicted.size(), static_cast<std::size_t>(kLooks) + 1) << finished.err;
  for (int i = 0; i <= kLooks; ++i) {
    std::ostringstream pair;
    pair << R"("time_s": )" << tenths(i) << R"(, "first": "a)" << i << R"(", "second": "b)" << i
         << '"';
    expect_parts(predicted[static_cast<std::size_t>(i)], {pair.str()});
  }
}

}  // namespace
}  // namespace beespace::cli_test
