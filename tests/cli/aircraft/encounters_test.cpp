// What simulators of air traffic read, by the first command that somebody would type.
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/temporary_folder.hpp"

namespace beespace::cli_test {
namespace {

// One flies north along the equator's meridian, the other to the west along 1.5 degrees north from
// 1.5 degrees east, both at 400 kt calibrated and FL200: 269.76 m/s. They are at the crossing after
// 614.9 s and 618.9 s.
constexpr std::string_view kScenario =
    "# crossing\n00:00:00.00>ASAS ON\n00:00:00.00>CRE NORTH B744 0. 0. 0. FL200 400\n"
    "00:00:00.00>CRE WEST B744 1.50 1.50 270 FL200 400\n"
    "00:00:00.00>CRE ABOVE B744 0. 0.5 0. FL210 400\n";

TEST(Encounters, AScenarioIsPredicted) {
  const Finished finished =
      run({"predict", "--separation", "enroute", "--horizon", "900", "--csv"}, kScenario);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.out << finished.err;
  EXPECT_EQ(rows[1].at(0) + rows[1].at(1), "NORTHWEST");
  // They are closing at 381.5 m/s, and within 9,260 m some 24 s before they are closest.
  EXPECT_NEAR(std::stod(rows[1].at(2)), 616.9 - 24.3, 3.0);
  expect_parts(finished.err, {"BlueSky scenario", "compared with heights in ft as they stand",
                              "where they fly from there is for BlueSky to say",
                              "in the standard atmosphere without wind"});
}

TEST(Encounters, AScenarioOfUnknownAircraftIsNoAllClear) {
  const Finished finished = run({"predict", "--threshold", "10m", "--fail-on-risk"},
                                std::string(kScenario) + "00:00:00.00>MCRE 5\n");
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"none of those that are known; 1 record was left out"});
}

// Each hides where somebody flies: "none" is no all-clear.
TEST(Encounters, WhatAScenarioDoesNotSayIsNoAllClear) {
  for (const std::string command : {"HDG NORTH 90", "NORTH SPD 250", "ADDWPT WEST 1.0 1.0"}) {
    const Finished finished =
        run({"predict", "--threshold", "10m", "--horizon", "60", "--fail-on-risk"},
            std::string(kScenario) + "00:00:10.00>" + command + "\n");
    EXPECT_EQ(finished.exit_code, 1) << command << finished.err;
    expect_parts(finished.err,
                 {"checked for now only", "none of those that are known", "is not followed"});
  }
  const Finished all = run({"predict", "--threshold", "10m", "--fail-on-risk"},
                           std::string(kScenario) + "00:00:10.00>ALT ALL FL300\n");
  EXPECT_EQ(all.exit_code, 1) << all.err;
  expect_parts(all.err, {"3 checked for now only", "none of those that are known",
                         "3 aircraft are told how to fly from there"});
  EXPECT_EQ(all.err.find("columns vx"), std::string::npos) << all.err;
  const Finished unknown = run({"predict", "--threshold", "10m", "--fail-on-risk"},
                               std::string(kScenario) + "00:00:00.00>SPAWN EAST 0 2\n");
  EXPECT_EQ(unknown.exit_code, 1) << unknown.err;
  expect_parts(unknown.err, {"none of those that are known; 1 record was left out"});
  const Finished created =
      run({"predict", "--threshold", "1NM", "--vertical", "1000ft", "--fail-on-risk"},
          std::string(kScenario) + "00:00:00.00>CREATE NEAR B744 0. 0. 0. FL200 400\n");
  EXPECT_EQ(created.exit_code, 1) << created.err;
  expect_parts(created.err, {"conflicts  1, of 2 bees\n"});
}

