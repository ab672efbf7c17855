// Bees of one name in several studies, trials, videos or days are several bees.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;

const std::string kMovebank =
    "event-id,visible,timestamp,location-long,location-lat,tag-local-identifier,"
    "individual-local-identifier,study-name\n";

std::string fix_of(const std::string& minute, const std::string& individual,
                   const std::string& study, const std::string& longitude = "9.17",
                   const std::string& visible = "true") {
  return "1," + visible + ",2015-09-10 07:" + minute + ":00.000," + longitude + ",47.7,1," +
         individual + "," + study + "\n";
}

TEST(Sets, IndividualsOfTwoStudiesAreTwo) {
  const Recording recording =
      recording_of(record(kMovebank + fix_of("00", "x", "S1") + fix_of("05", "x", "S1") +
                          fix_of("01", "x", "S2", "9.18") + fix_of("06", "x", "S2", "9.18")));
  EXPECT_EQ(ids_of(recording), (Ids{"x", "x (S2)"}));
  EXPECT_EQ(times_of(recording.bees[1])[0] - times_of(recording.bees[0])[0], 60.0);
  EXPECT_TRUE(has_note(recording,
                       "1 bee has the name of one of another study, trial, video or day; they are "
                       "told apart, as in 'x (S2)'"));
}

TEST(Sets, IndividualsOfOneStudyKeepTheirNames) {
  const Recording recording =
      recording_of(record(kMovebank + fix_of("00", "x", "S1") + fix_of("05", "x", "S1") +
                          fix_of("01", "y", "S2") + fix_of("06", "y", "S2")));
  EXPECT_EQ(ids_of(recording), (Ids{"x", "y"}));
  EXPECT_FALSE(has_note(recording, "told apart"));
}

TEST(Sets, FilesOfSeveralStudiesAreToldApart) {
  const TemporaryFolder folder;
  const Recording recording = recording_of(load_recording(
      {folder.write("1.csv", kMovebank + fix_of("00", "x", "S1") + fix_of("05", "x", "S1")),
       folder.write("2.csv", kMovebank + fix_of("01", "x", "S2") + fix_of("06", "x", "S2")),
       folder.write("3.csv", kMovebank + fix_of("10", "x", "S1"))}));
  EXPECT_EQ(ids_of(recording), (Ids{"x", "x (S2)"}));
  EXPECT_EQ(recording.bees[0].fixes.size(), 3u);
}

// A name may look as if it were one that was made.
TEST(Sets, NoNameIsGivenTwice) {
  const Recording recording = recording_of(
      record(kMovebank + fix_of("00", "x", "S1") + fix_of("00", "x", "S2") +
             fix_of("00", "x (S2)", "S1") + fix_of("00", "x", "") + fix_of("01", "x (S2)", "S1")));
  EXPECT_EQ(ids_of(recording), (Ids{"x", "x (S2)", "x (S2) (S1)", "x (none)"}));
  EXPECT_EQ(recording.bees[2].fixes.size(), 2u);
}

