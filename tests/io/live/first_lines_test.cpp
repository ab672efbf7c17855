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

TEST(FirstLines, CommentsArePassedOver) {
  const std::vector<Point> expected = {{1, 2, 3}, {4, 5, 6}};
  for (const char* text :
       {"# my bees\nx,y,z\n1,2,3\n4,5,6\n", "x,y,z\n1,2,3\n# in between\n4,5,6\n",
        "x,y,z\n1,2,3\n4,5,6\n# end\n", "# one\n\n# two, three\n# x,y,z\n# four\n1,2,3\n4,5,6\n",
        "# x y z\n# of 2 robots\n1 2 3\n#\n4 5 6\n", "#\n1,2,3\n  # indented\n4,5,6"}) {
    const auto loaded = load_text(text, in_metres());
    EXPECT_EQ(points_of(loaded), expected) << text;
    LoadOptions few_bytes = in_metres();
    few_bytes.threads = 2;
    EXPECT_EQ(points_of(load_text(text, few_bytes)), expected) << text;
  }
}

TEST(FirstLines, CommentsAreLinesAndNoRecords) {
  expect_error(load_text("# my bees\nx,y,z\n1,2,3\n# more\n4,oops,6\n", in_metres()),
               {ErrorCode::kNotANumber, "bees.csv:5:2", "'oops'"});
  const auto loaded = load_text("# a\nid,x,y,z\n# b\nfirst,1,2,3\n# c\nsecond,4,5,6\n");
  ASSERT_TRUE(loaded);
  std::vector<std::string> ids;
  for_each_record(loaded.value(), {0, 1}, [&](const Record& record) {
    ids.emplace_back(record.id);
    EXPECT_EQ(record.row, ids.size() - 1);
  });
  EXPECT_EQ(ids, (std::vector<std::string>{"first", "second"}));
}

TEST(FirstLines, WhatCouldBeARecordIsNoComment) {
  expect_error(load_text("# 4,5,6\n1,2,3\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:1", "a comment, or a record? '# 4,5,6'"});
  expect_error(load_text("# x,y,z\n# 4,5,6\n1,2,3\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:2", "a comment, or a record?"});
  expect_error(load_text("x,y,z\n1,2,3\n#4,5,6\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "a comment, or a record?"});
  expect_error(load_text("id,x,y,z\na,1,2,3\n#b;1;2;3\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:3", "a comment, or a record?"});
  expect_error(load_text("1 2 3\n# b 1 2\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:2", "a comment, or a record?"});
  EXPECT_EQ(points_of(load_text("1 2 3\n# 3 bees at 4 Hz\n", in_metres())).size(), 1u);
  expect_error(load_text("id,x,y,z\n#1,1,2,3\n#2,1,2,4\n", in_metres()),
               {ErrorCode::kMalformedRecord, "bees.csv:2", "let no id begin with #"});
}

TEST(FirstLines, ACommentThatMayNameTheColumnsMustDoSo) {
  expect_error(load_text("# lon lat\n8 47 500\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:1", "seems to name the columns"});
  expect_error(load_text("# x y z\n# m m m\n1 2 3\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:2", "and so may one before it"});
  expect_error(load_text("# nothing\n# but comments\n"),
               {ErrorCode::kNoPoints, "bees.csv", "no record after it"});
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
