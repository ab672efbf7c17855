// `beespace verify` of flights whose bees have fixes at times of their own, in degrees, as logs of
// drones have them; and what --vertical and --ignore-below leave out.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/exit_codes.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// Metres of a degree on the equator, to the east and to the north.
constexpr double kEastPerDegree_m = 111319.4908;
constexpr double kNorthPerDegree_m = 110574.2758;

std::string fix(const std::string& id, double time_s, double east_m, double north_m, double up_m,
                const std::string& velocity) {
  std::array<char, 160> text{};
  std::snprintf(text.data(), text.size(), "%s,%.2f,%.10f,%.10f,%.3f", id.c_str(), time_s,
                8.0 + east_m / kEastPerDegree_m, north_m / kNorthPerDegree_m, up_m);
  return std::string(text.data()) + velocity + "\n";
}

// a flies east at 10 m/s and b north, a metre higher and a quarter of a second later heard of: at
// 5 s b is right above a.
std::string crossing() {
  std::string text = "id,time_s,lon,lat,height,ve,vn,vu\n";
  for (int i = 0; i <= 10; ++i) {
    text += fix("a", i, 10.0 * (i - 5), 0.0, 100.0, ",10,0,0");
    text += fix("b", i + 0.25, 0.0, 10.0 * (i + 0.25 - 5), 101.0, ",0,10,0");
  }
  return text;
}

TEST(VerifyFlights, InDegreesAreLookedAtBetweenTheirFixes) {
  const Finished lost = run({"verify", "--threshold", "2"}, crossing());
  EXPECT_EQ(lost.exit_code, 1) << lost.err;
  const TextRows rows = rows_of(lost.out);
  ASSERT_EQ(rows.size(), 1u) << lost.out;
  EXPECT_EQ(rows[0].at(0), "loss");
  EXPECT_NEAR(std::stod(rows[0].at(5)), 1.0, 0.001);
  expect_parts(lost.err, {"straight lines from fix to fix, and curves with the velocities",
                          "a and b, 1.000 m apart at 5.00 s", "does not keep its distance"});
  const Finished kept = run({"verify", "--threshold", "0.9", "--max-speed", "10.1"}, crossing());
  EXPECT_EQ(kept.exit_code, 0) << kept.err;
  expect_parts(kept.err, {"verdict    holds\n"});
}

TEST(VerifyFlights, InDegreesHaveLimits) {
  const auto breach = [](const Arguments& limit) {
    const Finished finished = run(Arguments{"verify", "--threshold", "0.5"} + limit, crossing());
    return finished.exit_code == 1 ? finished.out : std::string();
  };
  EXPECT_NE(breach({"--max-horizontal", "9.9"}).find("horizontal\ta"), std::string::npos);
  EXPECT_NE(breach({"--max-speed", "9.9"}).find("speed\tb"), std::string::npos);
  EXPECT_NE(breach({"--max-height", "100.5"}).find("height\tb"), std::string::npos);
  EXPECT_EQ(breach({"--max-height", "101.5", "--max-climb", "0.1"}), "");
  expect_failure({"verify", "--max-height", "9"},
                 "id,time_s,lon,lat\na,0,8,47\na,1,8,47\nb,0,9,47\nb,1.5,9,47\n", kBadInput,
                 "the input has no heights, and so nothing is known of what --max-height limits");
}

// From rest with 5 m/s^2 for 2 s. A velocity that is always 0 of who moves is none: then the turns
// at fixes say it.
TEST(VerifyFlights, InDegreesAccelerateAsTheirVelocitiesSay) {
  const auto speeding_up = [](const std::array<std::string, 4>& velocities) {
    return "id,time_s,lon,lat,height,ve,vn,vu\n" + fix("a", 0, 0.0, 0, 9, velocities[0]) +
           fix("a", 1, 2.5, 0, 9, velocities[1]) + fix("a", 2, 10.0, 0, 9, velocities[2]) +
           fix("a", 3, 20.0, 0, 9, velocities[3]);
  };
  const std::string logged = speeding_up({",0,0,0", ",5,0,0", ",10,0,0", ",10,0,0"});
  const auto code = [](const std::string& text, const std::string& most) {
    return run({"verify", "--max-climb", "9", "--max-acceleration", most}, text).exit_code;
  };
  EXPECT_EQ(code(logged, "5.01"), 0);
  EXPECT_EQ(code(logged, "4.9"), 1);
  const std::string unknown = speeding_up({",0,0,0", ",0,0,0", ",0,0,0", ",0,0,0"});
  EXPECT_EQ(code(unknown, "6.3"), 0);
  EXPECT_EQ(code(unknown, "4.9"), 1);
}

TEST(VerifyFlights, WhoIsApartInHeightIsNotTooClose) {
  const auto code = [](const std::string& vertical, const std::string& text) {
    return run({"verify", "--threshold", "2", "--vertical", vertical}, text).exit_code;
  };
  EXPECT_EQ(code("0.9", crossing()), 0);
  EXPECT_EQ(code("1.1", crossing()), 1);
  const std::string metres = "id,time_s,x,y,z\na,0,-10,0,5\nb,0,0,-10,6\na,2,10,0,5\nb,2,0,10,6\n";
  EXPECT_EQ(code("0.9", metres), 0);
  EXPECT_EQ(code("1.1", metres), 1);
  expect_parts(run({"verify", "--threshold", "2", "--vertical", "1.1"}, metres).err,
               {"a and b, 0 m horizontally and 1.000 m vertically apart at 1.00 s"});
}

