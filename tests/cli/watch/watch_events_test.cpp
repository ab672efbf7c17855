// The events of `beespace watch`: worked out by hand, and byte for byte those that
// `beespace replay --report events` finds in the same recording.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// a stays; b comes by along x at 2 m/s, heard of every second: 20 - 2 t from it. Closer than 5 m
// from 7.5 s on, there at 10 s, and 5.5 m away again at 12.75 s.
std::string passing_by() {
  std::string text = "id,time_s,x,y,z\n";
  for (int t = 0; t <= 20; ++t) {
    const std::string time = std::to_string(t);
    text += "a," + time + ",0,0,0\nb," + time + "," + std::to_string(20 - 2 * t) + ",0,0\n";
  }
  return text;
}

constexpr std::string_view kEntered =
    R"({"event": "entered", "time_s": 7.5, "first": "a", "second": "b", )"
    R"("distance_m": 5, "closest_s": 8})";
constexpr std::string_view kClosestPassed =
    R"({"event": "closest_passed", "time_s": 10, "first": "a", "second": "b", )"
    R"("distance_m": 0, "closest_s": 10})";

// From a file, so that nothing comes of how fast the machine is.
Finished watch_file(const Arguments& more, const std::string& input) {
  const TemporaryFolder folder;
  return run(Arguments{"watch", folder.file("reports", input)} + more);
}

Finished watched(const Arguments& more, const std::string& input) {
  return watch_file(Arguments{"--threshold", "5"} + more, input);
}

// The lines of a table in the order of time, those of the same time as they come.
std::string in_order_of_time(const std::string& table) {
  auto lines = lines_of(table);
  if (lines.empty()) return {};
  std::stable_sort(lines.begin() + 1, lines.end(), [](const auto& a, const auto& b) {
    return std::stod(fields_of(a, ',').at(1)) < std::stod(fields_of(b, ',').at(1));
  });
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  return text;
}

// Each line as an object with the names of the columns.
std::string as_json_lines(const std::string& table) {
  const auto rows = rows_of(table, ',');
  std::string text;
  for (std::size_t row = 1; row < rows.size(); ++row) {
    text += '{';
    for (std::size_t i = 0; i < rows[row].size(); ++i) {
      text += (i > 0 ? ", \"" : "\"") + rows[0][i] + "\": ";
      text += i == 0 ? '"' + rows[row][i] + '"' : rows[row][i];
    }
    text += "}\n";
  }
  return text;
}

TEST(WatchEvents, AnEncounterIsPredictedEnteredPassedAndLeft) {
  const Finished finished = watched({}, passing_by());
  EXPECT_EQ(finished.exit_code, 0);
  const auto lines = lines_of(finished.out);
  ASSERT_EQ(lines.size(), 4u) << finished.out;
  EXPECT_EQ(
      lines[0],
      R"({"event": "predicted", "said_at_s": 1.9, "time_s": 7.5, "first": "a", "second": "b", )"
      R"("distance_m": 0, "closest_s": 10})");
  EXPECT_EQ(lines[1], kEntered);
  EXPECT_EQ(lines[2], kClosestPassed);
  EXPECT_EQ(lines[3], R"({"event": "left", "time_s": 12.75, "first": "a", "second": "b", )"
                      R"("distance_m": 5.5, "closest_s": 10})");
  for (const std::string& line : lines) EXPECT_TRUE(is_json(line)) << line;
}

// Head-on, and closest after the horizon: what is predicted is how close they are at its end.
TEST(WatchEvents, APredictionSaysThatTwoCloseInBeyondTheHorizon) {
  const auto event = lines_of(watched({"--horizon", "8"}, passing_by()).out).at(0);
  EXPECT_EQ(
      event,
      R"({"event": "predicted", "said_at_s": 1.9, "time_s": 7.5, "first": "a", "second": "b", )"
      R"("distance_m": 0.1999999999999993, "closest_s": 9.9, "closing": true})");
}

