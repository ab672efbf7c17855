// Pairs whose heights alone keep them apart.
#include "analysis/recorded/kept_by_height.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

// That stands there for ten seconds.
io::RecordedBee standing(const std::string& id, const Point& at) {
  io::RecordedBee bee;
  bee.id = id;
  for (int second = 0; second <= 10; ++second) {
    bee.fixes.push_back({static_cast<double>(second), at});
  }
  return bee;
}

// a, b and c above each other, and d far away.
io::Recording layers() {
  io::Recording recording;
  recording.bees = {standing("a", {0, 0, 10}), standing("b", {3, 0, 40}), standing("c", {0, 2, 80}),
                    standing("d", {500, 0, 10})};
  return recording;
}

KeptByHeight kept_in(const io::Recording& recording, const std::vector<Conflict>& conflicts) {
  ConflictOptions options;
  options.threshold_m = 5.0;
  const auto kept = kept_by_height(recording, options, 0.0, conflicts);
  EXPECT_TRUE(kept && *kept);
  return kept && *kept ? **kept : KeptByHeight{};
}

TEST(KeptByHeight, CountsPairsThatAreCloseOverGround) {
  const io::Recording recording = layers();
  const KeptByHeight kept = kept_in(recording, {});
  EXPECT_EQ(kept.pairs, 3u);
  EXPECT_EQ(kept.unsure, 0u);
  EXPECT_EQ(kept.vertical_m, 100.0);
  ASSERT_TRUE(kept.closest);
  EXPECT_EQ(kept.closest->closest_m, 2.0);
  EXPECT_EQ(kept_by_height_text(kept, recording, 5.0),
            "3 pairs come closer than 5 m over ground, and only their heights keep them apart (a "
            "and c: 2.000 m at 0.00 s); --vertical 100 counts them");
  EXPECT_TRUE(unsure_heights_text(kept).empty());
}

TEST(KeptByHeight, OfRoversAndBoatsItIsNoAllClear) {
  io::Recording recording = layers();
  recording.bees[0].on_surface = true;
  EXPECT_EQ(kept_in(recording, {}).unsure, 0u) << "the other one may fly";
  recording.bees[1].on_surface = true;
  const KeptByHeight kept = kept_in(recording, {});
  EXPECT_EQ(kept.unsure, 1u);
  EXPECT_EQ(unsure_heights_text(kept), "1 pair of rovers or boats is kept apart by heights alone");
}

TEST(KeptByHeight, OfAnimalsItIsNoAllClear) {
  io::Recording recording = layers();
  recording.of_animals = true;
  const KeptByHeight kept = kept_in(recording, {});
  EXPECT_EQ(kept.unsure, 3u);
  EXPECT_EQ(unsure_heights_text(kept), "3 pairs of animals are kept apart by heights alone");
}

// Their heights waver: they are close over ground all the time, and in space for a part of it.
TEST(KeptByHeight, OfAnimalsInConflictItIsToldWhereTheyAreCloseForLonger) {
  io::Recording recording = layers();
  const std::vector<Conflict> in_space = {{0, 1, 0.0, 0.0, 3.0, 0.001},
                                          {0, 2, 0.0, 0.0, 3.0, 0.001}};
  recording.frame = io::Frame::kWgs84;
  for (io::RecordedBee& bee : recording.bees) {
    for (Fix& fix : bee.fixes) {
      fix.position.x *= 1e-6;
      fix.position.y *= 1e-6;
    }
  }
  EXPECT_EQ(kept_in(recording, in_space).longer, 0u);
  recording.of_animals = true;
  const KeptByHeight kept = kept_in(recording, in_space);
  EXPECT_EQ(kept.longer, 2u);
  EXPECT_NE(kept_by_height_text(kept, recording, 5.0)
                .find("2 pairs are closer than 5 m over ground for longer than with heights ("),
            std::string::npos);
  ASSERT_TRUE(kept.longest);
  EXPECT_GT(kept.longest->by_s(), 0.0);
}

// What is left out as both are low is kept apart by no height.
TEST(KeptByHeight, TwoThatAreLeftOutAsBothAreLowAreNotKeptApartByIt) {
  ConflictOptions options;
  options.threshold_m = 5.0;
  const auto all = kept_by_height(layers(), options, 0.0, {});
  ASSERT_TRUE(all && all->has_value() && (*all)->closest);
  const Conflict& closest = *(*all)->closest;
  const auto others = kept_by_height(layers(), options, 0.0, {}, {closest});
  ASSERT_TRUE(others && others->has_value());
  EXPECT_EQ((*others)->pairs + 1, (*all)->pairs);
  ASSERT_TRUE((*others)->closest);
  EXPECT_FALSE((*others)->closest->first == closest.first &&
               (*others)->closest->second == closest.second);
}

TEST(KeptByHeight, IsNotLookedAtWhereHeightsSayNothingOrAreAskedFor) {
  ConflictOptions options;
  options.threshold_m = 5.0;
  const auto looked_at = [&](const io::Recording& recording) {
    const auto kept = kept_by_height(recording, options, 0.0, {});
    return kept && kept->has_value();
  };
  EXPECT_TRUE(looked_at(layers()));
  io::Recording flat = layers();
  flat.flat = true;
  EXPECT_FALSE(looked_at(flat));
  io::Recording show = layers();
  show.show.emplace();
  EXPECT_FALSE(looked_at(show));
  io::Recording level = layers();
  level.bees[1] = standing("b", {3, 0, 10});
  level.bees[2] = standing("c", {0, 2, 10});
  EXPECT_FALSE(looked_at(level));
  const auto beside_a_conflict = [&](const io::Recording& recording) {
    const auto kept = kept_by_height(recording, options, 0.0, {{0, 3, 0.0, 0.0, 1.0, 2.0}});
    return kept && kept->has_value();
  };
  EXPECT_FALSE(beside_a_conflict(layers()));
  options.vertical_m = 2.0;
  EXPECT_FALSE(looked_at(layers()));
}

}  // namespace
}  // namespace beespace::analysis
