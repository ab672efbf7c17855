// `beespace watch` as a program that runs for long: what it reads, passes over and refuses, how
// fast it goes, and how it ends. Its events are in watch_events_test.cpp.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// 1 m from each other at 0 s and at 1 s: they enter, and have not left at the end.
constexpr std::string_view kTogether =
    "id,time_s,x,y,z\na,0,0,0,0\nb,0,1,0,0\na,1,0,0,0\nb,1,1,0,0\n";
std::string entered_and_ended_at(const std::string& time_s) {
  const std::string rest = R"(, "first": "a", "second": "b", "distance_m": 1, "closest_s": 0})"
                           "\n";
  return R"({"event": "entered", "time_s": 0)" + rest + R"({"event": "ended", "time_s": )" +
         time_s + rest;
}
const std::string kEnteredAndEnded = entered_and_ended_at("1");

Finished watched(const std::string& reports, const Arguments& more = {}) {
  return run(Arguments{"watch", "--horizon", "0"} + more, reports);
}

double seconds_for(const Arguments& arguments, std::string_view input) {
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(run(arguments, input).exit_code, 0);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Both are heard of again, as lines of a table and of JSON.
const std::string kAgain = "a,1,0,0,0\nb,1,1,0,0\n";
const std::string kAgainInJson =
    "{\"id\": \"a\", \"time_s\": 1, \"x\": 0, \"y\": 0, \"z\": 0}\n"
    "{\"id\": \"b\", \"time_s\": 1, \"x\": 1, \"y\": 0, \"z\": 0}\n";
const std::string kAInJson = "{\"id\": \"a\", \"time_s\": 0, \"x\": 0, \"y\": 0, \"z\": 0}\n";
// With its keys in another order.
const std::string kBInJson = "{\"x\": 1, \"y\": 0, \"z\": 0, \"id\": \"b\", \"time_s\": 0}\n";

TEST(Watch, TablesAndJsonLinesAreReadAndReported) {
  const Finished table = watched(std::string(kTogether));
  EXPECT_EQ(table.exit_code, 0);
  EXPECT_EQ(table.out, kEnteredAndEnded);
  expect_parts(table.err, {"input      text, comma-separated\n", "times are read from column 2",
                           "reports    4\n", "bees       2 heard of, 0 stale\n",
                           "threshold  100 m (closer than)\n", "predicted  0\n", "entered    1\n",
                           "left       0\n"});
  const Finished json = watched(kAInJson + kBInJson + kAgainInJson);
  EXPECT_EQ(json.out, kEnteredAndEnded);
  expect_parts(json.err, {"input      JSON, an object a line\n", "reports    4\n"});
}

TEST(Watch, LineEndsOfEveryKindAndALastLineWithoutOneAreRead) {
  EXPECT_EQ(watched("id,time_s,x,y,z\r\na,0,0,0,0\r\n\r\nb,0,1,0,0\na,1,0,0,0\r\nb,1,1,0,0").out,
            kEnteredAndEnded);
}

TEST(Watch, ColumnsFramesAndUnitsMayBeGiven) {
  EXPECT_EQ(watched("a 0 0 0 0\nb 0 1 0 0\na 9 0 0 0\nb 9 1 0 0\n",
                    {"--columns", "id=1,time=2,x=3,y=4,z=5", "--time-unit", "ms"})
                .out,
            entered_and_ended_at("0.009"));
  EXPECT_EQ(watched("id,time,x,y,z\na,0,0,0,0\nb,0,1,0,0\n" + kAgain, {"--time-unit", "ms"}).out,
            entered_and_ended_at("0.001"));
  expect_failure({"watch"}, "id,time,x,y,z\na,0,0,0,0\n", 2, "--time-unit s, ms, us or ns");
  expect_failure({"watch", "--crs", "metres", "--columns", "id=1,time=2,lon=3,lat=4"}, kTogether, 2,
                 "--crs");
}

TEST(Watch, IdsCannotBreakALineOfJson) {
  const auto lines = lines_of(watched("id,time_s,x,y,z\n"
                                      "\"a\"\"\\\",0,0,0,0\nb\tc,0,1,0,0\n"
                                      "\"a\"\"\\\",1,0,0,0\nb\tc,1,1,0,0\n")
                                  .out);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_TRUE(is_json(lines[0])) << lines[0];
  expect_parts(lines[0], {R"("first": "a\"\\")", R"("second": "b\tc")"});
}

TEST(Watch, BadLinesAreReportedAndCountedAndTheRestSurvives) {
  const Finished finished = watched(
      "id,time_s,x,y,z\na,0,0,0,0\na,1,nan,0,0\nrubbish\n,,,,\nb,soon,1,0,0\nb,0,1,0,0\n" + kAgain);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, kEnteredAndEnded);
  expect_parts(finished.err,
               {"beespace: left out: <stdin>:3:3: 'nan'", "left out: <stdin>:4: 1 column",
                "left out: <stdin>:5:", "left out: <stdin>:6:2: 'soon'", "reports    4\n",
                "bad lines  4 left out\n"});
  EXPECT_EQ(watched("id,time_s,x,y,z\na,0,0,0,0\nrubbish\nb,0,1,0,0\n", {"--quiet"}).err, "");
}

TEST(Watch, BadLinesOfJsonAreReportedAndCountedAndTheRestSurvives) {
  const Finished finished =
      watched(kAInJson + "{\"id\": \"b\"}\n{\n[1, 2]\n{}\n" +
              "{\"id\": \"b\", \"time_s\": \"soon\", \"x\": 1, \"y\": 0, \"z\": 0}\n" + kBInJson +
              kAgainInJson);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, kEnteredAndEnded);
  expect_parts(finished.err, {"left out: <stdin>:2:", "left out: <stdin>:3:",
                              "left out: <stdin>:4:", "left out: <stdin>:5:",
                              "left out: <stdin>:6:", "reports    4\n", "bad lines  5 left out\n"});
}

