#include "io/recording/names_apart.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <string>
#include <unordered_map>
#include <vector>

namespace beespace::io {
namespace {

using Ids = std::vector<std::string>;
using Times = std::vector<double>;
using Fixes = std::vector<Fix>;

constexpr std::string_view kTwoBees = "id,time_s,x,y,z\na,0,1,2,3\nb,0,4,5,6\n";
constexpr std::string_view kOneBee = "time_s,x,y,z\n1,1,2,3\n2,1,2,4\n";

void write_table(const TemporaryFolder& folder, std::string_view name, std::string_view text) {
  EXPECT_FALSE(folder.write(name, text).empty());
}

void write_gzip(const std::string& path, std::string_view text) {
  gzFile file = gzopen(path.c_str(), "wb");
  ASSERT_NE(file, nullptr);
  EXPECT_EQ(gzwrite(file, text.data(), static_cast<unsigned>(text.size())),
            static_cast<int>(text.size()));
  gzclose(file);
}

TEST(RecordingFiles, BeesOfTheSameIdInSeveralFilesAreOneBee) {
  const TemporaryFolder folder;
  const auto recording = recording_of(
      load_recording({folder.write("late.csv", "id,time_s,x,y,z\na,1,7,8,9\nc,1,1,1,1\n"),
                      folder.write("early.csv", kTwoBees)}));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "c", "b"}));
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{0, {1, 2, 3}}, {1, {7, 8, 9}}}));
  EXPECT_TRUE(has_note(recording, "1 bee is in several files under the same id"));
  EXPECT_FALSE(has_note(recording, "back in time"));
}

TEST(RecordingFiles, FilesOfTheSameNameAreSeveralBees) {
  const TemporaryFolder folder;
  for (const char* const name : {"d1", "d2"}) {
    std::filesystem::create_directory(folder.file(name));
  }
  const std::string first = folder.write("d1/pose.csv", kOneBee);
  const std::string second = folder.write("d2/pose.csv", "time_s,x,y,z\n1,9,2,3\n2,9,2,4\n");
  const auto recording = recording_of(load_recording({first, second, second}));
  EXPECT_EQ(ids_of(recording), (Ids{"d1", "d2", second}));
  const std::string json = R"([{"time_s": 1, "x": 1, "y": 2, "z": 3}])";
  const std::string third = folder.write("d1/pose.json", json);
  EXPECT_EQ(ids_of(recording_of(load_recording({first, third}))), (Ids{"pose.csv", "pose.json"}));
}

// Of two folders with several files each, the folder alone names none of them.
TEST(RecordingFiles, FoldersOfTheSameNamesSayFolderAndName) {
  EXPECT_EQ(names_apart({"two/draft/1.csv", "two/draft/2.csv", "two/final/1.csv", "two/final/2.csv",
                         "two/final/3.csv"}),
            (std::unordered_map<std::string, std::string>{{"two/draft/1.csv", "draft/1"},
                                                          {"two/draft/2.csv", "draft/2"},
                                                          {"two/final/1.csv", "final/1"},
                                                          {"two/final/2.csv", "final/2"},
                                                          {"two/final/3.csv", "final/3"}}));
  // A second log of one drone, which was restarted: it is not a name beside those of the others.
  EXPECT_EQ(
      names_apart({"one/log/20_00_00.ulg", "two/log/20_00_00.ulg", "two/log/20_00_28.ulg"}),
      (std::unordered_map<std::string, std::string>{{"one/log/20_00_00.ulg", "one"},
                                                    {"two/log/20_00_00.ulg", "two/20_00_00"},
                                                    {"two/log/20_00_28.ulg", "two/20_00_28"}}));
  EXPECT_EQ(names_apart({"one/log.csv", "two/log.csv"}),
            (std::unordered_map<std::string, std::string>{{"one/log.csv", "one"},
                                                          {"two/log.csv", "two"}}));
}

