// Tables in tests: what stands below their header line.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

namespace beespace::cli_test {

// A table without its header line, which must be there.
inline std::string below_header(const std::string& text) {
  const std::size_t end = text.find('\n');
  EXPECT_NE(end, std::string::npos) << "there is no header line";
  return end == std::string::npos ? std::string() : text.substr(end + 1);
}

}  // namespace beespace::cli_test
