#include "analysis/recorded/matching_numbers.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

using Names = std::vector<std::string>;
using Found = std::vector<std::optional<std::size_t>>;

TEST(MatchingNumbers, AreThoseThatDifferFromNameToName) {
  const Names show = {"Drone 1", "Drone 2", "Drone 10"};
  EXPECT_EQ(match_by_numbers(Names{"10", "2"}, show), (Found{2, 1}));
  EXPECT_EQ(match_by_numbers(Names{"drone02_00000042", "drone10_00000042"}, show), (Found{1, 2}));
  EXPECT_EQ(match_by_numbers(Names{"uav 7", "uav 1"}, show), (Found{std::nullopt, 0}));
}

TEST(MatchingNumbers, AreNoneWhereTheyDoNotTellAllApart) {
  const Names show = {"Drone 1", "Drone 2"};
  EXPECT_TRUE(match_by_numbers(Names{"a1_3", "a2_4"}, show).empty());  // which of the two?
  EXPECT_TRUE(match_by_numbers(Names{"a1", "b1"}, show).empty());
  EXPECT_TRUE(match_by_numbers(Names{"left", "right"}, show).empty());
  EXPECT_TRUE(match_by_numbers(Names{"1", "2 b 3"}, show).empty());
  EXPECT_TRUE(match_by_numbers(Names{}, show).empty());
}

}  // namespace
}  // namespace beespace::analysis