TEST(RecordingFiles, TablesOfTheSameNameInAnArchiveAreSeveralBees) {
  const std::string bee(kOneBee);
  const auto recording = recording_of(
      load_recording_from_memory(zipped({{"a/1.csv", bee}, {"b/1.csv", bee}}), "show.zip", {}));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "b"}));
  std::string twice = zipped({{"1.csv", bee}, {"2.csv", bee}});
  for (std::size_t at = 0; (at = twice.find("2.csv", at)) != std::string::npos;) twice[at] = '1';
  expect_error(load_recording_from_memory(twice, "show.zip", {}),
               {ErrorCode::kUnsupportedFormat, "show.zip", "holds several files named '1.csv'"});
}

TEST(RecordingFiles, TablesInAnArchiveAreReadAsThoseBesideIt) {
  const std::string commas = "Time [msec];x [m];y [m];z [m]\n0;0,5;1,25;3,0\n1000;0,5;1,5;3,0\n";
  const std::string wide = "time,x1,y1,x2,y2\n0,1,2,3,4\n1,1,2,3,4\n";
  for (const std::string& table : {commas, wide}) {
    RecordingOptions options;
    options.pixel =
        table == wide ? std::optional(StatedLength{1.0, 1.0, Unit::kMetre}) : std::nullopt;
    const auto alone = recording_of(load_recording_from_memory(table, "1.csv", options));
    const auto packed =
        recording_of(load_recording_from_memory(zipped({{"1.csv", table}}), "show.zip", options));
    EXPECT_EQ(ids_of(packed), ids_of(alone));
    EXPECT_EQ(packed.bees[0].fixes, alone.bees[0].fixes);
  }
}

TEST(RecordingFiles, VelocitiesThatOneFileHasAreUnknownInTheOther) {
  const TemporaryFolder folder;
  const auto recording = recording_of(
      load_recording({folder.write("1.csv", kTwoBees),
                      folder.write("2.csv", "id,time_s,x,y,z,vx,vy,vz\na,1,7,8,9,1,2,3\n")}));
  ASSERT_EQ(recording.bees[0].velocities.size(), 2u);
  EXPECT_NE(recording.bees[0].velocities[0].x, recording.bees[0].velocities[0].x);
  EXPECT_EQ(recording.bees[0].velocities[1], (Velocity{1, 2, 3}));
  EXPECT_TRUE(recording.bees[1].velocities.empty());
}

TEST(RecordingFiles, AConflictBetweenFilesIsBlamedOnTheSecond) {
  const TemporaryFolder folder;
  const std::string first = folder.write("1.csv", kTwoBees);
  const std::string second = folder.write("2.csv", "id,time_s,x,y,z\nc,0,0,0,0\nb,0,9,9,9\n");
  expect_error(load_recording({first, second}, on_one_clock()),
               {ErrorCode::kTimeOrder, second + ":3", "in " + first + ", line 3"});
}

TEST(RecordingFiles, FilesMustAgreeOnTheFrame) {
  const TemporaryFolder folder;
  const std::string metres = folder.write("1.csv", kTwoBees);
  const std::string degrees = folder.write("2.csv", "id,time_s,lon,lat,alt\nc,0,1,2,3\n");
  expect_error(load_recording({metres, degrees}),
               {ErrorCode::kUnknownFrame, degrees,
                "this is in degrees, but " + metres + " is in metres; read them apart"});
}

TEST(RecordingFiles, FilesMustAgreeOnWhatTimesAre) {
  const TemporaryFolder folder;
  const std::string seconds = folder.write("1.csv", kTwoBees);
  const std::string dates = folder.write("2.csv", "id,time,x,y,z\nc,2024-05-01T12:00:00Z,1,2,3\n");
  const std::string snapshot = folder.write("3.csv", "id,x,y,z,vx,vy,vz\nd,1,2,3,4,5,6\n");
  expect_error(load_recording({seconds, dates}),
               {ErrorCode::kInvalidArgument, dates, "times here are counted from 1970"});
  expect_error(
      load_recording({dates, seconds}),
      {ErrorCode::kInvalidArgument, seconds, "times here are counted from a zero of their own"});
  expect_error(load_recording({seconds, snapshot}),
               {ErrorCode::kMissingColumn, snapshot, "there is no time here, but one in"});
}

