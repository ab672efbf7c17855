// Conflicts of two that are both low: left out only where both are all the time, above the places
// from which they are known to have taken off.
#include "analysis/recorded/low_conflicts.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

// Climbs by a metre a second from `ground_m`, where it stands at first.
io::RecordedBee climber(const std::string& id, double ground_m) {
  io::RecordedBee bee;
  bee.id = id;
  for (int second = 0; second <= 10; ++second) {
    bee.fixes.push_back({static_cast<double>(second), {0.0, 0.0, ground_m + second}});
  }
  bee.landed = {{0.0, 0.5}};
  return bee;
}

Conflict conflict_in(double begins_s, double ends_s) {
  Conflict conflict;
  conflict.first = 0;
  conflict.second = 1;
  conflict.begins_s = conflict.closest_s = begins_s;
  conflict.ends_s = ends_s;
  conflict.closest_m = 1.0;
  conflict.certain = true;
  return conflict;
}

std::size_t left_out(const io::Recording& recording, const Conflict& conflict) {
  std::vector<Conflict> conflicts{conflict};
  const LowConflicts low = leave_out_low(recording, 3.0, conflicts);
  EXPECT_EQ(low.left_out.size() + conflicts.size(), 1u);
  return low.left_out.size();
}

TEST(LowConflicts, OfTwoThatAreLowAllTheTimeAreLeftOut) {
  io::Recording recording;
  recording.bees = {climber("a", 100.0), climber("b", 250.0)};
  EXPECT_EQ(left_out(recording, conflict_in(0.0, 2.9)), 1u);
  EXPECT_EQ(left_out(recording, conflict_in(0.0, 3.0)), 0u);
  EXPECT_EQ(left_out(recording, conflict_in(4.0, 5.0)), 0u);
  Conflict possible = conflict_in(0.0, 2.9);
  possible.certain = false;
  EXPECT_EQ(left_out(recording, possible), 0u);
}

TEST(LowConflicts, BelowThePlaceOfTakeOffIsFlightToo) {
  io::Recording recording;
  recording.bees = {climber("a", 100.0), climber("b", 100.0)};
  for (Fix& fix : recording.bees[1].fixes) fix.position.z = 100.0 - 2.0 * fix.time_s;
  EXPECT_EQ(left_out(recording, conflict_in(0.0, 1.0)), 1u);
  EXPECT_EQ(left_out(recording, conflict_in(0.0, 2.0)), 0u);
}

TEST(LowConflicts, WhoIsFirstHeardOfInTheAirIsNotLow) {
  io::Recording recording;
  recording.bees = {climber("a", 100.0), climber("b", 100.0)};
  recording.bees[1].landed.clear();
  EXPECT_EQ(left_out(recording, conflict_in(0.0, 1.0)), 0u);
  std::vector<Conflict> none;
  EXPECT_EQ(leave_out_low(recording, 3.0, none).bees_not_known, 1u);
}

}  // namespace
}  // namespace beespace::analysis
