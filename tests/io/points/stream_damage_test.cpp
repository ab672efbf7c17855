// Points block after block, of inputs that are damaged at random: what the whole is refused for is
// never taken in blocks, and the points and what is left out are the same.
#include "io/bytes/gzip_stream.hpp"
#include "io/load_points.hpp"
#include "io/points/array_layout.hpp"
#include "io/stream_points.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

// A file as it is read in blocks: all of it.
struct Streamed {
  std::vector<Point> points = {};
  std::vector<std::uint64_t> skipped = {};
  Frame frame = Frame::kAuto;
};

Result<Streamed> streamed(const std::string& path, const LoadOptions& options, std::size_t bytes) {
  auto stream = PointStream::open(path, options, bytes);
  if (!stream) return stream.error();
  Streamed all;
  all.frame = stream->facts().frame;
  for (;;) {
    const auto block = stream->next();
    if (!block) return block.error();
    if (!*block) return all;
    const auto& points = (*block)->points;
    all.points.insert(all.points.end(), points.begin(), points.end());
    for (const std::uint64_t row : skipped_rows(**block)) {
      all.skipped.push_back(stream->row() + row);
    }
  }
}

std::string compressed(std::string_view content) {
  std::string all;
  GzipStream gzip;
  const auto keep = [&](std::string_view bytes) { all += bytes; };
  gzip.write(content, keep);
  gzip.finish(keep);
  return all;
}

std::vector<std::string> seeds() {
  std::vector<std::string> seeds;
  std::string table = "id;longitude;latitude;height_ft\r\n";
  std::string bare = "x,y,z\n";
  for (int row = 0; row < 40; ++row) {
    const std::string number = std::to_string(row);
    table += "\"b;" + number + "\";8." + number + ";47.5;" + number + "00\r\n";
    bare += number + ".5,-" + number + "0,3e2\n";
  }
  std::vector<double> numbers;
  for (int index = 0; index < 120; ++index) numbers.push_back(1.5 * index);
  const std::string raw(reinterpret_cast<const char*>(numbers.data()), 8 * numbers.size());
  const std::string npy = npy_header_for(ArrayLayout{}, 40) + raw;
  const std::string no_header = bare.substr(6);
  seeds = {table, bare, no_header, "\n\n" + bare + "\n\n", npy, raw};
  return seeds;
}

class DamagedStreams : public testing::Test {
 protected:
  ~DamagedStreams() override { std::filesystem::remove_all(folder_); }

  std::string damaged(std::string content) {
    const std::size_t times = random_() % 4;
    for (std::size_t time = 0; time < times && !content.empty(); ++time) {
      const std::size_t at = random_() % content.size();
      switch (random_() % 4) {
        case 0:
          content[at] = static_cast<char>(random_() % 256);
          break;
        case 1:
          content.erase(at, random_() % 20);
          break;
        case 2:
          content.insert(at, std::string_view(",\n;x9.-e\"").substr(random_() % 9, 2));
          break;
        default:
          content.resize(at);
      }
    }
    return content;
  }

  LoadOptions some_options() {
    LoadOptions options;
    options.frame = static_cast<Frame>(random_() % 3);
    options.skip_bad = random_() % 2 == 0;
    options.threads = 1;
    return options;
  }

  std::mt19937_64 random_{11};
  std::string folder_ = [] {
    std::string name = (std::filesystem::temp_directory_path() / "damaged-XXXXXX").string();
    return std::string(::mkdtemp(name.data()));
  }();
};

TEST_F(DamagedStreams, AreTakenAsTheWholeIsOrNotAtAll) {
  std::size_t taken = 0;
  std::size_t refused = 0;
  const std::vector<std::string> all = seeds();
  for (int round = 0; round < 4'000; ++round) {
    const std::size_t which = random_() % all.size();
    const bool packs = random_() % 3 == 0;
    std::string content = damaged(all[which]);
    if (packs) content = compressed(content);
    if (packs && random_() % 4 == 0) content = damaged(content);
    const std::string path =
        folder_ + (which + 1 == all.size() ? "/points.bin" : "/points.csv") + (packs ? ".gz" : "");
    std::ofstream(path, std::ios::binary) << content;
    const LoadOptions options = some_options();
    const auto whole = load_points(path, options);
    const auto parts = streamed(path, options, 1 + random_() % 300);
    SCOPED_TRACE("round " + std::to_string(round) + " of seed " + std::to_string(which));
    if (!parts) {
      ++refused;
      const ErrorCode code = parts.error().code;
      // What only all values together could tell, and arrays with records to leave out.
      const bool may = code == ErrorCode::kUnknownFrame || code == ErrorCode::kInvalidArgument;
      EXPECT_TRUE(!whole || may) << to_string(parts.error());
      // How long the input is, is known at its end only: another fault may come before.
      const bool of_end = !whole && (whole.error().code == ErrorCode::kTruncated ||
                                     whole.error().code == ErrorCode::kCorrupt);
      if (!whole && !may && !of_end) {
        EXPECT_EQ(to_string(parts.error()), to_string(whole.error()));
      }
      continue;
    }
    ++taken;
    ASSERT_TRUE(whole) << to_string(whole.error());
    EXPECT_EQ(parts->points, whole->points);
    EXPECT_EQ(parts->frame, whole->frame);
    const auto skipped = skipped_rows(*whole);
    EXPECT_EQ(parts->skipped, std::vector<std::uint64_t>(skipped.begin(), skipped.end()));
  }
  EXPECT_GT(taken, 800U);
  EXPECT_GT(refused, 800U);
}

}  // namespace
}  // namespace beespace::io
