// Invalid command lines, and those that ask for help.
#include <gtest/gtest.h>

#include <beespace/version.hpp>

#include <string>
#include <utility>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kTwo = "x,y,z\n0,0,0\n1,0,0\n";

void expect_usage_error(const Arguments& arguments, const std::string& message) {
  const Finished finished = run(arguments, kTwo);
  EXPECT_EQ(finished.exit_code, kUsage);
  EXPECT_EQ(finished.out, "");
  EXPECT_NE(finished.err.find(message), std::string::npos) << "'" << message << "' in\n"
                                                           << finished.err;
}

TEST(Usage, ThresholdsThatAreNotAboveZeroAndFiniteAreRefused) {
  for (const std::string bad : {"0", "-0", "-5", "nan", "inf", "-inf", "1e999", "1e-400"}) {
    expect_usage_error({"detect", "--threshold", bad},
                       "the threshold is " + bad +
                           " m; give a finite distance above zero, in metres, for example "
                           "--threshold 100\n");
  }
  // Only values beyond the limits of the domain get a message about them.
  for (const std::string bad : {"1e300", "1e-200"}) {
    expect_usage_error({"detect", "--threshold", bad},
                       "the threshold is " + bad + " m; give one from 3.9e-121 m to 2.6e+120 m");
  }
  for (const std::string bad : {"abc", "100 bees", "100 m/s", "1,5", "+-5", "++5", "+"}) {
    expect_usage_error({"detect", "--threshold=" + bad}, "'" + bad + "' is not a length");
  }
  expect_usage_error({"detect", "--threshold=-5ft"}, "the threshold is -5ft; give");
}

TEST(Usage, AThresholdMayHaveAPlusSignAsNumbersInFilesMay) {
  EXPECT_EQ(run({"detect", "--threshold", "+5"}, kTwo).out, "0\n1\n");
  EXPECT_EQ(run({"detect", "--threshold", "+.5"}, kTwo).out, "");
}

TEST(Usage, ABadThresholdLeavesNoOutput) {
  const TemporaryFolder folder;
  EXPECT_EQ(run({"detect", "--threshold", "0", "--output", folder.path("x")}, kTwo).exit_code,
            kUsage);
  EXPECT_TRUE(folder.names().empty());
}

TEST(Usage, UnknownOptionsGetAHint) {
  expect_usage_error({"detect", "--thershold", "5"}, "did you mean '--threshold'?");
  expect_usage_error({"detect", "--banana"}, "beespace detect --help");
  // As others call it.
  expect_usage_error({"verify", "--min-distance", "2"}, "did you mean '--threshold'?");
  expect_usage_error({"verify", "-t", "2"}, "did you mean '--threshold'?");
  expect_usage_error({"generate", "--point", "5"}, "did you mean '--points'?");
  expect_usage_error({"detekt"}, "did you mean 'detect'?");
  expect_usage_error({"detect", "--thresh", "5"}, "did you mean '--threshold'?");
  expect_usage_error({"detect", "-threshold", "5"}, "did you mean '--threshold'?");
  expect_usage_error({"detect", "-q"}, "did you mean '--quiet'?");
  expect_usage_error({"--quiet", "detect"}, "'--quiet' is no option of 'beespace', whose options");
}

TEST(Usage, OfAnUnknownOptionAndItsValueTheOptionIsNamed) {
  expect_usage_error({"detect", "bees.csv", "--treshold", "5"},
                     "'--treshold' is no option of 'beespace detect'; did you mean '--threshold'?");
  expect_usage_error({"generate", "5", "--treshold", "5"},
                     "'--treshold' is no option of 'beespace generate'");
}

TEST(Usage, AnArgumentTooManyIsNamed) {
  expect_usage_error({"detect", "a", "b"}, "'b' is one argument too many for 'beespace detect'");
  expect_usage_error({"x", "y"},
                     "'x' is nothing that beespace does; say detect, predict, replay, watch, "
                     "advise, guide, follow, simulate, verify, fleet, report, view, plot, export, "
                     "generate, bench or help");
}

TEST(Usage, AnOptionGivenTwiceWithoutItsValueOrAFlagWithOneIsRefused) {
  expect_usage_error({"detect", "--threshold", "5", "--threshold", "6"},
                     "--threshold is given 2 times; give it once");
  expect_usage_error({"detect", "--threshold"}, "--threshold needs a value");
  expect_usage_error({"detect", "--crs="}, "--crs needs a value");
  expect_usage_error({"detect", "--csv=5"}, "--csv takes no value");
  expect_usage_error({"detect", "--quiet=false"}, "--quiet takes no value");
  expect_usage_error({"detect", "--version=1"}, "--version takes no value");
  expect_usage_error({"detect", "--help=false"}, "--help takes no value");
  expect_usage_error({"--help=1"}, "--help takes no value");
}

