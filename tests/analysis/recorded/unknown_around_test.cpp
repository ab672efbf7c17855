#include "analysis/recorded/unknown_around.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace beespace::analysis {
namespace {

Conflict lasting(double begins_s, double ends_s) {
  return {1, 3, begins_s, begins_s, ends_s, 1.0};
}

TEST(UnknownAround, IsWhatComesJustBeforeAndJustAfter) {
  const std::vector<Gap> unknown = {{0, 0.0, 100.0}, {1, 10.0, 20.0}, {3, 30.0, 40.0}};
  const auto before = [&](double begins_s) {
    return unknown_around(lasting(begins_s, 90.0), unknown).before;
  };
  const auto after = [&](double ends_s) {
    return unknown_around(lasting(1.0, ends_s), unknown).after;
  };
  EXPECT_FALSE(before(10.0)) << "it is known up to then";
  EXPECT_TRUE(before(15.0));
  EXPECT_TRUE(before(20.0)) << "it comes back in a conflict";
  EXPECT_FALSE(before(20.5));
  EXPECT_TRUE(before(40.0)) << "of the other one, too";
  EXPECT_TRUE(after(10.0)) << "it is lost in a conflict";
  EXPECT_TRUE(after(15.0));
  EXPECT_FALSE(after(20.0)) << "it is known from then on";
  EXPECT_TRUE(after(30.0));
  EXPECT_FALSE(unknown_around(lasting(5.0, 95.0), unknown).before);
  EXPECT_FALSE(unknown_around(lasting(5.0, 95.0), unknown).after);
}

TEST(UnknownAround, TimeInWhichEitherIsUnknownCountsOnce) {
  const std::vector<Gap> unknown = {
      {1, 0.0, 10.0}, {1, 20.0, 30.0}, {2, 0.0, 1000.0}, {3, 5.0, 12.0}, {3, 22.0, 24.0}};
  EXPECT_EQ(unknown_of_pair_s(1, 3, unknown), 22.0);
  EXPECT_EQ(unknown_of_pair_s(0, 3, unknown), 9.0);
  EXPECT_EQ(unknown_of_pair_s(0, 4, unknown), 0.0);
}

}  // namespace
}  // namespace beespace::analysis
