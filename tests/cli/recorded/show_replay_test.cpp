// `beespace replay` of drone shows: their verdict, the distance that they declare, and curves.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

std::string drone(const std::string& name, const std::string& points) {
  return R"({"type": "generic", "settings": {"name": ")" + name +
         R"(", "trajectory": {"version": 1, "points": [)" + points + "]}}}";
}

// Up to 10 m, 10 m along x, and down again, at this y.
std::string flight(const std::string& name, const std::string& y) {
  return drone(name, "[0, [0, " + y + ", 0], []], [2, [0, " + y + ", 10], []], [12, [10, " + y +
                         ", 10], []], [14, [10, " + y + ", 0], []]");
}

// Two that fly the same way, 3 m beside each other, in one JSON file.
std::string side_by_side(const std::string& settings) {
  return R"({"version": 1, "settings": )" + settings + R"(, "swarm": {"drones": [)" +
         flight("left", "0") + "," + flight("right", "3") + "]}}";
}

std::string declaring(const std::string& metres) {
  return side_by_side(R"({"validation": {"minDistance": )" + metres + "}}");
}

class ShowReplay : public testing::Test {
 protected:
  Finished replay(const std::string& show, const Arguments& more = {}) {
    return run(Arguments{"replay", folder_.file("show.json", show)} + more);
  }

  TemporaryFolder folder_;
};

