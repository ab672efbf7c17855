#include "io/bytes/atomic_output.hpp"

#include "tests/io/points/loading.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <optional>
#include <string>
#include <thread>

namespace beespace::io {
namespace {

AtomicOutput opened(const std::string& path) {
  auto output = AtomicOutput::open(path);
  EXPECT_TRUE(output.has_value()) << (output ? "" : to_string(output.error()));
  return std::move(output).value();
}

TEST(AtomicOutput, AppearsWithItsNameOnlyOnCommit) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.txt");
  auto output = opened(path);
  output.write("one\n");
  output.write("two\n");
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(output.commit().has_value());
  EXPECT_EQ(content_of(path), "one\ntwo\n");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
}

TEST(AtomicOutput, WithoutCommitNothingIsLeftAndTheOldFileStays) {
  const TemporaryFolder folder;
  const std::string path = folder.write("out.txt", "old");
  {
    auto output = opened(path);
    output.write(std::string(3'000'000, 'x'));
    EXPECT_EQ(folder.names().size(), 2u);
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out.txt"});
}

TEST(AtomicOutput, KeepsEveryByteOfSmallAndLargeWrites) {
  const TemporaryFolder folder;
  const std::string path = folder.file("out.txt");
  auto output = opened(path);
  std::string expected;
  for (std::size_t size = 0; size < 3'000'000; size = size * 3 + 1) {
    const std::string text(size, static_cast<char>('a' + size % 26));
    output.write(text);
    expected += text;
  }
  ASSERT_TRUE(output.commit().has_value());
  EXPECT_EQ(content_of(path), expected);
}

TEST(AtomicOutput, KeepsThePermissionsOfTheFileItReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.write("out.txt", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0640), 0);
  auto output = opened(path);
  ASSERT_TRUE(output.commit().has_value());
  struct stat status = {};
  ASSERT_EQ(::stat(path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(AtomicOutput, ANewFileHasThePermissionsOfTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  auto output = opened(folder.file("out.txt"));
  ::umask(before);
  ASSERT_TRUE(output.commit().has_value());
  struct stat status = {};
  ASSERT_EQ(::stat(folder.file("out.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(AtomicOutput, ReplacesWhereASymbolicLinkLeadsAndKeepsTheLink) {
  const TemporaryFolder folder;
  const std::string target = folder.write("target.txt", "old");
  ASSERT_EQ(::symlink("target.txt", folder.file("link").c_str()), 0);
  ASSERT_EQ(::symlink("later.txt", folder.file("dangling").c_str()), 0);
  auto output = opened(folder.file("link"));
  output.write("new");
  ASSERT_TRUE(output.commit().has_value());
  EXPECT_EQ(content_of(target), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link")));
  auto dangling = opened(folder.file("dangling"));
  dangling.write("there");
  ASSERT_TRUE(dangling.commit().has_value());
  EXPECT_EQ(content_of(folder.file("later.txt")), "there");
}

TEST(AtomicOutput, AFullDiskIsReportedWithThePath) {
  auto output = opened("/dev/full");
  output.write("text");
  const Status status = output.commit();
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, ErrorCode::kWriteFailed);
  EXPECT_NE(to_string(status.error()).find("/dev/full: cannot write (No space left"),
            std::string::npos)
      << to_string(status.error());
  EXPECT_FALSE(output.pipe_closed());
}

TEST(AtomicOutput, DevicesAreWrittenToNotReplaced) {
  auto output = opened("/dev/null");
  output.write("text");
  EXPECT_TRUE(output.commit().has_value());
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(AtomicOutput, MissingFoldersAndDirectoriesAreErrors) {
  const TemporaryFolder folder;
  const auto missing = AtomicOutput::open(folder.file("no/out.txt"));
  ASSERT_FALSE(missing.has_value());
  EXPECT_EQ(missing.error().code, ErrorCode::kWriteFailed);
  EXPECT_NE(missing.error().message.find("the folder does not exist"), std::string::npos);
  const auto directory = AtomicOutput::open(folder.file(""));
  ASSERT_FALSE(directory.has_value());
  EXPECT_NE(directory.error().message.find("this is a directory"), std::string::npos);
  EXPECT_FALSE(AtomicOutput::open("").has_value());
}

TEST(AtomicOutput, AWriteProtectedFileIsNotReplaced) {
  if (::geteuid() == 0) GTEST_SKIP() << "everything is writable to root";
  const TemporaryFolder folder;
  const std::string path = folder.write("out.txt", "old");
  ASSERT_EQ(::chmod(path.c_str(), 0444), 0);
  const auto output = AtomicOutput::open(path);
  ASSERT_FALSE(output.has_value());
  EXPECT_EQ(output.error().code, ErrorCode::kWriteFailed);
}

TEST(AtomicOutput, AClosedPipeIsDistinguishedFromOtherFailures) {
  const TemporaryFolder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  auto* const before = std::signal(SIGPIPE, SIG_IGN);
  std::optional<AtomicOutput> output;
  std::thread reader([&pipe] { ::close(::open(pipe.c_str(), O_RDONLY)); });
  output = opened(pipe);
  reader.join();
  output->write("this is not read");
  const Status status = output->commit();
  std::signal(SIGPIPE, before);
  ASSERT_FALSE(status.has_value());
  EXPECT_EQ(status.error().code, ErrorCode::kWriteFailed);
  EXPECT_TRUE(output->pipe_closed());
  EXPECT_TRUE(output->failed());
}

TEST(AtomicOutput, ASignalHandlerCanDiscardWhatIsOpen) {
  const TemporaryFolder folder;
  auto first = opened(folder.file("first.txt"));
  auto second = opened(folder.file("second.txt"));
  first.write("text");
  ASSERT_TRUE(second.commit().has_value());
  discard_open_outputs_in_signal_handler();
  EXPECT_EQ(folder.names(), std::vector<std::string>{"second.txt"});
}

TEST(AtomicOutput, ManyMayBeOpenButNotWithoutEnd) {
  const TemporaryFolder folder;
  std::vector<AtomicOutput> outputs;
  outputs.reserve(16);
  for (int i = 0; i < 16; ++i) {
    outputs.push_back(opened(folder.file("out" + std::to_string(i))));
  }
  const auto refused = AtomicOutput::open(folder.file("one more"));
  ASSERT_FALSE(refused.has_value());
  EXPECT_NE(refused.error().message.find("too many output files"), std::string::npos);
  outputs.pop_back();
  EXPECT_TRUE(AtomicOutput::open(folder.file("one more")).has_value());
}

TEST(AtomicOutput, MovedOutputsWriteToTheSameFile) {
  const TemporaryFolder folder;
  auto first = opened(folder.file("out.txt"));
  first.write("one ");
  AtomicOutput second = std::move(first);
  second.write("two");
  ASSERT_TRUE(second.commit().has_value());
  EXPECT_EQ(content_of(folder.file("out.txt")), "one two");
}

}  // namespace
}  // namespace beespace::io
