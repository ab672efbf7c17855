// What a long stage says it will take yet.
#include "cli/console/progress_bar.hpp"

#include <gtest/gtest.h>

namespace beespace::cli {
namespace {

TEST(TimeLeft, GoesByThePaceSoFar) {
  EXPECT_EQ(left_text(0.5, 10.0), ", about 10 s left");
  EXPECT_EQ(left_text(0.25, 100.0), ", about 5 min left");
  EXPECT_EQ(left_text(0.9, 2.0), ", about 1 s left");
  EXPECT_EQ(left_text(0.01, 100.0), ", about 2 h 45 min left");
}

TEST(TimeLeft, IsNotGuessed) {
  EXPECT_EQ(left_text(0.5, 0.9), "");
  EXPECT_EQ(left_text(0.0, 100.0), "");
  EXPECT_EQ(left_text(0.009, 100.0), "");
  EXPECT_EQ(left_text(-1.0, 100.0), "");
  EXPECT_EQ(left_text(1.0, 100.0), "");
}

}  // namespace
}  // namespace beespace::cli