std::string drone(const std::string& name, double x, double takeoff_s, const std::string& points) {
  const std::string home = "[" + std::to_string(x) + ", 0, 0]";
  return R"({"settings": {"name": ")" + name + R"(", "home": )" + home + R"(, "landAt": )" + home +
         R"(, "trajectory": {"version": 1, "takeoffTime": )" + std::to_string(takeoff_s) +
         R"(, "points": [)" + points + "]}}}";
}

// a takes off a metre beside b, which stands, flies to 20 m away and lands there before b takes
// off; c does the same on the other side.
std::string grid() {
  return R"({"version": 1, "swarm": {"drones": [)" +
         drone("a", 0, 0, "[0,[0,0,0],[]],[10,[0,0,10],[]],[20,[-20,0,10],[]],[30,[-20,0,0],[]]") +
         "," + drone("b", 1, 40, "[0,[1,0,0],[]],[10,[1,0,10],[]],[20,[1,0,0],[]]") +
         R"(]}, "settings": {"validation": {"minDistance": 3}}})";
}

TEST(IgnoreBelow, IsNotOfferedWhereOneLandsNearlyOnAnother) {
  const TemporaryFolder folder;
  const std::string show = folder.file(
      "show.json",
      R"({"version": 1, "swarm": {"drones": [)" +
          drone("a", 0, 0, "[0,[0,0,0],[]],[10,[0,0,10],[]],[20,[19,0,10],[]],[30,[19.4,0,0],[]]") +
          "," +
          drone("b", 20, 0,
                "[0,[20,0,0],[]],[10,[20,0,10],[]],[12,[20,9,10],[]],[20,[20,0,0],[]]") +
          R"(]}, "settings": {"validation": {"minDistance": 3}}})");
  const Finished all = run({"verify", show});
  EXPECT_EQ(all.exit_code, 1) << all.err;
  expect_parts(all.err, {"0.600 m apart", "with a drone on the ground"});
  EXPECT_EQ(all.err.find("--ignore-below"), std::string::npos) << all.err;
}

TEST(IgnoreBelow, LeavesOutWhoTakesOffBesideAnotherOnlyWhenAsked) {
  const TemporaryFolder folder;
  const std::string show = folder.file("show.json", grid());
  const Finished all = run({"verify", show});
  EXPECT_EQ(all.exit_code, 1) << all.err;
  expect_parts(all.err,
               {"1 with a drone on the ground\n",
                "--ignore-below 3 leaves out 1 conflict of two that are both lower than that"});
  const Finished low = run({"verify", show, "--ignore-below", "3"});
  EXPECT_EQ(low.exit_code, 0) << low.err;
  expect_parts(low.err, {"losses     none\n",
                         "left out   1 conflict of two lower than 3 m above where they took off "
                         "(--ignore-below), the closest a and b, 1.000 m apart",
                         "holds, but for 1 conflict of two lower than 3 m"});
  // While a is between 2 m and 2.83 m high they are too close, too.
  EXPECT_EQ(run({"verify", show, "--ignore-below", "2"}).exit_code, 1);
  expect_parts(run({"verify", show, "--ignore-below", "3", "--json"}).out,
               {R"("ignore_below_m": 3)", R"("ignored_count": 1)"});

  EXPECT_EQ(run({"replay", show, "--fail-on-risk"}).exit_code, 1);
  const Finished replayed = run({"replay", show, "--fail-on-risk", "--ignore-below", "3"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
  expect_parts(replayed.err, {"keeps its distance, but for 1 conflict of two lower than 3 m",
                              "left out   1 conflict"});
  expect_parts(run({"replay", show, "--ignore-below", "3", "--json"}).out,
               {R"("conflict_count": 0)", R"("ignored_count": 1)"});
  expect_usage_error({"replay", show, "--ignore-below", "3", "--report", "events"},
                     "--ignore-below does not apply to --report events");
}

TEST(IgnoreBelow, PagesPicturesAndFilesForMapsSayWhatIsLeftOut) {
  const TemporaryFolder folder;
  const std::string show = folder.file("show.json", grid());
  const std::string text = "1 conflict of two lower than 3 m above where they took off";
  for (const Arguments& asked :
       {Arguments{"report", show, "-o", folder.path("page.html")},
        Arguments{"plot", show, "-o", folder.path("picture.svg")},
        Arguments{"export", show, "--origin", "19,47,100,90", "-o", folder.path("map.kml")}}) {
    Arguments risky = asked;
    risky.emplace_back("--fail-on-risk");
    EXPECT_EQ(run(risky).exit_code, 1) << asked.front();
    risky.insert(risky.end(), {"--ignore-below", "3"});
    const Finished finished = run(risky);
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    expect_parts(finished.err, {"at risk    none, but for " + text,
                                "note       " + text +
                                    ", left out (--ignore-below), the closest a and b, 1.000 m"});
  }
  expect_parts(folder.read("picture.svg"), {"but for " + text});
  expect_parts(folder.read("map.kml"), {text + " are left out"});
  expect_failure({"report", "--ignore-below", "3", "-o", folder.path("none.html")},
                 "x,y,z\n0,0,0\n1,0,0\n", kUsage,
                 "is a snapshot, which does not say where bees took off; leave --ignore-below out");
}

TEST(IgnoreBelow, KeepsThoseOfWhichItIsNotKnownWhereTheyTookOff) {
  const std::string standing = "id,time_s,x,y,z\na,0,0,0,5\nb,0,1,0,5\na,2,0,0,5\nb,2,1,0,5\n";
  const Finished finished = run({"verify", "--threshold", "2", "--ignore-below", "3"}, standing);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"left out   0 conflicts",
                              "of 2 bees it is not known where they took off: none of theirs is "
                              "left out"});
}

}  // namespace
}  // namespace beespace::cli_test
