// Tables of aircraft as pandas writes them (see make-tables), by the first command that somebody
// would type.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"
#include "tests/cli/run/json_check.hpp"

namespace beespace::cli_test {
namespace {

std::string table(const std::string& name) {
  return std::string(BEESPACE_AIRCRAFT_TABLES) + "/" + name;
}

std::string content_of(const std::string& name) {
  std::ifstream file(table(name));
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

class TrafficTable : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(Forms, TrafficTable,
                         testing::Values("traffic.csv", "traffic_indexed.csv", "traffic.json",
                                         "traffic.json.gz", "traffic_records.json",
                                         "traffic_iso.json", "traffic_lines.json",
                                         "traffic_split.json", "traffic_index.json",
                                         "traffic_table.json"),
                         [](const auto& name) {
                           std::string text = name.param;
                           for (char& c : text) c = c == '.' ? '_' : c;
                           return text;
                         });

// BEE101 and HIVE22 are 0.276872 degrees apart at 05:00:20, 20,860 m at 47.5 degrees north, and
// meet at 463 m/s. The third flies exactly 1,000 ft above BEE101. COMB7 has no velocity.
TEST_P(TrafficTable, PredictNamesTheTwoThatMeet) {
  const Finished finished = run({"predict", table(GetParam()), "--separation", "enroute"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  const TextRows rows = rows_of(finished.out);
  ASSERT_EQ(rows.size(), 1u) << finished.out << finished.err;
  EXPECT_EQ(rows[0][0], "3c6501 (BEE101)");
  EXPECT_EQ(rows[0][1], "406a02 (HIVE22)");
  // After 25.05 s.
  EXPECT_EQ(rows[0][2].substr(0, 22), "2018-08-01T05:00:45.05");
  expect_parts(
      finished.err,
      {"bees       3 of 4\n", "now        2018-08-01T05:00:20.000Z\n",
       "1 checked for now only, where last heard of",
       "conflicts  1, of 2 bees, after the end of the recording; 1 bee is checked for now only, "
       "1 record was left out\n",
       "1 record without a position is left out\n",
       "1 record of aircraft on the ground is left out",
       "heights in ft: the header is that of traffic",
       "compared with heights in ft as they stand"});
}

TEST_P(TrafficTable, ReplayKnowsTheTimeFrom1970) {
  const Finished finished =
      run({"replay", table(GetParam()), "--threshold", "30km", "--vertical", "1000ft", "--json"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_TRUE(is_json(finished.out)) << finished.out;
  expect_parts(finished.out, {R"("times": "seconds since 1970-01-01T00:00:00Z")",
                              R"("conflict_count": 1)", R"("first": "3c6501", "second": "406a02")",
                              R"("first_label": "BEE101", "second_label": "HIVE22")"});
  expect_parts(finished.err,
               {"from       2018-08-01T05:00:00.000Z to 2018-08-01T05:00:20.000Z (20.00 s)\n"});
}

// One aircraft of which it is not known where it goes, or where it is, is never passed over.
TEST_P(TrafficTable, IsNeverAnAllClear) {
  const Arguments nothing = {"predict", table(GetParam()), "--threshold", "10m", "--horizon", "20"};
  const Finished finished = run(nothing + Arguments{"--fail-on-risk"});
  EXPECT_EQ(finished.exit_code, 1) << finished.err;
  expect_parts(finished.err, {"conflicts  none of those that are known after the end of the "
                              "recording; 1 bee is checked for now only, "
                              "1 record was left out\n"});
  expect_parts(run(nothing + Arguments{"--json"}).out,
               {R"("without_velocity": 1)", R"("complete": false)"});
}

TEST_P(TrafficTable, HeightsByPressureAreTakenForAll) {
  const Finished finished =
      run({"predict", table(GetParam()), "--separation", "enroute", "--heights", "pressure"});
  EXPECT_EQ(rows_of(finished.out).size(), 1u) << finished.err;
  expect_parts(finished.err, {"heights    pressure altitude", "which has 'altitude' in it"});
}

TEST_P(TrafficTable, PicturesShowIt) {
  const Finished finished =
      run({"export", table(GetParam()), "--threshold", "30km", "--format", "csv"});
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  expect_parts(finished.out, {"3c6501", "406a02", "2018-08-01T05:00:"});
}

TEST(AircraftTables, OfOpenSkyAreInMetres) {
  for (const char* const name : {"opensky.csv", "opensky.json"}) {
    const Finished finished =
        run({"predict", table(name), "--threshold", "5NM", "--vertical", "300", "--csv"});
    const TextRows rows = rows_of(finished.out, ',');
    ASSERT_EQ(rows.size(), 2u) << finished.out << finished.err;
    EXPECT_EQ(rows[1].at(0) + rows[1].at(1), "3c6501406a02");
    EXPECT_NEAR(std::stod(rows[1].at(2)), 1533099620 + (20'860.0 - 9260) / 463, 0.3);
    expect_parts(finished.err, {"heights in m: the header is that of OpenSky",
                                "speeds in m/s: the header is that of OpenSky",
                                "now        2018-08-01T05:00:20.000Z\n"});
  }
}

TEST(AircraftTables, WatchReadsThemLineByLine) {
  for (const char* const name : {"traffic.csv", "traffic_lines.json", "opensky.csv"}) {
    const Finished finished = run(
        {"watch", "--threshold", "5NM", "--vertical", "300", "--horizon", "60", "--max-age", "20"},
        content_of(name));
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    expect_parts(finished.out, {R"("event": "predicted")", R"("first": "3c6501")",
                                R"("second": "406a02")", R"("first_label": "BEE101")"});
    expect_parts(finished.err, {"1 record without a position is left out",
                                "1 record of aircraft on the ground is left out"});
  }
}

TEST(AircraftTables, TheUnitOfTimesIsToldByTheirSizeAndSaid) {
  const std::string header = "timestamp,icao24,latitude,longitude,alt_ft\n";
  const struct {
    const char* time;
    const char* unit;
  } times[] = {{"1533099600", "seconds"},
               {"1533099600000", "milliseconds"},
               {"1533099600000000", "microseconds"},
               {"1533099600000000000", "nanoseconds"}};
  for (const auto& [time, unit] : times) {
    std::string a_second_later = time;
    a_second_later[9] = '1';
    const Finished finished =
        run({"replay", "--threshold", "100m"},
            header + time + ",a,47,8,1\n" + time + ",b,48,8,1\n" + a_second_later + ",a,47,8,1\n");
    EXPECT_EQ(finished.exit_code, 0) << finished.err;
    expect_parts(finished.err, {std::string("times are read from column 1 'timestamp' in ") + unit +
                                    ", since 1970, as their size tells\n",
                                "from       2018-08-01T05:00:00.000Z to"});
  }
}

TEST(AircraftTables, TimesOfNoSuchSizeAreAskedFor) {
  const std::string header = "timestamp,icao24,latitude,longitude,alt_ft\n";
  for (const std::string times : {"12,a,47,8,1\n13,b,48,8,1\n", "1533099600,a,47,8,1\n9,b,48,8,1\n",
                                  "1533099600,a,47,8,1\n1533099600000,b,48,8,1\n"}) {
    const Finished finished = run({"replay", "--threshold", "100m"}, header + times);
    EXPECT_EQ(finished.exit_code, 2) << times << finished.err;
    expect_parts(finished.err, {"holds the time, but in which unit?"});
  }
  // Microseconds since a drone was switched on may have the size of seconds since 1970.
  const Finished drones = run({"replay"}, "timestamp,id,x,y,z\n1533099600,a,0,0,0\n");
  EXPECT_EQ(drones.exit_code, 2);
  expect_parts(drones.err, {"holds the time, but in which unit?"});
}

TEST(AircraftTables, ALaterTimeInAnotherUnitIsAnError) {
  std::string text = "timestamp,icao24,latitude,longitude,alt_ft\n";
  for (int i = 0; i < 20; ++i) text += std::to_string(1533099600 + i) + ",a,47,8,1\n";
  const Finished finished = run({"replay"}, text + "1533099620000,a,47,8,1\n");
  EXPECT_EQ(finished.exit_code, 3);
  expect_parts(finished.err, {"<stdin>:22:1: '1533099620000' is no time since 1970 in seconds, as "
                              "the first times are"});
}

TEST(AircraftTables, TheAddressIsTheIdWhateverTheOrder) {
  const std::string text =
      "callsign,icao24,time_s,lat,lon,alt_ft\nSWR1,a1,0,47,8,1\n,a1,1,47,8,1\nSWR2,b2,0,47,8,2\n";
  const Finished finished = run({"replay", "--threshold", "100m", "--csv"}, text);
  const TextRows rows = rows_of(finished.out, ',');
  ASSERT_EQ(rows.size(), 2u) << finished.err;
  EXPECT_EQ(rows[1].at(0) + rows[1].at(1), "a1b2");
  EXPECT_EQ(rows[1].at(9) + rows[1].at(10), "SWR1SWR2");
  expect_parts(finished.err, {"ids are read from column 2 'icao24', and how they are called beside "
                              "from column 1 'callsign'; --columns id=1 would take that"});
  const TextRows flights = rows_of(
      run({"replay", "--threshold", "100m", "--columns", "id=callsign", "--csv", "--skip-bad"},
          text + "SWR1,a1,2,47,8,1\n")
          .out,
      ',');
  ASSERT_EQ(flights.size(), 2u);
  EXPECT_EQ(flights[1].at(0) + flights[1].at(1), "SWR1SWR2");
  // No labels; but whether SWR2, which is there once, is lost before and after.
  EXPECT_EQ(flights[0].back(), "unknown_after");
  EXPECT_EQ(flights[1].size(), 9u);
}

// 100 m would tell of two that are 600 ft and 4 NM apart that they keep their distance.
TEST(AircraftTables, ThereIsNoDefaultThresholdOfAircraft) {
  for (const char* const command : {"predict", "replay", "verify"}) {
    const Finished finished = run({command, table("traffic.csv")});
    EXPECT_EQ(finished.exit_code, 2) << command;
    expect_parts(finished.err, {"these are aircraft, by heights in feet: how close is too close? "
                                "Say --separation enroute, --separation terminal, or"});
    // verify tells by it what it finds.
    EXPECT_LT(run({command, table("traffic.csv"), "--separation", "enroute"}).exit_code, 2);
  }
}

TEST(AircraftTables, ASnapshotIsForPredict) {
  const Finished finished = run({"detect", table("traffic_records.json")});
  EXPECT_EQ(finished.exit_code, 3);
  expect_parts(finished.err, {"this is a recording of bees that move (JSON, a table of records), "
                              "not a table or an array of places; ask 'beespace replay' about it"});
}

TEST(AircraftTables, GroundedOnesAreKeptWhereTheyTellAHeight) {
  const std::string text =
      "time_s,icao24,lat,lon,alt_ft,onground\n0,a,47,8,1,True\n0,b,47,8,2,True\n0,c,47,8,,True\n"
      "1,a,47,8,1,True\n";
  EXPECT_EQ(rows_of(run({"replay", "--threshold", "100m", "--grounded"}, text).out).size(), 1u);
  const Finished finished = run({"replay", "--threshold", "100m"}, text);
  EXPECT_EQ(finished.exit_code, 3);
  expect_parts(finished.err, {"no bee is left: 4 records of aircraft on the ground are left out; "
                              "--grounded keeps those that tell a height"});
}

}  // namespace
}  // namespace beespace::cli_test
