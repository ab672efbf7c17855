// A fault of the disk.
#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace beespace::test {

// Changes a byte of the newest file without a name that this process has open.
inline void damage_last_temporary_file(std::uint64_t offset) {
  int newest = -1;
  for (int descriptor = 3; descriptor < 256; ++descriptor) {
    std::error_code none;
    const auto target =
        std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none);
    if (!none && target.string().find("(deleted)") != std::string::npos) newest = descriptor;
  }
  ASSERT_GE(newest, 0);
  char byte = 0;
  ASSERT_EQ(::pread(newest, &byte, 1, static_cast<off_t>(offset)), 1);
  byte = static_cast<char>(byte ^ 4);
  ASSERT_EQ(::pwrite(newest, &byte, 1, static_cast<off_t>(offset)), 1);
}

}  // namespace beespace::test