TEST(WatchEvents, TheLeaveFactorMovesTheLeavingAndTheHorizonThePrediction) {
  EXPECT_EQ(lines_of(watched({"--horizon", "0"}, passing_by()).out).at(0), kEntered);
  const auto lines = lines_of(watched({"--leave-factor", "2"}, passing_by()).out);
  EXPECT_EQ(lines.back(), R"({"event": "left", "time_s": 15, "first": "a", "second": "b", )"
                          R"("distance_m": 10, "closest_s": 10})");
}

TEST(WatchEvents, EventsComeBeforeTheInputEnds) {
  // Up to 11 s: enough to know of entering and passing, not of leaving.
  const std::string all = passing_by();
  const auto lines = lines_of(watched({"--horizon", "0"}, all.substr(0, all.find("a,12,"))).out);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0], kEntered);
  EXPECT_EQ(lines[1], kClosestPassed);
  expect_parts(lines[2], {R"("event": "ended", "time_s": 11, "first": "a")"});
}

TEST(WatchEvents, AVerticalThresholdIsComparedApart) {
  std::string high;
  for (const std::string& line : lines_of(passing_by())) {
    high += line.starts_with("b,") ? line.substr(0, line.size() - 1) + "4\n" : line + "\n";
  }
  EXPECT_EQ(watched({"--vertical", "4"}, high).out, "");
  EXPECT_EQ(lines_of(watched({"--vertical", "4.5"}, high).out).size(), 4u);
}

TEST(WatchEvents, ABeeThatIsSilentForLongIsStaleAndLost) {
  const Finished finished = watched({"--max-age", "3", "--horizon", "0"},
                                    "id,time_s,x,y,z\n"
                                    "a,0,0,0,0\nb,0,3,0,0\na,1,0,0,0\nb,1,3,0,0\n"
                                    "a,2,0,0,0\na,3,0,0,0\na,4,0,0,0\na,5,0,0,0\n");
  const auto lines = lines_of(finished.out);
  ASSERT_EQ(lines.size(), 3u) << finished.out;
  EXPECT_EQ(lines[1], R"({"event": "stale", "time_s": 1, "id": "b"})");
  expect_parts(lines[2], {R"({"event": "lost", "time_s": 1, "first": "a", "second": "b")"});
  expect_parts(finished.err, {"bees       1 heard of, 1 stale\n"});
  EXPECT_EQ(watched({"--max-age", "4", "--horizon", "0"},
                    "id,time_s,x,y,z\na,0,0,0,0\nb,0,90,0,0\na,2,0,0,0\na,4,0,0,0\n")
                .out,
            "");
}

// Recordings with many encounters.
class WatchOfARecording : public testing::TestWithParam<const char*> {
 protected:
  static std::string recording(const Arguments& more = {}) {
    const std::string scene = GetParam();
    Arguments question = {"generate",   "--scene", scene,        "--points", "60",
                          "--duration", "12",      "--interval", "0.4"};
    if (scene != "encounters") question = question + Arguments{"--size", "200"};
    const Finished made = run(question + more);
    EXPECT_EQ(made.exit_code, 0) << made.err;
    return in_order_of_time(made.out);
  }
};

TEST_P(WatchOfARecording, AgreesWithReplayHoweverOftenItLooks) {
  const std::string table = recording();
  for (const char* every : {"0.03", "0.1", "0.7", "5", "1000"}) {
    const Arguments live = {"--threshold", "15", "--look-every", every};
    const Finished replayed =
        run(Arguments{"replay", "--report", "events", "--quiet"} + live, table);
    EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
    EXPECT_GT(lines_of(replayed.out).size(), 20u);
    const Finished watched = watch_file(live, table);
    EXPECT_EQ(watched.exit_code, 0) << watched.err;
    EXPECT_TRUE(watched.out == replayed.out) << GetParam() << ", looked every " << every;
    EXPECT_TRUE(watch_file(live, as_json_lines(table)).out == replayed.out)
        << "as JSON, " << GetParam() << ", looked every " << every;
  }
}