TEST(RecordingFiles, WhatOfAnArchiveIsNotReadIsSaid) {
  const Recording recording =
      recording_of(load_recording_from_memory(zipped({{"1.csv", std::string(kTwoBees)},
                                                      {"more/b.json", "{}"},
                                                      {"__MACOSX/._1.csv", "x"},
                                                      {"read.me", "x"}}),
                                              "bees.zip"));
  EXPECT_TRUE(has_note(recording,
                       "of bees.zip, an archive, the tables are read: 'more/b.json' and 1 more are "
                       "left out"));
  const Recording all = recording_of(
      load_recording_from_memory(zipped({{"1.csv", std::string(kTwoBees)}}), "bees.zip"));
  EXPECT_FALSE(has_note(all, "left out"));
}

TEST(RecordingFiles, AHeightThatOneFileLacksIsNotZero) {
  const TemporaryFolder folder;
  const std::string space = folder.write("1.csv", kTwoBees);
  const std::string plane = folder.write("2.csv", "id,time_s,x,y\nc,0,1,2\n");
  expect_error(load_recording({space, plane}),
               {ErrorCode::kMissingColumn, plane, "there are no heights here, but in " + space});
  expect_error(load_recording({plane, space}),
               {ErrorCode::kMissingColumn, space, "heights here, but none in " + plane});
  RecordingOptions in_a_plane = columns_are("id=id,time=time_s,x=x,y=y");
  in_a_plane.one_clock = true;
  EXPECT_TRUE(load_recording({space, plane}, in_a_plane));
  const std::string high = folder.write("3.csv", "id,time_s,lon,lat,height\na,0,9,47,500\n");
  const std::string ground = folder.write("4.csv", "id,time_s,lon,lat\nb,0,9,47\n");
  expect_error(load_recording({high, ground}), {ErrorCode::kMissingColumn, ground, "no heights"});
  const std::string packed =
      zipped({{"1.csv", std::string(kTwoBees)}, {"2.csv", "id,time_s,x,y\nc,0,1,2\n"}});
  expect_error(load_recording_from_memory(packed, "bees.zip"),
               {ErrorCode::kMissingColumn, "bees.zip!2.csv", "there are no heights here, but in"});
}

TEST(RecordingFiles, HeightsThatAreEmptyThroughoutOneFileAreNotZero) {
  const TemporaryFolder folder;
  const std::string header =
      "event-id,visible,timestamp,location-long,location-lat,height-above-ellipsoid,"
      "tag-local-identifier,individual-local-identifier\n";
  const std::string high =
      folder.write("1.csv", header + "1,true,2015-09-10 07:00:00.000,9.17,47.7,420,1,a\n");
  const std::string none =
      folder.write("2.csv", header + "2,true,2015-09-10 07:00:00.000,9.17,47.7,,2,b\n");
  expect_error(load_recording({high, none}),
               {ErrorCode::kMissingColumn, none, "there are no heights here, but in " + high});
}

TEST(RecordingFiles, AFolderIsReadByTheNamesOfItsTables) {
  const TemporaryFolder folder;
  write_table(folder, "bee 2.csv", kOneBee);
  write_table(folder, "bee 1.TXT", kOneBee);
  write_gzip(folder.file("bee 3.csv.gz"), kOneBee);
  write_table(folder, "README.md", "no table");
  write_table(folder, ".hidden.csv", "no table");
  std::filesystem::create_directory(folder.file("folder.csv"));
  const auto recording = recording_of(load_recording({folder.file("")}));
  EXPECT_EQ(ids_of(recording), (Ids{"bee 1", "bee 2", "bee 3"}));
  EXPECT_EQ(times_of(recording.bees[2]), (Times{1, 2}));
  EXPECT_TRUE(has_note(recording, "/.hidden.csv is left out; name them, too"));
}