TEST(Sets, TrialsAndVideosOfOtherTablesAreToldApartToo) {
  const Recording recording =
      recording_of(record("trial,video,id,time_s,x_m,y_m\n1,a,0,0,0,0\n1,a,0,1,1,0\n1,b,0,2,9,0\n"
                          "2,a,0,3.5,5,0\n2,a,0,4.5,6,0\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"0", "0 (1, b)", "0 (2, a)"}));
  const Recording nameless =
      recording_of(record("arena,time_s,x_m,y_m\nleft,0,0,0\nright,0.5,5,0\nleft,1,1,0\n"));
  EXPECT_EQ(ids_of(nameless), (Ids{"bees", "bees (right)"}));
  EXPECT_EQ(nameless.bees[0].fixes.size(), 2u);
}

// Seconds that begin again with each day.
TEST(Sets, NumbersOfTimeOnSeveralDaysAreNotMixed) {
  const Recording recording =
      recording_of(record("date,id,time_s,x_m,y_m\n2015-09-10,a,0,0,0\n2015-09-10,a,10,1,0\n"
                          "2015-09-11,a,15,50,0\n2015-09-11,a,25,51,0\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "a (2015-09-11)"}));
  const Recording dated =
      recording_of(record("date,id,unix_time_s,x_m,y_m\n2015-09-10,a,1441868400,0,0\n"
                          "2015-09-11,a,1441954800,0,0\n"));
  EXPECT_EQ(ids_of(dated), Ids{"a"});
}

// Two trials, each from 0.
std::string trials(const std::string& column, char delimiter = ',') {
  std::string text =
      column + ",id,time_s,x_m,y_m\n1,a,0,0,0\n1,a,1,1,0\n2,a,0,0.5,0\n2,a,1,1.5,0\n";
  std::replace(text.begin(), text.end(), ',', delimiter);
  return text;
}

TEST(Trials, WhoseTimesBeginAgainAreNotCompared) {
  for (const std::string column :
       {"trial", "session", "replicate", "run", "rep", "Run ID", "video", "date", "episode"}) {
    expect_error(record(trials(column)),
                 {ErrorCode::kTimeOrder, "bees.csv:4",
                  "the times of '1' and '2', which column 1 '" + column +
                      "' tells apart, begin again or overlap: trials are not compared with each "
                      "other; read one at a time, as by awk -F',' 'NR <= 1 || $1 == \"2\"' FILE > "
                      "one.csv; if all have one clock, say so with --one-clock"});
  }
  expect_error(record(trials("trial", '\t')),
               {ErrorCode::kTimeOrder, "bees.csv:4", "as by awk -F'\\t' 'NR <= 1 || $1 == \"2\"'"});
  // What is no plain word is not for a shell.
  const auto quoted = record("trial,id,time_s,x_m,y_m\n1,a,0,0,0\n2\";x,a,0,1,0\n");
  ASSERT_FALSE(quoted);
  EXPECT_EQ(quoted.error().message.find("awk"), std::string::npos) << quoted.error().message;
  const TemporaryFolder folder;
  const std::string header = "trial,id,time_s,x_m,y_m\n";
  expect_error(load_recording({folder.write("1.csv", header + "1,a,1,0,0\n1,a,2,1,0\n"),
                               folder.write("2.csv", header + "2,b,1,5,0\n2,b,2,6,0\n")},
                              columns_are("")),
               {ErrorCode::kTimeOrder, folder.file("2.csv") + ":2", "begin again or overlap"});
}

TEST(Trials, ThatFollowEachOtherOrAreDatedAreOneRecording) {
  const std::string header = "session,id,time_s,x_m,y_m\n";
  EXPECT_TRUE(record(header + "1,a,0,0,0\n1,a,1,1,0\n2,a,1,0.5,0\n2,a,2,1.5,0\n"));
  // Side by side, by one clock.
  EXPECT_TRUE(record("arena,id,time_s,x_m,y_m\nl,a,0,0,0\nl,a,1,1,0\nr,a,0,0.5,0\nr,a,1,1,0\n"));
  // One animal, whatever the session of its logger.
  EXPECT_EQ(ids_of(recording_of(record("session,id,unix_time_s,x_m,y_m\n1,a,1700000000,0,0\n"
                                       "2,a,1700000001,1,0\n"))),
            Ids{"a"});
}

TEST(Trials, WhatTheMessageSaysWorks) {
  RecordingOptions options;
  options.one_clock = true;
  EXPECT_TRUE(record(trials("trial"), options));
  EXPECT_EQ(recording_of(record("trial,id,time_s,x_m,y_m\n2,a,0,0.5,0\n2,a,1,1.5,0\n")).bees.size(),
            1u);
}

// ---- Sides, cameras, arenas, and videos: scenes beside each other ---------------------------

std::string scenes(const std::string& column, const std::string& second = "B") {
  return "time_s,bee_id," + column + ",x_mm,y_mm\n0,100,A,50,50\n0,101," + second +
         ",51,50\n1,100,A,50,50\n1,101," + second + ",51,50\n";
}

TEST(Scenes, BesideEachOtherAreNotCompared) {
  for (const std::string column : {"side", "cam_id", "camera", "arena", "Camera ID"}) {
    expect_error(record(scenes(column)),
                 {ErrorCode::kUnknownFrame, "bees.csv:3",
                  "places here are of 'B', others at the same time of 'A', as column 3 '" + column +
                      "' tells, which may have an origin of its own: scenes are not compared with "
                      "each other; read one at a time, as by awk -F',' 'NR <= 1 || $3 == \"B\"' "
                      "FILE > one.csv; if all are counted from one origin, and bees can meet, say "
                      "so with --crs metres"});
    RecordingOptions options;
    options.frame = Frame::kMetres;
    EXPECT_TRUE(record(scenes(column), options)) << column;
    EXPECT_TRUE(record(scenes(column, "A"))) << column;
  }
}

// In pixels, too; a camera is not whose place it is.
TEST(Scenes, OfCamerasInPixelsAreNotCompared) {
  const std::string table =
      "bee_id,timestamp,cam_id,x_pos,y_pos\n100,1690000000.5,0,250,250\n"
      "101,1690000000.5,1,251,250\n100,1690000001.5,0,250,250\n";
  RecordingOptions options;
  options.pixel = StatedLength{1e-4, 0.1, Unit::kMillimetre};
  expect_error(record(table, options), {ErrorCode::kUnknownFrame, "bees.csv:3", "as column 3"});
}

// Positions in metres and degrees are of one frame; one scene behind the other does not meet it.
TEST(Scenes, OfOneFrameOrOneAfterTheOtherAreOneRecording) {
  EXPECT_TRUE(record("time_s,id,side,x_m,y_m\n0,a,home,1,2\n0,b,away,3,4\n"));
  EXPECT_TRUE(record("time_s,id,camera,lon,lat\n0,a,1,9,47\n0,b,2,9.1,47\n"));
  EXPECT_TRUE(record("time_s,id,camera,x_mm,y_mm\n0,a,1,1,2\n1,a,1,1,2\n2,a,2,3,4\n3,a,2,3,4\n"));
}

RecordingOptions pictures() {
  RecordingOptions options;
  options.frames_per_second = 25.0;
  return options;
}

TEST(Videos, WhoseFramesBothBeginAreNotCompared) {
  const TemporaryFolder folder;
  const std::string header = "frame,bee_id,x_mm,y_mm\n";
  const std::vector<std::string> files = {
      folder.write("day1.csv", header + "0,101,50,50\n1,101,50,50\n"),
      folder.write("day2.csv", header + "1,102,51,50\n2,102,51,50\n")};
  // Those that overlap, wherever they begin.
  const std::vector<std::string> later = {
      files[0], folder.write("later.csv", header + "0,103,51,50\n9,103,51,50\n")};
  expect_error(load_recording(later, pictures()),
               {ErrorCode::kInvalidArgument, later[1],
                "frames here and in " + later[0] +
                    " may be counted from the beginning of a video each: then they cannot be "
                    "compared; read the files each for itself, or, if all are of one video, say so "
                    "with --one-clock"});
  RecordingOptions options = pictures();
  options.one_clock = true;
  EXPECT_EQ(recording_of(load_recording(later, options)).bees.size(), 2u);
  // One goes on where the other has ended.
  EXPECT_TRUE(load_recording(files, pictures()));
  // Animations have heights, and one clock.
  EXPECT_TRUE(load_recording({folder.write("d1.csv", "frame,x_m,y_m,z_m\n0,1,2,3\n9,1,2,4\n"),
                              folder.write("d2.csv", "frame,x_m,y_m,z_m\n0,5,2,3\n9,5,2,4\n")},
                             pictures()));
}

// A table an animal, named after the video.
TEST(Videos, OfTRexAreToldApartByTheNamesOfTheirFiles) {
  const TemporaryFolder folder;
  const auto animal = [&](const std::string& name, const std::string& x) {
    return folder.write(name, "frame,missing,time,X#wcentroid (cm),Y#wcentroid (cm)\n0,0,0," + x +
                                  ",2\n1,0,0.04," + x + ",2\n");
  };
  const std::string one = animal("guppies_fish0.csv", "1");
  const std::string other = animal("guppies_fish1.csv", "1.5");
  const std::string elsewhere = animal("mollies_fish1.csv", "1.5");
  EXPECT_EQ(recording_of(load_recording({one, other}, {})).bees.size(), 2u);
  expect_error(load_recording({one, elsewhere}, {}),
               {ErrorCode::kInvalidArgument, folder.file("mollies"),
                "may be counted from the beginning of a video each"});
  RecordingOptions options;
  options.one_clock = true;
  EXPECT_EQ(recording_of(load_recording({one, elsewhere}, options)).bees.size(), 2u);
}

// As ToxTrac numbers animals within an arena.
TEST(Tracks, ThatNumberAnimalsAreIds) {
  const std::string header = "time_s,arena,track,x_mm,y_mm\n";
  const Recording recording =
      recording_of(record(header + "0,1,1,50,50\n0,1,2,50.5,50\n1,1,1,50,50\n1,1,2,50.5,50\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"1", "2"}));
  EXPECT_TRUE(has_note(recording, "ids are read from column 3 'track'"));
  expect_error(record(header + "0,1,1,50,50\n0,1,2,50.5,50\n0,2,1,50,50\n1,2,1,50,50\n1,1,1,5,5\n"),
               {ErrorCode::kUnknownFrame, "bees.csv:4", "as column 2 'arena' tells"});
  // A direction beside a speed is none.
  const Recording vehicle =
      recording_of(record("time_s,x_m,y_m,groundspeed_mps,track\n0,1,2,1,90\n1,2,2,1,90\n"));
  EXPECT_EQ(ids_of(vehicle), Ids{"bees"});
}

// As R and the interface of Movebank for programs write them.
TEST(Sets, IdsOfMovebankHaveOtherNames) {
  for (const std::string header : {"id,location.long,location.lat,timestamp",
                                   "individual_id,location_long,location_lat,timestamp",
                                   "ID,location-long,location-lat,timestamp"}) {
    const Recording recording =
        recording_of(record(header + "\nAnna,8.95,47.75,2023-08-15 06:00:00\n"
                                     "Bert,8.96,47.75,2023-08-15 06:00:00\n"));
    EXPECT_EQ(ids_of(recording), (Ids{"Anna", "Bert"})) << header;
  }
}

// ---- Marks of the owner, and tags -----------------------------------------------------------

std::string tagged(const std::string& tags, const std::string& marks = ",,") {
  std::string text =
      "timestamp,location-long,location-lat,tag-local-identifier,individual-local-identifier,"
      "algorithm-marked-outlier,manually-marked-outlier,manually-marked-valid\n";
  for (std::size_t i = 0; i < tags.size(); ++i) {
    text += "2015-09-10 07:1" + std::to_string(i) + ":00.000,9.17,47.7," + tags[i] + ",x," +
            (i == 1 ? marks : ",,") + "\n";
  }
  return text;
}

TEST(Outliers, ThatTheOwnerHasMarkedAreNoPlaces) {
  for (const std::string marks : {"true,,", ",TRUE,", "true,true,false"}) {
    const Recording recording = recording_of(record(tagged("aaa", marks)));
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u) << marks;
    EXPECT_TRUE(has_note(recording, "1 record marked as outliers")) << marks;
  }
  for (const std::string marks : {"false,,", "true,,true", ",,"}) {
    EXPECT_EQ(recording_of(record(tagged("aaa", marks))).bees[0].fixes.size(), 3u) << marks;
  }
}

TEST(Tags, TwoAtOnceOnOneAnimalAreAskedAbout) {
  expect_error(
      record(tagged("abab")),
      {ErrorCode::kMissingColumn, "bees.csv:3",
       "bee 'x' has two tags at once, 'a' and 'b' (column 4 'tag-local-identifier'), whose "
       "places would be mixed; of two on one animal leave the records of one out; to take "
       "each tag for one, say --columns id=4, or to mix them all the same, --columns id=5"});
  EXPECT_EQ(ids_of(recording_of(record(tagged("abab"), columns_are("id=4", Unit::kUnstated)))),
            (Ids{"a", "b"}));
  EXPECT_EQ(ids_of(recording_of(record(tagged("abab"), columns_are("id=5", Unit::kUnstated)))),
            Ids{"x"});
  // One after the other.
  EXPECT_EQ(ids_of(recording_of(record(tagged("aabb")))), Ids{"x"});
}

// An outlier is no place: who has no other is known nowhere.
TEST(Sets, AnAnimalOfOutliersOnlyIsKnownNowhere) {
  const Recording recording =
      recording_of(record(kMovebank + fix_of("00", "a", "S1", "9.17", "FALSE") +
                          fix_of("05", "a", "S1", "9.17", "FALSE") + fix_of("00", "b", "S1") +
                          fix_of("05", "b", "S1", "9.17", "false") + fix_of("06", "b", "S1")));
  EXPECT_EQ(ids_of(recording), Ids{"b"});
  EXPECT_TRUE(has_note(
      recording,
      "3 records marked as outliers (visible=false, ...-marked-outlier=true) are left out"));
  EXPECT_EQ(recording.missing.count, 1u);
  EXPECT_EQ(recording.missing.nowhere_ids, Ids{"a"});
}

}  // namespace
}  // namespace beespace::io
