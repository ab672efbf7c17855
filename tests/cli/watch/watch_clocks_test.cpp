// `beespace watch` and clocks that are wrong: the bee is named, and all others are watched as if it
// were not there.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

using Ahead = std::function<double(double time_s)>;

// Pairs of bees that pass each other, one pair a second, ten reports a second each; and c, far off.
std::string flock(double lasts_s, const Ahead& ahead, bool with_c = true) {
  std::ostringstream text;
  text.precision(12);
  text << "id,time_s,x,y,z\n";
  for (int round = 0; round < static_cast<int>(10.0 * lasts_s); ++round) {
    const double t = round / 10.0;
    for (int pair = 0; pair < 20; ++pair) {
      const double along = 10.0 * (t - pair - 1);
      text << "a" << pair << "," << t << "," << along << "," << 1'000 * pair << ",0\n";
      text << "b" << pair << "," << t << "," << -along << "," << 1'000 * pair + 1 << ",0\n";
      if (with_c && pair == 9) text << "c," << t + ahead(t) << ",0,-9000,0\n";
    }
  }
  return text.str();
}

// As from a file, so that the speed of the machine does not matter.
Finished watched(const std::string& table, const Arguments& more = {}) {
  const TemporaryFolder folder;
  return run(Arguments{"watch", "--threshold", "5", folder.file("bees.csv", table)} + more);
}

// The lines that are not about c; and of these what has happened.
std::string of_others(const std::string& lines, bool predictions = true) {
  std::string text;
  for (const std::string& line : lines_of(lines)) {
    if (line.find("\"c\"") != std::string::npos) continue;
    if (!predictions && line.find("\"predicted\"") != std::string::npos) continue;
    text += line + "\n";
  }
  return text;
}

