// `beespace report`: its exit codes, what it refuses, and that nothing is left behind then.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/page_command.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kTwo = "x,y,z\n0,0,0\n1,0,0\n";
constexpr std::string_view kFlown = "id,time_s,x,y,z\na,0,0,0,0\na,9,0,0,0\nb,0,3,0,0\nb,9,3,0,0\n";

class ReportRefusals : public PageCommand {};

TEST_F(ReportRefusals, BadInputIsReportedWithItsLineAndLeavesNoFile) {
  const std::string bad = folder_.file("bad.csv", "x,y,z\n0,0,0\n1,zero,0\n");
  expect_failure({"report", bad, "-o", folder_.path("page.html")}, {}, kBadInput, "bad.csv:3");
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"bad.csv"});
  folder_.file("page.html", "old");
  expect_failure({"report", bad, "-o", folder_.path("page.html")}, {}, kBadInput, "bad.csv:3");
  EXPECT_EQ(folder_.read("page.html"), "old");
  expect_failure({"report"}, "id,time_s,x,y,z\na,0,0,0,0\na,one,0,0,0\n", kBadInput, "<stdin>:3");
  expect_failure({"report"}, "", kBadInput, "<stdin>");
}

TEST_F(ReportRefusals, BadRecordsAreLeftOutWhenAskedAndThatIsInThePage) {
  const Page page = reported({"--skip-bad"}, "x,y,z\n0,0,0\n1,zero,0\n2,0,0\n");
  EXPECT_EQ(std::uint64_t(page.swarm()["count"]), 2u);
  const auto notes = report_test::texts_of(page.swarm()["notes"]);
  EXPECT_NE(std::find(notes.begin(), notes.end(), "bad records left out: 1"), notes.end());
}

// What names a time is a recording: about its columns all ask what 'replay' asks.
TEST_F(ReportRefusals, OfSeveralVehiclesBesideEachOtherTheLineOfAwkIsTold) {
  const std::string wide =
      folder_.file("wide.csv",
                   "timestamp,cf1_x,cf1_y,cf1_z,cf2_x,cf2_y,cf2_z\n1777629600.0,0,0,1,5,5,1\n"
                   "1777629600.1,0,1,1,5,6,1\n");
  constexpr const char* kLine = "NR>1{p(\"cf1\",2,3,4);p(\"cf2\",5,6,7)}'";
  expect_failure({"replay", wide, "--threshold", "1"}, {}, kBadInput, kLine);
  for (const Arguments& shown :
       {Arguments{"report", "-o", folder_.path("a.html")},
        Arguments{"plot", "-o", folder_.path("a.svg")},
        Arguments{"export", "-o", folder_.path("a.kml"), "--origin", "8,47,400,90"}}) {
    expect_failure(shown + Arguments{wide, "--threshold", "1"}, {}, kBadInput, kLine);
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"wide.csv"});
}

TEST_F(ReportRefusals, WhatIsMissingIsNamed) {
  const std::string there = folder_.file("there.csv", kTwo);
  const std::string missing = folder_.path("missing.csv");
  expect_failure({"report", missing}, {}, kSystem, "missing.csv");
  expect_failure({"report", there, "--compare", missing}, {}, kSystem, "missing.csv");
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"there.csv"});
}

TEST_F(ReportRefusals, WhereNothingCanBeWrittenIsKnownBeforeTheInputIsRead) {
  Running running({"report", "-o", folder_.path("nowhere/page.html")});
  const Finished finished = running.finish();  // though the input has not ended
  EXPECT_EQ(finished.exit_code, kSystem);
  expect_parts(finished.err, {"nowhere/page.html"});
}

TEST_F(ReportRefusals, AFolderThatIsClosedToOneIsAnError) {
  Surroundings surroundings;
  surroundings.unprivileged = true;  // the folder is closed to others
  const Arguments closed = {"report", "-o", folder_.path("page.html")};
  if (run(closed, kTwo, surroundings).exit_code == 0) GTEST_SKIP() << "not root: it is one's own";
  expect_failure(closed, kTwo, kSystem, "not allowed to write here", surroundings);
}

TEST_F(ReportRefusals, AFullDiskIsAnError) {
  expect_failure({"report", "-o", "/dev/full"}, kTwo, kSystem, "the disk is full");
}

TEST_F(ReportRefusals, WhenTheReaderIsGoneItEndsQuietly) {
  Surroundings surroundings;
  surroundings.output = Surroundings::Output::kClosedPipe;
  const Finished finished = run({"report"}, kTwo, surroundings);
  EXPECT_EQ(finished.exit_code, 141);
  EXPECT_EQ(finished.err, "");
}