TEST(Watch, OnlyTheFirstBadLinesAreReportedOneByOne) {
  std::string many(kTogether);
  for (int i = 0; i < 50; ++i) many += "rubbish\n";
  const Finished finished = watched(many);
  int said = 0;
  for (const std::string& line : lines_of(finished.err)) {
    if (line.starts_with("beespace: left out: ")) ++said;
  }
  EXPECT_EQ(said, 20);
  expect_parts(finished.err, {"bad lines  50 left out\n"});
}

TEST(Watch, ALineOfMegabytesIsOneBadLine) {
  const std::string long_line = "a,0," + std::string(std::size_t{5} << 20, '1') + ",0,0\n";
  const Finished finished =
      watched("id,time_s,x,y,z\na,0,0,0,0\n" + long_line + "b,0,1,0,0\n" + kAgain);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, kEnteredAndEnded);
  expect_parts(finished.err, {"bad lines  1 left out\n", "reports    4\n"});
  EXPECT_LT(finished.err.size(), 2'000u);
}

TEST(Watch, LateAndRepeatedReportsAreCountedAndLeftOut) {
  // A report puts a at b after later ones were heard, and others come twice at the same place.
  const Finished finished =
      watched("id,time_s,x,y,z\na,5,0,0,0\nb,5,500,0,0\na,4,500,0,0\na,5,0,0,0\nb,6,500,0,0\n");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "");
  expect_parts(finished.err,
               {"reports    3\n", "late       1 left out\n", "repeated   1 left out\n"});
}

TEST(Watch, ASparseFeedLosesNoReport) {
  // From each report to the next it is more than a minute, as far as all bees go.
  const Finished finished = watched(
      "id,time_s,x,y,z\na,0,0,0,0\nb,100,500,0,0\na,161,0,0,0\na,1000,0,0,0\nb,5000,500,0,0\n");
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err, {"reports    5\n"});
  EXPECT_EQ(finished.err.find("left out"), std::string::npos) << finished.err;
}

TEST(Watch, AReportFarAheadOfAllOthersInTimeIsLeftOutAndCounted) {
  const Finished finished =
      watched("id,time_s,x,y,z\na,0,0,0,0\nb,0,1,0,0\nb,9999,1,0,0\n" + kAgain);
  // Where b was in between is not known.
  expect_parts(
      finished.out,
      {R"({"event": "entered", "time_s": 0)", R"({"event": "stale", "time_s": 0, "id": "b"})",
       R"({"event": "lost", "time_s": 0)", R"({"event": "entered", "time_s": 1)"});
  expect_parts(finished.err, {"reports    4\n", "clocks     1 report left out for its time\n"});
}

