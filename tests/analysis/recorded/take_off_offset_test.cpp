#include "analysis/recorded/take_off_offset.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace beespace::analysis {
namespace {

// Up from there at 1 m/s.
std::vector<Fix> climb(double begins_s, double ground_m) {
  return {{begins_s - 5.0, {0, 0, ground_m}},
          {begins_s, {0, 0, ground_m}},
          {begins_s + 10.0, {0, 0, ground_m + 10.0}}};
}

using Fixes = std::vector<Fix>;

std::vector<TakeOffOffset> offsets_of(const std::vector<std::pair<Fixes, Fixes>>& bees,
                                      std::size_t in_air = 0) {
  std::vector<SetAndFlownFixes> all;
  for (const auto& [set, flown] : bees) all.push_back({set, flown, all.size() >= in_air});
  return take_off_offsets(all);
}

TEST(TakeOffOffset, IsTheMiddleOfThoseThatAgree) {
  const auto offsets = offsets_of({{climb(5, 0), climb(1005.2, 102)},
                                   {climb(8, 0), climb(1008.3, 102)},
                                   {climb(9, 0), climb(1009.4, 103)}});
  ASSERT_EQ(offsets.size(), 1u);
  EXPECT_NEAR(offsets[0].seconds, 1000.3, 1e-9);
  EXPECT_EQ(offsets[0].bees, 3u);
}

TEST(TakeOffOffset, IsNoneWhereTheyDoNotAgreeOrNoneTakesOff) {
  EXPECT_TRUE(offsets_of({{climb(5, 0), climb(1005, 0)}, {climb(5, 0), climb(1020, 0)}}).empty());
  EXPECT_TRUE(offsets_of({{climb(5, 0), {{0, {0, 0, 9}}, {60, {0, 0, 9}}}}}).empty());
  EXPECT_TRUE(offsets_of({}).empty());
}

// Who flies already when it is first heard of, and climbs later, does not take off.
TEST(TakeOffOffset, IsNothingThatTheFewSayWhoBeginOnTheGround) {
  EXPECT_TRUE(offsets_of({{climb(5, 0), climb(1005, 20)},
                          {climb(5, 0), climb(1005, 20)},
                          {climb(5, 0), climb(1005, 0)}},
                         2)
                  .empty());
  EXPECT_EQ(offsets_of({{climb(5, 0), climb(1005, 20)},
                        {climb(5, 0), climb(1005, 0)},
                        {climb(5, 0), climb(1005, 0)}},
                       1)
                .size(),
            1u);
}

// Up 10 m, and down again after a minute.
Fixes flight(double begins_s) {
  Fixes fixes = climb(begins_s, 0);
  fixes.push_back({begins_s + 60.0, {0, 0, 10}});
  fixes.push_back({begins_s + 70.0, {0, 0, 0}});
  return fixes;
}

TEST(TakeOffOffset, IsOneOfEachFlight) {
  Fixes twice = flight(1005);
  const Fixes again = flight(2005);
  twice.insert(twice.end(), again.begin(), again.end());
  const auto offsets = offsets_of({{flight(5), twice}, {flight(5), twice}});
  ASSERT_EQ(offsets.size(), 2u);
  EXPECT_NEAR(offsets[0].seconds, 1000.0, 1e-9);
  EXPECT_NEAR(offsets[1].seconds, 2000.0, 1e-9);
  // What is set to land between and take off again is one.
  Fixes set = flight(5);
  const Fixes set_again = flight(1005);
  set.insert(set.end(), set_again.begin(), set_again.end());
  EXPECT_EQ(offsets_of({{set, twice}}).size(), 1u);
}

}  // namespace
}  // namespace beespace::analysis
