#include "io/points/table_reading.hpp"

#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

struct Way {
  unsigned threads;
  bool fast_path;
  std::size_t piece_bytes;
};

const std::vector<Way> kWays = {{1, true, 1 << 18}, {1, false, 1 << 18}, {1, true, 7},
                                {1, false, 50},     {2, true, 64},       {5, true, 300},
                                {4, false, 20},     {3, true, 1}};

Result<TableContent> read(std::string_view text, const Way& way, bool skip_bad, Frame frame) {
  ColumnOptions columns;
  columns.frame = Frame::kMetres;
  const auto layout = find_layout(text, columns);
  if (!layout) return layout.error();
  TableOptions options;
  options.frame = frame;
  options.skip_bad = skip_bad;
  options.threads = way.threads;
  options.fast_path = way.fast_path;
  options.piece_bytes = way.piece_bytes;
  return read_table(text, layout.value(), options);
}

std::string described(const Result<TableContent>& content) {
  if (!content) return to_string(content.error());
  std::string text;
  for (const Point& point : content->points) {
    text += std::to_string(point.x) + " " + std::to_string(point.y) + " " +
            std::to_string(point.z) + "\n";
  }
  for (const std::uint64_t row : content->skipped.rows)
    text += "skipped " + std::to_string(row) + "\n";
  for (const Error& error : content->skipped.errors) text += to_string(error) + "\n";
  return text;
}

// Every way of reading gives what the first one gives: values bit for bit, lists and errors.
void expect_one_answer(std::string_view text) {
  for (const bool skip_bad : {false, true}) {
    for (const Frame frame : {Frame::kAuto, Frame::kMetres, Frame::kWgs84}) {
      const auto expected = read(text, kWays.front(), skip_bad, frame);
      for (const Way& way : kWays) {
        const auto found = read(text, way, skip_bad, frame);
        ASSERT_EQ(described(found), described(expected)) << text;
        if (!expected) continue;
        ASSERT_EQ(found->points, expected->points) << text;
        if (!expected->points.empty()) {
          ASSERT_EQ(found->extent.lowest, expected->extent.lowest);
          ASSERT_EQ(found->extent.highest, expected->extent.highest);
        }
      }
    }
  }
}

TEST(TableReading, PlainAndOddLinesGiveOneAnswerInEveryWay) {
  const std::vector<std::string> lines = {
      "1,2,3",
      "-1.5,2.25,-3.125",
      "1, 2, 3",
      "1,  2,3",
      " 1,2,3",
      "1,2,3 ",
      "1,2,3\r",
      "\"1\",2,3",
      "+1,2,3",
      "1e2,2,3",
      ".5,5.,-.5",
      "12345678,1,2",
      "1234567.12345678,1,2",
      "0.1234567890123456789,1,2",
      "9007199254740993,1,2",
      "7.123456789012345,1,2",
      "-0,-0.0,0",
      "1,2",
      "1,2,3,4",
      "1,2,",
      ",,",
      "a,2,3",
      "1,nan,3",
      "1,2,1e999",
      "1,2,3x",
      "1.2.3,4,5",
      "--1,2,3",
      "-,2,3",
      "1,91,3",
      "400,2,3",
      "1,2,2000000",
      "1,2,1e-300",
      "",
      "   ",
      "\"1,2,3",
      "1;2;3",
      "1 2 3",
      "0.00000000000000000000000000000000000000000001,1,1",
      "123456.12345678901,123456.12345678901,123456.12345678901"};
  for (const std::string& line : lines) {
    for (const std::size_t before : {0u, 1u, 30u}) {
      std::string text;
      for (std::size_t i = 0; i < before; ++i) text += "10.5,20.25,30\n";
      text += line + "\n";
      for (int i = 0; i < 30; ++i) text += "7.5,8.25,-9.125\n";
      expect_one_answer("x,y,z\n" + text);
    }
  }
}

TEST(TableReading, RandomTablesGiveOneAnswerInEveryWay) {
  std::mt19937_64 random(11);
  const std::string alphabet = "0123456789012345678901234567890123456789..--,,,,\n\n\n e\"+\r";
  for (int table = 0; table < 100; ++table) {
    std::string text = "x,y,z\n";
    const std::size_t size = random() % 600;
    for (std::size_t i = 0; i < size; ++i) {
      if (random() % 3 == 0) {
        text += std::to_string(random() % 1000) + "." + std::to_string(random() % 100000) + "," +
                std::to_string(random() % 80) + ",-" + std::to_string(random() % 100) + "\n";
      } else if (random() % 40 == 0) {
        text += alphabet[random() % alphabet.size()];
      }
    }
    expect_one_answer(text);
  }
}

TEST(TableReading, AnErrorInALaterPieceNeverHidesAnEarlierOne) {
  std::string text = "x,y,z\n";
  for (int i = 0; i < 3000; ++i) text += i % 1000 == 700 ? "1,oops,3\n" : "1,2,3\n";
  for (const unsigned threads : {1u, 2u, 8u}) {
    const auto content = read(text, {threads, true, 100}, false, Frame::kMetres);
    ASSERT_FALSE(content.has_value());
    EXPECT_EQ(content.error().location.line, 702u);
    EXPECT_EQ(content.error().location.record, 700u);
  }
}

TEST(TableReading, ThreadCountDoesNotChangePointsIdsOrLines) {
  std::string text = "id,x,y,z\n";
  for (int i = 0; i < 60'000; ++i) {
    const std::string number = std::to_string(i);
    text += 'b';
    text += number;
    text += ',';
    text += number;
    text += ".5,2,3\n";
    if (i % 1000 == 0) text += "\n";
  }
  LoadOptions options;
  const auto one = load_text(text, options);
  options.threads = 2;
  const auto two = load_text(text, options);
  options.threads = 0;
  const auto all = load_text(text, options);
  EXPECT_EQ(points_of(one), points_of(two));
  EXPECT_EQ(points_of(one), points_of(all));
  EXPECT_EQ(one.value().points.size(), 60'000u);
}

}  // namespace
}  // namespace beespace::io