TEST_P(WatchOfARecording, AgreesForAVerticalThresholdAndOtherHorizons) {
  const std::string table = recording({"--seed", "3"});
  for (const Arguments& live :
       {Arguments{"--vertical", "10"}, Arguments{"--horizon", "2", "--leave-factor", "1"},
        Arguments{"--horizon", "0", "--leave-factor", "1.5"}, Arguments{"--threads", "3"}}) {
    const Arguments both = Arguments{"--threshold", "20"} + live;
    EXPECT_TRUE(watch_file(both, table).out ==
                run(Arguments{"replay", "--report", "events"} + both, table).out)
        << GetParam() << live[0];
  }
}

// Past events follow from the reports alone; only predictions depend on the looks.
TEST_P(WatchOfARecording, ReportsTheSamePastHoweverOftenItLooks) {
  const std::string table = recording();
  std::vector<std::string> first;
  for (const char* every : {"0.05", "3", "1000"}) {
    const Finished finished = watch_file(
        {"--threshold", "15", "--horizon", "0", "--look-every", every, "--quiet"}, table);
    std::vector<std::string> what;
    for (const std::string& line : lines_of(finished.out)) {
      what.push_back(line.substr(0, line.find(", \"closest_s\"")));
    }
    std::sort(what.begin(), what.end());
    if (first.empty()) first = what;
    EXPECT_TRUE(what == first) << GetParam() << ", looked every " << every;
  }
}

INSTANTIATE_TEST_SUITE_P(Some, WatchOfARecording,
                         testing::Values("flight", "crossing", "encounters"),
                         [](const auto& scene) { return std::string(scene.param); });

TEST(WatchEvents, AircraftAreWatchedAsTheyAreReplayed) {
  std::string table = "id,time_s,lon,lat,height,ve,vn,vu\n";
  for (int t = 0; t <= 60; ++t) {
    const std::string time = std::to_string(t);
    const std::string along = std::to_string(0.1 * t / 60.0);
    const std::string back = std::to_string(0.1 - 0.1 * t / 60.0);
    table += "KLM1," + time + "," + along + ",0.001,10000,185,0,0\n";
    table += "BAW2," + time + "," + back + ",0.001,10200,-185,0,0\n";
  }
  const Arguments near = {"--threshold", "1000", "--vertical", "201"};
  const Finished watched = watch_file(near, table);
  EXPECT_EQ(watched.out, run(Arguments{"replay", "--report", "events"} + near, table).out);
  expect_parts(watched.out, {R"("event": "entered")",
                             R"("event": "closest_passed", "time_s": 30, "first": "KLM1", )",
                             R"("event": "left")"});
  const Arguments apart = {"--threshold", "1000", "--vertical", "200"};
  EXPECT_EQ(watch_file(apart, table).out, "");
}

TEST(WatchEvents, ReplayHasThemAsATableAndInItsDocumentToo) {
  const Arguments question = {"replay", "--threshold", "5", "--report", "events", "--horizon", "0"};
  const auto rows = rows_of(run(question + Arguments{"--csv"}, passing_by()).out, ',');
  expect_rows(rows, {{"time_s", "event", "first", "second", "distance_m", "closest_s", "said_at_s",
                      "closing"},
                     {"7.5", "entered", "a", "b", "5", "8", "", ""},
                     {"10", "closest_passed", "a", "b", "0", "10", "", ""},
                     {"12.75", "left", "a", "b", "5.5", "10", "", ""}});
  const Arguments ahead = {"replay", "--threshold", "5", "--report", "events", "--horizon", "8"};
  const auto said = rows_of(run(ahead + Arguments{"--csv"}, passing_by()).out, ',');
  expect_rows({said.at(1)}, {{"7.5", "predicted", "a", "b", "0.2", "9.9", "1.9", "yes"}});
  const std::string json = run(question + Arguments{"--json"}, passing_by()).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("events": [)", R"({"time_s": 12.75, "event": "left", "first": "a", )"});
}

}  // namespace
}  // namespace beespace::cli_test
