#include "tests/io/bytes/gzipping.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace beespace::io {
namespace {

const std::vector<Point> kPoints = {{1, 2, 3}, {4, 5, 6}};
constexpr std::string_view kText = "x,y,z\n1,2,3\n4,5,6\n";

TEST(Sources, ReadsAFile) {
  const TemporaryFolder folder;
  const auto loaded = load_points(folder.write("bees.csv", kText));
  EXPECT_EQ(points_of(loaded), kPoints);
  EXPECT_EQ(loaded.value().bytes, kText.size());
}

TEST(Sources, ReadsAFileThatFillsItsPagesToTheLastByte) {
  const TemporaryFolder folder;
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  std::string text = "x,y,z\n";
  while (text.size() + 12 <= page) text += "1,2,3\n";
  while (text.size() < page)
    text += text.size() + 1 == page ? '7' : text.back() == '\n' ? '1' : ',';
  text = text.substr(0, text.rfind('\n') + 1);
  text += "1,2," + std::string(page - text.size() - 4, '1');
  ASSERT_EQ(text.size(), page);
  EXPECT_GT(points_of(load_points(folder.write("page.csv", text))).size(), 100u);
}

TEST(Sources, MissingFileDirectoryAndUnreadableFile) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("no.csv");
  expect_error(load_points(missing), {ErrorCode::kCannotOpen, missing, "there is no such file"});
  const std::string directory = folder.file("");
  expect_error(load_points(directory), {ErrorCode::kCannotOpen, directory, "this is a directory"});
  if (::geteuid() == 0) GTEST_SKIP() << "everything is readable to root";
  const std::string locked = folder.write("locked.csv", kText);
  ASSERT_EQ(::chmod(locked.c_str(), 0), 0);
  expect_error(load_points(locked), {ErrorCode::kCannotOpen, locked, "not allowed to read"});
}

TEST(Sources, EmptyFileIsNoPoints) {
  const TemporaryFolder folder;
  const std::string empty = folder.write("empty.csv", "");
  expect_error(load_points(empty), {ErrorCode::kNoPoints, empty, "the input is empty"});
}

TEST(Sources, ReadsAPipe) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&pipe] { std::ofstream(pipe) << kText; });
  EXPECT_EQ(points_of(load_points(pipe)), kPoints);
  writer.join();
}

TEST(Sources, ReadsStandardInputAndNamesItInErrors) {
  const auto with_input = [](std::string_view text) {
    int ends[2] = {-1, -1};
    EXPECT_EQ(::pipe(ends), 0);
    EXPECT_EQ(::write(ends[1], text.data(), text.size()), static_cast<ssize_t>(text.size()));
    ::close(ends[1]);
    const int saved = ::dup(STDIN_FILENO);
    ::dup2(ends[0], STDIN_FILENO);
    ::close(ends[0]);
    auto loaded = load_points("-");
    ::dup2(saved, STDIN_FILENO);
    ::close(saved);
    return loaded;
  };
  EXPECT_EQ(points_of(with_input(kText)), kPoints);
  EXPECT_EQ(points_of(with_input(gzipped(kText))), kPoints);
  expect_error(with_input("x,y,z\n1,2,q\n"), {ErrorCode::kNotANumber, "<stdin>:2:3", "'q'"});
}

TEST(Gzip, IsKnownByItsContentAndMayHaveSeveralMembers) {
  const auto loaded = load_points_from_memory(gzipped(kText), "bees.txt");
  EXPECT_EQ(points_of(loaded), kPoints);
  EXPECT_EQ(loaded.value().format_description, "text, comma-separated, gzip-compressed");
  const std::string two = gzipped("x,y,z\n1,2,3\n") + gzipped("4,5,6\n");
  EXPECT_EQ(points_of(load_points_from_memory(two, "bees.gz")), kPoints);
  EXPECT_EQ(points_of(load_points_from_memory(two + std::string(512, '\0'), "bees.gz")), kPoints);
}

TEST(Gzip, CompressedTwiceIsNamed) {
  expect_error(load_points_from_memory(gzipped(gzipped(kText)), "bees.csv.gz"),
               {ErrorCode::kUnsupportedFormat, "bees.csv.gz", "compressed twice"});
}

TEST(Sources, TheEndingOfRawArraysIsKnownInCapitalsToo) {
  std::string rows(48, '\0');
  const double values[] = {1, 2, 3, 4, 5, 6};
  std::memcpy(rows.data(), values, rows.size());
  EXPECT_EQ(points_of(load_points_from_memory(rows, "BEES.BIN", in_metres())), kPoints);
  expect_error(load_points_from_memory(rows, "bees", in_metres()),
               {ErrorCode::kUnsupportedFormat, "bees",
                "byte 0 is NUL; save it as text in UTF-8, or let the name of raw float64 end in "
                ".bin"});
  LoadOptions options = in_metres();
  options.format_can_be_said = true;
  expect_error(load_points_from_memory(rows, "bees", options),
               {ErrorCode::kUnsupportedFormat, "bees", "for raw float64 say --format bin"});
}