TEST(Watch, TheSummarySaysTheFrameTheHeightsAndTheThreshold) {
  expect_parts(watched(std::string(kTogether), {"--threshold", "5", "--vertical", "2"}).err,
               {"input      text, comma-separated\n  frame      metres\n",
                "threshold  horizontally 5 m (closer than), and in height 2 m (closer than)\n"});
  const std::string aircraft =
      R"({"now":1000000.5,"hex":"4B1814","alt_baro":9000,"alt_geom":10000,)"
      R"("lat":47.25,"lon":8.5,"seen_pos":0})"
      "\n";
  expect_parts(
      watched(aircraft, {"--threshold", "5NM"}).err,
      {"frame      WGS84 longitude, latitude, height\n", "heights    above the WGS84 ellipsoid\n"});
  expect_parts(watched(aircraft, {"--threshold", "5NM", "--heights", "pressure"}).err,
               {"heights    pressure altitude\n"});
}

TEST(Watch, InputThatCannotBeUnderstoodIsRefused) {
  for (const auto& [input, message] :
       {std::pair{"hello world\nfoo bar\n", "the header names no position"},
        std::pair{"1,2,3,4,5\n6,7,8,9,10\n", "there is no header that tells the columns"},
        std::pair{"x,y,z\n1,2,3\n", "--columns"},
        std::pair{"{\"id\": \"a\"}\n", "the keys of this"},
        std::pair{"\x1f\x8b\x08 zipped\n", "the gzip data is damaged"}}) {
    expect_failure({"watch"}, input, kBadInput, message);
  }
  // It does not wait for the end of the input.
  Running running({"watch"});
  for (int i = 0; i < 12; ++i) running.send("hello world\n");
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, kBadInput);
  expect_parts(finished.err,
               {"the header names no position", "(and none of the next 9 lines could be read)"});
}

TEST(Watch, AStreamMayBeJoinedInTheMiddleOfALine) {
  const Finished json = watched("\"x\": 5, \"y\": 0}\n" + kAInJson + kBInJson + kAgainInJson);
  EXPECT_EQ(json.exit_code, 0);
  EXPECT_EQ(json.out, kEnteredAndEnded);
  expect_parts(json.err, {"beespace: left out: <stdin>:1", "input      JSON, an object a line\n",
                          "bad lines  1 left out\n"});
  const Finished table = watched("0,0\na,0,0,0,0\nb,0,1,0,0\n" + kAgain,
                                 {"--columns", "id=1,time=2,x=3,y=4,z=5", "--time-unit", "s"});
  EXPECT_EQ(table.exit_code, 0) << table.err;
  EXPECT_EQ(table.out, kEnteredAndEnded);
  expect_parts(table.err, {"bad lines  1 left out\n"});
  const Finished aircraft = watched(
      "\":47.25,\"lon\":8.5,\"seen_pos\":0}\n"
      R"({"now":1000000.5,"hex":"4B1814","alt_geom":10000,"lat":47.25,"lon":8.5,)"
      R"("seen_pos":0})"
      "\n",
      {"--threshold", "5NM"});
  const Finished headed = watched("0,0\n" + std::string(kTogether));
  EXPECT_EQ(headed.exit_code, 0) << headed.err;
  EXPECT_EQ(headed.out, kEnteredAndEnded);
  expect_parts(headed.err, {"bad lines  1 left out\n"});
  EXPECT_EQ(aircraft.exit_code, 0) << aircraft.err;
  expect_parts(aircraft.err, {"input      readsb JSON", "bad lines  1 left out\n"});
}

TEST(Watch, ADamagedFirstRecordCostsNoHeader) {
  const Finished finished = watched("id,time_s,x,y,z\n\"a,0\na,0,0,0,0\nb,0,1,0,0\n" + kAgain);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, kEnteredAndEnded);
  expect_parts(finished.err, {"bad lines  1 left out\n"});
}

