// Ids that two bees seem to have: what is told by the way from one to the other is not certain.
#include "analysis/recorded/shared_ids.hpp"
#include "analysis/recorded/gaps.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

// "1" is of two, whose reports come 0.02 s apart.
io::Recording with_shared() {
  io::Recording recording;
  for (const std::string id : {"1", "3"}) {
    io::RecordedBee bee;
    bee.id = id;
    for (int i = 0; i < 50; ++i) {
      const double time_s = 0.2 * i;
      bee.fixes.push_back({time_s, {1.0, 2.0, 3.0}});
      if (id == "1") bee.fixes.push_back({time_s + 0.02, {90.0, 2.0, 3.0}});
    }
    recording.bees.push_back(bee);
  }
  recording.bees.front().shared = true;
  recording.missing.shared = 1;
  return recording;
}

Conflict between(PointId first, PointId second) {
  Conflict conflict;
  conflict.first = first;
  conflict.second = second;
  return conflict;
}

TEST(SharedIds, DoNotTellHowOftenOthersReport) {
  io::Recording recording = with_shared();
  EXPECT_DOUBLE_EQ(max_gap_of(recording, std::nullopt).seconds, 1.0);
  recording.bees.pop_back();  // by itself it does
  EXPECT_LT(max_gap_of(recording, std::nullopt).seconds, 1.0);
}

TEST(SharedIds, MakeConflictsPossibleOnly) {
  io::Recording recording = with_shared();
  recording.bees.push_back(recording.bees[1]);
  recording.bees.back().id = "4";
  std::vector<Conflict> conflicts = {between(0, 1), between(1, 2), between(0, 2)};
  EXPECT_EQ(count_of_shared_ids(conflicts, recording), 2u);
  doubt_shared_ids(recording, conflicts);
  EXPECT_FALSE(conflicts[0].certain);
  EXPECT_TRUE(conflicts[1].certain);
  EXPECT_FALSE(conflicts[2].certain);
  recording.missing.shared = 0;
  EXPECT_EQ(count_of_shared_ids(conflicts, recording), 0u);
}

}  // namespace
}  // namespace beespace::analysis
