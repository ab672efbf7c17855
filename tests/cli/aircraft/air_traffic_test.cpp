// What who knows air traffic expects of recordings of it: spikes of heights, aircraft that enter
// and leave a sector, fixes a minute apart in cruise, levels that are kept, and minima above FL410.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <utility>

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

// ---- A cut of a sector --------------------------------------------------------------------------

// Three far from each other, each there for a part of the time; the third with a silence of half a
// minute, perhaps.
std::string sector(bool silence) {
  std::string text = kHeader;
  for (int t = 0; t < 200; t += 2) {
    if (t < 120) text += row(t, "4b1814", 47.0, 30'000.0);
    if (t >= 60) text += row(t, "3c6444", 47.5, 30'000.0);
    const bool silent = silence && t > 100 && t < 130;
    if (t >= 40 && t < 160 && !silent) text += row(t, "39bd24", 48.0, 30'000.0);
  }
  return text;
}

TEST(CutOfASector, IsNotAskedAboutOutsideWhereThatIsSaid) {
  const Finished asked = run(kEnroute, sector(false));
  EXPECT_EQ(asked.exit_code, 1) << asked.err;
  expect_parts(asked.err, {"no conflict in the known time; 3 bees known for a part"});
  const Finished finished = run(kEnroute + Arguments{"--sector"}, sector(false));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err,
               {"keeps its distance; 3 bees are outside the sector before the first or after the "
                "last fix (--sector)",
                "outside, and not asked about (--sector)"});
  EXPECT_EQ(finished.err.find('?'), std::string::npos) << "over time";
  const Finished json =
      run(kEnroute + Arguments{"--sector", "--json", "--report", "bees"}, sector(false));
  expect_parts(json.out, {R"("sector": true)", R"("bees_partly_known": 3)", R"("unknown_s": 0)"});
}

TEST(CutOfASector, SilencesWithinAreUnknownAllTheSame) {
  const Finished finished = run(kEnroute + Arguments{"--sector"}, sector(true));
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"no conflict in the known time; 1 bee unknown for 30 s in all"});
}

// The last place again, as traffic fills it; but an aircraft that is there for long without one is.
TEST(CutOfASector, RecordsWithoutAPlaceAtItsEndsAreOutsideToo) {
  const auto with_silence = [](int seconds) {
    std::string text = sector(false);
    for (int t = 120; t < 120 + seconds; t += 2) {
      text += moment(t) + ",4b1814,4b1814,,,30000,442,90,0\n";
    }
    return text;
  };
  EXPECT_EQ(run(kEnroute, with_silence(6)).exit_code, 1);
  const Finished finished = run(kEnroute + Arguments{"--sector"}, with_silence(6));
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const Finished long_one = run(kEnroute + Arguments{"--sector"}, with_silence(60));
  EXPECT_EQ(long_one.exit_code, 1) << long_one.err;
  expect_parts(long_one.err, {"no conflict in the known time; 30 records were left out"});
}