TEST(Watch, ABeeThatLeavesIsThereNoLonger) {
  const std::string both = "id,time_s,x,y,z\na,0,0,0,0\nb,0,1,0,0\n" + kAgain;
  std::string alone;
  for (int t = 2; t < 20; ++t) alone += "a," + std::to_string(t) + ",0,0,0\n";
  const Finished silent = watched(both + alone);
  expect_parts(silent.out, {R"("event": "stale", "time_s": 1, "id": "b")"});
  const Finished left = watched(both + "{\"event\": \"leave\", \"id\": \"b\"}\n" + alone);
  EXPECT_EQ(left.exit_code, 0) << left.err;
  EXPECT_EQ(left.out.find("stale"), std::string::npos) << left.out;
  expect_parts(left.err, {"bees       1 heard of, 0 stale\n"});
  // Lines about unknown bees are ignored; a bee that leaves must be reported.
  const Finished bad =
      watched(both + "{\"event\": \"leave\", \"id\": \"z\"}\n{\"event\": \"leave\"}\n");
  EXPECT_EQ(bad.exit_code, 0);
  expect_parts(bad.err, {"this does not say who leaves; give an id", "bad lines  1 left out\n"});
}

TEST(Watch, InputWithoutAReportIsAnErrorEvenWhenQuiet) {
  for (const std::string input : {"", "\n\n", "id,time_s,x,y,z\n"}) {
    expect_failure({"watch", "--quiet"}, input, kBadInput, "there is no report in the input");
  }
  expect_failure({"watch", "--quiet"}, "id,time_s,x,y,z\na,0,oops,0,0\n", kBadInput,
                 "no line of the input could be read as a report");
}

TEST(Watch, FilesThatCannotBeReadAreNamed) {
  const TemporaryFolder folder;
  expect_failure({"watch", folder.path("missing.csv")}, {}, kSystem,
                 "missing.csv: there is no such file");
  expect_failure({"watch", folder.path("")}, {}, kSystem,
                 folder.path("") + ": this is a directory; name a file in it");
  Surroundings unprivileged;
  unprivileged.unprivileged = true;
  ASSERT_EQ(chmod(folder.path(".").c_str(), 0777), 0);
  const std::string secret = folder.file("secret.csv", kTogether);
  ASSERT_EQ(chmod(secret.c_str(), 0), 0);
  expect_failure({"watch", secret}, {}, kSystem, "secret.csv: not allowed to read this file",
                 unprivileged);
}

TEST(Watch, FilesAreReadAsStandardInputIs) {
  const TemporaryFolder folder;
  EXPECT_EQ(run({"watch", folder.file("bees.csv", kTogether), "--horizon", "0"}).out,
            kEnteredAndEnded);
  EXPECT_EQ(run({"watch", "-", "--horizon", "0"}, kTogether).out, kEnteredAndEnded);
}

TEST(Watch, InvalidNumbersAndOptionsAreRefused) {
  for (const std::string option : {"--max-age", "--look-every"}) {
    for (const std::string bad : {"0", "-1", "nan", "inf", "soon"}) {
      expect_usage_error({"watch", option + "=" + bad},
                         option + " '" + bad + "' is not a number of seconds above 0");
    }
  }
  for (const std::string bad : {"0", "-1", "nan", "inf", "fast"}) {
    expect_usage_error({"watch", "--speed=" + bad},
                       "--speed '" + bad + "' is not a number of times");
    expect_usage_error({"watch", "--rate=" + bad},
                       "--rate '" + bad + "' is not a number of reports");
    expect_usage_error({"watch", "--vertical=" + bad}, "--vertical '" + bad + "' is not a number");
    expect_usage_error({"watch", "--threshold=" + bad}, "the threshold");
  }
  expect_usage_error({"watch", "--max-skew=0"},
                     "--max-skew '0' is not a number of seconds above 0");
  expect_usage_error({"watch", "--clock", "mine"}, "--clock: 'mine' is none of report, arrival");
  for (const std::string pace : {"--speed", "--rate"}) {
    expect_usage_error({"watch", "--clock", "arrival", pace, "2"},
                       "--clock arrival is for reports that come as things happen; leave " + pace);
  }
  expect_usage_error({"watch", "--leave-factor", "0.99"}, "--leave-factor '0.99' is not a number");
  expect_usage_error({"watch", "--horizon=-1"}, "--horizon '-1' is not a number of seconds from 0");
  expect_usage_error({"watch", "--threads", "many"}, "--threads 'many' is not a whole number");
  expect_usage_error({"watch", "--speed", "2", "--rate", "5"},
                     "--speed and --rate exclude each other");
  expect_usage_error({"watch", "--crs", "mars"}, "--crs: 'mars' is none of auto, wgs84, metres");
  expect_usage_error({"watch", "--time-unit", "h"}, "--time-unit: 'h' is none of auto, s, ms");
  expect_usage_error({"watch", "a.csv", "b.csv"}, "'b.csv' is one argument too many");
  expect_usage_error({"watch", "--csv"}, "'--csv' is no option of 'beespace watch'");
  expect_usage_error({"watch", "--columns", ""}, "--columns: the value is empty");
}

