// What who knows air traffic expects of recordings of it: spikes of heights, aircraft that enter
// and leave a sector, fixes a minute apart in cruise, levels that are kept, and minima above FL410.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

const Arguments kEnroute = {"replay", "--separation", "enroute", "--fail-on-risk"};

std::string moment(int seconds) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "2026-11-23 14:%02d:%02d+00:00", seconds / 60,
                seconds % 60);
  return text.data();
}

// As traffic writes them.
const std::string kHeader =
    "timestamp,icao24,callsign,latitude,longitude,altitude,groundspeed,track,vertical_rate\n";

// One that flies eastwards, at a moment.
std::string row(int seconds, const std::string& id, double latitude, double altitude_ft,
                int climb_ft_min = 0) {
  constexpr double kDegreesPerSecond = 0.003;  // 228 m/s at 47 degrees
  return moment(seconds) + "," + id + "," + id + "," + std::to_string(latitude) + "," +
         std::to_string(8.0 + kDegreesPerSecond * seconds) + "," + std::to_string(altitude_ft) +
         ",442,90," + std::to_string(climb_ft_min) + "\n";
}

// ---- Spikes -------------------------------------------------------------------------------------

// Two 3 NM beside each other, 10,000 ft apart; one row of the lower one is far above.
std::string with_spike(double spike_ft) {
  std::string text = kHeader;
  for (int t = 0; t < 40; ++t) {
    text += row(t, "4b1814", 47.0, t == 20 ? spike_ft : 10'000.0);
    text += row(t, "3c6444", 47.05, 20'000.0);
  }
  return text;
}

TEST(SpikesOfHeights, MakeNoConflictsAndAreNotKnown) {
  const Finished finished = run(kEnroute, with_spike(30'000.0));
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_EQ(rows_of(finished.out).size(), 0U) << finished.out;
  expect_parts(finished.err,
               {"no conflict in the known time", "1 bee jumps", "1 record was left out",
                "1 record to which its bee jumps, and back from there"});
  const std::string bees =
      run(kEnroute + Arguments{"--report", "bees", "--json"}, with_spike(30'000.0)).out;
  expect_parts(bees, {R"("unknown_s": 2,)"});
  // A real one at that height is found: what is left out is the spike alone.
  EXPECT_EQ(run(kEnroute, with_spike(10'000.0)).exit_code, 0);
}

TEST(SpikesOfHeights, AreNotInPictures) {
  const TemporaryFolder folder;
  const std::string file = folder.file("t.csv", with_spike(99'000.0));
  const std::string picture = folder.path("t.svg");
  run({"plot", file, "--separation", "enroute", "-o", picture});
  const std::string svg = folder.read("t.svg");
  EXPECT_EQ(svg.find("100,000"), std::string::npos);
  EXPECT_EQ(svg.find("possible"), std::string::npos);
}

// As aerobatic aircraft do, and fighters: 20,000 ft/min and more.
TEST(SpikesOfHeights, DivesAndClimbsAreNone) {
  std::string text = kHeader;
  for (int t = 0; t < 60; ++t) {
    const int phase = t % 20;
    const bool down = phase < 10;
    const double height_ft = 12'000.0 - 350.0 * (down ? phase : 20 - phase);
    text += row(t, "4b1814", 47.0, height_ft, down ? -21'000 : 21'000);
    text += row(t, "3c6444", 47.5, 30'000.0);
  }
  const Finished finished = run(kEnroute, text);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
}

// Once and for all: it is not known which of both is wrong, and on the way there it is nowhere.
TEST(SpikesOfHeights, NorDoesAJumpWithoutAWayBackMakeAConflictOnItsWay) {
  std::string text = kHeader;
  for (int t = 0; t < 40; ++t) {
    text += row(t, "4b1814", 47.0, t >= 20 ? 30'000.0 : 10'000.0);
    text += row(t, "3c6444", 47.05, 20'000.0);
  }
  const Finished finished = run(kEnroute, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_EQ(rows_of(finished.out).size(), 0U) << finished.out;
  expect_parts(finished.err, {"no conflict in the known time", "1 bee jumps"});
}

// ---- Gliders that circle ------------------------------------------------------------------------

// One that circles within 80 m of a place, a fix every 4 s, as an IGC log; `phase` in turns.
std::string circling(const std::string& id, double phase) {
  constexpr double kTurn = 6.283185307179586;
  constexpr double kRadius_m = 80.0;
  constexpr double kPeriod_s = 20.0;
  std::string text = "AXXX" + id + "\nHFDTE200726\n";
  for (int t = 0; t < 120; t += 4) {
    const double angle = kTurn * (t / kPeriod_s + phase);
    const double north_minutes = kRadius_m * std::sin(angle) / 1852.0;
    const double east_minutes = kRadius_m * std::cos(angle) / (1852.0 * 0.682);
    std::array<char, 80> line{};
    std::snprintf(line.data(), line.size(), "B11%02d%02d47%05.0fN008%05.0fEA0150001550\n",
                  30 + t / 60, t % 60, 1000.0 * (30.0 + north_minutes),
                  1000.0 * (30.0 + east_minutes));
    text += line.data();
  }
  return text;
}

TEST(GlidersThatCircle, AreInConflictPerhapsWhereOnlyStraightLinesAre) {
  const TemporaryFolder folder;
  folder.file("a.igc", circling("001", 0.0));
  folder.file("b.igc", circling("002", 0.5));
  const Finished finished =
      run({"replay", "--threshold", "150", "--fail-on-risk", folder.path("")});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"may not keep its distance",
                              "possible, not certain: where the two "
                              "turn, straight lines between fixes may "
                              "be off by up to"});
  EXPECT_EQ(finished.out.find("yes"), std::string::npos) << "certain";
  const Finished surely = run({"replay", "--threshold", "200", folder.path("")});
  expect_parts(surely.err, {"does not keep its distance"});
  EXPECT_EQ(surely.err.find("not certain"), std::string::npos);
}

}  // namespace
}  // namespace beespace::cli_test
