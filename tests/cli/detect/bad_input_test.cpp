// Invalid input: the message, the exit code, and that no files are left behind.
#include <gtest/gtest.h>

#include <sys/stat.h>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// One header and one good record, to put a bad one after.
const std::string kGood = "longitude,latitude,height\n-75.5,6.25,1500\n";

class BadInput : public testing::Test {
 protected:
  // Detects in a file of this content; the answer would go to another file.
  void expect_refused(const std::string& name, std::string_view content, const std::string& message,
                      Arguments more = {}) {
    folder_.file(name, content);
    expect_refused_path(folder_.path(name), message, kBadInput, std::move(more));
  }

  void expect_refused_path(const std::string& path, const std::string& message, int exit_code,
                           Arguments more = {}) {
    const auto before = folder_.names();
    Arguments arguments = {"detect", path, "--output", folder_.path("answer.txt")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Finished to_file = run(arguments, {}, surroundings_);
    EXPECT_EQ(to_file.exit_code, exit_code);
    EXPECT_NE(to_file.err.find(message), std::string::npos) << "'" << message << "' in\n"
                                                            << to_file.err;
    EXPECT_NE(to_file.err.find("beespace: error: "), std::string::npos);
    EXPECT_EQ(folder_.names(), before) << "something was left behind";

    Arguments to_stdout = {"detect", path};
    to_stdout.insert(to_stdout.end(), more.begin(), more.end());
    const Finished finished = run(to_stdout, {}, surroundings_);
    EXPECT_EQ(finished.exit_code, exit_code);
    EXPECT_EQ(finished.out, "") << "a part of an answer was written";
  }

  TemporaryFolder folder_;
  Surroundings surroundings_;
};

TEST_F(BadInput, MissingFile) {
  expect_refused_path(folder_.path("missing.csv"), "missing.csv: there is no such file", kSystem);
}

TEST_F(BadInput, Directory) {
  expect_refused_path(folder_.path("."), "this is a directory", kSystem);
}

TEST_F(BadInput, UnreadableFile) {
  // Root may read everything; another user must be able to enter the folder that root made.
  surroundings_.unprivileged = true;
  ASSERT_EQ(chmod(folder_.path(".").c_str(), 0777), 0);
  const std::string path = folder_.file("secret.csv", kGood);
  ASSERT_EQ(chmod(path.c_str(), 0), 0);
  expect_refused_path(path, "secret.csv: not allowed to read this file", kSystem);
}

TEST_F(BadInput, EmptyFile) {
  expect_refused("empty.csv", "", "the input is empty");
}

TEST_F(BadInput, HeaderOnly) {
  expect_refused("header.csv", "longitude,latitude,height\n", "no record after it");
}

TEST_F(BadInput, MissingColumn) {
  expect_refused("bees.csv", "longitude,height\n1,2\n", "--columns");
  expect_refused("bees.csv", kGood, "breite", {"--columns", "lon=longitude,lat=breite"});
}

TEST_F(BadInput, NotANumberIsNamedWithLineColumnAndText) {
  expect_refused("bees.csv", kGood + "-75.5,6..3,1500\n", "bees.csv:3:2: '6..3' is not a number");
}

TEST_F(BadInput, NanAndInfinity) {
  expect_refused("bees.csv", kGood + "-75.5,nan,1500\n", "bees.csv:3:2: 'nan'");
  expect_refused("bees.csv", kGood + "-75.5,6.25,inf\n", "bees.csv:3:3: 'inf'");
}

TEST_F(BadInput, LatitudeBeyondNinety) {
  expect_refused("bees.csv", kGood + "6.25,-95.5,1500\n", "bees.csv:3:2: latitude '-95.5'");
}

TEST_F(BadInput, LongitudeBeyondAFullTurn) {
  expect_refused("bees.csv", kGood + "-361,6.25,1500\n", "bees.csv:3:1: longitude '-361'");
}

TEST_F(BadInput, HeightInTheMillions) {
  expect_refused("bees.csv", kGood + "-75.5,6.25,1500000\n", "bees.csv:3:3: height '1500000'");
}

TEST_F(BadInput, MixedColumnCounts) {
  expect_refused("bees.csv", kGood + "-75.5,6.25\n", "bees.csv:3: 2 columns");
}

TEST_F(BadInput, DegreesOrMetresIsNeverGuessed) {
  expect_refused("bees.csv", "1,2,3\n4,5,6\n", "degrees or metres?");
}

TEST_F(BadInput, TruncatedGzip) {
  const std::string whole = run({"generate", "--points", "500", "--format", "csv.gz"}).out;
  expect_refused("bees.csv.gz", whole.substr(0, whole.size() / 2), "ends too early");
}

TEST_F(BadInput, TruncatedNpy) {
  const std::string whole = run({"generate", "--points", "500", "--format", "npy"}).out;
  expect_refused("bees.npy", whole.substr(0, whole.size() - 100), "of 500 points");
}

TEST_F(BadInput, WrongNpyTypeAndShape) {
  std::string array = run({"generate", "--points", "500", "--format", "npy"}).out;
  const std::size_t type = array.find("<f8");
  expect_refused("bees.npy", std::string(array).replace(type, 3, "<i8"), "'<i8'");
  const std::size_t shape = array.find("(500, 3)");
  expect_refused("bees.npy", std::string(array).replace(shape, 8, "(750, 2)"), "(750, 2)");
}

TEST_F(BadInput, BinaryRubbish) {
  std::string rubbish;
  for (unsigned i = 0; i < 4'096; ++i) rubbish += static_cast<char>((i * i + 7 * i) % 251);
  expect_refused("bees.csv", rubbish, "this is no text");
}

TEST_F(BadInput, ALineOfTenMegabytes) {
  expect_refused("bees.csv", kGood + std::string(10'000'000, '7') + "\n", "too long");
}

TEST_F(BadInput, WithJsonTheErrorIsADocumentToo) {
  const Finished finished = run({"detect", "--json"}, kGood + "-75.5,abc,1500\n");
  EXPECT_EQ(finished.exit_code, kBadInput);
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  for (const char* part :
       {R"("code": "not_a_number")", R"("file": "<stdin>")", R"("line": 3)", R"("column": 2)"}) {
    EXPECT_NE(finished.out.find(part), std::string::npos) << part << " in " << finished.out;
  }
  EXPECT_NE(finished.err.find("<stdin>:3:2: 'abc'"), std::string::npos);
}

TEST_F(BadInput, ErrorsCannotSteerTheTerminal) {
  const Finished finished = run({"detect",
                                 "/missing\x1b[2J\r\xC2\x9B"
                                 "2J"});
  EXPECT_EQ(finished.err.find_first_of("\x1b\r"), std::string::npos);
  EXPECT_EQ(finished.err.find("\xC2\x9B"), std::string::npos);
  const Finished summary = run({"detect"},
                               "id,x,y,z\n\xC2\x9B"
                               "2J,0,0,0\nb,1,0,0\n");
  EXPECT_EQ(summary.exit_code, 0);
  EXPECT_NE(summary.err.find("closest    ??2J and b"), std::string::npos) << summary.err;
  EXPECT_EQ(summary.err.find("\xC2\x9B"), std::string::npos);
}

TEST_F(BadInput, OnePointIsAnAnswerNotAnError) {
  const Finished finished = run({"detect"}, kGood);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.out, "");
  EXPECT_NE(finished.err.find("at risk    none"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace beespace::cli_test
