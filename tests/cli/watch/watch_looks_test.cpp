// When `beespace watch` looks at the swarm.
#include <gtest/gtest.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::string tenths(int count) {
  std::ostringstream text;
  text << count / 10;
  if (count % 10 != 0) text << '.' << count % 10;
  return text.str();
}

// At each tenth of a second two bees are heard 1 m apart, which have entered, and two that will
// come too close later. A look writes past events first, so a predicted event comes between them
// only if each tenth has a look of its own that uses all reports of its time.
TEST(WatchLooks, NoneIsSkippedAndEachSeesTheReportsOfItsOwnTime) {
  constexpr int kLooks = 1'000;
  std::ostringstream table;
  table << "id,time_s,x,y,z,vx,vy,vz\n";
  for (int i = 0; i <= kLooks; ++i) {
    table << "a" << i << "," << tenths(i) << "," << 100 * i << ",0,0,0,0,0\n";
    table << "b" << i << "," << tenths(i) << "," << 100 * i + 1 << ",0,0,0,0,0\n";
    table << "c" << i << "," << tenths(i) << "," << 100 * i << "," << 9'000 + 50 * i
          << ",0,1,0,0\n";
    table << "d" << i << "," << tenths(i) << "," << 100 * i + 10 << "," << 9'000 + 50 * i
          << ",0,-1,0,0\n";
  }
  const TemporaryFolder folder;
  const Finished finished = run({"watch", folder.file("reports", table.str()), "--threshold", "5",
                                 "--max-age", "1000", "--max-skew", "2"});
  std::vector<std::string> lines;
  for (const std::string& line : lines_of(finished.out)) {
    if (line.find("\"ended\"") == std::string::npos) lines.push_back(line);
  }
  ASSERT_EQ(lines.size(), 2 * static_cast<std::size_t>(kLooks + 1)) << finished.err;
  for (int i = 0; i <= kLooks; ++i) {
    std::ostringstream entered;
    entered << R"({"event": "entered", "time_s": )" << tenths(i) << R"(, "first": "a)" << i << '"';
    std::ostringstream predicted;
    predicted << R"("second": "d)" << i << '"';
    expect_parts(lines[2 * static_cast<std::size_t>(i)], {entered.str()});
    expect_parts(lines[2 * static_cast<std::size_t>(i) + 1],
                 {R"({"event": "predicted")", predicted.str()});
  }
}

// a and b stand 1 m apart, and then come lines that bring nothing new.
TEST(WatchLooks, LinesThatBringNothingKeepItFromNone) {
  for (const std::string nothing : {"\n", "rubbish\n", "a,0,0,0,0,0,0,0\n", "a,-1,0,0,0,0,0,0\n"}) {
    const TemporaryFolder folder;
    Surroundings to_file;
    to_file.output = Surroundings::Output::kFile;
    to_file.file = folder.file("events", "");
    Running running({"watch", "--threshold", "5", "--max-age", "1"}, to_file);
    running.send("id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,0,0,0\nb,0,1,0,0,0,0,0\n");
    const auto start = std::chrono::steady_clock::now();
    const auto told = [&](const char* what) {
      const auto passed = [&] { return std::chrono::steady_clock::now() - start; };
      while (passed() < std::chrono::seconds(20)) {
        running.send(nothing);
        if (folder.read("events").find(what) != std::string::npos) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
      }
      return std::chrono::duration<double>(passed()).count();
    };
    EXPECT_LT(told("\"entered\""), 3.0) << nothing;
    EXPECT_LT(told("\"stale\""), 5.0) << nothing;
    running.close_input();
    EXPECT_EQ(running.finish().exit_code, 0);
  }
}

}  // namespace
}  // namespace beespace::cli_test
