#include "io/bytes/zip_archive.hpp"

#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

Bytes bytes_of(const std::string& text) {
  auto owner = std::make_shared<const std::string>(text);
  return {owner, *owner};
}

Result<Bytes> read_part(const std::string& zip, const std::string& member) {
  auto archive = ZipArchive::open(bytes_of(zip), "a.zip");
  if (!archive) return archive.error();
  return archive->read(member);
}

void expect_problem(const Result<Bytes>& read, const Expected& expected) {
  ASSERT_FALSE(read.has_value());
  const std::string text = to_string(read.error());
  EXPECT_EQ(to_string(read.error().code), to_string(expected.code)) << text;
  EXPECT_EQ(text.substr(0, expected.place.size() + 2), std::string(expected.place) + ": ");
  EXPECT_NE(text.find(expected.message), std::string::npos) << text;
}

TEST(ZipArchive, FilesAreNamedAndRead) {
  const std::string long_text(1'000'000, 'x');
  const std::string zip = zipped({{"b/two", long_text}, {"one", "1"}, {"b/", ""}, {"none", ""}});
  auto archive = ZipArchive::open(bytes_of(zip), "a.zip");
  ASSERT_TRUE(archive.has_value());
  EXPECT_EQ(archive->names(), (std::vector<std::string>{"b/two", "one", "none"}));
  EXPECT_TRUE(archive->contains("one"));
  EXPECT_FALSE(archive->contains("two"));
  EXPECT_EQ(archive->read("b/two").value().view, long_text);
  EXPECT_EQ(archive->read("one").value().view, "1");
  EXPECT_EQ(archive->read("none").value().view, "");
  EXPECT_EQ(archive->place_of("one"), "a.zip!one");
}

TEST(ZipArchive, IsRecognisedByItsFirstBytes) {
  EXPECT_TRUE(is_zip(zipped({{"one", "1"}})));
  EXPECT_FALSE(is_zip("PK"));
  EXPECT_FALSE(is_zip("id,time\n"));
}

TEST(ZipArchive, APartThatIsNotThere) {
  expect_problem(read_part(zipped({{"one", "1"}}), "two"),
                 {ErrorCode::kCannotOpen, "a.zip", "there is no file 'two' in this archive"});
}

TEST(ZipArchive, ATruncatedArchive) {
  const std::string zip = zipped({{"one", std::string(1000, 'x')}, {"two", "2"}});
  for (const std::size_t size : {std::size_t{4}, std::size_t{30}, zip.size() / 2, zip.size() - 1}) {
    expect_problem(read_part(zip.substr(0, size), "one"),
                   {ErrorCode::kTruncated, "a.zip", "the zip archive ends too early"});
  }
}

TEST(ZipArchive, DamagedContent) {
  std::string zip = zipped({{"one", "some text that is stored"}}, ZIP_CM_STORE);
  zip[zip.find("some")] = 'S';
  expect_problem(read_part(zip, "one"),
                 {ErrorCode::kCorrupt, "a.zip!one", "the zip archive is damaged (CRC error)"});
}

TEST(ZipArchive, AnUnknownWayOfPacking) {
  std::string zip = zipped({{"one", "some text that is stored"}}, ZIP_CM_STORE);
  // The method stands 8 bytes behind the start of a file, and 10 in its entry of the directory.
  zip[8] = 97;
  zip[zip.find("PK\x01\x02") + 10] = 97;
  expect_problem(read_part(zip, "one"),
                 {ErrorCode::kUnsupportedFormat, "a.zip!one", "packed in a way that is not read"});
}

TEST(ZipArchive, AnEncryptedPart) {
  std::string zip = zipped({{"one", "some text that is stored"}}, ZIP_CM_STORE);
  zip[6] |= 1;
  zip[zip.find("PK\x01\x02") + 8] |= 1;
  expect_problem(read_part(zip, "one"),
                 {ErrorCode::kUnsupportedFormat, "a.zip!one", "is encrypted"});
}

TEST(ZipArchive, ThatUnpacksToAGreatSizeIsRefused) {
  const std::string zip = zipped({{"one", std::string(10'000'000, '\0')}});
  EXPECT_LT(zip.size(), 20'000u);
  auto archive = ZipArchive::open(bytes_of(zip), "a.zip", {9'999'999, 1'000'000'000});
  ASSERT_TRUE(archive.has_value());
  expect_problem(archive->read("one"), {ErrorCode::kUnsupportedFormat, "a.zip!one",
                                        "unpacks to more than 9999999 bytes"});
  EXPECT_TRUE(read_part(zip, "one").has_value());
}

TEST(ZipArchive, ThePartsTogetherAreLimited) {
  const std::string zip = zipped({{"one", std::string(1'000'000, '\0')}});
  auto archive = ZipArchive::open(bytes_of(zip), "a.zip", {1'000'000, 3'999'999});
  ASSERT_TRUE(archive.has_value());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(archive->read("one").has_value());
  expect_problem(archive->read("one"),
                 {ErrorCode::kUnsupportedFormat, "a.zip", "unpacks to more than 3999999 bytes"});
}

}  // namespace
}  // namespace beespace::io