TEST(Gzip, HoldsRawArraysToo) {
  std::string rows(48, '\0');
  const double values[] = {1, 2, 3, 4, 5, 6};
  std::memcpy(rows.data(), values, rows.size());
  EXPECT_EQ(points_of(load_points_from_memory(gzipped(rows), "bees.bin.gz", in_metres())), kPoints);
}

TEST(Gzip, UnpacksMuchMoreThanItsSize) {
  std::string text = "x,y,z\n";
  for (int i = 0; i < 300'000; ++i) text += "1,2,3\n";
  EXPECT_EQ(points_of(load_points_from_memory(gzipped(text), "bees.gz")).size(), 300'000u);
}

TEST(Gzip, EveryTruncationIsAnError) {
  const std::string whole = gzipped(kText);
  for (std::size_t size = 2; size < whole.size(); ++size) {
    const auto loaded = load_points_from_memory(whole.substr(0, size), "bees.gz");
    ASSERT_FALSE(loaded.has_value()) << size;
    EXPECT_EQ(loaded.error().code, ErrorCode::kTruncated) << size;
  }
  expect_error(load_points_from_memory(whole + gzipped(kText).substr(0, 15), "bees.gz"),
               {ErrorCode::kTruncated, "bees.gz", "ends too early"});
}

TEST(Gzip, DamageIsAnError) {
  std::string whole = gzipped(kText);
  whole[whole.size() - 6] = static_cast<char>(whole[whole.size() - 6] ^ 1);  // the checksum
  expect_error(load_points_from_memory(whole, "bees.gz"),
               {ErrorCode::kCorrupt, "bees.gz", "damaged near byte"});
  expect_error(load_points_from_memory(gzipped(kText) + "rubbish", "bees.gz"),
               {ErrorCode::kCorrupt, "bees.gz", "other data follows"});
}

// kText as zstd 1.5.4 packs it, with its checksum.
constexpr std::string_view kPacked(
    "\x28\xB5\x2F\xFD\x04\x58\x91\x00\x00\x78\x2C\x79\x2C\x7A\x0A\x31\x2C\x32\x2C\x33\x0A\x34"
    "\x2C\x35\x2C\x36\x0A\x1D\x44\x5D\xAE",
    31);

#if BEESPACE_READS_ZSTD

TEST(Zstd, IsKnownByItsContentAndMayHaveSeveralFrames) {
  const auto loaded = load_text(kPacked);
  EXPECT_EQ(points_of(loaded), kPoints);
  EXPECT_EQ(loaded.value().format_description, "text, comma-separated, zstd-compressed");
  std::string twice(kPacked);
  twice += kPacked;
  // The header comes again with the second one.
  std::vector<Point> both = kPoints;
  both.insert(both.end(), kPoints.begin(), kPoints.end());
  EXPECT_EQ(points_of(load_text(twice)), both);
}

TEST(Zstd, EveryTruncationIsAnError) {
  for (std::size_t length = 2; length < kPacked.size(); ++length) {
    const auto loaded = load_text(kPacked.substr(0, length));
    ASSERT_FALSE(loaded) << length;
    EXPECT_EQ(loaded.error().code, ErrorCode::kTruncated) << length;
  }
}

TEST(Zstd, DamageIsAnError) {
  std::string damaged(kPacked);
  damaged[12] = static_cast<char>(damaged[12] ^ 1);
  expect_error(load_text(damaged), {ErrorCode::kCorrupt, "bees.csv", "zstd data is damaged"});
  expect_error(load_text(std::string(kPacked) + "more"),
               {ErrorCode::kCorrupt, "bees.csv", "zstd data is damaged"});
}

#else

TEST(Zstd, IsNamedWhereItIsNotRead) {
  expect_error(load_text(kPacked), {ErrorCode::kUnsupportedFormat, "bees.csv", "zstdcat FILE |"});
}

#endif

TEST(Progress, ReachesItsTotal) {
  const TemporaryFolder folder;
  Progress progress;
  LoadOptions options;
  options.progress = &progress;
  ASSERT_TRUE(load_points(folder.write("bees.csv", kText), options).has_value());
  EXPECT_EQ(progress.total.load(), kText.size());
  EXPECT_EQ(progress.done.load(), kText.size());
  ASSERT_TRUE(load_points(folder.write("bees.gz", gzipped(kText)), options).has_value());
  EXPECT_EQ(progress.done.load(), progress.total.load());
}

}  // namespace
}  // namespace beespace::io
