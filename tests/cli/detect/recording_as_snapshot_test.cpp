// `beespace detect` on what is no snapshot: a recording is refused, and replay named, before every
// fix counts as a bee.
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr std::string_view kRecording =
    "id,time_s,x,y,z\na,0,0,0,0\nb,0,50,0,0\na,1,1,0,0\nb,1,51,0,0\n";

void expect_answer(std::string_view input, const std::string& answer) {
  const Finished finished = run({"detect"}, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(finished.out, answer);
}

TEST(RecordingAsSnapshot, ATableWithABeeAtTwoTimesIsRefusedAndNamed) {
  expect_failure({"detect"}, kRecording, kBadInput,
                 "<stdin>: this is a recording: bee 'a' is in it at more than one time ('0' and "
                 "'1'); ask 'beespace replay' about it");
  const TemporaryFolder folder;
  const std::string path = folder.file("flight.csv", kRecording);
  expect_failure({"detect", path}, {}, kBadInput, "flight.csv: this is a recording");
  expect_failure({"detect", "--others", path}, "x,y,z\n0,0,0\n", kBadInput,
                 "flight.csv: this is a recording");
}

TEST(RecordingAsSnapshot, ColumnsAreKnownByTheirNamesWhereverTheyAre) {
  expect_failure({"detect"},
                 "lon;lat;height;timestamp;\"id\"\n"
                 "1;2;3;2024-05-01T12:00:00Z;\"a\"\n1;2;4;2024-05-01T12:00:01Z;a\n",
                 kBadInput, "bee 'a' is in it at more than one time");
  expect_failure({"detect"}, "drone,t_ms,x,y,z\n7,0,0,0,0\n7,100,1,0,0\n", kBadInput,
                 "bee '7' is in it at more than one time");
  expect_failure({"detect", "--columns", "id=5,x=1,y=2,z=3"},
                 "a,b,c,time,d\n0,0,0,1,e\n0,0,0,2,e\n", kBadInput, "bee 'e'");
}

// Frames, days and times under names of one's own, and a header in a comment.
TEST(RecordingAsSnapshot, TimesAreKnownAsReplayKnowsThem) {
  expect_failure({"detect"}, "id,frame,x,y,z\na,0,0,0,0\na,1,1,0,0\n", kBadInput,
                 "bee 'a' is in it at more than one time ('0' and '1')");
  expect_failure({"detect"},
                 "id,LMT_Date,LMT_Time,x,y,z\na,10.01.2023,01:00:00,0,0,0\n"
                 "a,10.01.2023,02:00:00,1,0,0\n",
                 kBadInput, "bee 'a' is in it at more than one time");
  expect_failure({"detect"}, "# simt, id, lat, lon, alt\n0.0,KL1,52,4,6096\n1.0,KL1,52.1,4,6096\n",
                 kBadInput, "bee 'KL1' is in it at more than one time ('0.0' and '1.0')");
}

// One bee, all of whose fixes would be bees.
TEST(RecordingAsSnapshot, ATableOfSeveralTimesWithoutAnIdIsOne) {
  expect_failure({"detect"}, "Time [msec],x [m],y [m],z [m]\n0,0,0,0\n250,0,0,1\n500,0,0,2\n",
                 kBadInput,
                 "this is a recording: its records are of several times ('0' and '250'); ask "
                 "'beespace replay' about it");
  expect_answer("time_s,x,y,z\n7,0,0,0\n7.0,50,0,0\n7,900,0,0\n", "0\n1\n");
}

TEST(RecordingAsSnapshot, SoIsOneWhoseIdNumbersTheRecords) {
  const std::string_view spots =
      "LABEL,TRACK_ID,FRAME,x,y,z\nID0,0,0,0,0,0\nID1,1,0,9,0,0\nID2,0,1,1,0,0\n";
  expect_failure({"detect"}, spots, kBadInput, "this is a recording: ");
  const std::string_view rows = "id,time_s,x,y,z\n1,0,0,0,0\n2,1,50,0,0\n3,2,900,0,0\n";
  expect_failure({"detect"}, rows, kBadInput,
                 "and column 1 'id' numbers them; ask 'beespace replay' about it, leave one time "
                 "in it, or, if each is of another bee, say --columns id=1");
  EXPECT_EQ(run({"detect", "--columns", "id=1"}, rows).out, "1\n2\n");
  // Beside an id that has several times it numbers them all the same.
  expect_failure(
      {"detect", "--columns", "id=1"},
      "id,animals_id,time_s,x_m,y_m,z_m\n1,a,0,0,0,5\n2,b,0,9,0,5\n3,a,1,1,0,5\n", kBadInput,
      "column 1 'id' numbers its records, and column 2 'animals_id' has 'a' at more than "
      "one time ('0' and '1'); ask 'beespace replay'");
  const std::string_view aircraft =
      "icao24,time_s,x [m],y [m],z [m]\na,0,0,0,0\nb,1,50,0,0\nc,2,900,0,0\n";
  EXPECT_EQ(run({"detect", "--threshold", "100m"}, aircraft).out, "a\nb\n");
}

TEST(RecordingAsSnapshot, HeightsAboveEachTakeOffAreRefusedLikewise) {
  const std::string_view table = "id,lat,lon,rel_alt_m\n1,47,8,10\n2,47.1,8,30\n";
  const std::string columns = "lon=3,lat=2,height=4";
  for (const std::vector<std::string>& how : {std::vector<std::string>{}, {"--memory", "1GB"}}) {
    std::vector<std::string> words = {"detect", "--columns", columns};
    words.insert(words.end(), how.begin(), how.end());
    const Finished refused = run(words, table);
    EXPECT_EQ(refused.exit_code, 2) << refused.err;
    expect_parts(refused.err, {"those of several cannot be compared"});
    words.insert(words.end(), {"--crs", "wgs84"});
    EXPECT_EQ(run(words, table).exit_code, 0);
  }
}

TEST(RecordingAsSnapshot, ASnapshotMayHaveATimeColumn) {
  expect_answer("id,time_s,x,y,z\na,0,0,0,0\nb,0,50,0,0\n", "a\nb\n");
  // Each heard of at a time of its own.
  expect_answer("id,time_s,x,y,z\na,0,0,0,0\nb,1,50,0,0\n", "a\nb\n");
  expect_answer("time_s,x,y,z\n0,0,0,0\n1,50,0,0\n", "0\n1\n");
}

TEST(RecordingAsSnapshot, IdsMayRepeatWithoutATime) {
  expect_answer("id,x,y,z\na,0,0,0\na,50,0,0\n", "a\na\n");
  expect_answer("id,time_s,x,y,z\na,1,0,0,0\na,1.0,50,0,0\n", "a\na\n");
  expect_answer("id,time_s,x,y,z\n,0,0,0,0\n,1,50,0,0\na,,9,0,0\na,7,9,0,0\n", "0\n1\na\na\n");
}

TEST(RecordingAsSnapshot, OtherFormatsOfRecordingsAreNamedToo) {
  const TemporaryFolder folder;
  const std::string show = folder.file(
      "show.json", R"({"version": 1, "settings": {}, "swarm": {"drones": [{"type": "generic",
        "settings": {"name": "a", "trajectory": {"version": 1,
        "points": [[0, [0, 0, 0], []], [9, [0, 0, 9], []]]}}}]}})");
  expect_failure({"detect", show}, {}, kBadInput,
                 "show.json: this is a recording of bees that move (Skybrush show");
  const std::string heard = folder.file(
      "port30003.csv",
      "MSG,3,1,1,4B1814,1,2024/05/01,12:00:00.250,2024/05/01,12:00:00.250,,10000,,,47.25,8.5,,,0,"
      "0,0,0\n");
  expect_failure({"detect", heard}, {}, kBadInput,
                 "port30003.csv: this is a look at bees that move (BaseStation messages)");
}

TEST(RecordingAsSnapshot, WhatIsNoRecordingKeepsItsError) {
  const TemporaryFolder folder;
  expect_failure({"detect", folder.file("some.json", "{\"a\": 1}")}, {}, kBadInput,
                 "this is JSON of a kind that beespace does not know");
  expect_failure({"detect", folder.file("bad.csv", "x,y,z\n0,0,oops\n")}, {}, kBadInput,
                 "bad.csv:2:3: 'oops'");
  // Nor is that a reason to wait for more of a pipe.
  expect_failure({"detect"}, "{\"a\": 1}", kBadInput,
                 "this is JSON of a kind that beespace does not know");
}

}  // namespace
}  // namespace beespace::cli_test
