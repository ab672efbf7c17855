#include "io/problems/skipped_records.hpp"
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

LoadOptions skipping() {
  LoadOptions options;
  options.skip_bad = true;
  return options;
}

TEST(SkipBad, LeavesBadRecordsOutAndListsThem) {
  const auto loaded =
      load_text("x,y,z\n1,2,3\nfoo,2,3\n\n4,5\n4,5,6\n7,nan,9\n7,\"8,9\n7,8,9\n", skipping());
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  EXPECT_EQ(loaded.value().skipped_count, 4u);
  ASSERT_EQ(loaded.value().skipped.size(), 4u);
  EXPECT_EQ(to_string(loaded.value().skipped[0]).substr(0, 14), "bees.csv:3:1: ");
  EXPECT_EQ(loaded.value().skipped[1].code, ErrorCode::kColumnCount);
  EXPECT_EQ(loaded.value().skipped[1].location.line, 5u);
  EXPECT_EQ(loaded.value().skipped[2].code, ErrorCode::kNotFinite);
  EXPECT_EQ(loaded.value().skipped[3].code, ErrorCode::kMalformedRecord);
  EXPECT_EQ(loaded.value().skipped[3].location.record, 5u);
}

TEST(SkipBad, IdsStayTheDataRowsOfTheFile) {
  const auto loaded =
      load_text("x,y,z\n1,2,3\nfoo,2,3\n4,5,6\nbar,2,3\nbaz,2,3\n7,8,9\n", skipping());
  std::vector<std::uint64_t> rows;
  std::vector<std::string> texts;
  ASSERT_EQ(points_of(loaded).size(), 3u);
  for_each_record(loaded.value(), {0, 1, 2}, [&](const Record& record) {
    rows.push_back(record.row);
    texts.emplace_back(record.text);
  });
  EXPECT_EQ(rows, (std::vector<std::uint64_t>{0, 2, 5}));
  EXPECT_EQ(texts, (std::vector<std::string>{"1,2,3", "4,5,6", "7,8,9"}));
}

TEST(SkipBad, PositionsOutOfRangeAreBadToo) {
  const auto loaded = load_text("lon,lat,alt\n1,2,3\n1,95,3\nx,2,3\n1,2,9e9\n4,5,6\n", skipping());
  EXPECT_EQ(points_of(loaded).size(), 2u);
  ASSERT_EQ(loaded.value().skipped.size(), 3u);
  EXPECT_EQ(loaded.value().skipped[0].code, ErrorCode::kInvalidLatitude);
  EXPECT_EQ(loaded.value().skipped[0].location.line, 3u);
  EXPECT_EQ(loaded.value().skipped[1].code, ErrorCode::kNotANumber);
  EXPECT_EQ(loaded.value().skipped[2].code, ErrorCode::kInvalidHeight);
  EXPECT_EQ(loaded.value().skipped[2].location.line, 5u);
}

TEST(SkipBad, PositionsOutOfRangeAreBadWhenTheValuesDecideTheFrame) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += "-175." + std::to_string(500 + i) + ",6.3," + std::to_string(1000 * i) + "\n";
  }
  text += "-175.5,oops,1\n-175.5,6.3,5000000\n";
  const auto loaded = load_text(text, skipping());
  EXPECT_EQ(points_of(loaded).size(), 100u);
  EXPECT_EQ(loaded.value().frame, Frame::kWgs84);
  ASSERT_EQ(loaded.value().skipped.size(), 2u);
  EXPECT_EQ(loaded.value().skipped[1].location.line, 102u);
  EXPECT_EQ(loaded.value().skipped[1].location.record, 101u);
}

TEST(SkipBad, ListsTheFirstTwentyAndCountsAll) {
  std::string text = "x,y,z\n1,2,3\n";
  for (int i = 0; i < 1000; ++i) text += "bad,2,3\n";
  const auto loaded = load_text(text, skipping());
  ASSERT_EQ(points_of(loaded).size(), 1u);
  EXPECT_EQ(loaded.value().skipped_count, 1000u);
  EXPECT_EQ(loaded.value().skipped.size(), kMostSkippedListed);
}

TEST(SkipBad, TheListDoesNotAdviseWhatIsDoneAlready) {
  const std::string text = "x,y,z\n1,2,3\nfoo,2,3\n4,5\n7,nan,9\n1,2,\n";
  const auto loaded = load_text(text, skipping());
  ASSERT_EQ(points_of(loaded).size(), 1u);
  ASSERT_EQ(loaded.value().skipped.size(), 4u);
  for (const Error& error : loaded.value().skipped) {
    EXPECT_EQ(error.message.find("--skip-bad"), std::string::npos) << error.message;
  }
  EXPECT_NE(load_text(text).error().message.find("--skip-bad"), std::string::npos);
}

TEST(SkipBad, NothingLeftIsAnError) {
  expect_error(load_text("x,y,z\na,b,c\n", skipping()),
               {ErrorCode::kNoPoints, "bees.csv", "the only record is bad: 'a' is not"});
}

}  // namespace
}  // namespace beespace::io
