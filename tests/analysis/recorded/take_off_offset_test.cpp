#include "analysis/recorded/take_off_offset.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace::analysis {
namespace {

// Up from there at 1 m/s.
std::vector<Fix> climb(double begins_s, double ground_m) {
  return {{begins_s - 5.0, {0, 0, ground_m}},
          {begins_s, {0, 0, ground_m}},
          {begins_s + 10.0, {0, 0, ground_m + 10.0}}};
}

TEST(TakeOffOffset, IsTheMiddleOfThoseThatAgree) {
  const auto offset = take_off_offset({{climb(5, 0), climb(1005.2, 102)},
                                       {climb(8, 0), climb(1008.3, 102)},
                                       {climb(9, 0), climb(1009.4, 103)}});
  ASSERT_TRUE(offset);
  EXPECT_NEAR(offset->seconds, 1000.3, 1e-9);
  EXPECT_EQ(offset->bees, 3u);
}

TEST(TakeOffOffset, IsNoneWhereTheyDoNotAgreeOrNoneTakesOff) {
  EXPECT_FALSE(take_off_offset({{climb(5, 0), climb(1005, 0)}, {climb(5, 0), climb(1020, 0)}}));
  EXPECT_FALSE(take_off_offset({{climb(5, 0), {{0, {0, 0, 9}}, {60, {0, 0, 9}}}}}));
  EXPECT_FALSE(take_off_offset({}));
}

}  // namespace
}  // namespace beespace::analysis