TEST(Usage, AnEmptyValueIsNoValue) {
  expect_usage_error({"detect", ""}, "FILE: the value is empty");
  expect_usage_error({"detect", "--columns", ""}, "--columns: the value is empty");
  for (const char* option : {"--points", "--size", "--sigma", "--area", "--seed", "--output"}) {
    expect_usage_error({"generate", option, ""}, std::string(option) + ": the value is empty");
  }
}

TEST(Usage, TheErrorOfAnUnknownReportListsAll) {
  expect_usage_error(
      {"detect", "--report", "neighbours"},
      "--report: 'neighbours' is none of at-risk, pairs, neighbors, counts, nearest, "
      "groups, closest-pair; did you mean 'neighbors'?");
  expect_usage_error({"detect", "--report", ""}, "--report");
}

TEST(Usage, OptionsThatTheReportWouldIgnoreAreRefused) {
  expect_usage_error({"detect", "--report", "groups", "--others", "x.csv"},
                     "--others does not apply to --report groups");
  expect_usage_error({"detect", "--max-results", "5"},
                     "--max-results does not apply to --report at-risk");
  expect_usage_error({"detect", "--report", "pairs", "--at-risk-only"},
                     "--at-risk-only does not apply to --report pairs");
}

TEST(Usage, TheLimitOfResultsIsAWholeNumberAboveZero) {
  for (const std::string bad : {"0", "-1", "1.5", "many", "18446744073709551616"}) {
    expect_usage_error({"detect", "--report", "pairs", "--max-results", bad},
                       "--max-results '" + bad + "' is not a whole number from 1 to");
  }
}

TEST(Usage, StandardInputIsReadOnce) {
  expect_usage_error({"detect", "-", "--others", "-"}, "standard input can be read once");
  expect_usage_error({"detect", "--others", "-"}, "say which file to read");
}

TEST(Usage, BenchChecksItsNumbers) {
  for (const std::string bad : {"0", "999", "-1", "many", "100000001"}) {
    expect_usage_error({"bench", "--points", bad},
                       "--points '" + bad + "' is not a whole number from 1,000 to 100,000,000");
  }
  expect_usage_error({"bench", "--threads", "1025"}, "--threads '1025' is not a whole number");
  expect_usage_error({"bench", "bees.csv"}, "'bees.csv' is one argument too many");
}

TEST(Usage, ColumnsThatContradictTheFrameAreRefused) {
  expect_usage_error({"detect", "--crs", "metres", "--columns", "lon=1,lat=2,height=3"}, "--crs");
  expect_usage_error({"detect", "--crs", "wgs84", "--columns", "x=1,y=2,z=3"}, "--crs");
}

TEST(Usage, AFileMayBeCalledAsACommandIs) {
  const Finished finished = run({"detect", "generate"});
  EXPECT_EQ(finished.exit_code, 4);
  EXPECT_NE(finished.err.find("generate: there is no such file"), std::string::npos)
      << finished.err;
}

TEST(Usage, ACommandIsNeeded) {
  expect_usage_error(
      {},
      "say what to do: detect, predict, replay, watch, advise, guide, follow, simulate, verify, "
      "fleet, report, view, plot, export, generate, bench or help (see");
}

TEST(Usage, AnswersExcludeEachOther) {
  expect_usage_error({"detect", "--csv", "--geojson"}, "exclude each other");
}

TEST(Usage, WordsAndNumbersAreChecked) {
  expect_usage_error({"detect", "--crs", "mars"}, "--crs: 'mars' is none of auto, wgs84, metres");
  expect_usage_error({"detect", "--crs", "meters"}, "did you mean 'metres'?");
  expect_usage_error({"generate", "--scene", "unifrom"}, "did you mean 'uniform'?");
  expect_usage_error({"detect", "--format", "xls"}, "--format");
  for (const std::string bad : {"-1", "1.5", "two", "4294967296", "99999999999999999999"}) {
    expect_usage_error({"detect", "--threads", bad},
                       "--threads '" + bad + "' is not a whole number from 0 (all) to");
  }
  expect_usage_error({"detect", "--output", ""}, "--output");
}