TEST_F(ShowReplay, AShowThatKeepsTheDistanceThatItDeclaresIsFine) {
  const Finished finished = replay(declaring("2.5"), {"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0);
  EXPECT_EQ(below_header(finished.out), "");
  expect_parts(finished.err,
               {"Skybrush show)\n", "heights    above the place of take-off\n", "bees       2\n",
                "from       0.00 s to 14.00 s (14.00 s)\n",
                "threshold  2.5 m (closer than), as the input declares\n",
                "verdict    keeps its distance\n", "closest    left and right, 3.000 m apart at "});
}

// It promises none: what is too close is asked for.
TEST_F(ShowReplay, ADistanceOfZeroIsSettledByAThreshold) {
  const Finished asked = replay(declaring("0"));
  EXPECT_NE(asked.exit_code, 0);
  expect_parts(asked.err, {"declares a least distance of 0", "as in --threshold 2"});
  EXPECT_EQ(replay(declaring("0"), {"--threshold", "2.5", "--fail-on-risk"}).exit_code, 0);
  const std::string show = folder_.file("show.json", declaring("0"));
  EXPECT_EQ(run({"verify", show, "--threshold", "2.5"}).exit_code, 0);
  EXPECT_EQ(run({"verify", show, "--threshold", "3.5"}).exit_code, 1);
}

// Where it is after the end of its path is not known: it may be in the way of the other.
TEST_F(ShowReplay, ADroneWhosePathEndsInTheAirIsNoAllClear) {
  const std::string show =
      R"({"version": 1, "settings": {}, "swarm": {"drones": [)" + flight("left", "0") + "," +
      drone("right", "[0, [0, 30, 0], []], [2, [0, 30, 10], []], [5, [0, 9, 10], []]") + "]}}";
  const Finished finished = replay(show, {"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(
      finished.err,
      {"verdict    no conflict in the known time; 1 bee known for a part of the recording "
       "only (1 of which begins or ends in the air while others fly: right)\n",
       "before the first or after the last fix, for 9 s in all; 1 of them in the air then\n"});
  const Finished verified = run({"verify", folder_.file("show.json", show)});
  EXPECT_EQ(verified.exit_code, 1);
  expect_parts(verified.err,
               {"verdict    not seen as a whole: holds in the known time; 1 bee known "
                "for a part of the recording only"});
}

// Who has landed is still there, whether a path says so or a table.
TEST_F(ShowReplay, ADroneThatLandsBesideOneOfATableThatHasLandedIsNoAllClear) {
  const std::string header = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n";
  const std::string left =
      folder_.file("left.csv", header + "0,0,0,0,0,0,0\n2000,0,0,10,0,0,0\n4000,0,0,0,0,0,0\n");
  const auto beside = [&](const std::string& y) {
    return folder_.file("right.csv", header + "0,0,30,0,0,0,0\n3000,0,30,10,0,0,0\n6000,0," + y +
                                         ",10,0,0,0\n9000,0," + y + ",0,0,0,0\n");
  };
  const Finished finished = run({"replay", left, beside("1"), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"left and right, 1.000 m apart at "});
  EXPECT_EQ(run({"verify", left, beside("1")}).exit_code, 1);
  EXPECT_EQ(run({"replay", left, beside("3"), "--fail-on-risk"}).exit_code, 0);
  EXPECT_EQ(run({"verify", left, beside("3")}).exit_code, 0);
}

// Reports, pages and files of a conflict with a drone on the ground name it, too.
TEST_F(ShowReplay, ConflictsWithDronesOnTheGroundAreInAllThatIsWritten) {
  const std::string header = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n";
  const std::string left =
      folder_.file("left.csv", header + "0,0,0,0,0,0,0\n2000,0,0,10,0,0,0\n4000,0,0,0,0,0,0\n");
  const std::string right =
      folder_.file("right.csv", header +
                                    "0,0,30,0,0,0,0\n3000,0,30,10,0,0,0\n6000,0,1,10,0,0,0\n"
                                    "9000,0,1,0,0,0,0\n");
  const Finished apart = run({"replay", left, right, "--report", "separation", "--quiet"});
  expect_parts(apart.out, {"9\t1\tleft\tright\t"});
  const Finished events = run({"replay", left, right, "--report", "events", "--quiet"});
  expect_parts(events.out, {R"("event": "entered")", R"("first": "left", "second": "right")"});
  const Finished table = run({"export", left, right, "--format", "csv", "--quiet"});
  expect_parts(table.out, {"left,right,"});
  EXPECT_EQ(table.out.find(",,"), std::string::npos) << table.out;
  const Finished map =
      run({"export", left, right, "--format", "geojson", "--origin", "8,47,0,0", "--quiet"});
  expect_parts(map.out, {R"("first":"left","second":"right")"});
}

TEST_F(ShowReplay, TablesThatEndInTheAirAreNoAllClear) {
  const std::string header = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n";
  const std::string left =
      folder_.file("left.csv", header + "0,0,0,0,0,0,0\n2000,0,0,10,0,0,0\n4000,0,0,0,0,0,0\n");
  const auto replayed = [&](const std::string& height, const Arguments& more) {
    const std::string right =
        folder_.file("right.csv", header + "0,0,30,0,0,0,0\n1500,0,30,10,0,0,0\n3000,0,30," +
                                      height + ",0,0,0\n");
    return run(Arguments{"replay", left, right, "--fail-on-risk"} + more);
  };
  EXPECT_EQ(replayed("0", {}).exit_code, 0);
  EXPECT_EQ(replayed("5", {}).exit_code, 1);
  // Who stands where, and until when, all of a show tells together.
  const Finished streamed = replayed("0", {"--memory", "17MB"});
  EXPECT_EQ(streamed.exit_code, 3);
  expect_parts(streamed.err,
               {"this is a drone show, which is read as a whole; leave --memory out"});
}

TEST_F(ShowReplay, AShowThatDoesNotKeepItFails) {
  const Finished finished = replay(declaring("3.5"), {"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_rows(without_lasts(rows_of(finished.out)), {{"left", "right", "0", "0", "3", "14"}});
  expect_parts(finished.err, {"threshold  3.5 m (closer than), as the input declares\n",
                              "verdict    does not keep its distance: 1 conflict of 1 pair\n",
                              "in conflict for 14.00 s\n"});
  EXPECT_EQ(replay(declaring("3.5")).exit_code, 0);
}

TEST_F(ShowReplay, AThresholdThatIsAskedForCountsInsteadOfTheDeclaredOne) {
  const Finished finished = replay(declaring("3.5"), {"--threshold", "3", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0);
  expect_parts(finished.err, {"threshold  3 m (closer than)\n", "keeps its distance"});
  EXPECT_EQ(
      replay(declaring("2.5"), {"--threshold", "3", "--inclusive", "--fail-on-risk"}).exit_code, 1);
}

TEST_F(ShowReplay, WithoutADeclaredDistanceItIsTwoMetres) {
  const Finished finished = replay(side_by_side("{}"));
  expect_parts(finished.err, {"threshold  2 m (closer than), the default of shows that declare "
                              "none (--threshold)\n"});
  EXPECT_EQ(rows_of(finished.out).size(), 0u);
}

TEST_F(ShowReplay, TheDeclaredDistanceIsInTheDocument) {
  const Finished finished = replay(declaring("3.5"), {"--json"});
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {R"("format": "Skybrush show")", R"("threshold_m": 3.5)",
                              R"("pair_count": 1)", R"("heights": "above the place of take-off")"});
}

TEST_F(ShowReplay, EventsOfAShowAreThoseOfItsPlan) {
  EXPECT_EQ(replay(declaring("3.5"), {"--report", "events"}).out,
            "{\"event\": \"entered\", \"time_s\": 0, \"first\": \"left\", \"second\": \"right\", "
            "\"distance_m\": 3, \"closest_s\": 0}\n"
            "{\"event\": \"ended\", \"time_s\": 14, \"first\": \"left\", \"second\": \"right\", "
            "\"distance_m\": 3, \"closest_s\": 0}\n");
  EXPECT_EQ(replay(declaring("2.5"), {"--report", "events"}).out, "") << "a bee went stale";
}

// One flies a parabola with its apex (0, 5) at 5 s; the other one stands 3 m from there.
class CurvedShow : public ShowReplay {
 protected:
  Finished ask(const std::string& threshold, const Arguments& more = {}) {
    return replay(R"({"version": 1, "settings": {}, "swarm": {"drones": [)" +
                      drone("curve", "[0, [-10, 0, 10], []], [10, [10, 0, 10], [[0, 10, 10]]]") +
                      "," + drone("post", "[0, [0, 8, 10], []], [10, [0, 8, 10], []]") + "]}}",
                  Arguments{"--grounded", "--threshold", threshold} + more);
  }
};

TEST_F(CurvedShow, AConflictBeyondTheToleranceIsCertain) {
  const Finished finished = ask("4");
  const auto rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1u);
  ASSERT_EQ(rows[0].size(), 8u);
  EXPECT_EQ(rows[0][6], "yes");
  EXPECT_NEAR(std::stod(rows[0][3]), 5.0, 0.05);
  EXPECT_NEAR(std::stod(rows[0][4]), 3.0, 0.002);
  expect_parts(finished.err, {"does not keep its distance"});
}

// Exactly 3 m is not closer than 3 m: what straight lines leave open is decided along the curves,
// however roughly these are followed, as by verify.
TEST_F(CurvedShow, OneWithinTheToleranceIsDecidedAlongTheCurves) {
  for (const char* tolerance : {"0.001", "0.5"}) {
    EXPECT_EQ(below_header(ask("3", {"--tolerance", tolerance}).out), "");
    EXPECT_EQ(ask("3", {"--tolerance", tolerance, "--fail-on-risk"}).exit_code, 0);
    const Finished closer = ask("3.0002", {"--tolerance", tolerance, "--csv"});
    const auto rows = rows_of(closer.out, ',');
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].at(6), "certain");
    EXPECT_EQ(rows[1].at(6), "yes");
    expect_parts(closer.err, {"does not keep its distance"});
  }
}

// An exact threshold that counts is not decided so: it stays possible.
TEST_F(CurvedShow, OneThatTouchesAnInclusiveThresholdStaysPossible) {
  const Finished finished = ask("3", {"--inclusive", "--json"});
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {R"("certain": false, "lasts_s": )"});
  expect_parts(finished.err, {"may not keep its distance"});
  EXPECT_EQ(ask("3", {"--inclusive", "--fail-on-risk"}).exit_code, 1);
}

// One lands 1 m beside another one that waits for its take-off, long before it flies: that is a
// conflict. Two that both stand, 1 m apart from then on, are none.
TEST_F(ShowReplay, ADroneThatStandsIsThereForThoseThatFly) {
  const std::string show = R"({"version": 1, "settings": {}, "swarm": {"drones": [)" +
                           drone("waits",
                                 "[0, [0, 0, 0], []], [20, [0, 0, 0], []], [25, [0, 0, 10], []], "
                                 "[30, [30, 0, 0], []]") +
                           "," +
                           drone("lands",
                                 "[0, [20, 0, 0], []], [3, [20, 0, 5], []], [6, [1, 0, 5], []], "
                                 "[9, [1, 0, 0], []]") +
                           "]}}";
  const Finished finished = replay(show, {"--threshold", "2", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  const auto rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 2u) << finished.out;
  // From sqrt(3) m above the ground at 5/3 m/s, and until the other one is as high at 2 m/s.
  EXPECT_NEAR(std::stod(rows[0][2]), 9.0 - std::sqrt(3.0) * 0.6, 1e-6);
  EXPECT_EQ(rows[0][4], "1");
  EXPECT_EQ(rows[0][5], "9");
  EXPECT_EQ(rows[1][2], "20");
  EXPECT_NEAR(std::stod(rows[1][5]), 20.0 + std::sqrt(3.0) * 0.5, 1e-6);
  const Finished verify = run({"verify", folder_.file("show.json", show), "--threshold", "2"});
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(verify.err, {"losses     2 conflicts, 2 with a drone on the ground\n",
                            "does not keep its distance"});
  const Finished apart = replay(show, {"--threshold", "0.99", "--fail-on-risk"});
  EXPECT_EQ(apart.exit_code, 0) << apart.out << apart.err;
}

// One that never takes off is in the way of who lands on it; of who stands beside it, it is not.
TEST_F(ShowReplay, ADroneThatNeverTakesOffIsThereForThoseThatFly) {
  const std::string show = R"({"version": 1, "settings": {}, "swarm": {"drones": [)" +
                           drone("spare", "[0, [0, 0, 0], []], [60, [0, 0, 0], []]") + "," +
                           drone("beside", "[0, [1, 0, 0], []]") + "," +
                           drone("lands",
                                 "[0, [20, 0, 0], []], [3, [20, 0, 5], []], [6, [-1, 0, 5], []], "
                                 "[9, [-1, 0, 0], []]") +
                           "]}}";
  const std::string path = folder_.file("show.json", show);
  const Finished finished = run({"replay", path, "--threshold", "1.5", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err,
               {"bees       3\n", "1 conflict of 1 pair, 1 with a drone on the ground",
                "closest    spare and lands, 1.000 m apart", "s, with a drone on the ground\n"});
  // Of each bee who is closest in the air, and behind that who is with a drone on the ground.
  const auto bees = rows_of(run({"replay", path, "--threshold", "1.5", "--report", "bees"}).out);
  ASSERT_EQ(bees.size(), 3u);
  ASSERT_EQ(bees[2].size(), 10u);
  EXPECT_EQ(bees[2][0], "lands");
  EXPECT_EQ(bees[2][3], "");
  EXPECT_NEAR(std::stod(bees[2][7]), 1.0, 1e-9);
  EXPECT_EQ(bees[2][9], "spare");
  const Finished verify = run({"verify", path, "--threshold", "1.5"});
  EXPECT_EQ(verify.exit_code, 1);
  expect_parts(verify.err, {"losses     1 conflict, 1 with a drone on the ground\n"});
  const Finished page =
      run({"report", path, "--threshold", "1.5", "--output", folder_.path("x.html")});
  EXPECT_EQ(page.exit_code, 0) << page.err;
  EXPECT_NE(folder_.read("x.html").find("\"stands\""), std::string::npos);
}

// Two that stand 1 m beside each other until 5 s, and a third that never takes off: as a show and
// as tables.
TEST_F(ShowReplay, TablesLeaveTheTimeOnTheGroundOutAsShowsDo) {
  const auto path = [](const std::string& y) {
    return "[0, [0, " + y + ", 0], []], [5, [0, " + y + ", 0], []], [10, [0, " + y +
           "0, 10], []], [15, [0, " + y + ", 0], []], [20, [0, " + y + ", 0], []]";
  };
  const std::string show =
      folder_.file("show.json", R"({"version": 1, "settings": {}, "swarm": {"drones": [)" +
                                    drone("a", path("1")) + "," + drone("b", path("2")) + "," +
                                    drone("c", "[0, [0, 3, 0], []], [20, [0, 3, 0], []]") + "]}}");
  const auto table = [&](const std::string& name, const std::string& y, bool flies) {
    std::string rows = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n";
    for (int t = 0; t <= 20; t += 5) {
      rows +=
          std::to_string(t * 1000) + ",0," + y + (flies && t == 10 ? "0,10" : ",0") + ",0,0,0\n";
    }
    folder_.file("tables/" + name + ".csv", rows);
  };
  std::filesystem::create_directory(folder_.path("tables"));
  table("a", "1", true);
  table("b", "2", true);
  table("c", "3", false);
  for (const Arguments& more : {Arguments{}, Arguments{"--grounded"}}) {
    const Finished of_show = run(Arguments{"replay", show, "--threshold", "1.5"} + more);
    const Finished of_tables =
        run(Arguments{"replay", folder_.path("tables"), "--threshold", "1.5"} + more);
    const auto rows = rows_of(of_show.out);
    const auto others = rows_of(of_tables.out);
    ASSERT_EQ(rows.size(), others.size()) << of_show.out << of_tables.out;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(rows[i][k], others[i][k]) << of_tables.out;
    }
    if (!more.empty()) continue;
    for (const Finished& one : {of_show, of_tables}) {
      expect_parts(one.err, {"from       5.00 s to 15.00 s", "2 drones stand on the ground",
                             "1 drone never leaves the ground", "with a drone on the ground"});
    }
  }
}

// 1.92 - 1.12 is 0.8, though of doubles it is less.
TEST_F(ShowReplay, AShowAtExactlyItsOwnDistanceKeepsIt) {
  const auto show = [](const std::string& first, const std::string& second) {
    return R"({"version": 1, "settings": {"validation": {"minDistance": 0.8}}, )"
           R"("swarm": {"drones": [)" +
           flight("left", first) + "," + flight("right", second) + "]}}";
  };
  const std::string table =
      "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n0,0,Y,0,0,0,0\n2000,0,Y,9,0,0,0\n"
      "4000,0,Y,0,0,0,0\n";
  const auto at = [&](const std::string& name, const std::string& y) {
    std::string rows = table;
    for (auto k = rows.find('Y'); k != std::string::npos; k = rows.find('Y')) rows.replace(k, 1, y);
    return folder_.file(name, rows);
  };
  for (const auto& [second, exit_code] : {std::pair("1.92", 0), {"1.919999", 1}}) {
    const std::string file = folder_.file("show.json", show("1.12", second));
    const Finished replayed = run({"replay", file, "--fail-on-risk"});
    EXPECT_EQ(replayed.exit_code, exit_code) << replayed.err;
    EXPECT_EQ(run({"verify", file}).exit_code, exit_code);
    if (exit_code == 0) {
      expect_parts(replayed.err, {"verdict    keeps its distance\n", " 0.800 m apart at "});
    }
    const Arguments tables = {at("left.csv", "1.12"), at("right.csv", second), "--threshold",
                              "0.8"};
    EXPECT_EQ(run(Arguments{"replay", "--fail-on-risk"} + tables).exit_code, exit_code);
    EXPECT_EQ(run(Arguments{"verify"} + tables).exit_code, exit_code);
  }
}

// Of several conflicts those in the air come first, however close one lands beside a parked drone.
TEST_F(ShowReplay, TheClosestTwoInTheAirAreNamedBeforeThoseOnTheGround) {
  const auto show = [](const std::string& y) {
    return R"({"version": 1, "settings": {}, "swarm": {"drones": [)" +
           drone("spare", "[0, [0, 0, 0], []], [60, [0, 0, 0], []]") + "," +
           drone("lands",
                 "[0, [20, 0, 0], []], [3, [20, 0, 5], []], [6, [-1, 0, 5], []], "
                 "[9, [-1, 0, 0], []]") +
           "," +
           drone("beside", "[0, [20, " + y + ", 0], []], [3, [20, " + y + ", 5], []], [6, [20, " +
                               y + ", 0], []]") +
           "]}}";
  };
  const std::string near = folder_.file("near.json", show("1.5"));
  const Finished replayed = run({"replay", near, "--threshold", "2"});
  expect_parts(replayed.err, {"2 conflicts of 2 pairs, 1 with a drone on the ground\n",
                              "closest    lands and beside, 1.500 m apart at ",
                              "\n             spare and lands, 1.000 m apart at ",
                              ", with a drone on the ground\n  worst      lands and beside, ",
                              "\n             spare and lands, 1.000 m apart at "});
  const Finished verified = run({"verify", near, "--threshold", "2"});
  expect_parts(verified.err, {"closest    lands and beside, 1.500 m apart at ",
                              "\n             spare and lands, 1.000 m apart at ",
                              "losses     2 conflicts, 1 with a drone on the ground\n"
                              "             lands and beside, 1.500 m apart at "});
  const Finished json = run({"replay", near, "--threshold", "2", "--json"});
  expect_parts(json.out,
               {R"("with_standing_count": 1)", R"("closest_in_the_air": {"first": "lands")",
                R"("closest": {"first": "spare")"});
  // Also where those in the air keep apart.
  const Finished far = run({"replay", folder_.file("far.json", show("3")), "--threshold", "2"});
  expect_parts(far.err, {"1 conflict of 1 pair, 1 with a drone on the ground\n",
                         "closest    lands and beside, 3.000 m apart at ",
                         "\n             spare and lands, 1.000 m apart at "});
}

// Who hovers still at the lowest height of a show that is all in the air does not stand.
TEST_F(ShowReplay, WhoHoversAtTheLowestHeightOfAShowInTheAirFlies) {
  const std::string home = R"({"type": "generic", "settings": {"home": [0, 0, 10], "name": ")";
  const auto hovers = [&](const std::string& name, const std::string& points) {
    return home + name + R"(", "trajectory": {"version": 1, "points": [)" + points + "]}}}";
  };
  const std::string show = R"({"version": 1, "settings": {}, "swarm": {"drones": [)" +
                           hovers("hovers", "[0, [10, 0, 10], []], [60, [10, 0, 10], []]") + "," +
                           hovers("beside", "[0, [11, 0, 10], []], [60, [11, 0, 10], []]") + "," +
                           hovers("crosses", "[0, [0, 0.5, 10], []], [60, [60, 0.5, 10], []]") +
                           "]}}";
  const std::string path = folder_.file("show.json", show);
  const Finished finished = run({"replay", path, "--threshold", "2", "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"bees       3\n", "3 conflicts of 3 pairs\n"});
  EXPECT_EQ(run({"verify", path, "--threshold", "2"}).exit_code, 1);
}

// Its drones would be in conflict with themselves.
TEST_F(ShowReplay, ATakeOffGridBesideItIsAskedAbout) {
  const std::string show = folder_.file("show.json", declaring("2"));
  for (const auto& [table, said] : std::vector<std::pair<std::string, std::string>>{
           {"name,time_s,x,y,z\nleft,0,0,0,0\nright,0,0,3,0\n",
            "bee 'left' is also a drone of the show"},
           {"id,time_s,x,y,z\n1,0,0,0,0\n2,0,0,3,0\n",
            "bee '1' stands where drone 'left' of the show begins, as in a take-off grid"},
           {"id,time_s,x,y,z\nother,0,5,50,0\n2,0,0,3,0.2\n2,20,0,3,0.2\n",
            "bee '2' stands where drone 'right' of the show begins"}}) {
    const std::string grid = folder_.file("grid.csv", table);
    for (const Arguments& files : {Arguments{show, grid}, Arguments{grid, show}}) {
      const Finished finished = run(Arguments{"replay"} + files);
      EXPECT_EQ(finished.exit_code, 2) << finished.out;
      expect_parts(finished.err, {"grid.csv", said, ": read the show alone"});
    }
  }
}

// Key frames are a plan, however far apart they are: a table beside them says nothing of them.
TEST_F(ShowReplay, GapsOfATableAreNoGapsOfAShowBesideIt) {
  std::string table = "id,time_s,x,y,z\n";
  for (int k = 0; k <= 140; ++k) {
    const std::string t = std::to_string(k / 10) + "." + std::to_string(k % 10);
    table += "visitor," + t + ",5,1,10\n";
  }
  const std::string show = folder_.file("show.json", declaring("2"));
  const std::string file = folder_.file("visitor.csv", table);
  const Finished finished = run({"replay", show, file, "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(finished.err.find("unknown"), std::string::npos) << finished.err;
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1u) << finished.out << finished.err;
  EXPECT_EQ(rows[0].at(0) + rows[0].at(1), "leftvisitor");
  // Its way of ten seconds is straight, and passes 1 m beside the visitor after 7 s.
  EXPECT_EQ(rows[0].at(3) + " " + rows[0].at(4), "7 1");
  const Finished asked = run({"replay", show, file, "--max-gap", "1"});
  EXPECT_EQ(asked.err.find("unknown"), std::string::npos) << asked.err;
}

// Two take off and land at the same instants while a third one flies: they are one conflict, and
// none with one on the ground.
TEST_F(ShowReplay, WhoLandsWithAnotherIsNotBesideOneOnTheGround) {
  const auto flown = [](const std::string& x, int begins_s, int ends_s) {
    const auto row = [&x](int time_s, int height_m) {
      return std::to_string(1000 * time_s) + "," + x + ",0," + std::to_string(height_m) +
             ",0,0,0\n";
    };
    return "Time [msec],x [m],y [m],z [m],Red,Green,Blue\n" + row(0, 0) + row(begins_s, 0) +
           row(begins_s + 5, 20) + row(ends_s - 5, 20) + row(ends_s, 0) + row(61, 0);
  };
  const TemporaryFolder folder;
  folder.file("Drone 1.csv", flown("0", 5, 53));
  folder.file("Drone 2.csv", flown("1.4", 5, 53));
  folder.file("Drone 3.csv", flown("30", 13, 60));
  const Finished finished =
      run({"replay", folder.path(""), "--threshold", "2", "--max-gap", "100"});
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1u) << finished.out << finished.err;
  EXPECT_EQ(rows[0].at(2) + " " + rows[0].at(5), "5 53");
  EXPECT_NE(finished.err.find("1 conflict of 1 pair"), std::string::npos) << finished.err;
}

}  // namespace
}  // namespace beespace::cli_test
