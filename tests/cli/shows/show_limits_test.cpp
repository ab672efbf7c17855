// Limits that a show declares beside speeds and heights: accelerations in one direction, and those
// of which it is not known whether they are kept.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::string text_of_ring() {
  std::ifstream file(std::string(BEESPACE_SHOWS) + "/ring.json");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// The ring with other limits beside its own, all of which it keeps at these thresholds.
class LimitsBesideTheRing : public testing::Test {
 protected:
  std::string with(const std::string& limits) {
    std::string changed = text_of_ring();
    const std::string height = R"("maxAltitude": 120)";
    changed.replace(changed.find(height), height.size(), height + ", " + limits);
    return folder_.file("ring.json", changed);
  }
  Finished verify(const std::string& limits, const Arguments& more = {}) {
    return run(Arguments{"verify", with(limits), "--threshold", "3.5", "--max-descent", "2.5"} +
               more);
  }

  TemporaryFolder folder_;
};

// Accelerations are up to 0.833 m/s^2 in x and y, and up to 1.667 m/s^2 in z.
TEST_F(LimitsBesideTheRing, OfAccelerationsAreLookedAtInTheirDirection) {
  const Finished kept = verify(R"("maxAccelerationXY": 0.9, "maxAccelerationZ": 1.7)");
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  expect_parts(kept.err, {"horizontal acceleration 0.9 m/s^2, vertical acceleration 1.7 m/s^2 (as "
                          "the show declares)"});
  const Finished broken = verify(R"("max_acceleration_xy": 0.8, "maxAccelerationZ": 1.7)");
  EXPECT_EQ(broken.exit_code, 1);
  expect_parts(broken.err, {"above the horizontal acceleration of 0.8 m/s^2 (max_acceleration_xy), "
                            "the worst 0.833 m/s^2",
                            "breaks the limits"});
  EXPECT_EQ(broken.err.find("--skip-limits"), std::string::npos) << broken.err;
  expect_parts(broken.out, {"acceleration\tDrone 1"});
  EXPECT_EQ(verify(R"("maxAccelerationZ": 1.6)").exit_code, 1);
  // Who says that it need not be looked at means it.
  EXPECT_EQ(verify(R"("maxAccelerationXY": 0.8)", {"--skip-limits", "maxAccelerationXY"}).exit_code,
            0);
  EXPECT_EQ(verify(R"("maxAccelerationXY": "fast")").exit_code, 3);
  // Upwards apart: it is not known which way the other is.
  EXPECT_EQ(verify(R"("maxAccelerationZ": 1.7, "maxAccelerationZUp": 2)").exit_code, 0);
  expect_parts(verify(R"("maxAccelerationZ": 1.6, "maxAccelerationZUp": 2)").err,
               {"but whether maxAccelerationZ is kept is not known"});
#if BEESPACE_HAS_PAGE
  const std::string page = folder_.path("ring.html");
  EXPECT_EQ(run({"report", with(R"("maxAccelerationXY": 0.8)"), "--output", page}).exit_code, 0);
  expect_parts(folder_.read("ring.html"), {R"("limit":"horizontal_acceleration","most":0.8)"});
#endif
}

// Up and down alone below 10 m.
TEST_F(LimitsBesideTheRing, OfTheHeightToNavigateAreKeptWhereNoneMovesSidewaysBelow) {
  const Finished studio = verify(R"("minNavAltitude": 2.5)");
  EXPECT_EQ(studio.exit_code, 0) << studio.err;
  expect_parts(studio.err, {"minNavAltitude 2.5 m: kept (below it none moves sideways by more than "
                            "0.1 m)\n",
                            "verdict    holds\n"});
  // At 10 m along a side of 5 m.
  const Finished low = verify(R"("minNavAltitude": 12)");
  EXPECT_EQ(low.exit_code, 1) << low.err;
  expect_parts(low.err, {"breaches   4 drones move sideways below minNavAltitude 12 m, the worst "
                         "5.00 m, at up to 1.25 m/s: Drone 1 at ",
                         "verdict    does not keep minNavAltitude; where that does not count, say "
                         "--skip-limits minNavAltitude\n"});
  EXPECT_EQ(low.err.find("not looked at"), std::string::npos) << low.err;
  const Finished json = verify(R"("minNavAltitude": 12)", {"--json", "--quiet"});
  expect_parts(json.out, {R"("name": "minNavAltitude", "below_m": 12, "kept": false, "bees": 4)"});
  const Finished said = verify(R"("minNavAltitude": 12)", {"--skip-limits", "minNavAltitude"});
  EXPECT_EQ(said.exit_code, 0) << said.err;
  expect_parts(said.err,
               {"declared, but not looked at: minNavAltitude\n",
                "verdict    holds in what was looked at, which minNavAltitude is not (--skip"});
}

// As Studio samples and rounds paths: who climbs straight up moves by a centimetre.
TEST_F(LimitsBesideTheRing, OfTheHeightToNavigateAreKeptDespiteRounding) {
  const auto show = [this](const std::string& x) {
    std::string points;
    for (int k = 0; k <= 40; ++k) {
      points += (k == 0 ? "[" : ",[") + std::to_string(0.25 * k) + ",[" + (k % 2 == 0 ? "0" : x) +
                ",0," + std::to_string(k <= 20 ? 0.5 * k : 0.5 * (40 - k)) + "],[]]";
    }
    return folder_.file(
        "show.json",
        R"({"version":1,"settings":{"validation":{"minDistance":2,"minNavAltitude":2.5}},)"
        R"("swarm":{"drones":[{"type":"generic","settings":{"name":"a","home":[0,0,0],)"
        R"("trajectory":{"version":1,"points":[)" +
            points + "]}}}]}}");
  };
  const auto text_of = [&](const std::string& x) {
    return run({"verify", show(x), "--max-height", "20"}).err;
  };
  expect_parts(text_of("0.01"), {"minNavAltitude 2.5 m: kept"});
  expect_parts(text_of("0.2"), {"1 drone moves sideways below minNavAltitude 2.5 m, the worst 0.20 "
                                "m, at up to 0.80 m/s: a at "});
}

TEST_F(LimitsBesideTheRing, ThatAreNotKnownAreSaid) {
  const std::string both = R"("maxAccelerationXY": 0.9, "minBattery": 20)";
  expect_parts(verify(both).err, {"whether minBattery is kept is not known"});
  EXPECT_EQ(verify(both, {"--skip-limits", "minBattery"}).exit_code, 0);
  const Finished other = verify(both, {"--skip-limits", "maxAltitude"});
  EXPECT_EQ(other.exit_code, 2);
  expect_parts(other.err, {"the input declares minBattery, maxAccelerationXY alone"});
#if BEESPACE_HAS_PAGE
  const std::string page = folder_.path("ring.html");
  EXPECT_EQ(run({"report", with(both), "--output", page}).exit_code, 0);
  expect_parts(folder_.read("ring.html"), {R"("not_looked_at":["minBattery"])"});
#endif
}

}  // namespace
}  // namespace beespace::cli_test