TEST_F(ReportRefusals, ABeeAtRiskFailsOnlyWhenAsked) {
  const std::string apart = folder_.file("apart.csv", "x,y,z\n0,0,0\n900,0,0\n");
  const std::string close = folder_.file("close.csv", kTwo);
  const std::string flown = folder_.file("flown.csv", kFlown);
  const auto status = [](const Arguments& how) {
    return run(Arguments{"report", "--quiet"} + how).exit_code;
  };
  EXPECT_EQ(status({close}), 0);
  EXPECT_EQ(status({close, "--fail-on-risk"}), 1);
  EXPECT_EQ(status({apart, "--fail-on-risk"}), 0);
  EXPECT_EQ(status({close, "--compare", apart, "--fail-on-risk"}), 1);
  EXPECT_EQ(status({apart, "--compare", close, "--fail-on-risk"}), 1);
  EXPECT_EQ(status({apart, "--compare", apart, "--fail-on-risk"}), 0);
  EXPECT_EQ(status({flown, "--fail-on-risk"}), 1);
  EXPECT_EQ(status({flown, "--fail-on-risk", "--threshold", "3"}), 0);
}

TEST_F(ReportRefusals, WithRiskThePageIsThereAllTheSame) {
  const Finished finished =
      run({"report", "--fail-on-risk", "-o", folder_.path("page.html")}, kTwo);
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(std::uint64_t(Page(folder_.read("page.html")).risk()["at_risk"]), 2u);
}

TEST_F(ReportRefusals, QuietSaysNothing) {
  const Finished quiet = run({"report", "--quiet", "-o", folder_.path("page.html")}, kTwo);
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.out, "");
  EXPECT_EQ(quiet.err, "");
  const Finished plain = run({"report", "-o", folder_.path("page.html")}, kTwo);
  expect_parts(plain.err,
               {"input      standard input (", "bees       2\n", "at risk    2 of 2: 1 pair",
                "written    ", "page.html", "time       read ", ", find ", ", write ",
                "worst pair file:///", "page.html#bees=0,1\n"});
}

TEST_F(ReportRefusals, TheLinkToTheWorstPairIsAnAddress) {
  const Finished finished = run({"report", "-o", folder_.path("what's new? 50%.html")}, kTwo);
  expect_parts(finished.err, {"worst pair file:///", "what%27s%20new%3F%2050%25.html#bees=0,1\n"});
  const Finished calm = run({"report", "--threshold", "0.001", "-o", folder_.path("p.html")}, kTwo);
  EXPECT_EQ(calm.err.find("worst pair"), std::string::npos) << calm.err;
}

double seconds_in(const std::string& text, const std::string& label) {
  std::size_t at = text.find(label);
  if (at == std::string::npos) return -1.0;
  at += label.size();
  std::size_t used = 0;
  const double number = std::stod(text.substr(at), &used);
  return text.substr(at + used).starts_with(" ms") ? number / 1e3 : number;
}

TEST_F(ReportRefusals, TheTimeOfReadingIsNotThatOfFinding) {
  // The other writer is slow; on a busy machine the command may begin to read even later.
  std::string said;
  for (const int wait_ms : {400, 1'600, 6'400}) {
    Running running({"report", "-o", folder_.path("page" + std::to_string(wait_ms) + ".html")});
    running.send(kTwo);
    std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    running.close_input();
    said = running.finish().err;
    if (seconds_in(said, "time       read ") >= 0.3) break;
  }
  EXPECT_GE(seconds_in(said, "time       read "), 0.3) << said;
  EXPECT_LT(seconds_in(said, ", find "), 0.2) << said;
  EXPECT_GE(seconds_in(said, ", find "), 0.0) << said;
  EXPECT_GE(seconds_in(said, ", write "), 0.0) << said;
}

TEST_F(ReportRefusals, ASnapshotAndARecordingCannotBeCompared) {
  const std::string bees = folder_.file("bees.csv", kTwo);
  const std::string flown = folder_.file("flown.csv", kFlown);
  const std::string page = folder_.path("page.html");
  for (const auto& [one, other] : {std::pair{bees, flown}, std::pair{flown, bees}}) {
    const Finished finished = run({"report", one, "--compare", other, "-o", page});
    EXPECT_EQ(finished.exit_code, kUsage);
    expect_parts(finished.err, {"'bees.csv'", "'flown.csv'", "cannot be compared"});
  }
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"bees.csv", "flown.csv"}));
}

TEST_F(ReportRefusals, DegreesAndMetresCannotBeCompared) {
  const std::string metres = folder_.file("metres.csv", "x,y,z\n1,2,3\n");
  const std::string degrees = folder_.file("degrees.csv", "lon,lat,height\n-75.5,6.25,1500\n");
  for (const auto& [one, other] : {std::pair{metres, degrees}, std::pair{degrees, metres}}) {
    const Finished finished = run({"report", one, "--compare", other});
    EXPECT_EQ(finished.exit_code, kUsage);
    EXPECT_EQ(finished.out, "");
    expect_parts(finished.err, {"'metres.csv'", "'degrees.csv'", "one is in degrees"});
  }
}

