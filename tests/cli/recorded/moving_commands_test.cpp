// What `beespace predict` and `beespace replay` have in common: options, refusals, bad input, and
// answers that are there whole or not at all.
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Two that have met and are still within 100 m of each other at the end.
constexpr std::string_view kMeeting =
    "id,time_s,x,y,z,vx,vy,vz\n"
    "a,0,0,0,0,1,0,0\n"
    "b,0,4,0,0,-1,0,0\n"
    "a,10,10,0,0,1,0,0\n"
    "b,10,-6,0,0,-1,0,0\n";

constexpr std::string_view kFarApart =
    "id,time_s,x,y,z,vx,vy,vz\n"
    "a,0,0,0,0,0,0,0\n"
    "a,10,0,0,0,0,0,0\n"
    "b,0,1e6,0,0,0,0,0\n"
    "b,10,1e6,0,0,0,0,0\n";

class MovingCommands : public testing::TestWithParam<const char*> {
 protected:
  Finished ask(const Arguments& more, std::string_view input = kMeeting,
               const Surroundings& surroundings = {}) {
    return run(Arguments{GetParam()} + more, input, surroundings);
  }

  void expect_refused(const Arguments& more, const std::string& message) {
    expect_usage_error(Arguments{GetParam()} + more, message);
  }

  // Bad input: refused on standard output as in a file, of which nothing is left.
  void expect_bad(std::string_view input, const std::string& message, const Arguments& more = {}) {
    expect_failure(Arguments{GetParam()} + more, input, kBadInput, message);
    expect_failure(Arguments{GetParam(), "--output", folder_.path("answer")} + more, input,
                   kBadInput, message);
    EXPECT_TRUE(folder_.names().empty());
  }

  TemporaryFolder folder_;
};

TEST_P(MovingCommands, FailOnRiskReportsConflictsByTheExitStatus) {
  EXPECT_EQ(ask({"--fail-on-risk"}).exit_code, 1);
  EXPECT_EQ(ask({"--fail-on-risk", "--json", "--quiet"}).exit_code, 1);
  EXPECT_EQ(ask({}).exit_code, 0);
  const Finished fine = ask({"--fail-on-risk"}, kFarApart);
  EXPECT_EQ(fine.exit_code, 0);
  EXPECT_EQ(below_header(fine.out), "");
}

TEST_P(MovingCommands, TheSameConflictsComeInEveryForm) {
  const auto rows = rows_of(ask({}).out);
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_EQ(rows[0].size(), 7u);
  without_lasts(rows);
  const auto csv = rows_of(ask({"--csv"}).out, ',');
  expect_rows(csv, {{"first", "second", "begins_s", "closest_s", "closest_m", "ends_s", "lasts_s"},
                    rows[0]});
  const std::string json = ask({"--json"}).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("command": ")" + std::string(GetParam()) + '"', R"("files": ["<stdin>"])",
                      R"("frame": "metres")", R"("bees": 2)", R"("threshold_m": 100)",
                      R"("vertical_m": null)", R"("inclusive": false)", R"("conflict_count": 1)",
                      R"({"first": "a", "second": "b", "begins_s": )" + rows[0][2] +
                          R"(, "closest_s": )" + rows[0][3] + R"(, "closest_m": )" + rows[0][4] +
                          R"(, "ends_s": )" + rows[0][5] + R"(, "lasts_s": )" + rows[0][6] + "}"});
}

TEST_P(MovingCommands, NoConflictIsAnEmptyAnswerInEveryForm) {
  EXPECT_EQ(below_header(ask({}, kFarApart).out), "");
  EXPECT_EQ(ask({"--csv"}, kFarApart).out,
            "first,second,begins_s,closest_s,closest_m,ends_s,lasts_s\n");
  const std::string json = ask({"--json"}, kFarApart).out;
  EXPECT_TRUE(is_json(json)) << json;
  expect_parts(json, {R"("conflict_count": 0)", R"("conflicts": [])"});
}

