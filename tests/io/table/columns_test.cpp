// --columns: what is chosen is chosen, and what contradicts itself is refused.
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

TEST(Columns, TheChosenIdIsNoHeight) {
  const auto loaded = load_text("num,lon,lat\n7,-75.5,6.3\n8,-75.5,6.3\n", with_columns("id=num"));
  ASSERT_EQ(points_of(loaded).size(), 2u);
  EXPECT_TRUE(has_id_column(loaded.value()));
  EXPECT_EQ(loaded.value().notes[0], "no height column: every height is taken as 0 m");
}

TEST(Columns, OneColumnUnderTwoNamesIsStillOneColumn) {
  expect_error(load_text("X,b,c\n1,2,3\n", with_columns("x=1,y=X")),
               {ErrorCode::kInvalidArgument, "bees.csv", "column 1 cannot be both x and y"});
}

TEST(Columns, BlankWishesAreRefused) {
  expect_error(load_text("x,y,z\n1,2,3\n", with_columns(" ")),
               {ErrorCode::kInvalidArgument, "bees.csv", "--columns: it is empty"});
}

TEST(Columns, AContradictingFrameIsRefused) {
  auto options = with_columns("lon=1,lat=2");
  options.frame = Frame::kMetres;
  expect_error(load_text("1,2,3\n", options),
               {ErrorCode::kInvalidArgument, "bees.csv", "--crs metres is given too"});
  options = with_columns("x=1,y=2");
  options.frame = Frame::kWgs84;
  expect_error(load_text("1,2,3\n", options),
               {ErrorCode::kInvalidArgument, "bees.csv", "--crs wgs84 is given too"});
}

TEST(Columns, ANameThatStandsTwiceNeedsItsNumber) {
  expect_error(load_text("a,b,a\n1,2,3\n", with_columns("x=a,y=b")),
               {ErrorCode::kMissingColumn, "bees.csv:1", "x=1 or x=3"});
  EXPECT_EQ(points_of(load_text("a,b,A\n1,2,3\n", with_columns("x=A,y=b"))),
            (std::vector<Point>{{3, 2, 0}}));
  expect_error(load_text("Ä,b,ä\n1,2,3\n", with_columns("y=b,x=a")),
               {ErrorCode::kMissingColumn, "bees.csv:1", "no column named 'a'"});
}

TEST(Columns, TheAdviceHasTheNumbersOfTheTable) {
  expect_error(load_text("alt,lat,foo,bar\n1,2,3,4\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "--columns lon=3,lat=2,height=1"});
  expect_error(load_text("1\n2\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "there is 1 column and no header"});
}

}  // namespace
}  // namespace beespace::io
