// Points that C reads from files: positions, ids, rows, and what the file was taken for.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace beespace::test {
namespace {

class CReadPoints : public testing::Test {
 protected:
  TestFolder folder_;
};

TEST_F(CReadPoints, OfATableInMetresAreItsNumbers) {
  const auto read = read_points(
      folder_.file("swarm.csv", "id,x [m],y [m],z [m]\nanna,1.5,-2,3\nbert,0.1,1e3,-0\n"));
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  EXPECT_EQ(xyz_of(read.points), (std::vector<double>{1.5, -2, 3, 0.1, 1e3, -0.0}));
  EXPECT_EQ(beespace_io_points_degrees(read.points.get()), nullptr);
  EXPECT_STREQ(beespace_io_points_id(read.points.get(), 0), "anna");
  EXPECT_STREQ(beespace_io_points_id(read.points.get(), 1), "bert");
  EXPECT_EQ(beespace_io_points_id(read.points.get(), 2), nullptr);
  EXPECT_EQ(beespace_io_points_id(read.points.get(), -1), nullptr);
  const std::int64_t* offsets = nullptr;
  const char* const ids = beespace_io_points_ids(read.points.get(), &offsets);
  EXPECT_EQ(std::string(ids, 10), std::string("anna\0bert\0", 10));
  EXPECT_EQ(std::vector<std::int64_t>(offsets, offsets + 3), (std::vector<std::int64_t>{0, 5, 10}));
  const auto* const facts = beespace_io_points_facts(read.points.get());
  EXPECT_STREQ(beespace_io_facts_frame(facts), "metres");
  EXPECT_STREQ(beespace_io_facts_format(facts), "text, comma-separated");
  EXPECT_STRNE(beespace_io_facts_frame_reason(facts), "");
  EXPECT_EQ(beespace_io_facts_skipped(facts), 0);
}

// ECEF where it needs no formula: on the equator, and at a pole, whose distance from the centre is
// the semi-minor axis of WGS84.
TEST_F(CReadPoints, OfATableInDegreesAreEarthCentred) {
  const auto read = read_points(
      folder_.file("degrees.csv", "lon_deg,lat_deg,height_m\n180,0,100\n90,0,0\n0,90,5\n"));
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  constexpr double kA = 6378137.0;
  const double b = kA * (1.0 - 1.0 / 298.257223563);
  const std::vector<double> expected = {-(kA + 100), 0, 0, 0, kA, 0, 0, 0, b + 5};
  const std::vector<double> xyz = xyz_of(read.points);
  ASSERT_EQ(xyz.size(), expected.size());
  for (std::size_t i = 0; i < xyz.size(); ++i) EXPECT_NEAR(xyz[i], expected[i], 1e-8) << i;
  const double* const degrees = beespace_io_points_degrees(read.points.get());
  ASSERT_NE(degrees, nullptr);
  EXPECT_EQ(std::vector<double>(degrees, degrees + 9),
            (std::vector<double>{180, 0, 100, 90, 0, 0, 0, 90, 5}));
  EXPECT_STREQ(beespace_io_facts_frame(beespace_io_points_facts(read.points.get())), "wgs84");
  EXPECT_EQ(beespace_io_points_id(read.points.get(), 0), nullptr);
  EXPECT_EQ(beespace_io_points_ids(read.points.get(), nullptr), nullptr);
}

TEST_F(CReadPoints, OfAFileThatIsGoneAreStillThere) {
  const std::string path = folder_.file("swarm.csv", "id,x [m],y [m]\na,1,2\nb,3,4\n");
  const auto read = read_points(path);
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  static_cast<void>(folder_.file("swarm.csv", ""));
  EXPECT_EQ(xyz_of(read.points), (std::vector<double>{1, 2, 0, 3, 4, 0}));
  EXPECT_STREQ(beespace_io_points_id(read.points.get(), 1), "b");
}

TEST_F(CReadPoints, AreUnpacked) {
  const auto read = read_points(folder_.gzip_file("swarm.csv.gz", "x [m],y [m]\n1,2\n"));
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  EXPECT_EQ(xyz_of(read.points), (std::vector<double>{1, 2, 0}));
  EXPECT_NE(std::string(beespace_io_facts_format(beespace_io_points_facts(read.points.get())))
                .find("gzip"),
            std::string::npos);
}

TEST_F(CReadPoints, OfRawDoublesAreTheSameBits) {
  const std::vector<double> xyz = {1e300, -0.1, 5e-5, 1234.5, 1e-3, -2};
  std::string bytes(xyz.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), xyz.data(), bytes.size());
  auto options = io_options();
  options.format = "bin";
  options.frame = "metres";
  const std::string path = folder_.file("swarm.dat", bytes);
  const auto read = read_points(path, &options);
  ASSERT_EQ(read.code, BEESPACE_OUTSIDE_DOMAIN) << text_of(read.error);  // 1e300
  EXPECT_EQ(read.error.record, 0);
  const auto rest =
      read_points(folder_.file("rest.dat", std::string_view(bytes).substr(24)), &options);
  ASSERT_EQ(rest.code, BEESPACE_OK) << rest.error.message;
  EXPECT_EQ(xyz_of(rest.points), (std::vector<double>{1234.5, 1e-3, -2}));
}

