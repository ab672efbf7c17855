// Columns that are called an id and are none: numbers of records, and what is common to several.
#include "tests/io/tracks/recording_loading.hpp"

#include <string>

namespace beespace::io {
namespace {

const std::string kRows =
    "id,animals_id,species,time_s,x_m,y_m\n1,a,ibex,0,0,0\n2,a,ibex,1,1,0\n3,b,ibex,0,9,0\n"
    "4,b,ibex,1,8,0\n";

RecordingOptions id_is(std::string column) {
  RecordingOptions options;
  options.columns = "id=" + std::move(column);
  return options;
}

TEST(RecordNumbers, AreNoIdsAndTheColumnsThatMayBeAreNamed) {
  expect_error(record(kRows),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "which column is the id? By column 1 'id' each of the 4 records, which are of "
                "several times, is of another bee, as if it numbered the records; say --columns "
                "id=2 for 'animals_id' or --columns id=3 for 'species'; if each is of another bee "
                "after all, say --columns id=1"});
  EXPECT_EQ(ids_of(recording_of(record(kRows, id_is("2")))), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(recording_of(record(kRows, id_is("1"))).bees.size(), 4u);
}

TEST(RecordNumbers, OfOneBeeAreTakenOut) {
  expect_error(record("id,time_s,x_m,y_m\n1,0,0,0\n2,1,1,0\n3,2,2,0\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "if all are of one bee, or the bees are told by the names of files, take that "
                "column out"});
}

TEST(RecordNumbers, OfOneTimeOrOfTwoRecordsAreIds) {
  EXPECT_EQ(recording_of(record("id,time_s,x_m,y_m\na,0,0,0\nb,0,1,0\nc,0,2,0\n")).bees.size(), 3u);
  EXPECT_EQ(recording_of(record("id,time_s,x_m,y_m\na,0,0,0\nb,1,1,0\n")).bees.size(), 2u);
}

// Heard once each, with a velocity that brings them to one time; addresses number nothing.
TEST(RecordNumbers, ALookAtBeesIsNone) {
  const std::string rows = "a,0,0,0,1,0\nb,1,9,0,1,0\nc,2,19,0,1,0\n";
  EXPECT_EQ(recording_of(record("id,time_s,x_m,y_m,vx_mps,vy_mps\n" + rows)).bees.size(), 3u);
  EXPECT_EQ(
      recording_of(record("icao24,time_s,lon,lat\na,0,8,47\nb,1,8.1,47\nc,2,8.2,47\n")).bees.size(),
      3u);
}

TEST(RecordNumbers, AsJsonToo) {
  expect_error(record("[{\"id\":1,\"ring\":\"a\",\"time_s\":0,\"x_m\":0,\"y_m\":0},"
                      "{\"id\":2,\"ring\":\"a\",\"time_s\":1,\"x_m\":1,\"y_m\":0},"
                      "{\"id\":3,\"ring\":\"b\",\"time_s\":0,\"x_m\":5,\"y_m\":0},"
                      "{\"id\":4,\"ring\":\"b\",\"time_s\":1,\"x_m\":4,\"y_m\":0}]"),
               {ErrorCode::kMissingColumn, "bees.csv", "say --columns id=2 for 'ring'"});
}

// Names are of kinds and of devices, ids of one each.
TEST(Ids, AreTakenBeforeNames) {
  const auto read = recording_of(
      record("Device Name,Device ID,time_s,x_m,y_m\nFox,1,0,0,0\nFox,2,0,9,0\nFox,1,1,1,0\n"
             "Fox,2,1,8,0\n"));
  EXPECT_EQ(ids_of(read), (std::vector<std::string>{"1", "2"}));
}

// Ten of each, 100 m apart, in turn; by `id` one herd.
std::string herd(const std::string& second) {
  std::string rows = "id," + second + ",time_s,x_m,y_m\n";
  for (int i = 0; i < 20; ++i) {
    rows += "herd," + std::string(i % 2 == 0 ? "t1," : "t2,") + std::to_string(i) + "," +
            std::to_string(i % 2 * 100 + i) + ",0\n";
  }
  return rows;
}

TEST(Ids, ThatAreCommonToSeveralInTurnAreAskedAbout) {
  expect_error(record(herd("tag")),
               {ErrorCode::kMissingColumn, "bees.csv:1",
                "which column is the id? By column 1 'id' there is one bee, which goes to and fro "
                "between what column 2 'tag' tells apart ('t1', 't2'); say --columns id=2, or, if "
                "the first is right, --columns id=1"});
  EXPECT_EQ(recording_of(record(herd("tag"), id_is("1"))).bees.size(), 1u);
  EXPECT_EQ(recording_of(record(herd("tag"), id_is("2"))).bees.size(), 2u);
}

// What it does is no bee: it goes on from where it was.
TEST(Ids, WithALabelOfWhatABeeDoesStay) {
  std::string rows = "id,label,time_s,x_m,y_m\n";
  for (int i = 0; i < 20; ++i) {
    rows += std::string("a,") + (i / 3 % 2 == 0 ? "rests," : "flies,") + std::to_string(i) + "," +
            std::to_string(i) + ",0\n";
  }
  EXPECT_EQ(ids_of(recording_of(record(rows))), (std::vector<std::string>{"a"}));
}

}  // namespace
}  // namespace beespace::io
