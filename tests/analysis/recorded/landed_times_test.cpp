// Drones that say that they have landed: two that stand are no conflict, one that flies close is.
#include "analysis/recorded/landed_times.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/all_conflicts.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

// At ten fixes, a second apart.
io::RecordedBee drone(const std::string& id, double from_m, double mps) {
  io::RecordedBee bee;
  bee.id = id;
  for (int second = 0; second < 10; ++second) {
    const double time_s = second;
    bee.fixes.push_back({time_s, {from_m + mps * time_s, 0.0, 1.0}});
  }
  return bee;
}

std::vector<Conflict> conflicts_in(const io::Recording& recording) {
  std::vector<Track> tracks;
  for (const io::RecordedBee& bee : recording.bees) tracks.push_back({bee.fixes});
  ConflictOptions options;
  options.threshold_m = 2.0;
  options.max_gap_s = 5.0;
  const auto found = all_conflicts(recording, tracks, Geometry::kSpace, options, true);
  EXPECT_TRUE(found);
  return found ? found->recorded.conflicts : std::vector<Conflict>{};
}

TEST(LandedTimes, TwoThatBothStandAreNoConflictAndOneThatFliesCloseIs) {
  io::Recording recording;
  recording.bees = {drone("a", 0.0, 0.0), drone("b", 1.0, 0.0)};
  EXPECT_EQ(conflicts_in(recording).size(), 1U);
  recording.bees[0].landed = {{0.0, 9.0}};
  EXPECT_EQ(conflicts_in(recording).size(), 1U) << "the other one flies";
  recording.bees[1].landed = {{0.0, 9.0}};
  EXPECT_TRUE(conflicts_in(recording).empty());
  recording.bees.push_back(drone("c", -20.0, 4.0));
  const auto flies_over = conflicts_in(recording);
  ASSERT_EQ(flies_over.size(), 2U);
  EXPECT_EQ(flies_over[0].second, 2U);
  EXPECT_EQ(flies_over[1].second, 2U);
}

TEST(LandedTimes, WhoTakesOffBesideAnotherIsInConflict) {
  io::Recording recording;
  recording.bees = {drone("a", 0.0, 0.0), drone("b", 1.0, 0.0)};
  recording.bees[0].landed = {{0.0, 9.0}};
  recording.bees[1].landed = {{0.0, 6.0}};
  EXPECT_EQ(conflicts_in(recording).size(), 1U);
  EXPECT_TRUE(has_landed(recording, 1, 6.0));
  EXPECT_FALSE(has_landed(recording, 1, 6.5));
}

}  // namespace
}  // namespace beespace::analysis
