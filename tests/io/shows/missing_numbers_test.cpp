// Numbers that are not there are told, where all the others are; other names are left alone.
#include "io/recording/missing_numbers.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

std::string note_of(const std::vector<std::string>& ids) {
  std::vector<RecordedBee> bees(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) bees[i].id = ids[i];
  return missing_numbers_note(bees).value_or("");
}

TEST(MissingNumbers, AreTold) {
  EXPECT_EQ(note_of({"Drone 1", "Drone 3", "Drone 5", "Drone 4"}),
            "drones are numbered from 1 to 5 without 2: if one was left out, nothing is known of "
            "that drone");
  std::vector<std::string> ids;
  for (int i = 1; i <= 40; ++i) {
    if (i % 4 != 2) ids.push_back("d" + std::to_string(i));
  }
  EXPECT_NE(note_of(ids).find("from 1 to 40 without 2, 6, 10, 14, 18, …:"), std::string::npos);
}

TEST(MissingNumbers, AreNotTheUsualNames) {
  EXPECT_EQ(note_of({"Drone 1", "Drone 2", "Drone 3"}), "");
  EXPECT_EQ(note_of({"Drone 1", "Drone 5", "Drone 9"}), "");
  EXPECT_EQ(note_of({"Drone 1", "Drone 3"}), "");
  EXPECT_EQ(note_of({"left", "middle", "right"}), "");
  EXPECT_EQ(note_of({"A1", "A2", "B4", "A5"}), "");
  EXPECT_EQ(note_of({"1", "2", "99999999999999999999"}), "");
}

}  // namespace
}  // namespace beespace::io
