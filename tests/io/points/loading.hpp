// Short functions to load a test's text, and to state the expected points.
#pragma once

#include "io/frames/coordinate_frame.hpp"
#include "io/load_points.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

inline Result<LoadedPoints> load_text(std::string_view text, const LoadOptions& options = {}) {
  return load_points_from_memory(text, "bees.csv", options);
}

inline LoadOptions in_metres() {
  LoadOptions options;
  options.frame = Frame::kMetres;
  return options;
}

inline LoadOptions with_columns(std::string columns) {
  LoadOptions options;
  options.columns = std::move(columns);
  return options;
}

// The points, or none (and a failed test) when loading fails.
inline std::vector<Point> points_of(const Result<LoadedPoints>& loaded) {
  EXPECT_TRUE(loaded.has_value()) << (loaded ? "" : to_string(loaded.error()));
  return loaded ? loaded.value().points : std::vector<Point>();
}

struct Expected {
  ErrorCode code;
  std::string_view place;    // "bees.csv:3:2", as to_string() writes it
  std::string_view message;  // a part of it
};

template <class Content>
void expect_error(const Result<Content>& loaded, const Expected& expected) {
  ASSERT_FALSE(loaded.has_value());
  const Error& error = loaded.error();
  const std::string text = to_string(error);
  EXPECT_EQ(to_string(error.code), to_string(expected.code)) << text;
  EXPECT_EQ(text.substr(0, expected.place.size() + 2), std::string(expected.place) + ": ") << text;
  EXPECT_NE(text.find(expected.message), std::string::npos) << text;
}

// A folder of its own for a test, gone with it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "beespace-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  [[nodiscard]] std::string file(std::string_view name) const {
    return (path_ / std::string(name)).string();
  }
  // Writes a file and returns its name.
  [[nodiscard]] std::string write(std::string_view name, std::string_view content) const {
    std::ofstream stream(file(name), std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    return file(name);
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : std::filesystem::directory_iterator(path_)) {
      found.push_back(entry.path().filename().string());
    }
    return found;
  }

 private:
  std::filesystem::path path_;
};

inline std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}  // namespace beespace::io
