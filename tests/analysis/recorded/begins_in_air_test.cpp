#include "analysis/recorded/begins_in_air.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace beespace::analysis {
namespace {

// Down from 20 m at 1 m/s from 30 s on, and 2 m/s to the side before that.
io::Recording log_from(double begins_s) {
  io::Recording recording;
  recording.frame = io::Frame::kMetres;
  recording.of_drones = true;
  io::RecordedBee bee;
  bee.id = "a";
  for (int second = 0; second <= 60; ++second) {
    const double time_s = second;
    if (time_s < begins_s) continue;
    const double z = time_s < 30.0 ? 20.0 : time_s > 50.0 ? 0.0 : 50.0 - time_s;
    bee.fixes.push_back({time_s, {time_s < 30.0 ? 2.0 * time_s : 60.0, 0.0, z}});
  }
  recording.bees = {bee};
  return recording;
}

std::size_t count_in(const io::Recording& recording) {
  return begins_in_air(recording, max_gap_of(recording, std::nullopt));
}

TEST(BeginsInAir, IsWhoIsHigherThanLaterAndMoves) {
  EXPECT_EQ(count_in(log_from(0.0)), 1u);
  EXPECT_EQ(count_in(log_from(52.0)), 0u);
  // Who hovers comes down there; who stands somewhere higher than where it lands is not known to
  // fly.
  io::Recording still = log_from(0.0);
  for (Fix& fix : still.bees[0].fixes) fix.position.x = 0.0;
  EXPECT_EQ(count_in(still), 1u);
  for (Fix& fix : still.bees[0].fixes) fix.position.x = fix.time_s < 30.0 ? 0.0 : 60.0;
  EXPECT_EQ(count_in(still), 0u);
  still.bees[0].landed = {{50.0, 60.0}};  // but who says later that it has landed
  EXPECT_EQ(count_in(still), 1u);
  still.bees[0].landed = {{0.0, 1.0}, {50.0, 60.0}};
  EXPECT_EQ(count_in(still), 0u);
}

TEST(BeginsInAir, IsNothingOfPlansAircraftAndAnimals) {
  io::Recording aircraft = log_from(0.0);
  aircraft.of_aircraft = true;
  EXPECT_EQ(count_in(aircraft), 0u);
  io::Recording animals = log_from(0.0);
  animals.of_animals = true;
  EXPECT_EQ(count_in(animals), 0u);
  io::Recording others = log_from(0.0);
  others.of_drones = false;
  EXPECT_EQ(count_in(others), 0u);
  io::Recording show = log_from(0.0);
  show.show.emplace();
  EXPECT_EQ(count_in(show), 0u);
}

// One that comes later is another matter.
TEST(BeginsInAir, CountsThoseThatBeginWithTheRecording) {
  io::Recording recording = log_from(0.0);
  recording.bees.push_back(log_from(20.0).bees[0]);
  EXPECT_EQ(count_in(recording), 1u);
  EXPECT_EQ(begins_in_air_text(1),
            "1 drone is in the air when the recording begins: what was before is not known");
  EXPECT_EQ(begins_in_air_text(0), "");
}

TEST(BeginsInAir, NothingSpeaksAgainstStandingOfWhoIsLowAndDoesNotMove) {
  EXPECT_FALSE(may_stand_at_first(log_from(0.0), 0));
  EXPECT_TRUE(may_stand_at_first(log_from(52.0), 0));
  io::Recording above = log_from(52.0);
  above.bees[0].took_off_at_m = -20.0;
  EXPECT_FALSE(may_stand_at_first(above, 0));
  io::Recording landed = log_from(0.0);
  landed.bees[0].landed = {{0.0, 1.0}};
  EXPECT_TRUE(may_stand_at_first(landed, 0));
}

}  // namespace
}  // namespace beespace::analysis
