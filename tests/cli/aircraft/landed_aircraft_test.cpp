// A recording in which an aircraft lands: who was heard of on the ground a moment ago is not
// silent. And what of it is looked at: what lies ahead of its end.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

constexpr int kLooks = 14;
constexpr int kEvery_s = 10;
constexpr int kLandsAt = 2;

// On its way to the east.
std::string aircraft(const char* hex, double latitude_deg, double way_m, const std::string& more) {
  constexpr double kDegree_m = 74'500.0;  // at 48 degrees of latitude
  std::array<char, 128> text = {};
  std::snprintf(text.data(), text.size(),
                R"({"hex": "%s", "lat": %.5f, "lon": %.6f, "seen_pos": 0.4, )", hex, latitude_deg,
                8.5 + way_m / kDegree_m);
  return text.data() + more + "}";
}

// Two far from each other, and one that lands between them within half a minute, and is heard of
// until that look.
void write_looks(const TemporaryFolder& folder, int heard_until) {
  for (int i = 0; i < kLooks; ++i) {
    const std::string flies = R"("alt_baro": 35000, "gs": 450, "track": 90, "baro_rate": 0)";
    std::string text = R"({"now": )" + std::to_string(1717581600 + kEvery_s * i);
    const double flown_m = 231.5 * kEvery_s * i;
    text += R"(, "aircraft": [)" + aircraft("4b1814", 47.0, flown_m, flies);
    text += ", " + aircraft("3c6444", 49.0, flown_m, flies);
    const bool down = i > kLandsAt;
    const std::string third =
        down ? R"("alt_baro": "ground", "gs": 5, "track": 90)"
             : R"("alt_baro": 1500, "gs": 140, "track": 90, "baro_rate": -700)";
    const double rolled_m = 72.0 * kEvery_s * std::min(i, kLandsAt) + 2.5 * kEvery_s * i;
    if (i <= heard_until) text += ", " + aircraft("4ca903", 48.0, rolled_m, third);
    folder.file("history_" + std::to_string(i) + ".json", text + "]}\n");
  }
}

Finished predicted(const TemporaryFolder& folder) {
  return run({"predict", folder.path(""), "--separation", "enroute", "--fail-on-risk"});
}

TEST(LandedAircraft, AreOnTheGroundAndNotSilent) {
  const TemporaryFolder folder;
  write_looks(folder, kLooks);
  const Finished finished = predicted(folder);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"landed     1 on the ground, as they say themselves: not compared with flyers\n",
                "conflicts  none after the end of the recording\n"});
  EXPECT_EQ(finished.err.find("stale"), std::string::npos) << finished.err;
  expect_parts(run({"predict", folder.path(""), "--separation", "enroute", "--json"}).out,
               {R"("stale": 0,)", R"("on_ground": 1,)"});
}

TEST(LandedAircraft, AreSilentWhereTheyAreNotHeardOfAnyMore) {
  const TemporaryFolder folder;
  write_looks(folder, kLooks - 6);
  const Finished finished = predicted(folder);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"stale      1 left out, not heard of for 30 s"});
}

TEST(PredictOfARecording, SaysThatItLooksAheadOfItsEnd) {
  const TemporaryFolder folder;
  write_looks(folder, kLooks);
  const std::string before = "note       this is a recording of ";
  expect_parts(predicted(folder).err,
               {before +
                "130.40 s: only what lies ahead of its end is looked at; for the rest ask "
                "'beespace replay " +
                folder.path("") + " --separation enroute'\n"});
  const Finished one = run({"predict", folder.path("history_0.json"), "--separation", "enroute"});
  EXPECT_EQ(one.err.find(before), std::string::npos) << one.err;
}

// One that is cut off, as while it is being written.
TEST(BrokenFiles, OfAFolderAreLeftOutWhereThatIsAskedFor) {
  const TemporaryFolder folder;
  write_looks(folder, kLooks);
  const std::string whole = folder.read("history_7.json");
  const std::string broken = folder.file("history_7.json", whole.substr(0, whole.size() / 2));
  const Arguments asked = {"replay", folder.path(""), "--separation", "enroute", "--fail-on-risk"};
  const Finished refused = run(asked);
  EXPECT_EQ(refused.exit_code, 3);
  expect_parts(refused.err, {"history_7.json:1:", "or leave such files out with --skip-bad"});
  const Finished skipped = run(asked + Arguments{"--skip-bad"});
  EXPECT_EQ(skipped.exit_code, 1) << skipped.err;
  expect_parts(skipped.err,
               {"skipped    1 bad record\n", "history_7.json", "the JSON ends too early",
                "1 file or folder was left out", "not read   " + broken});
  const Finished alone = run({"replay", broken, "--separation", "enroute", "--skip-bad"});
  EXPECT_EQ(alone.exit_code, 3);
  EXPECT_EQ(alone.err.find("--skip-bad"), std::string::npos) << alone.err;
}

// One at 0 kt and one place that does not say to be on the ground, one that passes close by, and
// two in the air that come less close.
std::string beside_one_that_stands(int speed_kt) {
  std::string text =
      "timestamp,icao24,latitude,longitude,groundspeed,track,vertical_rate,altitude\n";
  for (int t = 0; t <= 120; t += 5) {
    const auto add = [&](const std::string& of, double latitude, double longitude, int gs,
                         int altitude) {
      std::array<char, 128> line = {};
      std::snprintf(line.data(), line.size(), "%d,%s,%.6f,%.6f,%d,90,0,%d\n", 1714564800 + t,
                    of.c_str(), latitude, longitude, gs, altitude);
      text += line.data();
    };
    const double on = 0.001 * t;
    add("4400ec", 48.7, 2.3, speed_kt, 300);
    add("39856c", 48.703, 2.24 + on, 140, 325);
    add("4b1814", 49.5, 2.24 + on, 140, 9000);
    add("3c6444", 49.5, 2.36 - on, 140, 9900);
  }
  return text;
}

TEST(LandedAircraft, WhoStandsStillByItsOwnReportsComesLast) {
  const Finished found =
      run({"replay", "--separation", "terminal", "--units", "aviation", "--fail-on-risk"},
          beside_one_that_stands(0));
  EXPECT_EQ(found.exit_code, 1);
  expect_parts(found.err,
               {"2 conflicts of 2 pairs, 1 with an aircraft that stands still",
                "worst      4b1814 and 3c6444, 0.000 NM", "4400ec and 39856c, 0.180 NM",
                ", with an aircraft that stands still; in conflict",
                "note       who stands still for a minute or longer, by its own reports of 0 kt at "
                "one place, may be on the ground without saying so: its conflicts come last\n"});
  EXPECT_NE(found.out.find("4400ec\t39856c"), std::string::npos) << found.out;
  EXPECT_LT(found.err.find("4b1814 and 3c6444"), found.err.find("4400ec and 39856c"));
  const Finished taxis = run({"replay", "--separation", "terminal", "--units", "aviation"},
                             beside_one_that_stands(12));
  EXPECT_EQ(taxis.err.find("stands still"), std::string::npos) << taxis.err;
}

}  // namespace
}  // namespace beespace::cli_test