TEST(Usage, GenerateChecksItsNumbers) {
  expect_usage_error({"generate"}, "--points is required");
  for (const char* bad : {"0", "-1", "many", "1.5", "99999999999"}) {
    expect_usage_error({"generate", "--points", bad}, "whole number");
  }
  for (const char* bad :
       {"0", "1x2", "axbxc", "1x2x3x4", "inf", "-1", "1x", "1e-300", "1x1e-300x1", "1e16"}) {
    const std::string option = std::string("--size=") + bad;
    expect_usage_error({"generate", "--points", "5", option}, "--size");
  }
  for (const std::string bad : {"-1", "1.5", "99999999999999999999", "18446744073709551616"}) {
    expect_usage_error({"generate", "--points", "5", "--seed", bad},
                       "--seed '" + bad + "' is not a whole number from 0 to");
  }
  expect_usage_error({"generate", "--points", "5", "--clusters", "0"}, "--clusters");
  expect_usage_error({"generate", "--points", "5", "--sigma", "nan"}, "--sigma");
  expect_usage_error({"generate", "--points", "5", "--area", "atlantis"}, "medellin");
  expect_usage_error({"generate", "--points", "5", "--area", "medellin", "--size", "5"}, "--size");
  expect_usage_error({"generate", "--points", "5", "--scene", "clusters", "--size", "1x2x3"},
                     "cube");
}

TEST(Usage, TheFormatFollowsFromTheEndingOrIsRefused) {
  const TemporaryFolder folder;
  expect_usage_error({"generate", "--points", "5", "--output", folder.path("bees.xls")},
                     "does not tell the format");
  for (const auto& [name, format] :
       {std::pair{"bees.npy", "csv"}, std::pair{"BEES.BIN", "npy"}, std::pair{"bees.csv", "tsv"},
        std::pair{"bees.csv", "csv.gz"}, std::pair{"bees.csv.gz", "csv"},
        std::pair{"bees.gz", "npy"}}) {
    expect_usage_error(
        {"generate", "--points", "5", "--output", folder.path(name), "--format", format},
        "contradicts the ending");
  }
  EXPECT_TRUE(folder.names().empty());
}

TEST(Usage, HelpNamesEveryOptionAndGivesExamples) {
  const Finished all = run({"--help"});
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_NE(all.out.find("Examples:"), std::string::npos);
  const Finished detect = run({"detect", "--help"});
  EXPECT_EQ(detect.exit_code, 0);
  for (const char* word :
       {"--threshold",   "--output",       "--crs",          "--columns",     "--format",
        "--inclusive",   "--threads",      "--csv",          "--json",        "--geojson",
        "--report",      "--others",       "--at-risk-only", "--max-results", "closest-pair",
        "--skip-bad",    "--fail-on-risk", "--quiet",        "Examples:",     "Exit status:",
        "143 terminated"}) {
    EXPECT_NE(detect.out.find(word), std::string::npos) << word;
  }
  EXPECT_NE(run({"report", "--help"}).out.find("200,000 pairs, or conflicts,"), std::string::npos);
  const Finished generate = run({"generate", "--help"});
  EXPECT_EQ(generate.exit_code, 0);
  for (const char* word : {"--points", "--scene", "--size", "--clusters", "--sigma", "--area",
                           "--seed", "--output", "--format", "--quiet", "Examples:"}) {
    EXPECT_NE(generate.out.find(word), std::string::npos) << word;
  }
}

TEST(Usage, HelpIsACommandToo) {
  for (const std::string topic : {"detect", "predict", "replay", "watch", "advise", "simulate",
                                  "verify", "generate", "bench"}) {
    const Finished finished = run({"help", topic});
    EXPECT_EQ(finished.exit_code, 0);
    EXPECT_EQ(finished.out, run({topic, "--help"}).out);
  }
  EXPECT_EQ(run({"help"}).out, run({"--help"}).out);
  expect_usage_error({"help", "detekt"}, "did you mean 'detect'?");
}

TEST(Usage, VersionIsTheLibrarys) {
  for (const Arguments& arguments :
       {Arguments{"--version"}, Arguments{"detect", "--version"}, Arguments{"predict", "--version"},
        Arguments{"replay", "--version"}, Arguments{"watch", "--version"},
        Arguments{"advise", "--version"}, Arguments{"simulate", "--version"},
        Arguments{"verify", "--version"}, Arguments{"generate", "--version"},
        Arguments{"bench", "--version"}}) {
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.exit_code, 0);
    EXPECT_EQ(finished.out, "beespace " + std::string(version()) + "\n");
  }
}

}  // namespace
}  // namespace beespace::cli_test