TEST_P(MovingCommands, TheNumberOfThreadsChangesNothing) {
  EXPECT_EQ(ask({"--threads", "1"}).out, ask({"--threads", "4"}).out);
}

TEST_P(MovingCommands, IdsCannotBreakTheFormOrSteerTheTerminal) {
  constexpr std::string_view strange =
      "id,time_s,x,y,z,vx,vy,vz\n"
      "\"a,\"\"1\"\"\",0,0,0,0,1,0,0\n\xC2\x9B|,0,4,0,0,-1,0,0\n"
      "\"a,\"\"1\"\"\",10,10,0,0,1,0,0\n\xC2\x9B|,10,-6,0,0,-1,0,0\n";
  const Finished csv = ask({"--csv"}, strange);
  EXPECT_EQ(lines_of(csv.out).at(1).substr(0, 10), "\"a,\"\"1\"\"\",");
  EXPECT_EQ(csv.err.find("\xC2\x9B"), std::string::npos);
  const Finished json = ask({"--json"}, strange);
  EXPECT_TRUE(is_json(json.out)) << json.out;
  expect_parts(json.out, {R"("first": "a,\"1\"")"});
}

TEST_P(MovingCommands, InvalidNumbersAreRefused) {
  for (const std::string bad : {"0", "-5", "nan", "inf", "abc", "5 m/s"}) {
    expect_refused({"--threshold=" + bad}, "the threshold");
  }
  for (const std::string bad : {"0", "-5", "nan", "inf", "abc"}) {
    expect_refused({"--vertical=" + bad},
                   "--vertical '" + bad + "' is not a number of metres above 0");
  }
  for (const std::string bad : {"0", "-1", "1.5", "many"}) {
    expect_refused({"--max-results=" + bad},
                   "--max-results '" + bad + "' is not a whole number from 1 to");
  }
  for (const std::string bad : {"-1", "1.5", "two", "4294967296"}) {
    expect_refused({"--threads=" + bad}, "--threads '" + bad + "' is not a whole number");
  }
}

TEST_P(MovingCommands, InvalidWordsAndOptionsAreRefused) {
  const Finished both = ask({"--csv", "--json"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_TRUE(is_json(both.out)) << both.out;
  expect_parts(both.err, {"--csv and --json exclude each other"});
  expect_refused({"--crs", "meters"}, "did you mean 'metres'?");
  expect_refused({"--time-unit", "minutes"}, "--time-unit: 'minutes' is none of auto, s, ms");
  expect_refused({"--output", ""}, "--output: the value is empty");
  expect_refused({"--columns="}, "--columns needs a value");
  expect_refused({"--threshold", "5", "--threshold", "6"}, "--threshold is given 2 times");
  expect_refused({"--thershold", "5"}, "did you mean '--threshold'?");
  expect_refused({"--geojson"}, "is no option of 'beespace " + std::string(GetParam()) + "'");
  expect_refused({"--quiet=yes"}, "--quiet takes no value");
}

TEST_P(MovingCommands, InputWithoutReportsIsRefused) {
  expect_bad("", "the input is empty");
  expect_bad("id,time_s,x,y,z\n", "there is a header and no record after it");
  expect_bad("\x01\x02\x03\x04 rubbish", "this is no text");
}

TEST_P(MovingCommands, BadRecordsAreNamedByTheirPlace) {
  const std::string good = "id,time_s,x,y,z,vx,vy,vz\na,0,0,0,0,1,0,0\n";
  expect_bad(good + "b,0,nan,0,0,1,0,0\n", "<stdin>:3:3: 'nan'");
  expect_bad(good + "b,0,0,inf,0,1,0,0\n", "<stdin>:3:4: 'inf'");
  expect_bad(good + "b,soon,0,0,0,1,0,0\n", "<stdin>:3:2: 'soon'");
  expect_bad(good + "b,0,0,0,0,fast,0,0\n", "<stdin>:3:6: 'fast'");
  expect_bad(good + "b,0,0,0\n", "<stdin>:3: 4 columns");
  expect_bad("id,time_s,lon,lat,height\na,0,0,95,0\na,1,0,5,0\n", "<stdin>:2:4: latitude 95");
}

TEST_P(MovingCommands, ABeeAtTwoPlacesAtTheSameTimeIsRefused) {
  expect_bad("id,time_s,x,y,z\na,0,0,0,0\na,1,1,0,0\na,1,2,0,0\n",
             "<stdin>:4: bee 'a' is at another place at the same time, 1 s");
}

TEST_P(MovingCommands, SkippedRecordsAreListedAndTheRestIsSearched) {
  const Finished finished =
      ask({"--skip-bad"}, std::string(kMeeting) + "c,10,oops,0,0,0,0,0\nc,10,0,0\n");
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(rows_of(finished.out).size(), 1u);
  expect_parts(finished.err,
               {"skipped    2 bad records\n", "<stdin>:6:3: 'oops'", "<stdin>:7: 4 columns"});
  expect_parts(ask({"--skip-bad", "--json"}, std::string(kMeeting) + "c,10,0,0\n").out,
               {R"("skipped": 1)"});
}

TEST_P(MovingCommands, RecordsThatGoBackInTimeAreSortedAndReported) {
  const Finished finished = ask({"--threshold", "5"},
                                "id,time_s,x,y,z,vx,vy,vz\n"
                                "a,10,10,0,0,1,0,0\nb,10,13,0,0,1,0,0\n"
                                "a,0,0,0,0,1,0,0\nb,0,3,0,0,1,0,0\n");
  EXPECT_EQ(rows_of(finished.out).size(), 1u);
  expect_parts(finished.err, {"2 records go back in time"});
}

TEST_P(MovingCommands, TimesWithoutAUnitAreRefusedUntilItIsGiven) {
  std::string text(kMeeting);
  text.replace(text.find("time_s"), 6, "time");
  expect_failure({GetParam()}, text, 2, "--time-unit s, ms, us or ns");
  EXPECT_EQ(ask({"--time-unit", "s"}, text).out, ask({}).out);
}

TEST_P(MovingCommands, ColumnsMayBeGivenByNumber) {
  const std::string bare(kMeeting.substr(kMeeting.find('\n') + 1));
  EXPECT_EQ(
      ask({"--columns", "id=1,time=2,x=3,y=4,z=5,vx=6,vy=7,vz=8", "--time-unit", "s"}, bare).out,
      ask({}).out);
  expect_bad(bare, "--columns");
}

TEST_P(MovingCommands, FilesAndFoldersThatCannotBeReadAreNamed) {
  const std::string command = GetParam();
  expect_failure({command, folder_.path("missing.csv")}, {}, kSystem,
                 "missing.csv: there is no such file");
  expect_failure({command, folder_.path(".")}, {}, kBadInput,
                 "there is no .csv, .tsv or .txt file in this folder");
  Surroundings unprivileged;
  unprivileged.unprivileged = true;
  ASSERT_EQ(chmod(folder_.path(".").c_str(), 0777), 0);
  const std::string secret = folder_.file("secret.csv", kMeeting);
  ASSERT_EQ(chmod(secret.c_str(), 0), 0);
  expect_failure({command, secret}, {}, kSystem, "secret.csv: not allowed to read", unprivileged);
}

TEST_P(MovingCommands, WithJsonTheErrorIsADocumentToo) {
  const Finished finished = ask({"--json"}, "id,time_s,x,y,z\na,0,0,oops,0\n");
  EXPECT_EQ(finished.exit_code, kBadInput);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out,
               {R"("code": "not_a_number")", R"("file": "<stdin>", "line": 2)", R"("column": 4)"});
}

TEST_P(MovingCommands, MoreConflictsThanAllowedAreAnErrorInWordsOfTheCommand) {
  const std::string three = std::string(kMeeting) + "c,0,0,1,0,0,0,0\nc,10,0,1,0,0,0,0\n";
  expect_bad(three, "there are more than 1 conflict; raise --max-results", {"--max-results", "1"});
  expect_bad(three, "there are more than 2 conflicts; raise --max-results", {"--max-results", "2"});
  EXPECT_EQ(rows_of(ask({"--max-results", "3"}, three).out).size(), 3u);
}

TEST_P(MovingCommands, TheOutputFileHoldsTheAnswerAndIsLeftAloneByErrors) {
  const std::string path = folder_.path("answer");
  const Finished finished = ask({"--csv", "--output", path});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "");
  EXPECT_EQ(folder_.read("answer"), ask({"--csv"}).out);
  EXPECT_EQ(ask({"--output", path}, "").exit_code, kBadInput);
  EXPECT_EQ(folder_.read("answer"), ask({"--csv"}).out) << "an error has changed the file";
  expect_failure({GetParam(), "--output", folder_.path("nowhere/x")}, kMeeting, kSystem,
                 "nowhere/x");
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"answer"});
}