// Aircraft that are created later do not make others old; how they fly is said when they are
// created.
TEST(Encounters, AircraftOfAScenarioFlyOnAsTheyWereCreated) {
  const std::string later =
      "00:00:00.00>CRE DLH4AB,A320,50.0,7.027673,90,FL350,280\n"
      "00:04:10.00>CRE RYR72KD,A320,49.902778,8.064822,0,FL350,280\n";
  const Finished predicted = run({"predict", "--separation", "enroute", "--fail-on-risk"}, later);
  EXPECT_EQ(predicted.exit_code, 1) << predicted.err;
  expect_parts(predicted.err,
               {"bees       2\n", "now        250.00 s\n",
                "1 created before now was let fly on as created, for up to 250.00 s; conflicts "
                "before now are not looked for",
                "conflicts  1, of 2 bees\n"});
  // For long, round the Earth: a straight line would have led 37 km above it.
  const Finished long_after = run({"predict", "--separation", "enroute", "--fail-on-risk"},
                                  "00:00:00.00>CRE KLM10,B744,50.0,0.0,90,FL350,0.78\n"
                                  "00:50:00.00>CRE BAW20,B744,50.0,10.22645,270,FL350,0.78\n");
  EXPECT_EQ(long_after.exit_code, 1) << long_after.err;
  expect_parts(long_after.err, {"for up to 3,000.00 s", "conflicts  1, of 2 bees\n"});
  // Of one that is told how to fly it is not known where it is by then.
  const Finished turned = run({"predict", "--separation", "enroute", "--fail-on-risk"},
                              later + "00:00:10.00>DLH4AB HDG 180\n");
  EXPECT_EQ(turned.exit_code, 1) << turned.err;
  expect_parts(turned.err,
               {"stale      1 left out, created more than 30 s before now (--max-age), of "
                "which it is not known how they fly from there\n"});
}

// Two are in conflict before a third one is created far away.
TEST(Encounters, WhatWasBeforeTheLastIsCreatedIsLookedAt) {
  const std::string first = "00:00:00.00>CRE AFR123,B738,48.000000,1.813317,90,FL350,M.78\n";
  const std::string crossing = "00:00:00.00>CRE BAW456,B738,47.930602,2.000000,0,FL350,M.78\n";
  const std::string far = "00:00:00.00>CRE BAW456,B738,40.930602,2.000000,0,FL350,M.78\n";
  const std::string third = "00:05:00.00>CRE XX1,B738,52,10,90,FL350,M.78\n";
  const Arguments predict{"predict", "--separation", "enroute", "--fail-on-risk"};
  const Finished met = run(predict, first + crossing + third);
  EXPECT_EQ(met.exit_code, 1) << met.err;
  expect_parts(met.err, {"conflicts are looked for from 0.00 s on", "conflicts  1, of 2 bees\n",
                         "AFR123 and BAW456, 278."});
  expect_parts(met.err, {" s before now\n"});
  expect_parts(run(predict + Arguments{"--json"}, first + crossing + third).out,
               {R"("now_s": 300)", R"("looked_since_s": 0)"});
  const Finished apart = run(predict, first + far + third);
  EXPECT_EQ(apart.exit_code, 0) << apart.err;
  expect_parts(apart.err, {"conflicts  none\n"});
}

TEST(Encounters, WhatAPictureDoesNotShowIsNoAllClear) {
  const TemporaryFolder folder;
  const std::string file =
      folder.file("third.scn",
                  "00:00:00.00>CRE AFR123,B738,48.000000,1.813317,90,FL350,M.78\n"
                  "00:00:00.00>CRE BAW456,B738,47.930602,2.000000,0,FL350,M.78\n"
                  "00:05:00.00>CRE XX1,B738,52,10,90,FL350,M.78\n");
  const Finished shown = run(
      {"plot", file, "--separation", "enroute", "--fail-on-risk", "-o", folder.path("third.svg")});
  EXPECT_EQ(shown.exit_code, 1) << shown.err;
  expect_parts(shown.err,
               {"shown is one moment, 300.00 s", "from 0.00 s to 300.00 s not looked at"});
}

