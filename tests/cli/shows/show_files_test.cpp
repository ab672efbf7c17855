// Drone shows in the layouts of the tools that make them (see make-shows), by the first command
// that their operator would type.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/cli/run/below_header.hpp"
#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"
#include "tests/cli/run/temporary_folder.hpp"
#include "tests/cli/run/xml_check.hpp"

namespace beespace::cli_test {
namespace {

std::string show_file(const std::string& name) {
  return std::string(BEESPACE_SHOWS) + "/" + name;
}

std::string text_of_file(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class CompiledShow : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Forms, CompiledShow, testing::Values("ring.skyc", "ring.json"),
                         [](const auto& name) { return std::string(name.param).substr(5); });

// Half way along the sides of a square of 5 m two drones are 2.5 times the square root of 2 apart.
TEST_P(CompiledShow, ReplayNamesTheFourThatComeTooCloseAtTheShowsOwnDistance) {
  const Finished finished = run({"replay", show_file(GetParam()), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1);
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 4u) << finished.out;
  EXPECT_EQ(rows[0][0] + rows[0][1], "Drone 1Drone 2");
  EXPECT_NEAR(std::stod(rows[0][4]), 3.5355339, 1e-5);
  expect_parts(finished.err, {"threshold  4 m (closer than), as the input declares\n",
                              "verdict    does not keep its distance: 4 conflicts of 4 pairs\n"});
}

// Down from 10 m in 6 s along a curve at rest at both ends: 2.5 m/s in the middle.
TEST_P(CompiledShow, VerifyFindsWhoDescendsFasterThanTheShowAllows) {
  const Finished finished = run({"verify", show_file(GetParam())});
  EXPECT_EQ(finished.exit_code, 1);
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 5u) << finished.out;
  expect_rows({rows[4]}, {{"descent", "Drone 1", "", "20", "26", "2.5", "2.4", "23"}});
  expect_parts(
      finished.err,
      {"motion     along the curves of the show\n",
       "limits     horizontal speed 8 m/s, climb 3 m/s, descent 2.4 m/s, height 120 m (as "
       "the show declares)\n",
       "closest    Drone 1 and Drone 2, 3.536 m apart at 15.00 s\n",
       "climb 2.500 m/s, Drone 1 at 7.00 s\n", "losses     4 conflicts\n",
       "breaches   1 stretch above the descent of 2.4 m/s, the worst 2.500 m/s: Drone 1 at "
       "23.00 s\n",
       "verdict    does not keep its distance, and breaks the limits\n"});
}

TEST_P(CompiledShow, VerifyHoldsWhereItIsAskedForLess) {
  const Finished finished = run({"verify", show_file(GetParam()), "--threshold", "3.5",
                                 "--max-descent", "2.5", "--max-acceleration", "1.667"});
  EXPECT_EQ(finished.exit_code, 0) << finished.out;
  EXPECT_EQ(below_header(finished.out), "");
  expect_parts(finished.err, {"limits     descent 2.5 m/s, acceleration 1.667 m/s^2, horizontal",
                              "losses     none\n", "breaches   none\n", "verdict    holds\n"});
  EXPECT_EQ(run({"verify", show_file(GetParam()), "--threshold", "3.5", "--max-descent", "2.5",
                 "--max-acceleration", "1.66"})
                .exit_code,
            1);
}

TEST_P(CompiledShow, ItsJsonHasLimitsAndGreatestValues) {
  const Finished finished = run({"verify", show_file(GetParam()), "--json", "--quiet"});
  EXPECT_TRUE(is_json(finished.out));
  expect_parts(finished.out,
               {R"("descent": {"most": 2.4, "unit": "m/s", "declared": true})",
                R"("climb": {"most": 3, "unit": "m/s", "declared": true})",
                R"("descent": {"value": 2.5, "unit": "m/s", "id": "Drone 1", "at_s": 23})",
                R"("holds": false)", R"("breach_count": 1)"});
}

TEST_P(CompiledShow, ExportsLieWhereTheShowSays) {
  const TemporaryFolder folder;
  const std::string path = show_file(GetParam());
  const Finished finished = run({"export", path, "-o", folder.path("ring.geojson")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"placed on the Earth at longitude 19.06207, latitude 47.47292, height "
                "130.5 m, with x towards 30 degrees from north and y to its left"});
  // Half way between (0, -2.5) and (2.5, 0): 1.7075 m east and 0.4575 m north of the origin.
  expect_parts(text_of_file(folder.path("ring.geojson")),
               {R"("coordinates": [19.062092652, 47.472924115, 140.5])"});
  for (const char* const format : {"kml", "czml"}) {
    const Finished map = run({"export", path, "--format", format});
    EXPECT_EQ(map.exit_code, 0) << map.err;
    EXPECT_NE(map.out.find("19.0620"), std::string::npos);
  }
}

// Along the first side, 0.5 m from which a pillar stands; the others are 4 m away from it and more.
TEST_P(CompiledShow, DronesKeepClearOfObstaclesAlongTheirCurves) {
  const TemporaryFolder folder;
  const std::string pillar = folder.file(
      "pillar.json",
      R"({"obstacles": [{"kind": "cylinder", "center": [0, -3.5], "radius_m": 0.5, "high_m": 20}]})");
  const auto verify = [&](const std::string& clearance) {
    return run({"verify", show_file(GetParam()), "--threshold", "3", "--max-descent", "3",
                "--obstacles", pillar, "--clearance", clearance});
  };
  const Finished touched = verify("0.6");
  EXPECT_EQ(touched.exit_code, 1);
  expect_rows(rows_of(touched.out),
              {{"clearance", "Drone 1", "obstacles[0], a cylinder", "12", "18", "0.5", "0.6", ""}});
  EXPECT_EQ(verify("0.49").exit_code, 0);
}

#if BEESPACE_HAS_PAGE
TEST_P(CompiledShow, ThePageHasItsLimitsAndCues) {
  const TemporaryFolder folder;
  const std::string page = folder.path("ring.html");
  EXPECT_EQ(run({"report", show_file(GetParam()), "--output", page}).exit_code, 0);
  expect_parts(folder.read("ring.html"),
               {R"("limits":{"horizontal_mps":8,"climb_mps":3,"descent_mps":2.4,"height_m":120})",
                R"("limits_kept":{"count":1,"greatest":[{"limit":"horizontal","most":8,)",
                R"({"limit":"descent","most":2.4,"value":2.5,"bee":0,"time_s":19},)",
                R"("excesses":[{"limit":2,"bee":0,"begins_s":16,"ends_s":22,"value":2.5,)",
                R"({"time_s":8,"name":"Ring"})"});
}
#endif

class ShowTables : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Forms, ShowTables, testing::Values("ring.zip", "ring-csv"),
                         [](const auto& name) { return std::string(name.param).substr(5); });

