// `beespace generate` of bees that fly: the same bytes everywhere, and on through predict and
// replay.
#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <utility>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
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

std::string generated(const std::string& scene, const Arguments& more = {}) {
  const Finished made =
      run(Arguments{"generate", "--scene", scene, "--points", "40", "--seed", "5"} + more);
  EXPECT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  return made.out;
}

// The conflicts that predict or replay finds, as rows of text.
TextRows conflicts_of(const Arguments& question, const std::string& input) {
  const Finished found = run(question, input);
  EXPECT_EQ(found.exit_code, 0) << found.err;
  return rows_of(found.out);
}

// Pairs 0 and 1, 2 and 3, and so on, and no others.
void expect_the_pairs(const TextRows& conflicts, std::size_t pairs) {
  ASSERT_EQ(conflicts.size(), pairs);
  for (std::size_t i = 0; i < pairs; ++i) {
    EXPECT_EQ(conflicts[i].at(0), std::to_string(2 * i));
    EXPECT_EQ(conflicts[i].at(1), std::to_string(2 * i + 1));
  }
}

void expect_refused(const Arguments& arguments, const std::string& why) {
  const Finished finished = run(Arguments{"generate", "--points", "4"} + arguments);
  EXPECT_EQ(finished.exit_code, 2) << finished.err;
  EXPECT_EQ(finished.out, "");
  EXPECT_NE(finished.err.find(why), std::string::npos) << finished.err;
}

TEST(GenerateMoving, TheSameSeedGivesTheseBytesOnEveryMachine) {
  EXPECT_EQ(fingerprint(generated("flight")), 17'429'827'876'434'186'792u);
  EXPECT_EQ(fingerprint(generated("head-on", {"--speed", "7", "--miss", "0"})),
            18'355'306'972'949'339'105u);
  EXPECT_EQ(fingerprint(generated("crossing", {"--size", "300x300x20"})),
            4'135'418'266'330'545'405u);
  EXPECT_EQ(fingerprint(generated("sphere-swap", {"--duration", "10"})),
            18'349'409'869'157'184'793u);
  EXPECT_EQ(fingerprint(generated("encounters", {"--duration", "10", "--interval", "3"})),
            6'516'636'198'486'841'240u);
}

class GenerateMovingScene : public testing::TestWithParam<const char*> {};

TEST_P(GenerateMovingScene, IsASnapshotThatPredictReads) {
  const std::string swarm = generated(GetParam());
  const auto lines = lines_of(swarm);
  ASSERT_EQ(lines.size(), 41u);
  EXPECT_EQ(lines[0], "id,x,y,z,vx,vy,vz");
  EXPECT_EQ(lines[40].substr(0, 3), "39,");
  const Finished found = run({"predict"}, swarm);
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_NE(found.err.find("bees       40"), std::string::npos) << found.err;
  EXPECT_NE(found.err.find("velocities along x, y, z"), std::string::npos) << found.err;
}

TEST_P(GenerateMovingScene, IsARecordingThatReplayAndPredictRead) {
  const std::string recording = generated(GetParam(), {"--duration", "12.5", "--interval", "0.5"});
  const auto lines = lines_of(recording);
  EXPECT_EQ(lines[0], "id,time_s,x,y,z,vx,vy,vz");
  EXPECT_NEAR(static_cast<double>(lines.size()), 40.0 * 26.0, 40.0);
  const Finished found = run({"replay"}, recording);
  EXPECT_EQ(found.exit_code, 0) << found.err;
  EXPECT_NE(found.err.find("bees       40"), std::string::npos) << found.err;
  EXPECT_NE(found.err.find("0.00 s to 12.50 s"), std::string::npos) << found.err;
  const Finished ahead = run({"predict"}, recording);
  EXPECT_EQ(ahead.exit_code, 0) << ahead.err;
  EXPECT_NE(ahead.err.find("now        12.50 s"), std::string::npos) << ahead.err;
}