TEST(Watch, FailOnRiskReportsWhetherABeeHasEntered) {
  EXPECT_EQ(watched(std::string(kTogether), {"--fail-on-risk"}).exit_code, 1);
  EXPECT_EQ(watched(std::string(kTogether)).exit_code, 0);
  EXPECT_EQ(watched(std::string(kTogether), {"--fail-on-risk", "--threshold", "0.5"}).exit_code, 0);
}

TEST(Watch, ARateIsKept) {
  EXPECT_LT(seconds_for({"watch"}, kTogether), 1.0);
  // The fourth report is due after three tenths of a second.
  const double took_s = seconds_for({"watch", "--rate", "10"}, kTogether);
  EXPECT_GT(took_s, 0.29);
  EXPECT_LT(took_s, 5.0);
}

TEST(Watch, ASpeedIsThatOfTheClockOfTheReports) {
  // 1 s of reports in half a second; and in a hundredth.
  const double took_s = seconds_for({"watch", "--speed", "2"}, kTogether);
  EXPECT_GT(took_s, 0.49);
  EXPECT_LT(took_s, 5.0);
  EXPECT_LT(seconds_for({"watch", "--speed", "100"}, kTogether), 0.49);
  EXPECT_EQ(watched(std::string(kTogether), {"--speed", "50"}).out, kEnteredAndEnded);
}

// Runs with its answer in a file, so that it can be looked at before the end.
class WatchLive : public testing::Test {
 protected:
  bool wait_for(const std::string& text) {
    for (int i = 0; i < 1'000; ++i) {
      if (folder_.read("events").find(text) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  TemporaryFolder folder_;
  Surroundings to_file_ = [this] {
    Surroundings surroundings;
    surroundings.output = Surroundings::Output::kFile;
    surroundings.file = folder_.file("events", "");
    return surroundings;
  }();
};

TEST_F(WatchLive, EventsAreWrittenWhileTheInputIsStillOpen) {
  Running running({"watch", "--horizon", "0"}, to_file_);
  running.send(kTogether);
  EXPECT_TRUE(wait_for("\"entered\"")) << "nothing was said within ten seconds";
  running.close_input();
  EXPECT_EQ(running.finish().exit_code, 0);
}

TEST_F(WatchLive, ASilentBeeGrowsStaleWithoutFurtherInput) {
  Running running({"watch", "--max-age", "0.5"}, to_file_);
  running.send(kTogether);
  EXPECT_TRUE(wait_for(R"({"event": "stale", "time_s": 1, "id": "b"})")) << folder_.read("events");
  running.close_input();
  expect_parts(running.finish().err, {"bees       0 heard of, 2 stale\n"});
}

TEST_F(WatchLive, SignalsEndItWithTheLookThatIsDueAndTheSummary) {
  for (const auto& [number, exit_code] :
       {std::pair{SIGINT, 130}, std::pair{SIGTERM, 143}, std::pair{SIGHUP, 129}}) {
    Running running({"watch", "--horizon", "0", "--look-every", "1000"});
    running.send(kTogether);
    running.send("rubbish\n");  // of which it says so once it has read all before
    expect_parts(running.read_error_line(), {"left out: <stdin>:6"});
    running.signal(number);
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, kEnteredAndEnded);
    expect_parts(finished.err, {"reports    4\n", "entered    1\n"});
  }
}

TEST_F(WatchLive, ASecondSignalEndsItAtOnce) {
  // It waits a second for the reader that does not read.
  Running running({"watch", "--horizon", "0", "--speed", "1"}, to_file_);
  running.send("id,time_s,x,y,z\na,0,0,0,0\nrubbish\n");
  expect_parts(running.read_error_line(), {"left out: <stdin>:3"});
  running.signal(SIGTERM);
  running.signal(SIGTERM);
  EXPECT_EQ(running.finish().exit_code, 143);
}

TEST_F(WatchLive, CtrlCEndsItWithTheSummary) {
  Running running({"watch", "--horizon", "0"}, to_file_);
  running.send(kTogether);
  ASSERT_TRUE(wait_for("\"entered\""));
  running.signal(SIGINT);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(folder_.read("events"), kEnteredAndEnded);
  expect_parts(finished.err, {"reports    4\n", "bees       2 heard of, 0 stale\n",
                              "threshold  100 m (closer than)\n", "entered    1\n"});
}

TEST_F(WatchLive, CtrlCEndsItQuietlyWhenItIsToBeQuiet) {
  Running running({"watch", "--horizon", "0", "--quiet", "--fail-on-risk"}, to_file_);
  running.send(kTogether);
  ASSERT_TRUE(wait_for("\"entered\""));
  running.signal(SIGINT);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err, "");
}

TEST_F(WatchLive, CtrlCEndsAReadingAtASpeedToo) {
  // The last two are due after a thousand seconds, and are never taken.
  Running running({"watch", "--horizon", "0", "--speed", "1"}, to_file_);
  running.send("id,time_s,x,y,z\na,0,0,0,0\nb,0,1,0,0\na,0.2,0,0,0\nb,0.2,1,0,0\na,0.4,0,0,0\n");
  running.send("rubbish\na,1000,0,0,0\nb,1000,1,0,0\n");
  expect_parts(running.read_error_line(), {"left out: <stdin>:7"});
  ASSERT_TRUE(wait_for("\"entered\""));
  running.signal(SIGINT);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 130);
  expect_parts(finished.err, {"reports    5\n", "bees       2 heard of, 0 stale\n"});
}

