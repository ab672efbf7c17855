// Bees of one name in several studies, trials, videos or days are several bees.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

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
      recording_of(record("trial,video,id,time_s,x_m,y_m\n1,a,0,0,0,0\n1,a,0,1,1,0\n1,b,0,0,9,0\n"
                          "2,a,0,0.5,5,0\n2,a,0,1.5,6,0\n"));
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
                          "2015-09-11,a,5,50,0\n2015-09-11,a,15,51,0\n"));
  EXPECT_EQ(ids_of(recording), (Ids{"a", "a (2015-09-11)"}));
  const Recording dated =
      recording_of(record("date,id,unix_time_s,x_m,y_m\n2015-09-10,a,1441868400,0,0\n"
                          "2015-09-11,a,1441954800,0,0\n"));
  EXPECT_EQ(ids_of(dated), Ids{"a"});
}

// An outlier is no place: who has no other is known nowhere.
TEST(Sets, AnAnimalOfOutliersOnlyIsKnownNowhere) {
  const Recording recording =
      recording_of(record(kMovebank + fix_of("00", "a", "S1", "9.17", "FALSE") +
                          fix_of("05", "a", "S1", "9.17", "FALSE") + fix_of("00", "b", "S1") +
                          fix_of("05", "b", "S1", "9.17", "false") + fix_of("06", "b", "S1")));
  EXPECT_EQ(ids_of(recording), Ids{"b"});
  EXPECT_TRUE(has_note(recording, "3 records with visible=false (outliers) are left out"));
  EXPECT_EQ(recording.missing.count, 1u);
  EXPECT_EQ(recording.missing.nowhere_ids, Ids{"a"});
}

}  // namespace
}  // namespace beespace::io