// All bees fly straight on, so the recording has the conflicts that were predicted.
TEST_P(GenerateMovingScene, HasTheConflictsInItsRecordingThatItsSnapshotPredicts) {
  const Arguments narrow = {"--speed", "10-20"};
  const auto predicted =
      conflicts_of({"predict", "--quiet", "--threshold", "20"}, generated(GetParam(), narrow));
  const auto recorded = conflicts_of({"replay", "--quiet", "--threshold", "20"},
                                     generated(GetParam(), narrow + Arguments{"--duration", "60"}));
  ASSERT_EQ(recorded.size(), predicted.size());
  for (std::size_t i = 0; i < recorded.size(); ++i) {
    EXPECT_EQ(recorded[i].at(0), predicted[i].at(0));
    EXPECT_EQ(recorded[i].at(1), predicted[i].at(1));
    for (const std::size_t value : {2u, 3u, 4u, 5u}) {
      EXPECT_NEAR(std::stod(recorded[i].at(value)), std::stod(predicted[i].at(value)), 1e-6);
    }
  }
}

TEST_P(GenerateMovingScene, GoesThroughFilesOfEveryTextFormat) {
  const TemporaryFolder folder;
  for (const Arguments& more : {Arguments{}, Arguments{"--duration", "5"}}) {
    const Arguments question = {more.empty() ? "predict" : "replay", "--threshold", "300"};
    const std::string expected = run(question, generated(GetParam(), more)).out;
    for (const char* name : {"bees.csv", "bees.txt", "bees.tsv", "bees.csv.gz", "bees.tsv.gz"}) {
      EXPECT_EQ(generated(GetParam(), more + Arguments{"--output", folder.path(name)}), "");
      EXPECT_EQ(run(question + Arguments{folder.path(name)}).out, expected) << name;
    }
    EXPECT_EQ(fields_of(lines_of(folder.read("bees.tsv"))[1], '\t').size(), more.empty() ? 7u : 8u);
  }
}

TEST_P(GenerateMovingScene, HoldsNoArrays) {
  const TemporaryFolder folder;
  const std::string why = std::string("write --scene ") + GetParam() + " as csv or tsv";
  expect_refused({"--scene", GetParam(), "--output", folder.path("bees.npy")}, why);
  expect_refused({"--scene", GetParam(), "--format", "bin.gz", "--duration", "5"}, why);
  EXPECT_TRUE(folder.names().empty());
}

std::string name_of(const testing::TestParamInfo<const char*>& scene) {
  std::string name = scene.param;
  const std::size_t hyphen = name.find('-');
  if (hyphen != std::string::npos) name[hyphen] = '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, GenerateMovingScene,
                         testing::Values("flight", "head-on", "crossing", "sphere-swap",
                                         "encounters"),
                         name_of);

TEST(GenerateMoving, EncountersAreAllThatPredictAndReplayFind) {
  const Arguments some = {"--miss", "4", "--speed", "8-9"};
  expect_the_pairs(
      conflicts_of({"predict", "--quiet", "--threshold", "4"}, generated("encounters", some)), 20);
  expect_the_pairs(conflicts_of({"replay", "--quiet", "--threshold", "1000"},
                                generated("encounters", some + Arguments{"--duration", "30"})),
                   20);
}

TEST(GenerateMoving, HeadOnPairsPassAtTheDistanceAskedForWithinTheDuration) {
  const Arguments some = {"--miss", "3", "--duration", "25", "--size", "1e6"};
  const auto conflicts =
      conflicts_of({"replay", "--quiet", "--threshold", "3.01"}, generated("head-on", some));
  expect_the_pairs(conflicts, 20);
  for (const auto& row : conflicts) {
    EXPECT_NEAR(std::stod(row.at(4)), 3.0, 1e-6);
    EXPECT_LE(std::stod(row.at(3)), 25.0);
  }
}

TEST(GenerateMoving, OneSpeedIsThatOfAll) {
  for (const auto& [speed, exact] : {std::pair("12", 12.0), std::pair("5e-1-5e-1", 0.5)}) {
    const auto lines = lines_of(generated("crossing", {"--speed", speed}));
    for (std::size_t i = 1; i < lines.size(); ++i) {
      const auto fields = fields_of(lines[i], ',');
      EXPECT_EQ(std::stod(fields.at(4)) + std::stod(fields.at(5)), exact);
    }
  }
}