TEST_F(ReportRefusals, StandardInputIsReadOnce) {
  expect_usage_error({"report", "--compare", "-"}, "standard input can be read once");
  expect_usage_error({"report", "-", "--compare", "-"}, "standard input can be read once");
}

TEST_F(ReportRefusals, APageIsNotWrittenUnderTheNameOfSomethingElse) {
  const std::string bees = folder_.file("bees.txt", kTwo);
  for (const auto& [name, instead] :
       {std::pair{"zz.png", "let 'beespace plot' draw the picture"},
        std::pair{"zz.SVG", "let 'beespace plot' draw the picture"},
        std::pair{"zz.kml", "let 'beespace export' write that file"},
        std::pair{"zz.czml", "let 'beespace export' write that file"},
        std::pair{"zz.geojson", "let 'beespace export' write that file"},
        std::pair{"zz.csv", "let 'beespace export' write that file"},
        std::pair{"zz.json", "let 'beespace export' write .geojson or .czml"}}) {
    expect_failure({"report", bees, "-o", folder_.path(name)}, {}, kUsage, instead);
  }
  EXPECT_EQ(folder_.names(), std::vector<std::string>{"bees.txt"});
  for (const char* name : {"page", "page.htm", "page.html"}) {
    EXPECT_EQ(run({"report", bees, "-o", folder_.path(name)}).exit_code, 0) << name;
  }
  expect_failure({"report", bees, "-o", bees}, {}, kUsage, "is the input itself");
}

TEST_F(ReportRefusals, OfWhatIsNoTextItAdvisesWhatItHas) {
  const std::string bytes("x,y,z\n0,0,0\0\n", 13);
  const std::string nul = folder_.file("nul.csv", bytes);
  for (const Arguments& asked :
       {Arguments{"report", nul}, Arguments{"plot", nul},
        Arguments{"export", nul, "--format", "csv"}, Arguments{"view", nul, "--no-open"}}) {
    const Finished finished = run(asked);
    EXPECT_EQ(finished.exit_code, kBadInput);
    expect_parts(finished.err, {"this is no text: byte 11 is NUL; save it as text in UTF-8, or let "
                                "the name of raw float64 end in .bin\n"});
  }
  expect_failure({"detect", nul}, {}, kBadInput, "say --format bin");
  const Finished replayed = run({"replay", nul});
  expect_parts(replayed.err, {"this is no text: byte 11 is NUL; save it as text in UTF-8\n"});
}

TEST_F(ReportRefusals, SeveralSnapshotsAreNoRecordingAndMayBeCompared) {
  const std::string a = folder_.file("a.csv", kTwo);
  const std::string b = folder_.file("b.csv", kTwo);
  const std::string flown = folder_.file("flown.csv", kFlown);
  const std::string message =
      "there are no times in this snapshot, and several files are read as one recording; name one "
      "file, or set two beside each other: beespace report BEFORE --compare AFTER";
  expect_failure({"report", a, b}, {}, kBadInput, "a.csv: " + message);
  expect_failure({"report", flown, b}, {}, kBadInput, "b.csv: " + message);
  expect_failure({"export", a, b, "--format", "csv"}, {}, kBadInput, "a.csv: " + message);
  expect_failure({"plot", folder_.path("")}, {}, kBadInput, "a.csv: " + message);
}

TEST_F(ReportRefusals, ErrorsAreJsonWhenAskedFor) {
  const Finished finished = run({"report", "--json"}, "x,y,z\n0,nothing,0\n");
  EXPECT_EQ(finished.exit_code, kBadInput);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {"\"error\"", "<stdin>"});
}

TEST_F(ReportRefusals, InvalidOptionsAreRefused) {
  expect_usage_error({"report", "--threshold", "0"}, "threshold");
  expect_usage_error({"report", "--port", "1"}, "'--port' is no option");
}

TEST(PageCommandTest, WithoutThePageTheCommandSaysHowToGetIt) {
  if (kHasPage) GTEST_SKIP() << "this build has the page";
  const TemporaryFolder folder;
  const std::string bees = folder.file("bees.csv", kTwo);
  expect_failure({"report", bees, "-o", folder.path("page.html")}, {}, kUsage,
                 "this build has no page in it; build beespace with Node.js and npm, and without "
                 "-DBEESPACE_WEB=OFF");
  expect_failure({"view", bees, "--no-open"}, {}, kUsage, "this build has no page in it");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"bees.csv"});
}

}  // namespace
}  // namespace beespace::cli_test
