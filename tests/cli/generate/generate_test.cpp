// `beespace generate`: every format, the same bytes everywhere, and back through detect.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// FNV-1a.
std::uint64_t fingerprint(const std::string& bytes) {
  std::uint64_t hash = 14'695'981'039'346'656'037u;
  for (const char c : bytes) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 1'099'511'628'211u;
  }
  return hash;
}

TEST(Generate, TheSameSeedGivesTheseBytesOnEveryMachine) {
  const auto bytes = [](Arguments more) {
    Arguments arguments = {"generate", "--points", "1000", "--seed", "42"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return fingerprint(run(arguments).out);
  };
  EXPECT_EQ(bytes({"--size", "3300x2300x480"}), 2'901'695'393'425'909'980u);
  EXPECT_EQ(bytes({"--scene", "clusters"}), 8'169'277'716'266'216'062u);
  EXPECT_EQ(bytes({"--area", "medellin"}), 7'962'340'121'788'262'612u);
  EXPECT_EQ(bytes({"--format", "npy"}), 896'078'175'391'463'830u);
}

TEST(Generate, AnotherSeedGivesOtherBees) {
  EXPECT_NE(run({"generate", "--points", "10", "--seed", "1"}).out,
            run({"generate", "--points", "10", "--seed", "2"}).out);
}

TEST(Generate, TheAreaIsWrittenInTheCourseFormat) {
  const std::string text = run({"generate", "--area", "medellin", "--points", "100"}).out;
  const std::string header =
      "Coordenada x de la abeja, coordenada y de la abeja, coordenada z de la abeja\n";
  ASSERT_EQ(text.substr(0, header.size()), header);
  const std::string line =
      text.substr(header.size(), text.find('\n', header.size()) - header.size());
  const std::size_t first = line.find(',');
  const std::size_t second = line.find(',', first + 1);
  EXPECT_EQ(first - line.find('.') - 1, 11u) << line;
  EXPECT_EQ(second - line.find('.', first) - 1, 11u) << line;
  EXPECT_EQ(line.size() - line.find('.', second) - 1, 2u) << line;
  const Finished found = run({"detect"}, text);
  EXPECT_EQ(found.exit_code, 0);
  EXPECT_NE(found.err.find("WGS84"), std::string::npos) << found.err;
}

class GenerateFormat : public testing::TestWithParam<const char*> {};

// Text has all digits of the doubles, arrays their bits: the answers must not differ.
TEST_P(GenerateFormat, DetectReadsTheSameSwarmBack) {
  const Arguments swarm = {"generate", "--points", "3000", "--size", "2000x2000x500"};
  const std::string expected =
      run({"detect", "--report", "nearest", "--at-risk-only", "--threshold", "60"}, run(swarm).out)
          .out;
  ASSERT_GT(expected.size(), 1'000u);

  const TemporaryFolder folder;
  const std::string file = folder.path(std::string("bees.") + GetParam());
  Arguments to_file = swarm;
  to_file.insert(to_file.end(), {"--output", file});
  const Finished made = run(to_file);
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.out + made.err, "");
  const Finished found =
      run({"detect", file, "--report", "nearest", "--at-risk-only", "--threshold", "60"});
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_EQ(found.out, expected);
}

TEST_P(GenerateFormat, DetectReadsAnAreaBack) {
  const TemporaryFolder folder;
  const std::string file = folder.path(std::string("bees.") + GetParam());
  ASSERT_EQ(run({"generate", "--points", "1000", "--area", "medellin", "--output", file}).exit_code,
            0);
  const Finished found = run({"detect", file, "--crs", "wgs84"});
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_NE(found.err.find("points     1,000"), std::string::npos) << found.err;
  EXPECT_FALSE(found.out.empty());
}

std::string name_of(const testing::TestParamInfo<const char*>& format) {
  std::string name = format.param;
  const std::size_t dot = name.find('.');
  if (dot != std::string::npos) name[dot] = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, GenerateFormat,
                         testing::Values("csv", "txt", "tsv", "npy", "bin", "csv.gz", "txt.gz",
                                         "tsv.gz", "npy.gz", "bin.gz"),
                         name_of);

TEST(Generate, TheLargestSeedIsASeed) {
  const Finished finished = run({"generate", "--points", "3", "--seed", "18446744073709551615"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_NE(finished.out, run({"generate", "--points", "3", "--seed", "1"}).out);
}

TEST(Generate, DetectTakesTheSmallestAndTheLargestBox) {
  for (const char* size : {"0.000001", "1e15"}) {
    const std::string swarm = run({"generate", "--points", "500", "--size", size}).out;
    EXPECT_EQ(run({"detect"}, swarm).exit_code, 0) << size;
  }
}

TEST(Generate, AFormatMayBeNamedWhereTheEndingAgreesOrSaysNothing) {
  const TemporaryFolder folder;
  const auto write = [&folder](const std::string& name, const std::string& format) {
    return run({"generate", "--points", "3", "--output", folder.path(name), "--format", format})
        .exit_code;
  };
  EXPECT_EQ(write("a.npy", "npy"), 0);
  EXPECT_EQ(write("a.xyz", "npy"), 0);
  EXPECT_EQ(write("a.txt", "tsv"), 0);
  EXPECT_EQ(write("a.gz", "bin.gz"), 0);
  EXPECT_EQ(run({"generate", "--points", "3", "--output", folder.path("A.NPY")}).exit_code, 0);
  EXPECT_EQ(folder.read("A.NPY"), folder.read("a.npy"));
}

TEST(Generate, QuietChangesNothing) {
  const Arguments arguments = {"generate", "--points", "3"};
  Arguments quiet = arguments;
  quiet.emplace_back("--quiet");
  const Finished finished = run(quiet);
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(finished.err, "");
  EXPECT_EQ(finished.out, run(arguments).out);
}

TEST(Generate, ClustersAreCrowdedAndTheBoxIsNot) {
  const auto at_risk = [](const Arguments& swarm) {
    const std::string ids = run({"detect"}, run(swarm).out).out;
    std::size_t lines = 0;
    for (const char c : ids) lines += c == '\n' ? 1 : 0;
    return lines;
  };
  EXPECT_GT(at_risk({"generate", "--points", "1000", "--clusters", "3", "--sigma", "50"}), 900u);
  EXPECT_LT(at_risk({"generate", "--points", "1000"}), 20u);
}

}  // namespace
}  // namespace beespace::cli_test
