// What is wrong with a file reaches C: the code, the file, the line, the column, the record, and a
// sentence in the words of those who call a function.
#include "tests/c_io/test_file.hpp"

#include <beespace.h>
#include <beespace_io.h>

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace beespace::test {
namespace {

class CIoErrors : public testing::Test {
 protected:
  TestFolder folder_;
};

TEST_F(CIoErrors, AMissingFileIsNamed) {
  const std::string path = folder_.path("none.csv");
  const auto read = read_points(path);
  EXPECT_EQ(read.code, BEESPACE_CANNOT_OPEN);
  EXPECT_EQ(read.error.code, BEESPACE_CANNOT_OPEN);
  EXPECT_EQ(read.error.file, path);
  EXPECT_EQ(read.error.record, -1);
  EXPECT_EQ(read.error.line, 0);
  EXPECT_EQ(read.error.column, 0);
  EXPECT_EQ(text_of(read.error), path + ": " + read.error.message);
}

TEST_F(CIoErrors, AFolderIsNoFile) {
  EXPECT_EQ(read_points(folder_.path(".")).code, BEESPACE_CANNOT_OPEN);
}

TEST_F(CIoErrors, ABrokenRecordHasItsPlace) {
  const std::string path = folder_.file("swarm.csv", "id,x [m],y [m]\na,1,2\nb,3,four\n");
  const auto read = read_points(path);
  EXPECT_EQ(read.code, BEESPACE_NOT_A_NUMBER);
  EXPECT_EQ(read.error.file, path);
  EXPECT_EQ(read.error.line, 3);
  EXPECT_EQ(read.error.column, 3);
  EXPECT_EQ(read.error.record, 1);
  EXPECT_EQ(text_of(read.error), path + ":3:3: " + read.error.message);
  EXPECT_NE(std::strstr(read.error.message, "'four'"), nullptr);
  EXPECT_NE(std::strstr(read.error.message, "skip_bad"), nullptr);
  EXPECT_EQ(std::strstr(read.error.message, "--"), nullptr);
}

TEST_F(CIoErrors, WhatTheFileDoesNotSayIsAskedForByTheNameOfTheField) {
  const auto read = read_points(folder_.file("swarm.csv", "1,2,3\n4,5,6\n"));
  EXPECT_EQ(read.code, BEESPACE_UNKNOWN_FRAME);
  EXPECT_NE(std::strstr(read.error.message, "frame wgs84"), nullptr) << read.error.message;
  EXPECT_EQ(std::strstr(read.error.message, "--"), nullptr) << read.error.message;
}

TEST_F(CIoErrors, ARecordingIsNoSnapshot) {
  const auto read = read_points(
      folder_.file("flight.csv", "id,time_s,x [m],y [m],z [m]\na,0,1,2,0\nb,0,3,4,0\na,1,1,2,0\n"));
  EXPECT_EQ(read.code, BEESPACE_UNSUPPORTED_FORMAT);
  EXPECT_NE(std::strstr(read.error.message, "read it as a recording"), nullptr)
      << read.error.message;
}

TEST_F(CIoErrors, DamagedDataIsToldFromMissingData) {
  const std::string path = folder_.gzip_file("swarm.csv.gz", "x [m],y [m]\n1,2\n3,4\n");
  EXPECT_EQ(read_points(path).code, BEESPACE_OK);
  std::string bytes;
  {
    std::FILE* const file = std::fopen(path.c_str(), "rb");
    ASSERT_NE(file, nullptr);
    char buffer[4096];
    bytes.assign(buffer, std::fread(buffer, 1, sizeof buffer, file));
    std::fclose(file);
  }
  EXPECT_EQ(read_points(folder_.file("short.csv.gz", bytes.substr(0, bytes.size() - 6))).code,
            BEESPACE_TRUNCATED);
  bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 1);  // of the checksum
  EXPECT_EQ(read_points(folder_.file("bad.csv.gz", bytes)).code, BEESPACE_CORRUPT);
  EXPECT_EQ(read_points(folder_.file("empty.csv", "")).code, BEESPACE_NO_POINTS);
}

// A dash is a file as any other: standard input is read by nothing that does not name it.
TEST_F(CIoErrors, ADashIsNoStandardInput) {
  const auto read = read_points("-");
  EXPECT_EQ(read.code, BEESPACE_CANNOT_OPEN);
  EXPECT_STREQ(read.error.file, "./-");
}

TEST_F(CIoErrors, WhatIsTooLongIsCutWithMarks) {
  std::string path = "/none";
  while (path.size() < 1500) path += "/\xC3\xA4\xC3\xA4\xC3\xA4";  // a letter of two bytes
  const auto read = read_points(path);
  EXPECT_EQ(read.code, BEESPACE_CANNOT_OPEN);
  const std::string file = read.error.file;
  ASSERT_GE(file.size(), sizeof read.error.file - 2);
  EXPECT_EQ(file.substr(0, 3), "...");
  EXPECT_EQ(file.substr(3), path.substr(path.size() - (file.size() - 3)));
  EXPECT_NE(static_cast<unsigned char>(file[3]) & 0xC0U, 0x80U);
}

TEST_F(CIoErrors, AreWrittenAsFarAsThereIsRoom) {
  auto error = io_error();
  error.record = -1;
  std::strcpy(error.file, "bees.csv");
  std::strcpy(error.message, "no points");
  EXPECT_EQ(beespace_io_error_text(&error, nullptr, 0), 19U);
  char text[5];
  EXPECT_EQ(beespace_io_error_text(&error, text, sizeof text), 19U);
  EXPECT_STREQ(text, "bees");
  std::memset(error.message, 'm', sizeof error.message);  // without an end
  EXPECT_EQ(beespace_io_error_text(&error, nullptr, 0), 10 + sizeof error.message);
}

}  // namespace
}  // namespace beespace::test