TEST(RecordingFiles, AFolderWithoutTablesIsAnError) {
  const TemporaryFolder folder;
  write_table(folder, "README.md", "no table");
  const std::string name = folder.file("");
  expect_error(load_recording({name}),
               {ErrorCode::kNoPoints, name, "there is no .csv, .tsv or .txt file in this folder"});
}

TEST(RecordingFiles, MissingAndUnreadableFiles) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("no.csv");
  expect_error(load_recording({missing}), {ErrorCode::kCannotOpen, missing, "no such file"});
  EXPECT_EQ(load_recording({}).error().code, ErrorCode::kInvalidArgument);
  if (::geteuid() == 0) GTEST_SKIP() << "everything is readable to root";
  const std::string locked = folder.write("locked.csv", kTwoBees);
  ASSERT_EQ(::chmod(locked.c_str(), 0), 0);
  expect_error(load_recording({locked}), {ErrorCode::kCannotOpen, locked, "not allowed"});
}

TEST(RecordingFiles, TruncatedGzipIsAnError) {
  const TemporaryFolder folder;
  std::string text = "id,time_s,x,y,z\n";
  for (int i = 0; i < 1000; ++i) text += "a," + std::to_string(i * i) + ",1,2,3\n";
  write_gzip(folder.file("bees.csv.gz"), text);
  std::string packed = content_of(folder.file("bees.csv.gz"));
  packed.resize(packed.size() / 2);
  const std::string half = folder.write("half.csv.gz", packed);
  expect_error(load_recording({half}), {ErrorCode::kTruncated, half, "the gzip data ends too"});
}

TEST(RecordingFiles, AZipOfTablesIsReadByTheirNames) {
  const auto recording =
      recording_of(load_recording_from_memory(zipped({{"show/bee 2.csv", std::string(kOneBee)},
                                                      {"show/bee 1.csv", std::string(kOneBee)},
                                                      {"show/.bee 0.csv", "no table"},
                                                      {"__MACOSX/bee 3.csv", "no table"},
                                                      {"show/notes.md", "no table"}}),
                                              "bees.zip"));
  EXPECT_EQ(ids_of(recording), (Ids{"bee 1", "bee 2"}));
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{1, {1, 2, 3}}, {2, {1, 2, 4}}}));
}

TEST(RecordingFiles, SkybrushTablesWithAHeaderAreReadByIt) {
  const auto recording = recording_of(load_recording_from_memory(
      zipped({{"1.csv", "Time [msec],x [m],y [m],z [m],Red,Green,Blue\n500,1,2,3,255,0,0\n"},
              {"2.csv", "Time_msec,x_m,y_m,z_m\n1500,1,2,3\n"}}),
      "show.zip"));
  EXPECT_EQ(times_of(recording.bees[0]), Times{0.5});
  EXPECT_EQ(times_of(recording.bees[1]), Times{1.5});
}

TEST(RecordingFiles, SkybrushTablesWithoutAHeaderAreReported) {
  const std::string zip = zipped({{"1.csv", "0,1,2,3,255,0,0\n500,1,2,4,255,0,0\n"}});
  const auto recording = recording_of(load_recording_from_memory(zip, "show.zip"));
  EXPECT_EQ(recording.bees[0].fixes, (Fixes{{0, {1, 2, 3}}, {0.5, {1, 2, 4}}}));
  EXPECT_EQ(recording.frame, Frame::kMetres);
  EXPECT_TRUE(has_note(
      recording, "taken for a Skybrush CSV: t in milliseconds, then x, y, z in metres and a"));
  RecordingOptions table;
  table.format = RecordingFormat::kTable;
  expect_error(load_recording_from_memory(zip, "show.zip", table),
               {ErrorCode::kMissingColumn, "show.zip!1.csv:1", "there is no header"});
}

