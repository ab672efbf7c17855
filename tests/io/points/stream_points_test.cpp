// Points block after block: the same as all at once, and errors where they are.
#include "io/stream_points.hpp"

#include "io/load_points.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

class StreamedPoints : public testing::Test {
 protected:
  ~StreamedPoints() override { std::filesystem::remove_all(folder_); }

  std::string file(const std::string& name, const std::string& content) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  static Result<std::vector<Point>> stream(const std::string& path, const LoadOptions& options,
                                           std::size_t block_bytes) {
    auto stream = PointStream::open(path, options, block_bytes);
    if (!stream) return stream.error();
    std::vector<Point> all;
    for (std::vector<Point> points;;) {
      if (auto status = stream->next(points); !status) return status.error();
      if (points.empty()) return all;
      all.insert(all.end(), points.begin(), points.end());
    }
  }

  static Error error_of(const std::string& path, const LoadOptions& options, std::size_t bytes) {
    const auto points = stream(path, options, bytes);
    EXPECT_FALSE(points) << path;
    return points ? Error{} : points.error();
  }

  std::filesystem::path folder_ = [] {
    std::string name = (std::filesystem::temp_directory_path() / "stream-XXXXXX").string();
    return std::filesystem::path(::mkdtemp(name.data()));
  }();
};

LoadOptions in_metres() {
  LoadOptions options;
  options.frame = Frame::kMetres;
  return options;
}

TEST_F(StreamedPoints, AreThoseOfTheWholeFile) {
  std::string metres = "x_m,y_m,z_m\n";
  std::string degrees = "longitude;latitude;height_ft\n";
  std::string feet = "a comment\n";
  for (int row = 0; row < 500; ++row) {
    metres += std::to_string(row) + ".25,-3," + std::to_string(row * row) + "\n";
    degrees += "8." + std::to_string(row) + ";47;" + std::to_string(row) + "\r\n";
  }
  const std::string blank_in_between = metres + std::string(3000, '\n') + "1,2,3\n\n\n";
  for (const std::string& content : {metres, degrees, blank_in_between}) {
    const std::string path = file("points.csv", content);
    const auto whole = load_points(path);
    ASSERT_TRUE(whole) << to_string(whole.error());
    for (const std::size_t bytes : {1U, 100U, 1000U, 1U << 20U}) {
      const auto streamed = stream(path, {}, bytes);
      ASSERT_TRUE(streamed) << to_string(streamed.error());
      EXPECT_EQ(*streamed, whole->points) << bytes;
    }
  }
}

TEST_F(StreamedPoints, ErrorsSayWhereInTheFile) {
  std::string text = "x_m,y_m,z_m\n";
  for (int row = 0; row < 200; ++row) text += "1,2,3\n";
  const std::string path = file("points.csv", text + "4,five,6\n");
  const auto whole = load_points(path);
  ASSERT_FALSE(whole);
  EXPECT_EQ(whole.error().location.line, 202U);
  for (const std::size_t bytes : {1U, 64U, 10'000U}) {
    const Error error = error_of(path, {}, bytes);
    EXPECT_EQ(error.code, whole.error().code);
    EXPECT_EQ(error.location.line, 202U) << bytes;
    EXPECT_EQ(error.location.column, 2U);
    EXPECT_EQ(error.location.source, path);
  }
  // What another block would read otherwise is an error, too.
  const Error wider = error_of(file("wider.csv", text + "4,5,6,7\n4,5,6,7\n"), {}, 64);
  EXPECT_EQ(wider.code, ErrorCode::kColumnCount);
  EXPECT_EQ(wider.location.line, 202U);
}

TEST_F(StreamedPoints, OfArraysLieInTheFile) {
  std::vector<double> numbers;
  for (int index = 0; index < 300; ++index) numbers.push_back(0.5 * index);
  const std::string bytes(reinterpret_cast<const char*>(numbers.data()),
                          numbers.size() * sizeof(double));
  const std::string path = file("points.bin", bytes);
  auto opened = PointStream::open(path, in_metres());
  ASSERT_TRUE(opened);
  const auto view = opened->in_place();
  ASSERT_TRUE(view);
  const auto whole = load_points(path, in_metres());
  ASSERT_EQ(view->size(), 100U);
  for (std::size_t index = 0; index < 100; ++index) EXPECT_EQ((*view)[index], whole->points[index]);
  // In degrees they are turned into metres.
  LoadOptions degrees;
  degrees.frame = Frame::kWgs84;
  numbers.assign(numbers.size(), 8.0);
  const std::string geographic =
      file("places.bin", {reinterpret_cast<const char*>(numbers.data()), bytes.size()});
  const auto opened_places = PointStream::open(geographic, degrees);
  ASSERT_TRUE(opened_places);
  EXPECT_FALSE(opened_places->in_place());
  const auto streamed = stream(geographic, degrees, 240);
  const auto places = load_points(geographic, degrees);
  ASSERT_TRUE(streamed);
  EXPECT_EQ(*streamed, places->points);
}

TEST_F(StreamedPoints, AskForWhatOnlyAllValuesCouldTell) {
  EXPECT_EQ(error_of(file("bare.csv", "1,2,3\n"), {}, 100).code, ErrorCode::kUnknownFrame);
  EXPECT_EQ(error_of(file("axes.csv", "x,y,z\n1,2,3\n"), {}, 100).code, ErrorCode::kUnknownFrame);
  const auto said = stream(file("bare.csv", "1,2,3\n"), in_metres(), 100);
  ASSERT_TRUE(said);
  EXPECT_EQ(said->size(), 1U);
  EXPECT_EQ(error_of(file("ids.csv", "id,x_m,y_m,z_m\na,2,3,4\n"), {}, 100).code,
            ErrorCode::kUnsupportedFormat);
  EXPECT_EQ(error_of(file("packed.gz", "\x1f\x8b..."), {}, 100).code,
            ErrorCode::kUnsupportedFormat);
  EXPECT_EQ(error_of(file("empty.csv", ""), {}, 100).code, ErrorCode::kNoPoints);
  EXPECT_EQ(error_of((folder_ / "missing").string(), {}, 100).code, ErrorCode::kCannotOpen);
}

}  // namespace
}  // namespace beespace::io