TEST_F(CReadPoints, AnswerTheQuestionsOfTheOtherLibrary) {
  const auto read = read_points(folder_.file("swarm.csv", "x [m],y [m]\n0,0\n100,0\n103,4\n"));
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  const beespace_points points = beespace_io_points_view(read.points.get());
  beespace_search search{};
  search.struct_size = sizeof search;
  search.threshold_m = 5.0;
  search.flags = BEESPACE_INCLUSIVE;
  beespace_result* const result = beespace_result_create();
  ASSERT_EQ(beespace_at_risk(nullptr, &points, nullptr, &search, nullptr, result, nullptr),
            BEESPACE_OK);
  const std::int64_t* const ids = beespace_result_ids(result);
  EXPECT_EQ(std::vector<std::int64_t>(ids, ids + beespace_result_size(result)),
            (std::vector<std::int64_t>{1, 2}));
  beespace_result_free(result);
}

TEST_F(CReadPoints, UnitsAreConvertedAndSaid) {
  auto options = io_options();
  options.units = "position=km,height=ft";
  const auto read = read_points(folder_.file("swarm.csv", "x,y,z\n1,2,100\n3,4,200\n"), &options);
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  const std::vector<double> xyz = xyz_of(read.points);
  ASSERT_EQ(xyz.size(), 6U);
  EXPECT_EQ(xyz[0], 1000.0);
  EXPECT_EQ(xyz[2], 30.48);
  const auto notes = notes_of(beespace_io_points_facts(read.points.get()));
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("in ft") != std::string::npos;
  }));
}

TEST_F(CReadPoints, ColumnsAreTakenAsAsked) {
  auto options = io_options();
  options.columns = "id=4,x=2,y=1,z=3";
  options.frame = "metres";
  const auto read = read_points(folder_.file("swarm.csv", "1,2,3,a\n4,5,6,b\n"), &options);
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  EXPECT_EQ(xyz_of(read.points), (std::vector<double>{2, 1, 3, 5, 4, 6}));
  EXPECT_STREQ(beespace_io_points_id(read.points.get(), 1), "b");
}

TEST_F(CReadPoints, BadRecordsAreLeftOutAndListedWhereThatIsAsked) {
  const std::string path =
      folder_.file("swarm.csv", "id,x [m],y [m]\na,1,2\nb,oops,4\nc,5,6\nd,7\ne,8,9\n");
  const auto refused = read_points(path);
  EXPECT_EQ(refused.code, BEESPACE_NOT_A_NUMBER);
  EXPECT_EQ(refused.points, nullptr);

  auto options = io_options();
  options.flags = BEESPACE_IO_SKIP_BAD;
  const auto read = read_points(path, &options);
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  EXPECT_EQ(xyz_of(read.points), (std::vector<double>{1, 2, 0, 5, 6, 0, 8, 9, 0}));
  const std::int64_t* const rows = beespace_io_points_rows(read.points.get());
  EXPECT_EQ(std::vector<std::int64_t>(rows, rows + 3), (std::vector<std::int64_t>{0, 2, 4}));
  EXPECT_STREQ(beespace_io_points_id(read.points.get(), 2), "e");
  const auto* const facts = beespace_io_points_facts(read.points.get());
  ASSERT_EQ(beespace_io_facts_skipped(facts), 2);
  auto error = io_error();
  EXPECT_EQ(beespace_io_facts_skipped_error(facts, 0, &error), BEESPACE_NOT_A_NUMBER);
  EXPECT_EQ(error.line, 3);
  EXPECT_EQ(error.column, 2);
  EXPECT_EQ(beespace_io_facts_skipped_error(facts, 1, &error), BEESPACE_COLUMN_COUNT);
  EXPECT_EQ(error.line, 5);
  EXPECT_EQ(beespace_io_facts_skipped_error(facts, 2, &error), BEESPACE_OK);
  EXPECT_EQ(beespace_io_facts_skipped_error(facts, -1, &error), BEESPACE_OK);
}

TEST_F(CReadPoints, IdsThatComeAgainAreSaid) {
  const auto read = read_points(folder_.file("swarm.csv", "id,x [m],y [m]\na,1,2\na,3,4\n"));
  ASSERT_EQ(read.code, BEESPACE_OK) << read.error.message;
  const auto notes = notes_of(beespace_io_points_facts(read.points.get()));
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes.back().find("has the id of another one before"), std::string::npos);
}

TEST_F(CReadPoints, AreNoneOfNull) {
  EXPECT_EQ(beespace_io_points_count(nullptr), 0);
  EXPECT_EQ(beespace_io_points_xyz(nullptr), nullptr);
  EXPECT_EQ(beespace_io_points_degrees(nullptr), nullptr);
  EXPECT_EQ(beespace_io_points_rows(nullptr), nullptr);
  EXPECT_EQ(beespace_io_points_id(nullptr, 0), nullptr);
  EXPECT_EQ(beespace_io_points_ids(nullptr, nullptr), nullptr);
  const auto* const facts = beespace_io_points_facts(nullptr);
  EXPECT_EQ(facts, nullptr);
  EXPECT_STREQ(beespace_io_facts_frame(facts), "");
  EXPECT_STREQ(beespace_io_facts_heights(facts), "");
  EXPECT_EQ(beespace_io_facts_note(facts, 0), nullptr);
  EXPECT_EQ(beespace_io_facts_skipped(facts), 0);
  beespace_io_points_free(nullptr);
}

}  // namespace
}  // namespace beespace::test