TEST_P(ShowTables, AreShowsWithAThresholdOfTheirs) {
  const Finished finished = run({"replay", show_file(GetParam()), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.out;
  expect_parts(finished.err,
               {"bees       4\n",
                "threshold  2 m (closer than), the default of shows that declare none "
                "(--threshold)\n",
                "verdict    keeps its distance\n", "3.536 m apart at 15.00 s"});
}

TEST_P(ShowTables, DronesThatLandAtDifferentTimesAreVerified) {
  const Finished finished =
      run({"verify", show_file(GetParam()), "--threshold", "3.6", "--max-climb", "2.4"});
  EXPECT_EQ(finished.exit_code, 1);
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 8u) << finished.out;  // four pairs, four drones
  EXPECT_EQ(rows[0][0], "loss");
  EXPECT_EQ(rows[4][0] + rows[4][1], "climbDrone 1");
  EXPECT_EQ(
      run({"verify", show_file(GetParam()), "--max-climb", "2.5", "--max-height", "10"}).exit_code,
      0);
}

TEST_P(ShowTables, EveryDroneHasItsClosest) {
  const TextRows rows = rows_of(run({"replay", show_file(GetParam()), "--report", "bees"}).out);
  ASSERT_EQ(rows.size(), 4u);
  for (const auto& row : rows) {
    EXPECT_EQ(row[1], "0");
    EXPECT_NEAR(std::stod(row[3]), 3.5355339, 1e-5);
    EXPECT_EQ(row[6], "0");
  }
}

TEST(ShowPlace, IsAskedForWithItsHeading) {
  const TemporaryFolder folder;
  const std::string tables = show_file("ring-csv");
  const Finished nowhere = run({"export", tables, "--format", "kml"});
  EXPECT_EQ(nowhere.exit_code, 2);
  expect_parts(nowhere.err, {"say with --origin lon,lat,height,heading where it is"});
  const Finished unturned = run({"export", tables, "--format", "kml", "--origin", "19,47,130"});
  EXPECT_EQ(unturned.exit_code, 2);
  expect_parts(unturned.err, {"--origin needs the heading of the x axis too"});
  expect_parts(run({"export", tables, "--format", "kml", "--origin", "19,91,130,0"}).err,
               {"--origin: "});
}

// x to the north is y to the west: skybrush's axes; x to the east is y to the north.
TEST(ShowPlace, TurnsAxes) {
  const TemporaryFolder folder;
  const std::string flight = folder.file(
      "two.csv", "id,time_s,x,y,z\na,0,1000,0,5\na,1,1000,0,5\nb,0,1000,2,5\nb,1,1000,2,5\n");
  const auto exported = [&](const std::string& heading) {
    return run({"export", flight, "--threshold", "3", "--format", "geojson", "--origin",
                "0,0,100," + heading})
        .out;
  };
  // A degree is 111,319.49 m along the equator, and 110,574.28 m along a meridian there.
  expect_parts(exported("90"), {"[0.008983153, 9.044e-06, 105]"});
  expect_parts(exported("0"), {"[-8.983e-06, 0.009043695, 105]"});
  expect_parts(exported("180"), {"[8.983e-06, -0.009043695, 105]"});
}

TEST(ShowPlace, OfAShowIsNotGuessed) {
  const TemporaryFolder folder;
  std::string show = text_of_file(show_file("ring.json"));
  const auto with = [&](const std::string& location) {
    std::string other = show;
    const std::size_t at = other.find(R"({"origin")");
    other.replace(at, other.find('}', at) + 1 - at, location);
    return run({"export", folder.file("ring.json", other), "--format", "kml"});
  };
  for (const char* const location :
       {R"({"origin": [47.5, 19.1], "orientation": 30})", R"({"origin": [474729200, 190620700]})",
        R"({"origin": [990620700, 474729200], "orientation": 30})",
        R"({"origin": [474729200, 190620700], "orientation": 30, "type": "xyz"})"}) {
    const Finished finished = with(location);
    EXPECT_EQ(finished.exit_code, 2) << location;
    expect_parts(finished.err, {"--origin"});
  }
  EXPECT_EQ(
      with(R"({"origin": [474729200, 190620700], "orientation": 30, "type": "neu"})").exit_code, 0);
}

// How they lie to each other is not guessed: the next show may stand right beside the first one.
TEST(ShowPlace, OfSeveralShowsIsToBeOne) {
  const TemporaryFolder folder;
  const std::string show = text_of_file(show_file("ring.json"));
  const auto at = [&](const std::string& name, const std::string& location) {
    std::string other = show;
    const std::size_t begin = other.find(R"({"origin")");
    other.replace(begin, other.find('}', begin) + 1 - begin, location);
    return folder.file(name, other);
  };
  const std::string here =
      at("here.json", R"({"origin": [474729200, 190620700], "orientation": 30, "type": "neu"})");
  const std::string there =
      at("there.json", R"({"origin": [474729300, 190620700], "orientation": 30, "type": "neu"})");
  const std::string nowhere = at("nowhere.json", "{}");
  for (const char* const command : {"verify", "replay"}) {
    for (const std::string& other : {there, nowhere}) {
      const Finished apart = run({command, here, other});
      EXPECT_EQ(apart.exit_code, 2) << apart.err;
      expect_parts(apart.err, {"how they lie to each other is not known", "--crs metres"});
    }
    // Two that are at one place, as the caller says, collide drone by drone.
    EXPECT_EQ(run({command, here, there, "--crs", "metres", "--threshold", "1"}).err.find("error"),
              std::string::npos);
    EXPECT_EQ(
        run({command, here, folder.file("again.json", text_of_file(here)), "--threshold", "1"})
            .err.find("error"),
        std::string::npos);
  }
}

// Which comes first is asked for, with what to type.
TEST(ShowPlace, InDegreesIsAskedFor) {
  const TemporaryFolder folder;
  std::string show = text_of_file(show_file("ring.json"));
  const std::string location = "[474729200, 190620700, 130500]";
  const auto exported = [&](const std::string& origin, const Arguments& more = {}) {
    std::string other = show;
    other.replace(other.find(location), location.size(), origin);
    return run(Arguments{"export", folder.file("ring.json", other), "--format", "kml"} + more);
  };
  const Finished flat = exported("[19.06, 47.48]");
  EXPECT_EQ(flat.exit_code, 2);
  expect_parts(
      flat.err,
      {"'beespace export' with --origin 19.06,47.48,0,30 if it does, otherwise with --origin "
       "47.48,19.06,0,30 (with the height of the place instead of 0)"});
  expect_parts(exported("[19.06, 47.48, 110]").err,
               {"otherwise with --origin 47.48,19.06,110,30 (see"});
  EXPECT_EQ(exported("[19.06, 47.48]", {"--origin", "19.06,47.48,0,30"}).exit_code, 0);
}

// Heights then are those above the ground, and that is said.
TEST(ShowPlace, WithoutAHeightIsOnTheGround) {
  const TemporaryFolder folder;
  std::string show = text_of_file(show_file("ring.json"));
  const std::string location = "[474729200, 190620700, 130500]";
  const auto exported = [&](const std::string& format) {
    return run({"export", folder.path("ring.json"), "--format", format});
  };
  folder.file("ring.json", show);
  EXPECT_EQ(exported("kml").out.find("relativeToGround"), std::string::npos);
  show.replace(show.find(location), location.size(), "[474729200, 190620700]");
  folder.file("ring.json", show);
  const Finished kml = exported("kml");
  expect_parts(kml.out, {"<altitudeMode>relativeToGround</altitudeMode>", "19.06208"});
  EXPECT_EQ(kml.out.find("absolute"), std::string::npos);
  for (const char* const format : {"kml", "czml"}) {
    expect_parts(exported(format).out, {"of which the input does not say how high it is"});
  }
  expect_parts(exported("geojson").err,
               {"as the show says, which gives no height: heights are those above the place of "
                "take-off"});
}

TEST(ShowLimits, ThatAreNoneAreErrors) {
  const TemporaryFolder folder;
  std::string show = text_of_file(show_file("ring.json"));
  const std::string limit = R"("maxVelocityZ": 2.4)";
  for (const char* const other : {R"("maxVelocityZ": 0)", R"("maxVelocityZ": "fast")"}) {
    std::string changed = show;
    changed.replace(changed.find(limit), limit.size(), other);
    const Finished finished = run({"verify", folder.file("ring.json", changed)});
    EXPECT_EQ(finished.exit_code, 3);
    expect_parts(finished.err, {"settings.validation.maxVelocityZ"});
  }
}

// Two that fly side by side exactly 4 m apart along curves, which no rounding may call closer.
TEST(ShowLimits, ExactlyTheDistanceIsKept) {
  const TemporaryFolder folder;
  const auto drone = [](const std::string& name, const std::string& x) {
    return R"({"settings": {"name": ")" + name +
           R"(", "trajectory": {"version": 1, "points": [[0, [)" + x + R"(, 0, 1], []], [3.7, [)" +
           x + R"(, 7.3, 9.1], [[)" + x + ", 0.1, 3.3], [" + x + R"(, 8.1, 8.7]]]]}}})";
  };
  const auto show = [&](const std::string& least) {
    return folder.file("two.json", R"({"version": 1, "settings": {"validation": {"minDistance": )" +
                                       least + R"(}}, "swarm": {"drones": [)" + drone("a", "1.5") +
                                       "," + drone("b", "5.5") + "]}}");
  };
  EXPECT_EQ(run({"verify", show("4")}).exit_code, 0);
  EXPECT_EQ(run({"verify", show("4.000000000000001")}).exit_code, 1);
}

TEST(ShowTablesOfOthers, WithoutAHeaderAreKnownByTheirColours) {
  const TemporaryFolder folder;
  const std::string bare =
      folder.file("d1.csv", "0,0,0,5,255,0,0\n250,0,1,5,255,0,0\n500,0,2,5,0,0,255\n");
  const Finished finished = run({"replay", bare});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"taken for a Skybrush CSV", "threshold  2 m"});
  // Not where the last three are no colours.
  const std::string other = folder.file("d2.csv", "0,0,0,5,1.5,0,0\n250,0,1,5,1.5,0,0\n");
  EXPECT_EQ(run({"replay", other}).exit_code, 3);
}

TEST(ShowTablesOfOthers, WhichAreNotReadGetASentence) {
  const TemporaryFolder folder;
  const std::string vviz = folder.file("show.vviz", R"({"version": "1.0", "performances": []})");
  expect_parts(run({"replay", vviz}).err, {"the show has no performances; export it again"});
  folder.file("1.path3", "x");
  const TemporaryFolder paths;
  paths.file("1.path", "x");
  expect_parts(run({"replay", paths.path("")}).err, {"paths of a drone show (DSS)"});
}

TEST(ShowFolders, ASheetOfCuesIsNoDrone) {
  const TemporaryFolder folder;
  const std::string header = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n";
  folder.file("a.csv", header + "0,0,0,0,0,0,0\n2000,0,0,10,0,0,0\n4000,0,0,0,0,0,0\n");
  folder.file("b.csv", header + "0,9,0,0,0,0,0\n2000,9,0,10,0,0,0\n4000,9,0,0,0,0,0\n");
  folder.file("cues.csv", "time,cue\n0,start\n");
  const Finished finished = run({"replay", folder.path(""), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"bees       2"});
}

TEST(ShowFolders, TextsForPeopleAreNoTables) {
  const TemporaryFolder folder;
  const std::string header = "Time_msec,x_m,y_m,z_m,Red,Green,Blue\n";
  folder.file("a.csv", header + "0,0,0,0,0,0,0\n2000,0,0,10,0,0,0\n4000,0,0,0,0,0,0\n");
  folder.file("b.csv", header + "0,9,0,0,0,0,0\n2000,9,0,10,0,0,0\n4000,9,0,0,0,0,0\n");
  folder.file("README.txt", "The show of Friday.\n");
  const Finished finished = run({"replay", folder.path(""), "--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"bees       2\n", "keeps its distance"});
  EXPECT_EQ(finished.err.find("left out"), std::string::npos) << finished.err;
}

TEST(ShowFolders, OneShowIsReadAndOfSeveralItIsAsked) {
  const TemporaryFolder folder;
  const std::string show = text_of_file(show_file("ring.skyc"));
  folder.file("ring.skyc", show);
  folder.file("plan.txt", "Take off at nine.\n");
  const Finished one = run({"replay", folder.path("")});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  expect_parts(one.err, {"4 conflicts of 4 pairs", "plan.txt is left out"});
  folder.file("ring-2.skyc", show);
  const Finished two = run({"replay", folder.path("")});
  EXPECT_EQ(two.exit_code, 3);
  expect_parts(two.err, {"there are 2 shows (.skyc) in this folder"});
}

// Rows of centimetres: up to 10 m in 10 s, as 1,000.
TEST(ShowFolders, CentimetresWithoutAHeaderAreAskedAbout) {
  std::string table;
  for (int t = 0; t <= 20; ++t) {
    table += std::to_string(1000 * t) + ",300,0," + std::to_string(100 * std::min(t, 20 - t)) +
             ",255,0,0\n";
  }
  const Finished finished = run({"replay"}, table);
  EXPECT_EQ(finished.exit_code, 2);
  expect_parts(finished.err, {"are x, y, z in metres? Nothing names their unit, and in metres they "
                              "move at 100 m/s; say it with --units position=cm"});
  const Finished said = run({"verify", "--units", "position=cm", "--max-height", "9"}, table);
  EXPECT_EQ(said.exit_code, 1) << said.err;
  expect_parts(said.err, {"height 10.000 m"});
  EXPECT_EQ(run({"replay", "--units", "position=m"}, table).exit_code, 0);
}

TEST(ShowFolders, AFolderFurtherDownIsNamed) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("session/trajectories"));
  folder.file("session/trajectories/trajectories.csv",
              "time,x1,y1,x2,y2\n0.0,1,2,30,40\n0.04,1,2,30,41\n0.08,2,2,30,42\n");
  folder.file("session/trajectories/areas.csv", "id,mean\n");
  const Finished above = run({"replay", folder.path("session")});
  EXPECT_EQ(above.exit_code, 3);
  expect_parts(above.err, {"folders in it are not looked into: name ", "session/trajectories"});
  const Finished inside =
      run({"replay", folder.path("session/trajectories"), "--scale", "1", "--threshold", "3"});
  EXPECT_EQ(inside.exit_code, 0) << inside.err;
  expect_parts(inside.err, {"bees       2\n"});
  EXPECT_EQ(inside.err.find("left out"), std::string::npos) << inside.err;
}

}  // namespace
}  // namespace beespace::cli_test
