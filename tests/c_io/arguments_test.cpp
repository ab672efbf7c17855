// What callers of C can get wrong: sizes of structures, pointers, flags, words of options.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <utility>

namespace beespace::test {
namespace {

class CIoArguments : public testing::Test {
 protected:
  void expect_refused(const beespace_io_options& options, const std::string& word = "") {
    const auto read = read_points(path_, &options);
    EXPECT_EQ(read.code, BEESPACE_INVALID_ARGUMENT);
    EXPECT_STREQ(read.error.place, "options");
    EXPECT_NE(std::string(read.error.message).find(word), std::string::npos) << read.error.message;
    EXPECT_EQ(read.points, nullptr);
  }

  TestFolder folder_;
  std::string path_ = folder_.file("swarm.csv", "x [m],y [m]\n1,2\n3,4\n");
};

TEST_F(CIoArguments, DefaultsAreZeros) {
  const auto options = io_options();
  EXPECT_EQ(read_points(path_, &options).code, BEESPACE_OK);
  EXPECT_EQ(read_points(path_).code, BEESPACE_OK);
}

TEST_F(CIoArguments, SizesThatWereNeverSetAreRefused) {
  for (const std::size_t size :
       {std::size_t{0}, sizeof(beespace_io_options) - 1, std::size_t{5000}}) {
    auto options = io_options();
    options.struct_size = size;
    expect_refused(options, "struct_size");
  }
  auto options = io_options();
  options.reserved = 1;
  expect_refused(options, "reserved");
}

TEST_F(CIoArguments, UnknownFlagsAndWordsAreRefused) {
  auto options = io_options();
  options.flags = 1U << 20U;
  expect_refused(options, "flags");
  options.flags = BEESPACE_IO_GROUNDED;
  expect_refused(options, "flags");
  options = io_options();
  options.frame = "meters";
  expect_refused(options, "frame is one of auto, wgs84, metres, not 'meters'");
  options = io_options();
  options.heights = "high";
  expect_refused(options, "heights is one of");
  options = io_options();
  options.format = "xlsx";
  expect_refused(options, "format is one of");
  options = io_options();
  options.time_unit = "ms";
  expect_refused(options, "time_unit is for recordings");
  options = io_options();
  options.fps = 25;
  expect_refused(options, "time_zone, dates, scale and fps are for recordings");
  options = io_options();
  options.least_likelihood = 0.9;
  expect_refused(options, "least_likelihood and tolerance are for recordings");
  options = io_options();
  options.tolerance_m = 1;
  expect_refused(options, "least_likelihood and tolerance are for recordings");
  options = io_options();
  options.units = "height=cubits";
  expect_refused(options, "units: 'cubits'");
}

TEST_F(CIoArguments, PointersThatAreMissingAreRefused) {
  auto error = io_error();
  beespace_io_points* points = nullptr;
  EXPECT_EQ(beespace_io_read_points(nullptr, nullptr, &points, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "path");
  EXPECT_EQ(beespace_io_read_points("", nullptr, &points, &error), BEESPACE_INVALID_ARGUMENT);
  EXPECT_EQ(beespace_io_read_points(path_.c_str(), nullptr, nullptr, &error),
            BEESPACE_INVALID_ARGUMENT);
  EXPECT_STREQ(error.place, "points");
  EXPECT_EQ(beespace_io_read_points("/none", nullptr, &points, nullptr), BEESPACE_CANNOT_OPEN);
  // An error that is too small is not written to.
  std::memset(&error, 7, sizeof error);
  error.struct_size = sizeof error - 8;
  const auto before = error;
  EXPECT_EQ(beespace_io_read_points("/none", nullptr, &points, &error), BEESPACE_CANNOT_OPEN);
  EXPECT_EQ(std::memcmp(&before, &error, sizeof error), 0);
}

TEST_F(CIoArguments, AllProcessorsReadTheSame) {
  std::string table = "x [m],y [m],z [m]\n";
  for (int i = 0; i < 20000; ++i) {
    table += std::to_string(i) + "," + std::to_string(i % 7) + ".25,-" + std::to_string(i) + "\n";
  }
  const std::string path = folder_.file("large.csv", table);
  const auto one = read_points(path);
  auto options = io_options();
  options.threads = BEESPACE_ALL_PROCESSORS;
  const auto all = read_points(path, &options);
  ASSERT_EQ(one.code, BEESPACE_OK) << one.error.message;
  ASSERT_EQ(all.code, BEESPACE_OK) << all.error.message;
  EXPECT_EQ(beespace_io_points_count(one.points.get()), 20000);
  EXPECT_EQ(xyz_of(one.points), xyz_of(all.points));
}

}  // namespace
}  // namespace beespace::test