TEST(RecordingFiles, SkybrushTablesOutsideOfAZipMustBeNamed) {
  const TemporaryFolder folder;
  const std::string table = folder.write("1.csv", "0,1,2,3\n500,1,2,4\n");
  expect_error(load_recording({folder.file("")}),
               {ErrorCode::kMissingColumn, table + ":1", "there is no header"});
  RecordingOptions options;
  options.format = RecordingFormat::kSkybrushCsv;
  const auto recording = recording_of(load_recording({folder.file("")}, options));
  EXPECT_EQ(times_of(recording.bees[0]), (Times{0, 0.5}));
  expect_error(record("0,1,2\n", options),
               {ErrorCode::kMissingColumn, "bees.csv:1", "a Skybrush CSV has the columns"});
}

TEST(RecordingFiles, SkybrushTablesOutsideOfAZipAreKnownByTheirColours) {
  const auto shown = recording_of(record("0,1,2,3,255,0,0\n500,1,2,4,255,0,9\n"));
  EXPECT_EQ(times_of(shown.bees[0]), (Times{0, 0.5}));
  EXPECT_TRUE(shown.show.has_value());
  for (const char* const other :
       {"0,1,2,3,256,0,0\n500,1,2,4,255,0,9\n", "0,1,2,3,0.5,0,0\n500,1,2,4,0.5,0,9\n",
        "500,1,2,3,255,0,0\n0,1,2,4,255,0,9\n", "0.5,1,2,3,255,0,0\n1,1,2,4,255,0,9\n"}) {
    expect_error(record(other), {ErrorCode::kMissingColumn, "bees.csv:1", "there is no header"});
  }
}

// No picture and no millisecond is a part of one.
TEST(RecordingFiles, PathsWithColoursWhoseTimesAreNotWholeAreInSeconds) {
  const std::string rows = "0.00,1,2,3,255,0,0\n0.25,1,2,4,255,0,9\n0.50,1,2,5,255,0,9\n";
  const auto shown = recording_of(record(rows));
  EXPECT_EQ(times_of(shown.bees[0]), (Times{0, 0.25, 0.5}));
  EXPECT_TRUE(shown.show.has_value());
  const auto fine = recording_of(record("0.000,1,2,3,255,0,0\n41.667,1,2,3,255,0,9\n"));
  EXPECT_EQ(times_of(fine.bees[0]), (Times{0, 0.041667}));
}

// Of an animation there may be a row for every fifth or tenth picture, or for one a second.
TEST(RecordingFiles, PicturesInStepsAreNoMilliseconds) {
  for (const char* const step : {"1", "5", "10", "24", "25", "30", "60"}) {
    const std::string rows = std::string("0,1,2,3,255,0,0\n") + step + ",1,2,4,255,0,0\n";
    expect_error(record(rows), {ErrorCode::kInvalidArgument, "bees.csv:1:1",
                                "may count pictures, seconds or milliseconds; say --fps 24"});
    RecordingOptions pictures;
    pictures.frames_per_second = 5.0;
    EXPECT_EQ(times_of(recording_of(record(rows, pictures)).bees[0]),
              (Times{0.0, std::stod(step) / 5.0}));
  }
  for (const char* const step : {"20", "40", "50", "100", "250", "1000"}) {
    const std::string rows = std::string("0,1,2,3,255,0,0\n") + step + ",1,2,3,255,0,0\n";
    EXPECT_EQ(times_of(recording_of(record(rows)).bees[0])[1], std::stod(step) / 1000.0);
  }
}

TEST(RecordingFiles, WhatIsWrongInAZipIsBlamedOnItsPart) {
  expect_error(load_recording_from_memory(
                   zipped({{"1.csv", std::string(kOneBee)}, {"2.csv", "time_s,x,y,z\n0,1,?,3\n"}}),
                   "bees.zip"),
               {ErrorCode::kNotANumber, "bees.zip!2.csv:2:3", "'?' is not a number (y)"});
}