TEST_F(WatchLive, CtrlCBeforeTheFirstReportIsNoError) {
  const std::string pipe = folder_.path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  Running running({"watch", pipe}, to_file_);
  int writing = -1;  // as soon as it has been opened for reading
  for (int i = 0; i < 1'000 && writing < 0; ++i) {
    writing = open(pipe.c_str(), O_WRONLY | O_NONBLOCK);
    if (writing < 0) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  ASSERT_GE(writing, 0) << "the pipe was not opened within ten seconds";
  running.signal(SIGINT);
  const Finished finished = running.finish();
  close(writing);
  EXPECT_EQ(finished.exit_code, 130);
  EXPECT_EQ(finished.err.find("error"), std::string::npos) << finished.err;
}

TEST(Watch, CtrlCEndsAWriteThatWaitsForTheReader) {
  // All pairs enter: more than a pipe holds, and the test reads it only at the end.
  std::string reports = "id,time_s,x,y,z\n";
  for (const char* time : {"0", "1", "2"}) {
    for (int bee = 0; bee < 60; ++bee) {
      reports += std::to_string(bee) + "," + time + "," + std::to_string(bee) + ",0,0\n";
    }
  }
  Running running({"watch", "--horizon", "0"});
  running.send(reports);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  running.signal(SIGINT);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 130);
  expect_parts(finished.err, {"threshold  100 m (closer than)\n"});
}

TEST(Watch, EndsQuietlyWhenTheReaderIsGoneThoughTheInputGoesOn) {
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  Running running({"watch"}, closed);
  running.send(kTogether);  // and does not end
  running.send("a,2,0,0,0\nb,2,1,0,0\n");
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 141);
  EXPECT_EQ(finished.err, "");
}

TEST(Watch, AFullDiskIsAnError) {
  Surroundings full;
  full.output = Surroundings::Output::kFile;
  full.file = "/dev/full";
  const Finished finished = run({"watch"}, kTogether, full);
  EXPECT_EQ(finished.exit_code, kSystem);
  expect_parts(finished.err, {"beespace: error: cannot write to standard output"});
}

TEST(Watch, TerminalsSeeColourUnlessNoColorIsSet) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  const TemporaryFolder folder;
  const std::string path = folder.file("bees.csv", std::string(kTogether) + "rubbish\n");
  expect_parts(run_on_terminal({"watch", path}).err, {"bad lines  \x1b[1;31m1\x1b[0m left out"});
  const Finished plain = run_on_terminal({"watch", path}, "1");
  EXPECT_EQ(plain.err.find('\x1b'), std::string::npos) << plain.err;
}

TEST(Watch, ACommandDoesNotWaitForInputFromATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  Surroundings surroundings;
  surroundings.input_on_terminal = true;
  Running running({"watch"}, surroundings);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"say which file to read"});
}

}  // namespace
}  // namespace beespace::cli_test