// As OpenSky goes on to say the last place of who is not heard any more, at the time of that place:
// such an aircraft was lost, and did not leave.
TEST(CutOfASector, DoesNotExcuseWhomTheFeedKeepsAtItsLastPlace) {
  const auto with_repeats = [](int times) {
    std::string text = sector(false);
    for (int k = 0; k < times; ++k) text += row(118, "4b1814", 47.0, 30'000.0);
    return text;
  };
  const Finished leaves = run(kEnroute + Arguments{"--sector"}, with_repeats(2));
  EXPECT_EQ(leaves.exit_code, 0) << leaves.err;
  const Finished lost = run(kEnroute + Arguments{"--sector"}, with_repeats(30));
  EXPECT_EQ(lost.exit_code, 1) << lost.err;
  expect_parts(lost.err, {"no conflict in the known time; 1 bee there without a place"});
}

TEST(CutOfASector, AppliesToPicturesAndPagesAndNotToMoments) {
  const TemporaryFolder folder;
  const std::string file = folder.file("t.csv", sector(false));
  const Arguments plot = {"plot",           file, "--separation",      "enroute",
                          "--fail-on-risk", "-o", folder.path("t.svg")};
  EXPECT_EQ(run(plot).exit_code, 1);
  EXPECT_EQ(run(plot + Arguments{"--sector"}).exit_code, 0);
  EXPECT_EQ(folder.read("t.svg").find("known for a part"), std::string::npos);
  const Arguments report = {"report",         file, "--separation",       "enroute",
                            "--fail-on-risk", "-o", folder.path("t.html")};
  EXPECT_EQ(run(report + Arguments{"--sector"}).exit_code, 0);
  expect_parts(run({"plot", "--sector", "--threshold", "5"}, "x,y\n1,2\n3,4\n").err,
               {"leave --sector out"});
}

// ---- A fix a minute in cruise -------------------------------------------------------------------

// As Flightradar24 gives them: every 7 s in the climb, then about every minute.
std::string flight(double latitude, bool regular, const std::string& callsign = "SWR123") {
  std::string text = "Timestamp,UTC,Callsign,Position,Altitude,Speed,Direction\n";
  int t = 0;
  for (int i = 0; i < 100; ++i) {
    text += std::to_string(1795442400 + t) + ",2026-11-23T14:00:00Z," + callsign + ",\"" +
            std::to_string(latitude) + "," + std::to_string(8.0 + 0.003 * t) + "\"," +
            std::to_string(i < 60 ? 10'000 + 400 * i : 34'000) + ",442,90\n";
    t += i < 60 ? 7 : regular ? 63 : 45 + 10 * (i % 3);
  }
  return text;
}

TEST(FixesOfAMinute, TheGapThatJoinsThemIsInTheVerdict) {
  for (const bool regular : {true, false}) {
    const TemporaryFolder folder;
    folder.file("a.csv", flight(47.0, regular));
    folder.file("b.csv", flight(47.05, regular, "DLH4AB"));
    const Finished finished = run(kEnroute + Arguments{folder.path("")});
    EXPECT_EQ(finished.exit_code, 1) << finished.err;
    const std::string max_gap = regular ? "70" : "75";
    expect_parts(finished.err,
                 {"(--max-gap " + max_gap + " joins their fixes in cruise by straight lines)",
                  ": --max-gap " + max_gap + " joins such fixes by straight lines"});
    const Finished joined = run(kEnroute + Arguments{"--max-gap", max_gap, folder.path("")});
    expect_parts(joined.err, {"does not keep its distance: 1 conflict of 1 pair"});
  }
}

TEST(FixesOfAMinute, AFlightWithoutACallsignHasTheNameOfItsFile) {
  const TemporaryFolder folder;
  folder.file("a.csv", flight(47.0, true));
  folder.file("noname_3312ab7f.csv", flight(47.05, true, ""));
  const Finished finished = run(kEnroute + Arguments{"--max-gap", "70", folder.path("")});
  expect_parts(finished.out, {"SWR123\tnoname_3312ab7f"});
}

// ---- Vertical minima ----------------------------------------------------------------------------

// Two that fly for a while so far apart in height.
std::string apart(double low_ft, double high_ft, double latitude = 47.02) {
  std::string text = kHeader;
  for (int t = 0; t < 60; ++t) {
    text += row(t, "4b1814", 47.0, low_ft);
    text += row(t, "3c6444", latitude, high_ft);
  }
  return text;
}

TEST(VerticalMinima, WhoHardlyFallsShortIsSaidWithWhatWouldLeaveThemOut) {
  expect_parts(run(kEnroute, apart(30'000, 30'975)).err,
               {"the only conflict is within 50 ft of the vertical limit: --threshold 5NM "
                "--vertical 900ft would leave 0"});
  const Finished more = run(kEnroute, apart(30'000, 30'925));
  EXPECT_EQ(more.err.find("would leave"), std::string::npos);
  EXPECT_EQ(more.err.find("one step"), std::string::npos);
}

// Heights of transponders come in steps of 25 ft, by which they waver in level flight: also where
// others are in conflict by more, it is said who is by one step, and what leaves those out.
TEST(VerticalMinima, OneStepOfTheHeightsIsSaidToBeOne) {
  std::string text = apart(30'000, 30'975);
  for (int t = 0; t < 60; ++t) {
    text += row(t, "4b1815", 48.0, 31'000) + row(t, "3c6445", 48.02, 31'300);
    text += row(t, "4b1816", 49.0, 31'000) + row(t, "3c6446", 49.02, 31'300);
  }
  const Finished finished = run(kEnroute, text);
  expect_parts(
      finished.err,
      {"25 ft is one step of the reported heights, and 1 conflict is by no more than that: "
       "--threshold 5NM --vertical 975ft leaves it out"});
  EXPECT_EQ(rows_of(finished.out).size(), 3u);
  EXPECT_EQ(rows_of(run({"replay", "--threshold", "5NM", "--vertical", "975ft"}, text).out).size(),
            2u);
}

// A conflict that begins by heights while they fly apart: closest at the limit, and worse later,
// which is what is said.
TEST(VerticalMinima, OfAConflictThatBeginsAtTheLimitTheWorstMomentIsSaid) {
  std::string text = kHeader;
  for (int t = 0; t < 60; ++t) {
    text += row(t, "4b1814", 47.0, 30'000);
    text += row(t, "3c6444", 47.02 + 0.0005 * t, 31'200 - 10 * t, -600);
  }
  expect_parts(run(kEnroute, text).err,
               {"and 610 ft (185.928 m) vertically apart at 2026-11-23T14:00:59.000Z; in"});
}

TEST(VerticalMinima, AboveFl410WhoIsCloserThanHoldsThereIsNoAllClear) {
  const std::string says =
      "2 aircraft fly above FL410, where ICAO Doc 4444 asks for 2000 ft in height: ask --threshold "
      "5NM --vertical 2000ft for these, too";
  const Finished closer = run(kEnroute, apart(43'000, 44'000));
  EXPECT_EQ(closer.exit_code, 1);
  EXPECT_EQ(rows_of(closer.out).size(), 0U) << "no conflict by what was asked";
  expect_parts(closer.err, {"no conflict by that vertical limit; " + says,
                            "1 pair without a conflict come closer"});
  expect_parts(run(kEnroute + Arguments{"--json"}, apart(43'000, 44'000)).out,
               {R"("closer_above_fl410_count": 1)"});
  // One of the two is enough; by 2000 ft they keep apart.
  EXPECT_EQ(run(kEnroute, apart(40'500, 42'000)).exit_code, 1);
  const Finished apart_there = run(kEnroute, apart(43'000, 45'000));
  EXPECT_EQ(apart_there.exit_code, 0);
  expect_parts(apart_there.err, {"keeps its distance; " + says});
  EXPECT_EQ(run(kEnroute, apart(30'000, 31'000)).exit_code, 0);
  const Arguments predict = {"predict", "--separation", "enroute"};
  expect_parts(run(predict, apart(43'000, 44'000)).err, {"2 aircraft fly above FL410"});
  EXPECT_EQ(run(kEnroute, apart(40'000, 41'000)).err.find("FL410"), std::string::npos);
  EXPECT_EQ(run({"replay", "--threshold", "5NM", "--vertical", "2000ft"}, apart(43'000, 44'000))
                .err.find("FL410"),
            std::string::npos);
}

TEST(VerticalMinima, ADistanceAloneIsSaidToBeOfTheStraightLine) {
  const Finished finished = run({"replay", "--threshold", "5NM"}, apart(30'000, 31'000));
  expect_parts(finished.err, {"--vertical 1000ft leaves out who is kept apart by height"});
  EXPECT_EQ(run(kEnroute, apart(30'000, 31'000)).err.find("straight line"), std::string::npos);
}

// ---- Questions and recipes ----------------------------------------------------------------------

TEST(RecipesOfAirTraffic, GlidersAreAskedAboutInMetres) {
  const std::string log =
      "AXXX001\nHFDTE200726\nB1130004700000N00800000EA0150001550\n"
      "B1130044700010N00800000EA0150001550\n";
  const Finished asked = run({"replay"}, log);
  EXPECT_EQ(asked.exit_code, 2);
  expect_parts(asked.err, {"these are gliders", "--threshold 50"});
  EXPECT_EQ(run({"replay", "--threshold", "20"}, log).exit_code, 0);
}

TEST(RecipesOfAirTraffic, AMissingClimbRateIsNamed) {
  const std::string document =
      R"({"now": 1795442600.0, "aircraft": [
        {"hex": "4b1617", "lat": 47.0, "lon": 7.0, "alt_baro": 35000, "gs": 450, "track": 90,
         "seen_pos": 0.1, "seen": 0.1},
        {"hex": "3c6444", "lat": 47.5, "lon": 7.0, "alt_baro": 35000, "gs": 450, "track": 90,
         "baro_rate": 0, "seen_pos": 0.1, "seen": 0.1}]})";
  const Finished finished = run({"predict", "--separation", "enroute"}, document);
  expect_parts(finished.err, {"1 checked for now only",
                              "speed and direction are there, but no "
                              "climb rate (baro_rate or geom_rate"});
  EXPECT_EQ(finished.err.find("neither a velocity"), std::string::npos);
}

