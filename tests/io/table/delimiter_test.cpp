// What separates fields where several characters might.
#include "io/table/delimiter.hpp"

#include <gtest/gtest.h>

#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

TEST(Delimiter, TabsComeBeforeBlanksWhereEachLineHasAsMany) {
  // Nothing between two tabs, at an end too, and texts of two words.
  EXPECT_EQ(find_delimiter({"\tid\ttime_s\tx\ty\tz\tremark", "0\t1\t0.0\t-2.0\t0.0\t1.0\t",
                            "1\t1\t1.0\t-1.9\t0.0\t1.0\t"}),
            '\t');
  EXPECT_EQ(find_delimiter({"name\tx\ty\tz\tnote", "robot 1\t0\t0\t1\t", "robot 2\t0.2\t0\t1\t"}),
            '\t');
}

TEST(Delimiter, BlanksAreWhereTabsAreOnlyPadding) {
  EXPECT_EQ(find_delimiter({"1 2 3\t4", "5 6 7 8"}), ' ');
  EXPECT_EQ(find_delimiter({"a\t1 2 3 4", "b\t5 6 7 8"}), ' ');
  EXPECT_EQ(find_delimiter({"1 2 3", "4 5 6"}), ' ');
}

TEST(Delimiter, IsTheOneThatMakesTheMostNumbers) {
  EXPECT_EQ(find_delimiter({"id;x;y", "a;1,5;2,5"}), ';');
  EXPECT_EQ(find_delimiter({"id,x,y", "a b,1.5,2.5"}), ',');
}

}  // namespace
}  // namespace beespace::io