TEST(RecordingFiles, AZipOfTracesIsToBeUnpacked) {
  expect_error(
      load_recording_from_memory(zipped({{"traces/01/trace_full_4d0101.json", "{}"}}), "day.zip"),
      {ErrorCode::kUnsupportedFormat, "day.zip", "; unpack it and name the folder"});
}

TEST(RecordingFiles, AZipOfSomethingElseIsRefused) {
  expect_error(load_recording_from_memory(zipped({{"word/document.xml", "<x/>"}}), "bees.zip"),
               {ErrorCode::kUnsupportedFormat, "bees.zip",
                "holds neither a show.json nor any .csv, .tlog, .ulg or .bin file, but "
                "'word/document.xml'"});
  expect_error(load_recording_from_memory(
                   std::string_view("PK\x05\x06\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 22), "e.zip"),
               {ErrorCode::kUnsupportedFormat, "e.zip", "but nothing"});
}

// ---- Tables that were joined one behind the other -----------------------------------------------

constexpr std::string_view kJoinedHeader = "id,time_s,x_m,y_m,z_m\n";

std::string joined(const std::string& first, const std::string& second) {
  return std::string(kJoinedHeader) + first + std::string(kJoinedHeader) + second;
}

TEST(JoinedTables, TheHeaderThatComesAgainIsPassedOverAndThatIsSaid) {
  const std::string text = joined("a,1,1,2,3\na,2,1,2,3\n", "b,1,4,5,6\n\nb,2,4,5,6\n");
  const Recording recording = recording_of(record(text));
  EXPECT_EQ(ids_of(recording), (std::vector<std::string>{"a", "b"}));
  EXPECT_TRUE(recording.missing.none());
  EXPECT_TRUE(
      has_note(recording, "the header comes again in bees.csv, as where tables were joined"));
  // Of Excel, behind a byte-order mark each; and with ends of lines of Windows.
  EXPECT_EQ(recording_of(record("id,time_s,x_m,y_m,z_m\r\na,1,1,2,3\r\n\xEF\xBB\xBF"
                                "id,time_s,x_m,y_m,z_m\r\nb,1,4,5,6\r\n"))
                .bees.size(),
            2u);
}

TEST(JoinedTables, OtherColumnsAreRefusedWhateverIsLeftOut) {
  const std::string text = std::string(kJoinedHeader) +
                           "a,1,1,2,3\nid,time_s,y_m,x_m,z_m\n"
                           "b,1,4,5,6\n";
  for (const RecordingOptions& options : {RecordingOptions(), skipping_bad()}) {
    expect_error(record(text, options), {ErrorCode::kMalformedRecord, "bees.csv:3",
                                         "another header, 'id,time_s,y_m,x_m,z_m', than "
                                         "'id,time_s,x_m,y_m,z_m' before: read tables of "});
  }
}

TEST(JoinedTables, WhatIsAskedOfEachForItselfIsAskedOfThemTogether) {
  expect_error(record(joined("a,0,1,2,3\na,1,1,2,3\n", "b,0,4,5,6\n")),
               {ErrorCode::kInvalidArgument, "bees.csv:5:2",
                "times begin at 0 again, which may be another moment, as of another trial: then "
                "they cannot be compared; read the tables each for itself, or, if all have one "
                "clock, say so with --one-clock"});
  EXPECT_TRUE(record(joined("a,0,1,2,3\n", "b,0,4,5,6\n"), on_one_clock()));
  EXPECT_TRUE(record(joined("a,0,1,2,3\n", "a,1,4,5,6\n")));
  expect_error(record("time_s,x_m,y_m,z_m\n1,1,2,3\n2,1,2,3\ntime_s,x_m,y_m,z_m\n3,4,5,6\n"),
               {ErrorCode::kMissingColumn, "bees.csv:5", "no column says whose records they are"});
}

}  // namespace
}  // namespace beespace::io