TEST(GenerateMoving, AFlightIsMeantWhereOnlyItsOptionsAreGiven) {
  const auto made = [](const Arguments& more) {
    return run(Arguments{"generate", "--points", "40", "--seed", "5"} + more).out;
  };
  EXPECT_EQ(made({"--speed", "5-20"}), generated("flight"));
  EXPECT_EQ(made({"--duration", "3"}), generated("flight", {"--duration", "3"}));
}

TEST(GenerateMoving, TheExtremesAreReadBack) {
  for (const Arguments& extreme :
       {Arguments{"--size", "0.000001", "--speed", "0.000001", "--duration", "0.000001"},
        Arguments{"--size", "1e15", "--speed", "1e6", "--duration", "1e9", "--interval", "1e8"}}) {
    for (const char* scene : {"flight", "head-on", "crossing", "sphere-swap"}) {
      // So fast that it would be asked whether it is in metres.
      const Finished found =
          run({"replay", "--quiet", "--units", "position=m"}, generated(scene, extreme));
      EXPECT_EQ(found.exit_code, 0) << scene << ": " << found.err;
    }
  }
  const Finished far = run({"predict", "--quiet"}, generated("encounters", {"--miss", "1e15"}));
  EXPECT_EQ(far.exit_code, 0) << far.err;
}

TEST(GenerateMoving, OptionsThatTheSceneWouldIgnoreAreRefused) {
  expect_refused({"--scene", "uniform", "--speed", "5"},
                 "--speed does not apply to --scene uniform");
  expect_refused({"--scene", "clusters", "--duration", "5"},
                 "--duration does not apply to --scene clusters");
  expect_refused({"--area", "medellin", "--interval", "5"},
                 "--interval does not apply to --scene area");
  expect_refused({"--miss", "5"}, "--miss does not apply to --scene uniform");
  expect_refused({"--scene", "flight", "--miss", "5"}, "--miss does not apply to --scene flight");
  expect_refused({"--scene", "flight", "--sigma", "5"}, "--sigma does not apply to --scene flight");
  expect_refused({"--scene", "crossing", "--clusters", "5"},
                 "--clusters does not apply to --scene crossing");
  expect_refused({"--scene", "head-on", "--area", "medellin"},
                 "--area does not apply to --scene head-on");
  expect_refused({"--scene", "encounters", "--size", "5"},
                 "--size does not apply to --scene encounters");
  expect_refused({"--scene", "flight", "--interval", "5"}, "add --duration");
  expect_refused({"--scene", "sphere-swap", "--size", "1x2x3"}, "give --size its diameter");
}

TEST(GenerateMoving, InvalidValuesAreRefused) {
  for (const char* speed :
       {"0", "-5", "5-", "-", "20-5", "5-20-30", "fast", "nan", "1-inf", "1e7"}) {
    expect_refused({"--scene", "flight", std::string("--speed=") + speed}, "--speed '");
  }
  for (const char* option : {"--duration", "--interval"}) {
    for (const char* bad : {"0", "-1", "inf", "nan", "1e10", "5s"}) {
      expect_refused({"--scene", "flight", "--duration=1", std::string(option) + "=" + bad},
                     option);
    }
  }
  for (const char* miss : {"-1", "1e-9", "inf", "nan", "near"}) {
    expect_refused({"--scene", "head-on", std::string("--miss=") + miss}, "--miss '");
  }
  expect_refused({"--scene", "flight", "--duration", "1e9"}, "make the interval longer");
  for (const char* scene : {"head-on", "encounters"}) {
    const Finished odd = run({"generate", "--points", "5", "--scene", scene});
    EXPECT_EQ(odd.exit_code, 2);
    EXPECT_NE(odd.err.find("an even number"), std::string::npos) << odd.err;
  }
  expect_refused({"--scene", "head-onn"}, "did you mean 'head-on'?");
}

}  // namespace
}  // namespace beespace::cli_test
