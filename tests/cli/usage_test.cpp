// Command lines that make no sense, and those that ask for help.
#include <gtest/gtest.h>

#include <beespace/version.hpp>

#include <string>

#include "tests/cli/command_run.hpp"
#include "tests/cli/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kUsage = 2;
constexpr std::string_view kTwo = "x,y,z\n0,0,0\n1,0,0\n";

void expect_usage_error(const Arguments& arguments, const std::string& message) {
  const Finished finished = run(arguments, kTwo);
  EXPECT_EQ(finished.exit_code, kUsage);
  EXPECT_EQ(finished.out, "");
  EXPECT_NE(finished.err.find(message), std::string::npos) << "'" << message << "' in\n"
                                                           << finished.err;
}

TEST(Usage, ThresholdsThatAreNotAboveZeroAndFiniteAreRefused) {
  for (const std::string bad : {"0", "-0", "-5", "nan", "inf", "-inf", "1e999"}) {
    expect_usage_error({"detect", "--threshold", bad},
                       "the threshold '" + bad + "' is not above zero and finite");
  }
  for (const std::string bad : {"abc", "100m", "1,5"}) {
    expect_usage_error({"detect", "--threshold=" + bad}, "is not a number");
  }
  expect_usage_error({"detect", "--threshold", "1e300"}, "threshold");
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
  expect_usage_error({"generate", "--point", "5"}, "did you mean '--points'?");
  expect_usage_error({"detekt"}, "did you mean 'detect'?");
}

TEST(Usage, ACommandIsNeeded) {
  expect_usage_error({}, "detect or generate");
}

TEST(Usage, AnswersExcludeEachOther) {
  expect_usage_error({"detect", "--csv", "--geojson"}, "exclude each other");
}

TEST(Usage, WordsAndNumbersAreChecked) {
  expect_usage_error({"detect", "--crs", "mars"}, "--crs");
  expect_usage_error({"detect", "--format", "xls"}, "--format");
  expect_usage_error({"detect", "--threads", "-1"}, "--threads");
  expect_usage_error({"detect", "--output", ""}, "--output");
}

TEST(Usage, GenerateChecksItsNumbers) {
  expect_usage_error({"generate"}, "--points is required");
  for (const char* bad : {"0", "-1", "many", "1.5", "99999999999"}) {
    expect_usage_error({"generate", "--points", bad}, "whole number");
  }
  for (const char* bad : {"0", "1x2", "axbxc", "1x2x3x4", "inf", "-1", "1x"}) {
    const std::string option = std::string("--size=") + bad;
    expect_usage_error({"generate", "--points", "5", option}, "--size");
  }
  expect_usage_error({"generate", "--points", "5", "--clusters", "0"}, "--clusters");
  expect_usage_error({"generate", "--points", "5", "--sigma", "nan"}, "--sigma");
  expect_usage_error({"generate", "--points", "5", "--area", "atlantis"}, "medellin");
  expect_usage_error({"generate", "--points", "5", "--area", "medellin", "--size", "5"}, "--size");
  expect_usage_error({"generate", "--points", "5", "--scene", "clusters", "--size", "1x2x3"},
                     "cube");
}

TEST(Usage, TheFormatIsToldByTheEndingOrRefused) {
  const TemporaryFolder folder;
  expect_usage_error({"generate", "--points", "5", "--output", folder.path("bees.xls")},
                     "does not tell the format");
  EXPECT_TRUE(folder.names().empty());
}

TEST(Usage, HelpNamesEveryOptionAndGivesExamples) {
  const Finished all = run({"--help"});
  EXPECT_EQ(all.exit_code, 0);
  EXPECT_NE(all.out.find("Examples:"), std::string::npos);
  const Finished detect = run({"detect", "--help"});
  EXPECT_EQ(detect.exit_code, 0);
  for (const char* word :
       {"--threshold", "--output", "--crs", "--columns", "--format", "--inclusive", "--threads",
        "--csv", "--json", "--geojson", "--nearest", "--skip-bad", "--fail-on-risk", "--quiet",
        "Examples:", "Exit status:"}) {
    EXPECT_NE(detect.out.find(word), std::string::npos) << word;
  }
  const Finished generate = run({"generate", "--help"});
  EXPECT_EQ(generate.exit_code, 0);
  for (const char* word : {"--points", "--scene", "--size", "--clusters", "--sigma", "--area",
                           "--seed", "--output", "--format", "Examples:"}) {
    EXPECT_NE(generate.out.find(word), std::string::npos) << word;
  }
}

TEST(Usage, VersionIsTheLibrarys) {
  const Finished finished = run({"--version"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "beespace " + std::string(version()) + "\n");
}

}  // namespace
}  // namespace beespace::cli_test
