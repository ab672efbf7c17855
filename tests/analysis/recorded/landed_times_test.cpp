// Drones that say that they have landed: two that stand are no conflict, one that flies close is.
#include "analysis/recorded/landed_times.hpp"

#include "analysis/geometry/geometry.hpp"
#include "analysis/recorded/all_conflicts.hpp"
#include "analysis/recorded/verify_paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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

// The pads are 1 m apart; one rises after 5 s.
io::Recording taking_off() {
  io::Recording recording;
  recording.bees = {drone("a", 0.0, 0.0), drone("b", 1.0, 0.0)};
  for (Fix& fix : recording.bees[0].fixes) {
    fix.position.z += 0.4 * std::max(0.0, fix.time_s - 5.0);
  }
  recording.bees[0].landed = {{0.0, 5.0}};
  recording.bees[1].landed = {{0.0, 9.0}};
  return recording;
}

TEST(LandedTimes, OfEachThatFliesTheClosestIsToldAndNotOfTwoThatStand) {
  io::Recording recording;
  recording.bees = {drone("a", 0.0, 0.0), drone("b", 1.0, 0.0), drone("c", -20.0, 4.0)};
  recording.bees[0].landed = {{0.0, 9.0}};
  recording.bees[1].landed = {{0.0, 4.0}};
  std::vector<Track> tracks;
  for (const io::RecordedBee& bee : recording.bees) tracks.push_back({bee.fixes});
  const auto closest = closest_of_each_flying(recording, tracks, 2.0, 5.0, 1);
  ASSERT_TRUE(closest);
  EXPECT_FALSE((*closest)[0]) << "it never flies";
  ASSERT_TRUE((*closest)[1] && (*closest)[2]);
  EXPECT_EQ((*closest)[1]->second, 2U);
  EXPECT_EQ((*closest)[2]->first, 1U);
}

TEST(LandedTimes, AConflictBeginsWhenOneOfBothTakesOff) {
  const auto found = conflicts_in(taking_off());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].begins_s, 5.0);
  EXPECT_GT(found[0].ends_s, 9.0 - 1e-6);
  EXPECT_EQ(found[0].closest_s, 5.0);
  EXPECT_EQ(found[0].closest_m, 1.0);
}

TEST(LandedTimes, AHopBetweenTwoTimesOnTheGroundIsAConflictOfItsOwnTime) {
  io::Recording recording = taking_off();
  for (Fix& fix : recording.bees[0].fixes) {
    fix.position.x -= 0.25;  // 1.25 m from the other
    fix.position.z = fix.time_s > 3.0 && fix.time_s < 7.0 ? 1.5 : 1.0;
    if (fix.time_s == 0.0) fix.position.x += 0.25;
  }
  recording.bees[0].landed = {{0.0, 3.0}, {7.0, 9.0}};
  const auto found = conflicts_in(recording);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].begins_s, 3.0);
  EXPECT_EQ(found[0].ends_s, 7.0);
  EXPECT_NEAR(found[0].closest_m, 1.25, 1e-12) << "not the 1 m while both stand";
}

TEST(LandedTimes, WhatIsNotCertainStaysWhole) {
  const io::Recording recording = taking_off();
  std::vector<Conflict> conflicts{{0, 1, 1.0, 2.0, 8.0, 1.0, false}};
  const auto left_out = leave_out_standing(recording, {}, {.threshold_m = 2.0}, conflicts);
  ASSERT_TRUE(left_out);
  EXPECT_EQ(*left_out, 0U);
  ASSERT_EQ(conflicts.size(), 1U);
  EXPECT_EQ(conflicts[0].begins_s, 1.0);
}

TEST(LandedTimes, TheClosestInTheAirIsToldBesideTwoThatStand) {
  io::Recording recording;
  recording.bees = {drone("a", 0.0, 0.0), drone("b", 1.0, 0.0), drone("c", -20.0, 0.0),
                    drone("d", 30.0, 0.0)};
  recording.bees[0].landed = {{0.0, 9.0}};
  recording.bees[1].landed = {{0.0, 9.0}};
  std::vector<Track> tracks;
  for (const io::RecordedBee& bee : recording.bees) tracks.push_back({bee.fixes});
  const ConflictOptions options{.threshold_m = 2.0, .max_gap_s = 5.0};
  const auto found = all_conflicts(recording, tracks, Geometry::kSpace, options, true);
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->recorded.conflicts.empty());
  EXPECT_EQ(found->standing_count, 1U);
  ASSERT_TRUE(found->closest && found->closest_in_the_air);
  EXPECT_EQ(found->closest->closest_m, 1.0);
  EXPECT_EQ(found->closest_in_the_air->first, 2U);
  EXPECT_EQ(found->closest_in_the_air->second, 3U);
  EXPECT_EQ(found->closest_in_the_air->closest_m, 50.0);
}

// Fixes at the same times, as a step from one to the next would have it.
TEST(LandedTimes, VerifyJudgesTwoThatStandAsReplayDoes) {
  io::Recording recording;
  recording.bees = {drone("a", 0.0, 0.0), drone("b", 1.0, 0.0)};
  PathQuestion question;
  question.threshold_m = 2.0;
  question.max_gap_s = 5.0;
  const auto flying = verify_paths(recording, question);
  ASSERT_TRUE(flying);
  EXPECT_EQ(flying->losses.size(), 1U);
  recording.bees[0].landed = {{0.0, 9.0}};
  recording.bees[1].landed = {{0.0, 9.0}};
  const auto standing = verify_paths(recording, question);
  ASSERT_TRUE(standing);
  EXPECT_TRUE(standing->losses.empty());
  EXPECT_EQ(standing->standing_count, 1U);
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
