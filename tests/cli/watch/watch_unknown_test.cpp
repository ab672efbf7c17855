// Unknown bees of `beespace watch`: those heard once, silent or too many. It names them, and ends
// with 0 only where no conflict follows from what is known.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"
#include "tests/support/rounds.hpp"

namespace beespace::cli_test {
namespace {

Finished watched(const std::string& lines, const Arguments& more = {}) {
  const TemporaryFolder folder;
  return run(Arguments{"watch", folder.file("reports", "id,time_s,x,y,z\n" + lines), "--threshold",
                       "5", "--fail-on-risk"} +
             more);
}

// a stands still for 20 s; b is heard of for a second, `apart` metres from it.
std::string silent(const std::string& apart) {
  std::ostringstream text;
  for (int t = 0; t <= 20; ++t) {
    text << "a," << t << ",0,0,0\n";
    if (t <= 1) text << "b," << t << "," << apart << ",0,0\n";
  }
  return text.str();
}

TEST(WatchUnknown, ABeeHeardOfOnceIsInConflict) {
  const Finished finished = watched("a,0,0,0,0\nb,0,3,0,0\n");
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.out, {R"({"event": "entered", "time_s": 0, "first": "a", "second": "b", )"
                              R"("distance_m": 3)",
                              R"({"event": "ended", "time_s": 0)"});
  expect_parts(finished.err, {"verdict    1 conflict; 2 bees were heard of once only\n"});
  EXPECT_EQ(watched("a,0,0,0,0\nb,0,6,0,0\n").out, "");
}

TEST(WatchUnknown, ASilentBeeHasNotLeft) {
  const Finished finished = watched(silent("3"));
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(finished.out.find("\"left\""), std::string::npos) << finished.out;
  expect_parts(finished.out, {R"({"event": "lost", "time_s": 1, "first": "a", "second": "b")"});
  expect_parts(finished.err,
               {"unknown    1 bee for 19 s: b 19 s (to the end)\n", "lost       1\n"});
}

TEST(WatchUnknown, WhereABeeIsUnknownItIsNotKnownThatThereWasNoConflict) {
  const Finished finished = watched(silent("1000"));
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"unknown    1 bee for 19 s: b 19 s (to the end)\n",
                              "verdict    no conflict in the known time; 1 bee was unknown"});
  // It leaves; or its greatest speed tells.
  const std::string from_a = silent("1000").substr(silent("1000").find("a,2,"));
  EXPECT_EQ(watched("b,0,1000,0,0\na,1,0,0,0\n" + from_a).exit_code, 1);
  EXPECT_EQ(watched("b,0,1000,0,0\na,1,0,0,0\n{\"event\": \"leave\", \"id\": \"b\"}\n" + from_a)
                .exit_code,
            0);
  const Finished slow = watched(silent("1000"), {"--max-speed", "1"});
  EXPECT_EQ(slow.exit_code, 0) << slow.out << slow.err;
  EXPECT_EQ(slow.out.find("possible"), std::string::npos) << slow.out;
  const Finished fast = watched(silent("1000"), {"--max-speed", "100"});
  EXPECT_EQ(fast.exit_code, 1);
  expect_parts(fast.out, {R"({"event": "possible", "time_s": )", R"("since_s": 1)"});
  expect_parts(fast.err, {"possible   1\n", ", 1 possible conflict"});
  for (const std::string& line : lines_of(fast.out)) EXPECT_TRUE(is_json(line)) << line;
}

// A file sorted by bee, of a time so short that no clock can be told from a late one.
TEST(WatchUnknown, WhoIsHeardOfAfterTheOthersAreForgottenIsNotSaidToKeepItsDistance) {
  std::ostringstream sorted;
  std::ostringstream after_each_other;
  for (const char* bee : {"a", "b"}) {
    for (int t = 0; t <= 15; ++t) sorted << bee << "," << t << "e-1," << t - 8 << ",0,0\n";
  }
  const Finished finished = watched(sorted.str());
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"missed     1 bee was heard of late, b by 1.", " s: sort the reports by time",
                "1 bee was heard of too late to be compared from then on\n"});
  // Who comes later and is reported then misses nothing.
  for (int t = 0; t <= 30; ++t) {
    after_each_other << "a," << t << "e-1," << t << ",0,0\n";
    if (t >= 15) after_each_other << "b," << t << "e-1," << t << ",90,0\n";
  }
  const Finished later = watched(after_each_other.str());
  EXPECT_EQ(later.exit_code, 0) << later.err;
  EXPECT_EQ(later.err.find("missed"), std::string::npos) << later.err;
}

TEST(WatchUnknown, BeesBeyondTheBoundAreLeftOutAndReported) {
  std::ostringstream text;
  for (int t = 0; t < 30; ++t) {
    for (const char* bee : {"a", "b", "c", "d"}) {
      text << bee << "," << t << "," << 100 * (bee[0] - 'a') << ",0,0\n";
    }
  }
  const Finished finished = watched(text.str(), {"--max-bees", "2"});
  EXPECT_EQ(finished.exit_code, 1);
  // Every ten seconds.
  const auto lines = lines_of(finished.out);
  ASSERT_EQ(lines.size(), 3u) << finished.out;
  for (const std::string& line : lines) {
    EXPECT_TRUE(is_json(line)) << line;
    expect_parts(line, {R"({"event": "overloaded", "time_s": )", R"("bound": "bees")"});
  }
  expect_parts(finished.err, {"there are 2 bees already; say --max-bees, or which have left",
                              "bees       2 heard of", "overloaded: not all was watched"});
}

TEST(WatchUnknown, BeesThatHaveLeftMakeRoomForOthers) {
  std::ostringstream text;
  for (int t = 0; t < 100; ++t) {
    text << "bee" << t << "," << t << ",0,0,0\n";
    text << "{\"event\": \"leave\", \"id\": \"bee" << t << "\"}\n";
  }
  const Finished finished = watched(text.str(), {"--max-bees", "4", "--max-age", "0.5"});
  EXPECT_EQ(finished.exit_code, 0) << finished.out << finished.err;
  EXPECT_EQ(finished.out, "");
  expect_parts(finished.err, {"reports    100\n"});
}

TEST(WatchUnknown, ManyBeesAtOnePlaceAreBounded) {
  std::ostringstream text;
  for (int t = 0; t < 5; ++t) {
    for (int bee = 0; bee < 3'000; ++bee) {
      text << bee << "," << t << "," << 1e-4 * bee << ",0,0\n";
    }
  }
  const TemporaryFolder folder;
  Surroundings little;
  // All pairs would take 1.2 GB. A sanitizer reserves more than any limit would allow.
  if (!test::kSanitized) little.memory_bytes = std::size_t{400} << 20;
  const Finished finished = run({"watch", folder.file("reports", "id,time_s,x,y,z\n" + text.str()),
                                 "--threshold", "5", "--fail-on-risk", "--max-pairs", "20000"},
                                {}, little);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.out, {R"({"event": "overloaded", "time_s": )", R"("bound": "pairs")"});
  expect_parts(finished.err, {"overloaded: not all was watched"});
}

TEST(WatchUnknown, InvalidBoundsAreRefused) {
  for (const std::string option : {"--max-bees", "--max-pairs"}) {
    for (const std::string bad : {"0", "-1", "many", "1.5", "5000000000"}) {
      expect_usage_error({"watch", option + "=" + bad},
                         option + " '" + bad + "' is not a whole number from 1");
    }
  }
}

}  // namespace
}  // namespace beespace::cli_test