TEST(RecipesOfAirTraffic, FoldersAreFoundFromTheRootOfAHistory) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder.path("2026/11/23/traces/17"));
  folder.file("2026/11/23/traces/17/trace_full_4b1617.json", "{}");
  expect_parts(run(kEnroute + Arguments{folder.path("")}).err, {"name ", "2026/11/23/traces/17"});
}

TEST(RecipesOfAirTraffic, MessagesInAFolderAreRead) {
  const TemporaryFolder folder;
  std::string text;
  for (int t = 0; t < 4; ++t) {
    const std::string time = "2024/06/05,10:00:0" + std::to_string(t) + ".000";
    text += "MSG,3,1,1,3944EF,1," + time + "," + time + ",,35000,,,47.0,8.5,,,0,0,0,0\n";
    text += "MSG,3,1,1,4008F6,1," + time + "," + time + ",,35000,,,47.5,8.5,,,0,0,0,0\n";
  }
  folder.file("a.log", text);
  const Finished finished = run(kEnroute + Arguments{folder.path("")});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.err, {"bees       2"});
}

TEST(RecipesOfAirTraffic, AnEncounterWithoutItsUnitsIsSaidToLackThem) {
  const std::string rows =
      "Ownship, 47.0, 7.0, 35000.0, 90.0, 450.0, 0.0, 0.0\n"
      "AC1, 47.5, 7.9, 35000.0, 180.0, 440.0, 0.0, 0.0\n";
  const Finished finished = run(kEnroute, "NAME lat lon alt trk gs vs time\n" + rows);
  expect_parts(finished.err, {"DAIDALUS encounter without its line of units",
                              "sed '1a [none] [deg] [deg] [ft] [deg] [knot] [fpm] [s]'"});
  EXPECT_EQ(run(kEnroute,
                "NAME lat lon alt trk gs vs time\n[none] [deg] [deg] [ft] [deg] [knot] "
                "[fpm] [s]\n" +
                    rows)
                .err.find("line of units"),
            std::string::npos);
}