TEST_P(MovingCommands, EveryFormEndsQuietlyWhenTheReaderIsGone) {
  Surroundings closed;
  closed.output = Surroundings::Output::kClosedPipe;
  for (const Arguments& form : {Arguments{}, Arguments{"--csv"}, Arguments{"--json"}}) {
    const Finished finished = ask(form, kMeeting, closed);
    EXPECT_EQ(finished.exit_code, 141);
    EXPECT_EQ(finished.err, "");
  }
}

TEST_P(MovingCommands, AFullDiskIsAnError) {
  Surroundings full;
  full.output = Surroundings::Output::kFile;
  full.file = "/dev/full";
  for (const Arguments& form : {Arguments{}, Arguments{"--csv"}, Arguments{"--json"}}) {
    const Finished finished = ask(form, kMeeting, full);
    EXPECT_EQ(finished.exit_code, kSystem);
    expect_parts(finished.err, {"beespace: error: "});
  }
  EXPECT_EQ(ask({"--output", "/dev/full"}).exit_code, kSystem);
}

TEST_P(MovingCommands, SignalsEndItAndLeaveNothing) {
  for (const int signal : {SIGINT, SIGTERM}) {
    folder_.file("answer", "old");
    Running running({GetParam(), "--output", folder_.path("answer")});
    running.send(kMeeting);
    for (int i = 0; i < 1'000 && folder_.names().size() < 2; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_EQ(folder_.names().size(), 2u) << "no temporary file appeared";
    running.signal(signal);
    const Finished finished = running.finish();
    EXPECT_EQ(finished.exit_code, 128 + signal);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(folder_.names(), std::vector<std::string>{"answer"});
    EXPECT_EQ(folder_.read("answer"), "old");
  }
}

TEST_P(MovingCommands, TerminalsSeeColourUnlessNoColorIsSet) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  const std::string path = folder_.file("bees.csv", kMeeting);
  expect_parts(run_on_terminal({GetParam(), path}).err, {"\x1b[1;31m", "\x1b[0m"});
  const Finished plain = run_on_terminal({GetParam(), path}, "1");
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_EQ(plain.err.find('\x1b'), std::string::npos) << plain.err;
}

TEST_P(MovingCommands, ACommandDoesNotWaitForInputFromATerminal) {
  if (!has_terminals()) GTEST_SKIP() << "this system has no pseudo-terminals";
  Surroundings surroundings;
  surroundings.input_on_terminal = true;
  Running running({GetParam()}, surroundings);
  const Finished finished = running.finish();
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"say which file to read"});
}

TEST_P(MovingCommands, QuietRunsSayNothing) {
  EXPECT_EQ(ask({"--quiet"}).err, "");
}

INSTANTIATE_TEST_SUITE_P(Both, MovingCommands, testing::Values("predict", "replay"),
                         [](const auto& command) { return std::string(command.param); });

}  // namespace
}  // namespace beespace::cli_test
