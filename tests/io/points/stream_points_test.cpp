// Points block after block: the same as all at once, and errors where they are.
#include "io/stream_points.hpp"

#include "io/bytes/gzip_stream.hpp"
#include "io/load_points.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <string_view>
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

  // The same, compressed in so many members.
  std::string packed(const std::string& name, const std::string& content,
                     std::size_t members = 1) const {
    std::string all;
    const std::size_t size = content.size() / members + 1;
    for (std::size_t begin = 0; begin < content.size(); begin += size) {
      GzipStream gzip;
      const auto keep = [&](std::string_view bytes) { all += bytes; };
      gzip.write(std::string_view(content).substr(begin, size), keep);
      gzip.finish(keep);
    }
    return file(name, all);
  }

  static Result<std::vector<Point>> stream(const std::string& path, const LoadOptions& options,
                                           std::size_t block_bytes) {
    auto stream = PointStream::open(path, options, block_bytes);
    if (!stream) return stream.error();
    std::vector<Point> all;
    for (;;) {
      const auto block = stream->next();
      if (!block) return block.error();
      if (!*block) return all;
      EXPECT_EQ(stream->row(), all.size());
      all.insert(all.end(), (*block)->points.begin(), (*block)->points.end());
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
  // A record that another layout would fit, too.
  const Error wider = error_of(file("wider.csv", text + "4,5,6,7\n4,5,6,7\n"), {}, 64);
  EXPECT_EQ(wider.code, ErrorCode::kColumnCount);
  EXPECT_EQ(wider.location.line, 202U);
  EXPECT_EQ(wider.location.record, 200U);
  // The same of compressed bytes, counted as they are unpacked.
  EXPECT_EQ(error_of(packed("points.csv.gz", text + "4,five,6\n", 3), {}, 64).location.line, 202U);
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
  const auto said = stream(file("bare.csv", "1,2,3\n"), in_metres(), 100);
  ASSERT_TRUE(said);
  EXPECT_EQ(said->size(), 1U);
  EXPECT_EQ(error_of(file("empty.csv", ""), {}, 100).code, ErrorCode::kNoPoints);
  EXPECT_EQ(error_of((folder_ / "missing").string(), {}, 100).code, ErrorCode::kCannotOpen);
}

// Plain x, y and z are metres, unless all values together look like degrees: no block alone tells.
TEST_F(StreamedPoints, OfPlainAxesAreMetresUnlessValuesContradict) {
  std::string pillar = "x,y,z\n";
  for (int row = 0; row < 100; ++row) {
    pillar += "8.00" + std::to_string(row) + ",47.00" + std::to_string(row) + "," +
              std::to_string(100 * row) + "\n";
  }
  std::string swarm = pillar + "-300,20,5\n";
  const std::string flat = "x,y\n8.5,47.25\n8.75,47.5\n";
  for (const std::size_t bytes : {64U, 1U << 20U}) {
    EXPECT_FALSE(load_points(file("pillar.csv", pillar)));
    EXPECT_EQ(error_of(file("pillar.csv", pillar), {}, bytes).code, ErrorCode::kUnknownFrame);
    EXPECT_EQ(error_of(file("flat.csv", flat), {}, bytes).code, ErrorCode::kUnknownFrame);
    const std::string path = file("swarm.csv", swarm);
    const auto whole = load_points(path);
    const auto streamed = stream(path, {}, bytes);
    ASSERT_TRUE(whole) << to_string(whole.error());
    ASSERT_TRUE(streamed) << to_string(streamed.error());
    EXPECT_EQ(*streamed, whole->points);
  }
}

TEST_F(StreamedPoints, ComeWithTheirRecords) {
  std::string text = "id;x_m;y_m;z_m\n";
  for (int row = 0; row < 100; ++row) {
    text += "\"bee " + std::to_string(row) + ";\"\";\";" + std::to_string(row) + ";2;3\n";
  }
  for (const std::string& path : {file("ids.csv", text), packed("ids.csv.gz", text)}) {
    auto stream = PointStream::open(path, {}, 200);
    ASSERT_TRUE(stream) << to_string(stream.error());
    ASSERT_NE(stream->table(), nullptr);
    EXPECT_EQ(stream->table()->header, "id;x_m;y_m;z_m");
    EXPECT_NEAR(static_cast<double>(stream->likely_size().value_or(0)), 100.0, 10.0);
    int row = 0;
    for (;;) {
      const auto block = stream->next();
      ASSERT_TRUE(block);
      if (!*block) break;
      std::vector<PointId> all((*block)->points.size());
      std::iota(all.begin(), all.end(), PointId{0});
      for_each_record(**block, all, [&](const Record& record) {
        EXPECT_EQ(record.id, "bee " + std::to_string(row) + ";\";");
        EXPECT_TRUE(record.text.ends_with(";" + std::to_string(row) + ";2;3"));
        ++row;
      });
    }
    EXPECT_EQ(row, 100);
  }
}

TEST_F(StreamedPoints, OfCompressedArraysToo) {
  std::vector<double> numbers;
  for (int index = 0; index < 3000; ++index) numbers.push_back(0.5 * index + 0.25);
  const std::string bytes(reinterpret_cast<const char*>(numbers.data()),
                          numbers.size() * sizeof(double));
  const std::string header = npy_header_for(ArrayLayout{}, 1000);
  for (const bool npy : {true, false}) {
    const std::string before = npy ? header : "";
    const std::string name = npy ? "points.npy.gz" : "points.bin.gz";
    const std::string path = packed(name, before + bytes, 2);
    const auto whole = load_points(path, in_metres());
    ASSERT_TRUE(whole) << to_string(whole.error());
    for (const std::size_t block : {1U, 1000U, 1U << 20U}) {
      const auto streamed = stream(path, in_metres(), block);
      ASSERT_TRUE(streamed) << to_string(streamed.error());
      EXPECT_EQ(*streamed, whole->points);
    }
    // Too little, and too much.
    const std::string less = before + bytes.substr(0, bytes.size() - 5);
    EXPECT_EQ(error_of(packed(name, less), in_metres(), 1000).code, ErrorCode::kTruncated);
    const auto more = npy ? ErrorCode::kCorrupt : ErrorCode::kTruncated;
    EXPECT_EQ(error_of(packed(name, before + bytes + "12345"), in_metres(), 1000).code, more);
  }
  // Numbers that are none are told with their record.
  numbers[2000] = std::numeric_limits<double>::quiet_NaN();
  const std::string bad(reinterpret_cast<const char*>(numbers.data()), bytes.size());
  EXPECT_EQ(error_of(packed("bad.npy.gz", header + bad), in_metres(), 240).location.record, 666U);
  std::string columns = header;
  columns.replace(columns.find("False,"), 6, "True, ");
  EXPECT_EQ(error_of(packed("columns.npy.gz", columns + bytes), in_metres(), 240).code,
            ErrorCode::kUnsupportedFormat);
  const auto in_file = stream(file("columns.npy", columns + bytes), in_metres(), 240);
  ASSERT_TRUE(in_file) << to_string(in_file.error());
  EXPECT_EQ((*in_file)[1], (Point{0.75, 500.75, 1000.75}));
}

// A part of an answer would be an all-clear for the rest.
TEST_F(StreamedPoints, OfDamagedFilesAreAnError) {
  std::string text = "x_m,y_m,z_m\n";
  for (int row = 0; row < 20'000; ++row) text += std::to_string(row * 7919 % 10'007) + ",2,3\n";
  const std::string whole = packed("whole.csv.gz", text, 2);
  ASSERT_TRUE(stream(whole, {}, 1000));
  std::string bytes;
  {
    std::ifstream in(whole, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), {});
  }
  for (const std::size_t less : {std::size_t{1}, std::size_t{8}, bytes.size() / 4}) {
    const std::string cut = bytes.substr(0, bytes.size() - less);
    EXPECT_EQ(error_of(file("cut.csv.gz", cut), {}, 1000).code, ErrorCode::kTruncated) << less;
  }
  std::string damaged = bytes;
  damaged[bytes.size() / 2] = static_cast<char>(damaged[bytes.size() / 2] ^ 0x10);
  EXPECT_EQ(error_of(file("damaged.csv.gz", damaged), {}, 1000).code, ErrorCode::kCorrupt);
  EXPECT_EQ(error_of(file("more.csv.gz", bytes + "more"), {}, 1000).code, ErrorCode::kCorrupt);
  EXPECT_TRUE(stream(file("padded.csv.gz", bytes + std::string(700'000, '\0')), {}, 1000));
  EXPECT_EQ(error_of(packed("twice.csv.gz", bytes), {}, 1000).code, ErrorCode::kUnsupportedFormat);
}

TEST_F(StreamedPoints, OfAFileThatIsWrittenToAreAnError) {
  std::string text = "x_m,y_m,z_m\n";
  for (int row = 0; row < 400'000; ++row) text += "1,2,3\n";
  const std::string path = file("points.csv", text);
  auto growing = PointStream::open(path, {}, 1000);
  ASSERT_TRUE(growing);
  std::ofstream(path, std::ios::app) << "4,5,6\n";
  Status status = std::monostate{};
  for (bool more = true; more;) {
    auto block = growing->next();
    more = block && *block;
    if (!block) status = block.error();
  }
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().code, ErrorCode::kReadFailed);
  EXPECT_EQ(status.error().location.source, path);
  // Points that are searched where they are, too.
  const std::string array = file("points.bin", std::string(2400, '\0'));
  const auto mapped = PointStream::open(array, in_metres());
  ASSERT_TRUE(mapped);
  ASSERT_TRUE(mapped->in_place());
  EXPECT_TRUE(mapped->check_unchanged());
  std::ofstream(array, std::ios::app) << std::string(24, '\0');
  EXPECT_EQ(mapped->check_unchanged().error().code, ErrorCode::kReadFailed);
}

}  // namespace
}  // namespace beespace::io
