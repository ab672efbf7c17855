// Drones of logs that are never seen in the air, or are recorded while no other is.
#include "analysis/recorded/airborne.hpp"

#include "analysis/recorded/coverage.hpp"
#include "analysis/recorded/gaps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace beespace::analysis {
namespace {

// A fix a second: on the ground until 10 s, in the air until 60 s, on the ground again.
io::RecordedBee drone(const std::string& id, double x, int from_s, int until_s) {
  io::RecordedBee bee;
  bee.id = id;
  for (int second = from_s; second <= until_s; ++second) {
    const double up_m = std::min({10.0, 2.0 * (second - 10), 2.0 * (60 - second)});
    bee.fixes.push_back({static_cast<double>(second), {x, 0.0, 100.0 + std::max(0.0, up_m)}});
  }
  return bee;
}

io::Recording logs() {
  io::Recording recording;
  recording.of_drones = true;
  recording.bees = {drone("1", 0.0, 0, 70), drone("2", 10.0, 0, 70)};
  return recording;
}

constexpr MaxGap kFiveSeconds{5.0, 1.0};

TEST(Airborne, WhoIsKnownOnTheGroundOnlyMayHaveFlownWhileOthersDo) {
  io::Recording recording = logs();
  recording.bees.push_back(drone("3", 20.0, 0, 9));
  recording.bees.back().landed = {{0.0, 9.0}};
  recording.bees.back().on_ground_until_s = 0.0;
  recording.bees.back().on_ground_from_s = 9.0;
  const Coverage cut = coverage_of(recording, {}, kFiveSeconds);
  EXPECT_TRUE(cut.may_hide_conflicts());
  EXPECT_EQ(cut.unseen, (std::vector<PointId>{2}));
  EXPECT_EQ(cut.outside_s, 48.0) << "from 11 s to 59 s others are in the air";
  EXPECT_EQ(unknown_text(cut, &recording),
            "1 bee known for a part of the recording only (1 of which known on the ground only, "
            "and not while others fly: 3)");
  EXPECT_EQ(unknown_times_s(recording, {}, kFiveSeconds), (std::vector<double>{0.0, 0.0, 48.0}));
  const std::vector<Gap> spans = unknown_spans(recording, {}, kFiveSeconds);
  ASSERT_EQ(spans.size(), 1U);
  EXPECT_EQ(spans[0].begins_s, 11.0);
  // First heard after the others have landed.
  recording.bees.back() = drone("3", 20.0, 61, 70);
  recording.bees.back().landed = {{61.0, 70.0}};
  EXPECT_EQ(coverage_of(recording, {}, kFiveSeconds).unseen, (std::vector<PointId>{2}));
  // Without a word of it, too, as with --grounded.
  recording.bees.back().landed.clear();
  EXPECT_EQ(coverage_of(recording, {}, kFiveSeconds).unseen, (std::vector<PointId>{2}));
}

TEST(Airborne, WhoHasFlownAndWhoIsHeardAllTheTimeStands) {
  io::Recording recording = logs();
  recording.bees.push_back(drone("takes off later and lands earlier", 20.0, 5, 62));
  recording.bees.push_back(drone("never takes off", 30.0, 0, 70));
  for (Fix& fix : recording.bees.back().fixes) fix.position.z = 100.3;
  recording.bees.push_back(drone("stopped as others land", 40.0, 0, 9));
  recording.bees.back().fixes.push_back({56.0, {40.0, 0.0, 100.0}});
  EXPECT_TRUE(coverage_of(recording, {}, kFiveSeconds).unseen.empty());
  // What is no log of an autopilot is as it was.
  recording.bees.push_back(drone("cut", 50.0, 0, 9));
  EXPECT_EQ(coverage_of(recording, {}, kFiveSeconds).unseen.size(), 1U);
  recording.of_drones = false;
  EXPECT_TRUE(coverage_of(recording, {}, kFiveSeconds).unseen.empty());
}

TEST(Airborne, ALogOfAnotherDayIsComparedWithNone) {
  io::Recording recording = logs();
  recording.bees.push_back(drone("yesterday", 20.0, 0, 70));
  for (Fix& fix : recording.bees.back().fixes) fix.time_s -= 86400.0;
  const Coverage alone = coverage_of(recording, {}, kFiveSeconds);
  EXPECT_TRUE(alone.may_hide_conflicts());
  EXPECT_EQ(alone.alone, (std::vector<PointId>{2}));
  EXPECT_EQ(
      alone_text(alone, recording),
      "yesterday is recorded while no other is: compared with none; its times begin 24 h before "
      "those of the others");
  EXPECT_NE(unknown_text(alone, &recording).find("yesterday flies while no other is known"),
            std::string::npos);
  // Animals over years, and aircraft that pass, are so as a rule.
  recording.of_drones = false;
  EXPECT_EQ(coverage_of(recording, {}, kFiveSeconds).alone.size(), 1U);
  EXPECT_FALSE(coverage_of(recording, {}, kFiveSeconds).may_hide_conflicts());
  // Where all are, it is said that there is nothing to compare.
  recording.bees.erase(recording.bees.begin());
  EXPECT_TRUE(recorded_alone(recording).empty());
}

// As one computer of two writes them, whose clock is of another time zone.
TEST(Airborne, ATableOfAnotherTimeZoneIsComparedWithNone) {
  io::Recording tables = logs();
  tables.of_drones = false;
  tables.called_drones = true;
  tables.clock = io::WallClock{};
  tables.bees.push_back(drone("west", 20.0, 0, 70));
  for (Fix& fix : tables.bees.back().fixes) fix.time_s -= 3599.7;
  const Coverage one = coverage_of(tables, {}, kFiveSeconds);
  EXPECT_TRUE(one.may_hide_conflicts());
  EXPECT_FALSE(one.complete());
  const std::string text = alone_text(one, tables);
  EXPECT_NE(text.find("west is recorded while no other is: compared with none; its times begin "
                      "about 1 h before those of the others: was the clock in another time zone?"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("--time-zone"), std::string::npos) << text;
  // Two of them are compared with each other, and with none of the others.
  tables.bees.push_back(drone("west 2", 30.0, 0, 70));
  for (Fix& fix : tables.bees.back().fixes) fix.time_s -= 3600.0;
  tables.bees.push_back(drone("here", 40.0, 0, 70));
  const Coverage two = coverage_of(tables, {}, kFiveSeconds);
  EXPECT_EQ(two.alone, (std::vector<PointId>{2, 3}));
  EXPECT_NE(alone_text(two, tables).find("west and west 2 are recorded while none of the others"),
            std::string::npos);
  // Another flight begins at any time; and who says the zone says it.
  for (const PointId bee : {2u, 3u}) {
    for (Fix& fix : tables.bees[bee].fixes) fix.time_s -= 500.0;
  }
  EXPECT_TRUE(recorded_alone(tables).empty());
  for (const PointId bee : {2u, 3u}) {
    for (Fix& fix : tables.bees[bee].fixes) fix.time_s += 500.0;
  }
  tables.clock.reset();
  EXPECT_TRUE(recorded_alone(tables).empty());
}

TEST(Gaps, TheLongestThatIsBridgedIsTold) {
  io::Recording recording = logs();
  EXPECT_FALSE(longest_bridged(recording, kFiveSeconds));
  auto& fixes = recording.bees[1].fixes;
  fixes.erase(fixes.begin() + 34, fixes.begin() + 38);
  const auto bridged = longest_bridged(recording, kFiveSeconds);
  ASSERT_TRUE(bridged);
  EXPECT_EQ(bridged->track, 1U);
  EXPECT_EQ(bridged->begins_s, 33.0);
  EXPECT_EQ(bridged->ends_s, 38.0);
  EXPECT_EQ(bridged_text(coverage_of(recording, {}, kFiveSeconds), recording),
            "2 from 33.00 s for 5 s");
  // What is longer is a gap, and told as that.
  EXPECT_FALSE(longest_bridged(recording, {4.9, 1.0}));
  // Who is heard of seldom as a rule has no other fixes.
  std::erase_if(recording.bees[1].fixes,
                [](const Fix& fix) { return static_cast<int>(fix.time_s) % 4 != 0; });
  EXPECT_FALSE(longest_bridged(recording, kFiveSeconds));
}

}  // namespace
}  // namespace beespace::analysis
