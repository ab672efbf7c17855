// Temporary files without a name: what is read is what was written, or an error.
#include "io/bytes/scratch_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

class Scratch : public testing::Test {
 protected:
  ~Scratch() override { std::filesystem::remove_all(folder_); }

  // The open file below the folder, by the name that the system has for it.
  [[nodiscard]] std::string open_file() const {
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
      std::error_code gone;
      const auto target = std::filesystem::read_symlink(entry.path(), gone);
      if (!gone && target.string().starts_with(folder_)) return entry.path().string();
    }
    return {};
  }

  static Result<std::string> read(const ScratchFile& file, const ScratchFile::Block& block) {
    std::string bytes(block.size, '\0');
    if (auto status = file.read(block, bytes); !status) return status.error();
    return bytes;
  }

  std::string folder_ = [] {
    std::string name = (std::filesystem::temp_directory_path() / "scratch-XXXXXX").string();
    return std::string(::mkdtemp(name.data()));
  }();
};

TEST_F(Scratch, HasNoNameAndHoldsItsBlocks) {
  auto file = ScratchFile::make(folder_);
  ASSERT_TRUE(file) << to_string(file.error());
  std::vector<ScratchFile::Block> blocks;
  for (const std::string& text : {std::string("one"), std::string(), std::string(100'000, 'x')}) {
    const auto block = file->append(text);
    ASSERT_TRUE(block);
    blocks.push_back(*block);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
  EXPECT_EQ(*read(*file, blocks[2]), std::string(100'000, 'x'));
  EXPECT_EQ(*read(*file, blocks[0]), "one");
  EXPECT_EQ(*read(*file, blocks[1]), "");
}

TEST_F(Scratch, WhatIsNotWhatWasWrittenIsAnError) {
  auto file = ScratchFile::make(folder_);
  ASSERT_TRUE(file);
  const auto block = file->append("all that was written");
  ASSERT_TRUE(block);
  const std::string name = open_file();
  ASSERT_NE(name, "");
  {
    std::fstream other(name, std::ios::in | std::ios::out | std::ios::binary);
    other.seekp(7);
    other << 'X';
  }
  EXPECT_EQ(read(*file, *block).error().code, ErrorCode::kCorrupt);
  std::filesystem::resize_file(name, 5);
  EXPECT_EQ(read(*file, *block).error().code, ErrorCode::kCorrupt);
}

TEST_F(Scratch, AFolderThatIsNotThereIsNamed) {
  const std::string missing = folder_ + "/missing";
  const auto file = ScratchFile::make(missing);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, ErrorCode::kWriteFailed);
  EXPECT_NE(file.error().message.find(missing), std::string::npos);
  EXPECT_EQ(free_bytes_in(missing).error().code, ErrorCode::kWriteFailed);
  EXPECT_GT(*free_bytes_in(folder_), 0U);
}

}  // namespace
}  // namespace beespace::io