std::vector<std::string> of_clocks(const std::string& lines) {
  std::vector<std::string> found;
  for (const std::string& line : lines_of(lines)) {
    if (line.starts_with(R"({"event": "clock)")) found.push_back(line);
  }
  return found;
}

constexpr double kYear_s = 365.0 * 86'400.0;

TEST(WatchClocks, ABeeWhoseClockIsOffIsNamedAndTheOthersGoOn) {
  constexpr double kLasts_s = 25.0;
  const Ahead right = [](double) { return 0.0; };
  const std::string without = watched(flock(kLasts_s, right, false)).out;
  EXPECT_GT(lines_of(without).size(), 60u);
  struct Case {
    const char* what;
    Ahead ahead;
    const char* said;
  };
  for (const Case& wrong : {
           Case{"a year ahead from the fifth second on",
                [](double t) { return t < 5.0 ? 0.0 : kYear_s; }, R"("ahead_s": 31536000)"},
           Case{"a year ahead", [](double) { return kYear_s; }, R"("ahead_s": 31536000)"},
           Case{"5 s ahead", [](double) { return 5.0; }, R"("ahead_s": 5)"},
           Case{"18 s ahead", [](double) { return 18.0; }, R"("ahead_s": 18)"},
           Case{"59 s ahead", [](double) { return 59.0; }, R"("ahead_s": 59)"},
           Case{"3 s behind", [](double) { return -3.0; }, R"("ahead_s": -3)"},
           Case{"an hour behind", [](double) { return -3'600.0; }, R"("ahead_s": -3600)"},
           Case{"too fast", [](double t) { return t; }, R"("ahead_s": 2.)"},
           Case{"too slow", [](double t) { return -0.9 * t; }, R"("ahead_s": -)"},
           Case{"stepping", [](double t) { return 100.0 * std::floor(t); }, R"("ahead_s": 100)"},
       }) {
    const Finished finished = watched(flock(kLasts_s, wrong.ahead));
    EXPECT_EQ(finished.exit_code, 0) << wrong.what;
    // A clock that runs away is believed, and takes the looks along, up to --max-skew.
    const bool early = std::string(wrong.what) == "too fast";
    EXPECT_TRUE(of_others(finished.out, !early) == of_others(without, !early)) << wrong.what << "\n"
                                                                               << finished.err;
    const auto clocks = of_clocks(finished.out);
    ASSERT_FALSE(clocks.empty()) << wrong.what;
    EXPECT_LT(clocks.size(), 5u) << wrong.what;
    EXPECT_TRUE(is_json(clocks[0])) << clocks[0];
    expect_parts(clocks[0], {R"("event": "clock", "time_s": )", R"("id": "c")", wrong.said,
                             R"("right": false)"});
    expect_parts(finished.err, {"clocks     1 bee's is off, the last named: c, by "});
  }
}

TEST(WatchClocks, ABeeWhoseClockIsOffIsStillWatchedAtTheTimeOfTheOthers) {
  // c stands in the way of a5, which is there at 6 s.
  std::string table = flock(10.0, [](double) { return 30.0; });
  for (std::size_t at = 0; (at = table.find(",0,-9000,0", at)) != std::string::npos;) {
    table.replace(at, 10, ",0,4998,0");
  }
  const Finished finished = watched(table, {"--horizon", "0"});
  bool entered = false;
  for (const std::string& line : lines_of(finished.out)) {
    if (line.find("\"entered\"") == std::string::npos) continue;
    if (line.find(R"("second": "c")") == std::string::npos) continue;
    if (line.find(R"("first": "a5")") == std::string::npos) continue;
    entered = true;
    const double time_s = std::stod(line.substr(line.find("\"time_s\": ") + 10));
    EXPECT_NEAR(time_s, 5.6, 0.3) << line;
  }
  EXPECT_TRUE(entered) << finished.out;
}

// Less than is disbelieved, and 15 m for who flies 10 m/s: no promise includes it.
TEST(WatchClocks, ThatDifferByASecondAndAHalfAreNamedAndNoAllClear) {
  for (const double ahead_s : {1.5, -1.5}) {
    std::ostringstream table;
    table << "id,time_s,x,y,z\n";
    for (int round = 0; round < 200; ++round) {
      for (int bee = 0; bee < 6; ++bee) {
        const double time_s = round / 10.0 + (bee == 4 ? ahead_s : 0.0);
        table << bee << "," << time_s << "," << round << "," << 1'000 * bee << ",0\n";
      }
    }
    const Finished finished = watched(table.str(), {"--fail-on-risk", "--horizon", "0"});
    EXPECT_EQ(finished.exit_code, 1) << ahead_s;
    const auto clocks = of_clocks(finished.out);
    ASSERT_EQ(clocks.size(), 1u) << finished.out;
    EXPECT_TRUE(is_json(clocks[0])) << clocks[0];
    expect_parts(clocks[0], {R"("id": "4", "ahead_s": )", R"("right": false, "corrected": false)"});
    expect_parts(finished.err,
                 {"clocks     1 bee's differs from the others', the last named: 4, 1.",
                  ahead_s > 0.0 ? " s ahead\n" : " s behind, or late\n",
                  "verdict    not known, as 1 bee's clock differs from the others'\n"});
  }
}

TEST(WatchClocks, ThatDifferByLittleAreAllBelieved) {
  std::ostringstream table;
  table << "id,time_s,x,y,z\n";
  for (int round = 0; round < 200; ++round) {
    for (int bee = 0; bee < 30; ++bee) {
      table << bee << "," << round / 10.0 + 0.03 * bee << "," << 1'000 * bee << ",0,0\n";
    }
  }
  const Finished finished = watched(table.str());
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(finished.err.find("clocks"), std::string::npos) << finished.err;
  expect_parts(finished.err, {"reports    6,000\n", "bees       30 heard of, 0 stale\n"});
}

TEST(WatchClocks, ThatAllBeginAnewAreFollowed) {
  const Ahead before = [](double) { return 0.0; };
  std::string table = flock(21.0, before);
  const std::string again = flock(21.0, before);
  const std::string once = watched(table).out;
  table += again.substr(again.find('\n') + 1);
  const Finished finished = watched(table);
  EXPECT_EQ(finished.exit_code, 0);
  const std::string anew = R"({"event": "clocks_anew", "time_s": 0, "before_s": 20.9})"
                           "\n";
  expect_parts(finished.out, {anew});
  EXPECT_TRUE(finished.out == once + anew + once) << "as before, from the first";
  expect_parts(finished.err, {"clocks     all began anew\n"});
}

TEST(WatchClocks, OfManyBeesCostNoMoreWithOneThatIsOff) {
  std::ostringstream right;
  std::ostringstream wrong;
  for (std::ostringstream* table : {&right, &wrong}) {
    table->precision(12);
    *table << "id,time_s,x,y,z\n";
    for (int round = 0; round < 100; ++round) {
      for (int bee = 0; bee < 1'000; ++bee) {
        const double ahead_s = table == &wrong && bee == 7 ? kYear_s : 0.0;
        *table << bee << "," << round / 10.0 + ahead_s << "," << 100 * bee << ",0,0\n";
      }
    }
  }
  const auto seconds = [](const std::string& table) {
    const auto start = std::chrono::steady_clock::now();
    expect_parts(watched(table).err, {"bees       1,000 heard of, 0 stale\n"});
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const double right_s = seconds(right.str());
  EXPECT_LT(seconds(wrong.str()), 3.0 * right_s + 1.0);
}

// Each counts from when it was switched on, so that nothing tells where two were at one moment.
TEST(WatchClocks, ThatCountFromWhenEachVehicleWasSwitchedOnAreRefused) {
  const auto line = [](int id, int time_ms) {
    return R"({"sysid": )" + std::to_string(id) + R"(, "time_boot_ms": )" +
           std::to_string(time_ms) +
           R"(, "lat": 473977420, "lon": 85447992, "alt": 508000, "relative_alt": 20000})" + "\n";
  };
  const std::string alone = line(1, 0) + line(1, 200) + line(1, 400);
  EXPECT_EQ(run({"watch", "--threshold", "5"}, alone).exit_code, 0);
  const std::string two = line(1, 0) + line(2, 400) + line(1, 200) + line(2, 600);
  const TemporaryFolder folder;
  const std::vector<std::string> asked = {"watch", "--threshold", "5", "--fail-on-risk"};
  expect_failure(asked, two, 2,
                 "<stdin>:2: 'time_boot_ms' counts from when each vehicle was switched on, but "
                 "here are several ('1', '2'): then they cannot be compared; use a time of one "
                 "clock, or take the time at which each report comes, --clock arrival");
  expect_failure({"watch", "--threshold", "5", folder.file("two.ndjson", two)}, {}, 2,
                 "or of reports as they come, not of a file");
  expect_failure(asked, "id,time_boot_ms,x_m,y_m,z_m\na,0,0,0,0\nb,400,1,0,0\n", 2,
                 "<stdin>:3: 'time_boot_ms' counts from when each vehicle was switched on");
  for (const std::vector<std::string>& said :
       {std::vector<std::string>{"--clock", "arrival"}, {"--one-clock"}}) {
    std::vector<std::string> command = {"watch", "--threshold", "5"};
    command.insert(command.end(), said.begin(), said.end());
    expect_parts(run(command, two).out, {R"("first": "1", "second": "2")"});
  }
}

// By the time of arrival, whatever time a report states.
TEST(WatchClocks, OfArrivalAreThoseOfThisMachine) {
  Running running({"watch", "--threshold", "5", "--clock", "arrival", "--horizon", "0"});
  const auto now_s = [] {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch())
        .count();
  };
  running.send("id,time_s,x,y,z\na,5,0,0,0\nb,-1e9,1,0,0\n");
  // What comes after that is of a later time.
  const std::string line = running.read_line();
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  running.send("a,4,0,0,0\nb,1e20,1,0,0\n");
  expect_parts(line, {R"({"event": "entered", "time_s": )", R"("first": "a", "second": "b")"});
  EXPECT_NEAR(std::stod(line.substr(line.find("\"time_s\": ") + 10)), now_s(), 60.0);
  running.close_input();
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err, {"reports    4\n"});
  const TemporaryFolder folder;
  expect_failure({"watch", "--clock", "arrival", folder.file("bees.csv", "id,time_s,x,y,z\n")}, {},
                 2, "--clock arrival is for reports that come as things happen, not for a file");
}

}  // namespace
}  // namespace beespace::cli_test