// ---- What is not read, or in part -------------------------------------------------------------

TEST(TablesOfPairs, AreRefusedWithWhatToGiveInstead) {
  const Finished finished =
      run(kEnroute,
          ",timestamp,latitude_x,longitude_x,altitude_x,icao24_x,latitude_y,longitude_y,altitude_y,"
          "icao24_y,lateral,vertical\n0,2024-06-05 08:00:00+00:00,50.67,2.31,38000.0,4b1801,50.6,"
          "2.43,38000.0,4d0101,6.3,0.0\n");
  EXPECT_NE(finished.exit_code, 0);
  expect_parts(finished.err, {"this is a table of pairs", "flights.to_csv('flights.csv')"});
  EXPECT_EQ(finished.err.find("awk"), std::string::npos) << finished.err;
}

TEST(TracksOfGpx, BecomeTablesWithTheirHeights) {
  const TemporaryFolder folder;
  const std::string file =
      folder.file("a.gpx", "<?xml version=\"1.0\"?><gpx version=\"1.1\"></gpx>");
  expect_parts(run({"replay", "--threshold", "5", file}).err,
               {"id,time,lon,lat,height_m", "p.findtext('{*}ele', '')"});
}

TEST(FoldersOfEncounters, SayHowToAskOfEach) {
  const TemporaryFolder folder;
  folder.file("a.daa", "NAME lat lon\n");
  folder.file("b.daa", "NAME lat lon\n");
  expect_parts(run({"replay", folder.path("")}).err,
               {"each of these is a recording of its own", "/*.daa; do beespace replay \"$f\""});
  // With what was typed: another threshold would be an all-clear of another question.
  expect_parts(run({"replay", "--separation", "enroute", folder.path("")}).err,
               {"do beespace replay \"$f\" --separation enroute; done"});
  expect_parts(run({"replay", "--threshold", "5NM", "--vertical", "1000ft", folder.path("")}).err,
               {"do beespace replay \"$f\" --threshold 5NM --vertical 1000ft; done"});
}

