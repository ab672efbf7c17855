// What of a folder is not read may be of bees that come too close: it is no all-clear, unless the
// names say that it holds no places.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::string way(const std::string& y) {
  return "time_s,x,y,z,vx,vy,vz\n1,0," + y + ",0,1,0,0\n2,1," + y + ",0,1,0,0\n3,2," + y +
         ",0,1,0,0\n";
}

class LeftOutFiles : public testing::Test {
 protected:
  LeftOutFiles() {
    std::filesystem::create_directory(at());
    write("1.csv", way("0"));
    write("2.csv", way("50"));
  }
  [[nodiscard]] std::string at() const { return folder_.path("flight"); }
  void write(const std::string& name, const std::string& text) {
    folder_.file("flight/" + name, text);
  }
  Finished ask(const std::string& command, const Arguments& more = {}) {
    return run(Arguments{command, at(), "--threshold", "5"} + more);
  }

  TemporaryFolder folder_;
};

TEST_F(LeftOutFiles, WhatHoldsNoPlacesIsHarmless) {
  for (const char* const name :
       {"README.txt", "LICENSE", "notes.txt", "about.md", "plan.PDF", "stage.png", "music.mp3",
        "film.mp4", "show.blend", ".DS_Store", "._1.csv", "Thumbs.db", ".gitignore"}) {
    write(name, "no places here");
  }
  std::filesystem::create_directories(at() + "/pictures");
  write("pictures/a.png", "no places here");
  const Finished finished = ask("replay", {"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"bees       2\n", "verdict    keeps its distance\n"});
  EXPECT_EQ(finished.err.find("left out"), std::string::npos);
}

class LeftOutFile : public LeftOutFiles, public testing::WithParamInterface<const char*> {};
INSTANTIATE_TEST_SUITE_P(Kinds, LeftOutFile,
                         testing::Values("3.dat", "3.json", "3.csv.part", "3", ".3.csv", "3.zip",
                                         "3.tlog", "part2/3.csv", "part2/deeper/3"));

TEST_P(LeftOutFile, OfAFolderIsNoAllClear) {
  std::filesystem::create_directories(std::filesystem::path(at() + "/" + GetParam()).parent_path());
  write(GetParam(), way("1"));
  const Finished replay = ask("replay", {"--fail-on-risk"});
  EXPECT_EQ(replay.exit_code, 1);
  expect_parts(replay.err, {"verdict    no conflict among what was read; 1 file or folder "
                            "was left out\n",
                            "not read   " + at() + "/"});
  EXPECT_EQ(ask("verify").exit_code, 1);
  const Finished predict = ask("predict", {"--horizon", "1", "--fail-on-risk"});
  EXPECT_EQ(predict.exit_code, 1);
  expect_parts(predict.err,
               {"none of those that are known after the end of the recording; 1 file or folder "
                "was left out"});
  const Finished page =
      run({"report", at(), "--threshold", "5", "--output", folder_.path("page.html")});
  expect_parts(page.err, {"1 file or folder was left out"});
  const Finished json = ask("replay", {"--json"});
  expect_parts(json.out, {R"("left_out_files": 1)"});
}

// Named as well, it is read.
TEST_F(LeftOutFiles, AFolderWithinThatIsNamedTooIsRead) {
  std::filesystem::create_directory(at() + "/part2");
  write("part2/3.csv", way("1"));
  const Finished both =
      run({"replay", at(), at() + "/part2/", "--threshold", "5", "--fail-on-risk"});
  expect_parts(both.err, {"bees       3\n", "1 conflict of 1 pair\n"});
  EXPECT_EQ(both.err.find("left out"), std::string::npos);
}

// What DeepLabCut writes in three forms is read in one.
TEST_F(LeftOutFiles, TheSameInAnotherFormIsHarmless) {
  write("1.h5", "the same");
  write("1_meta.pickle", "the same");
  EXPECT_EQ(ask("replay", {"--fail-on-risk"}).exit_code, 0);
  write("3.h5", "another one");
  EXPECT_EQ(ask("replay", {"--fail-on-risk"}).exit_code, 1);
}

// What readsb writes: its receiver.json has a place, too, but that of the antenna.
TEST(LeftOutFilesOfReadsb, WhatTellsOfTheReceiverIsPassedOverAndTold) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("run"));
  for (const int second : {0, 1, 2}) {
    const std::string heard =
        R"("lat":48,"alt_geom":3000,"gs":0,"track":0,"geom_rate":0,"seen_pos":0)";
    std::string text = R"({"now":170000000)";
    text += std::to_string(second) + R"(,"messages":9,"aircraft":[{"hex":"aaaaaa","lon":2,)" +
            heard + R"(},{"hex":"bbbbbb","lon":3,)" + heard + "}]}";
    folder.file("run/history_" + std::to_string(second) + ".json", text);
  }
  folder.file("run/receiver.json", R"({"lat":48,"lon":2,"version":"3.14","refresh":1000})");
  folder.file("run/stats.json", R"({"now":1700000000,"latest":{},"last1min":{}})");
  const Arguments question = {"replay", folder.path("run"), "--threshold", "5m", "--fail-on-risk"};
  const Finished finished = run(question);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"bees       2\n",
                              "tell of the receiver, not of aircraft: "
                              "receiver.json, stats.json"});
  // Beside no snapshots such a name may mean anything.
  const TemporaryFolder other;
  std::filesystem::create_directory(other.path("run"));
  other.file("run/stats.json", R"({"now":1700000000,"latest":{},"last1min":{}})");
  EXPECT_EQ(run({"replay", other.path("run"), "--threshold", "5m"}).exit_code, 3);
}

TEST_F(LeftOutFiles, WithMemoryItIsNoAllClearEither) {
  write("3.dat", way("1"));
  const Finished finished =
      ask("replay", {"--memory", "100MB", "--crs", "metres", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"1 file or folder was left out"});
}

}  // namespace
}  // namespace beespace::cli_test
