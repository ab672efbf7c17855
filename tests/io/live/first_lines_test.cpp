// The first lines decide how a table is read: damaged ones must not decide wrongly.
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

LoadOptions skipping_in_metres() {
  LoadOptions options = in_metres();
  options.skip_bad = true;
  return options;
}

TEST(FirstLines, ADamagedFirstRecordDoesNotThrowTheSwarmAway) {
  const std::string text = "1,2\n1,2,3\n1,2,4\n1,2,5\n";
  const auto loaded = load_text(text, skipping_in_metres());
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {1, 2, 4}, {1, 2, 5}}));
  EXPECT_EQ(loaded.value().skipped_count, 1u);
  expect_error(load_text(text, in_metres()),
               {ErrorCode::kColumnCount, "bees.csv:1", "2 columns where the table has 3"});
}

TEST(FirstLines, ValuesWithoutNumbersAreNoHeader) {
  for (const char* first : {"1O.5,1O.2,3O.3", "N/A,N/A,N/A", "1m,1m,2m", ",,", "-,-,-"}) {
    const std::string text = std::string(first) + "\n1,2,3\n3,4,5\n";
    expect_error(load_text(text, in_metres()),
                 {ErrorCode::kNotANumber, "bees.csv:1:1", "neither a number nor the name"});
    const auto loaded = load_text(text, skipping_in_metres());
    EXPECT_EQ(points_of(loaded).size(), 2u) << first;
    EXPECT_EQ(loaded.value().skipped_count, 1u) << first;
  }
}

TEST(FirstLines, AnUnhelpfulHeaderIsReported) {
  const auto loaded = load_text("\na,b,c\n1,2,3\n", in_metres());
  ASSERT_EQ(points_of(loaded).size(), 1u);
  ASSERT_EQ(loaded.value().notes.size(), 1u);
  EXPECT_EQ(loaded.value().notes[0], "line 2 is taken as the header: 'a,b,c'");
}

TEST(FirstLines, TheSignBeforeNamesIsLeftOut) {
  for (const char* text : {"# x y z\n1 2 3\n", "#x y z\n1 2 3\n", "# x,y,z\n1,2,3\n"}) {
    const auto loaded = load_text(text);
    EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}})) << text;
    if (loaded) {
      EXPECT_EQ(header_line(loaded.value()).front(), 'x') << text;
    }
  }
}

TEST(FirstLines, CommentsElsewhereAreNamed) {
  expect_error(load_text("# my bees\n1,2,3\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:1", "a comment line: '# my bees'"});
  expect_error(load_text("# 4,5,6\n1,2,3\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:1", "a comment line"});
  expect_error(load_text("x,y,z\n1,2,3\n# end\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "comments are not read"});
}

TEST(FirstLines, DecimalCommasBetweenBlanksAreNamed) {
  expect_error(load_text("1,5 2,5\n1,6 2,6\n", in_metres()),
               {ErrorCode::kNotANumber, "bees.csv:1:1", "decimals with a point"});
}

TEST(FirstLines, AVeryLongFirstLineIsReadToItsEnd) {
  const std::string filler(100'000, 'f');
  const std::string text = filler + ",x,y,z\nf,1,2,3\n" + filler + ",4,5,6\n";
  EXPECT_EQ(points_of(load_text(text)), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
}

}  // namespace
}  // namespace beespace::io