// The last lines of a log of BaseStation, of which the first is cut.
TEST(MessagesOfBaseStation, AreKnownByThoseBehindTheFirst) {
  std::string text = "/05,08:00:00.179,,30300,,,53.11557,8.43151,,,0,0,0,0\n";
  for (int t = 0; t < 30; ++t) {
    for (const auto& [id, latitude] : {std::pair("39A701", 53.1), std::pair("39A702", 53.6)}) {
      const std::string at = "2024/06/05,08:00:" + std::to_string(10 + t) + ".000";
      text += "MSG,3,1,1," + std::string(id) + ",1," + at + "," + at + ",,30300,,," +
              std::to_string(latitude) + "," + std::to_string(8.0 + 0.002 * t) + ",,,0,0,0,0\n";
    }
  }
  const Finished finished = run(kEnroute, text);
  expect_parts(finished.err, {"BaseStation messages", "bees       2",
                              "1 record cut off at the beginning of the input is left out"});
}

// Two that report under one address in turn, and a third between: no one flies from one of the two
// places to the other.
TEST(SharedAddresses, MakeNoConflictThatIsCertain) {
  std::string text = kHeader;
  for (int t = 0; t < 60; ++t) {
    text += row(t, "000000", t % 2 == 0 ? 47.0 : 48.0, 30'000.0);
    text += row(t, "3c6444", 47.5, 30'000.0);
  }
  const Finished finished = run(kEnroute, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"may not keep its distance", " possible, of a shared id",
                              "possible, as two seem to share an id"});
  EXPECT_EQ(finished.err.find("does not keep"), std::string::npos) << finished.err;
  EXPECT_EQ(finished.out.find("\tyes\t"), std::string::npos) << finished.out;
}

// ---- Heights by pressure, climbs by heights
// ------------------------------------------------------

// 1900 ft apart by pressure, and 2050 ft in the warm air.
TEST(LimitsInFeet, AreOfHeightsByPressure) {
  std::string text =
      "timestamp,icao24,callsign,latitude,longitude,altitude,geoaltitude,groundspeed,track,"
      "vertical_rate\n";
  for (int t = 0; t < 20; ++t) {
    for (const bool upper : {false, true}) {
      text += moment(t) + (upper ? ",4b1814,SWR1," : ",3c6444,DLH2,") +
              (upper ? "47.02," : "47.0,") + std::to_string(8.0 + 0.003 * t) +
              (upper ? ",43900,46050" : ",42000,44000") + ",442,90,0\n";
    }
  }
  const Arguments replay = {"replay", "--threshold", "5NM", "--vertical", "2000ft", "--csv"};
  const Finished by_pressure = run(replay, text);
  EXPECT_EQ(rows_of(by_pressure.out, ',').size(), 2U) << by_pressure.err;
  expect_parts(by_pressure.err, {"pressure altitude"});
  const Finished geometric = run(replay + Arguments{"--heights", "geometric"}, text);
  EXPECT_EQ(rows_of(geometric.out, ',').size(), 1U) << geometric.err;
}

// Half a turn in a minute, told at its ends alone: straight on they keep 6 NM apart.
TEST(FixesOfAMinute, WithoutAClimbRateAreFollowedByTheirCourses) {
  std::string text = "Timestamp,UTC,Callsign,Position,Altitude,Speed,Direction\n";
  const auto fix = [&text](int seconds, const std::string& who, double latitude, double longitude,
                           int course) {
    text += std::to_string(1'795'867'200 + seconds) + "," + "2026-11-28T12:00:00Z," + who + ",\"" +
            std::to_string(latitude) + "," + std::to_string(longitude) + "\",33000,450," +
            std::to_string(course) + "\n";
  };
  for (int minute = 0; minute < 8; ++minute) {
    // 7.5 NM a minute: east, and back to the west 4 NM farther north.
    const bool back = minute > 3;
    const double along = back ? 7.0 - minute : minute;
    fix(60 * minute, "TURN1", back ? 50.0667 : 50.0, 0.1945 * along, back ? 270 : 90);
    fix(60 * minute, "PASS2", 50.0333 + 0.125 * (minute - 3.5), 0.1945 * 3 + 0.131, 0);
  }
  const Finished finished = run(kEnroute, text);
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"may not keep its distance", "along curves"});
  EXPECT_EQ(run(kEnroute + Arguments{"--straight"}, text).exit_code, 0);
}

}  // namespace
}  // namespace beespace::cli_test