// Where aircraft begin is no flight: no verdict about one follows from it.
TEST(Encounters, AScenarioIsNoFlight) {
  for (const char* const command : {"replay", "verify"}) {
    const Finished finished = run({command, "--threshold", "10m"}, kScenario);
    EXPECT_EQ(finished.exit_code, 3) << command << finished.err;
    EXPECT_EQ(finished.out.find("holds"), std::string::npos);
    EXPECT_EQ(finished.err.find("keeps its distance"), std::string::npos);
    expect_parts(finished.err, {"ask 'beespace predict' about it"});
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("crossing.scn", kScenario);
  const Finished two = run({"predict", file, "--separation", "enroute"});
  EXPECT_EQ(two.exit_code, 0) << two.err;
  const Finished several =
      run({"replay", file, folder.file("more.csv", "id,time_s,lon,lat\na,0,0,0\n")});
  EXPECT_EQ(several.exit_code, 2);
  expect_parts(several.err, {"a BlueSky scenario is read alone"});
  const Finished shown = run({"detect", file});
  EXPECT_EQ(shown.exit_code, 3);
  expect_parts(shown.err, {"ask 'beespace predict' about it, with --horizon 0 for now only"});
}

// Two that fly towards each other at 231.5 m/s from 5 km apart.
TEST(Encounters, ALogOfBlueSkyIsReplayed) {
  std::string log = "# Snapshot log\n# simt, id, lat, lon, alt, gs, trk, vs\n";
  for (int t = 0; t <= 15; ++t) {
    const auto row = [&](const std::string& id, double lon, const std::string& track) {
      log += std::to_string(t) + ".00000000," + id + ",0.00000000," + std::to_string(lon) +
             ",10668.00000000,231.50000000," + track + ",0.00000000\n";
    };
    row("BEE101", 7.0 + 0.00208 * t, "90.00000000");
    row("HIVE22", 7.045 - 0.00208 * t, "270.00000000");
  }
  const Finished finished = run({"replay", "--separation", "enroute", "--fail-on-risk"}, log);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  EXPECT_EQ(rows_of(finished.out).size(), 1u) << finished.out;
  EXPECT_NE(finished.err.find("BlueSky"), std::string::npos) << finished.err;
  EXPECT_EQ(finished.err.find("1970"), std::string::npos) << finished.err;
}

// As where a logger was given variables of `traf` by hand: the SI, too.
TEST(Encounters, ALogOfBlueSkyMayNameWhatHasItsColumns) {
  std::string log =
      "# Snapshot log 2\n"
      "# simt, traf.id, traf.lat, traf.lon, traf.alt, traf.gs, traf.trk, traf.vs\n";
  for (int t = 0; t <= 15; ++t) {
    for (const auto& [id, height] :
         {std::pair("LOW1,0,", "10668"), std::pair("HIGH2,0,", "10973")}) {
      log += std::to_string(t) + "," + id + std::to_string(7.0 + 0.00208 * t) + "," + height +
             ",231.5,90,0\n";
    }
  }
  // 305 m apart in height: more than 1,000 ft, and less if these were feet.
  const Finished finished = run({"replay", "--separation", "enroute", "--fail-on-risk"}, log);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"heights in m: the header is that of BlueSky, which has 'traf.alt'",
                              "keeps its distance"});
}

TEST(Encounters, ADaidalusEncounterIsReplayed) {
  std::string text =
      "NAME lat lon alt trk gs vs time\n[none] [deg] [deg] [ft] [deg] [knot] [fpm] [s]\n";
  for (int second = 0; second <= 60; ++second) {
    const std::string time = ", " + std::to_string(second) + ".0\n";
    const double moved = 0.0005 * second;
    text += "Ownship, 40.0, " + std::to_string(-74.0 + moved) + ", 15000.0, 90, 82.9, 0" + time;
    text += "Intruder, 40.0, " + std::to_string(-73.95 - moved) + ", 15200.0, 270, 82.9, 0" + time;
    text += "Other, 40.0, " + std::to_string(-73.95 - moved) + ", 15250.0, 270, 82.9, 0" + time;
  }
  const TemporaryFolder folder;
  const std::string file = folder.file("encounter.daa", text);
  expect_parts(run({"replay", file}).err,
               {"how close is too close? Say --separation well-clear-suas", "--separation nmac",
                "--threshold 4000ft --vertical 450ft"});
  const Finished finished = run({"replay", file, "--separation", "well-clear-suas", "--csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out, ',');
  // The third is exactly 250 ft above the ownship.
  ASSERT_EQ(rows.size(), 3u) << finished.out << finished.err;
  EXPECT_EQ(rows[1].at(0) + rows[1].at(1), "OwnshipIntruder");
  EXPECT_EQ(rows[2].at(0) + rows[2].at(1), "IntruderOther");
  EXPECT_NEAR(std::stod(rows[1].at(3)), 50.0, 0.01);
  expect_parts(finished.err,
               {"DAIDALUS encounter", "the first aircraft of each time is the ownship",
                "heights in ft: the line of units says so",
                "verdict    does not keep its distance: 2 conflicts of 2 pairs"});
}

}  // namespace
}  // namespace beespace::cli_test
