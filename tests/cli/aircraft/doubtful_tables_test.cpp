// Tables of aircraft that contradict themselves, or say less than they seem to.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/cli/run/command_run.hpp"
#include "tests/cli/run/expectations.hpp"

namespace beespace::cli_test {
namespace {

// What a table says of one aircraft beside its place.
struct Said {
  std::string altitude = "35000";
  std::string geoaltitude = "35250";
  std::string groundspeed = "450";
  std::string vertical_rate = "0";
  std::string onground = "False";
};

const std::string kColumns =
    "timestamp,icao24,callsign,latitude,longitude,altitude,groundspeed,track,vertical_rate";

std::string rows(const std::string& id, double latitude, const Said& said, bool with_geoaltitude) {
  std::string text;
  for (int t = 0; t < 6; ++t) {
    text += "2018-10-12 23:55:0" + std::to_string(t) + "+00:00," + id + ",FLY" + id + "," +
            std::to_string(latitude) + "," + std::to_string(7.5 + 0.001 * t) + "," + said.altitude +
            "," + said.groundspeed + ",90," + said.vertical_rate + "," +
            (with_geoaltitude ? said.geoaltitude + "," : "") + said.onground + "\n";
  }
  return text;
}

// Two that fly 3 NM beside each other, 800 ft apart by pressure.
std::string table(const Said& second, bool with_geoaltitude = true) {
  return kColumns + (with_geoaltitude ? ",geoaltitude" : "") + ",onground\n" +
         rows("4ca7b3", 50.0, Said{}, with_geoaltitude) +
         rows("3c6444", 50.05, second, with_geoaltitude);
}

Said lower() {
  return {"34200", "34450"};
}

Finished enroute(const std::string& input, const Arguments& more = {}) {
  return run(Arguments{"replay", "--separation", "enroute", "--fail-on-risk"} + more, input);
}

TEST(DoubtfulTables, AConflictAsItIs) {
  const Finished finished = enroute(table(lower()));
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(rows_of(finished.out).size(), 1u) << finished.out << finished.err;
}

// No aircraft is on the ground at 34,200 ft and 450 kt, or climbing.
TEST(DoubtfulTables, WhoSaysThatItIsOnTheGroundWhileItFliesIsKept) {
  Said grounded = lower();
  grounded.onground = "1";
  const Finished high = enroute(table(grounded));
  EXPECT_EQ(high.exit_code, 1);
  EXPECT_EQ(rows_of(high.out).size(), 1u) << high.err;
  expect_parts(high.err,
               {"6 records say that an aircraft is on the ground, but it is higher than any "
                "airport, or faster or steeper than it could be there: taken for flying, "
                "and kept\n"});
  const Finished fast = enroute(table({"100", "100", "240", "0", "1"}));
  expect_parts(fast.err, {"6 records say that an aircraft is on the ground", "bees       2\n"});
  const Finished steep = enroute(table({"100", "100", "120", "-1500", "1"}));
  expect_parts(steep.err, {"6 records say that an aircraft is on the ground", "bees       2\n"});
  // What rolls at an airport is on the ground, and then there is only one left.
  const Finished rolls = enroute(table({"5400", "5450", "140", "0", "1"}));
  expect_parts(rolls.err, {"6 records of aircraft on the ground are left out", "bees       1\n",
                           "nothing to compare"});
  EXPECT_EQ(rolls.exit_code, 1);
}

// The 1,000 ft of ICAO Doc 4444 are by pressure: that column is taken, and said.
// Two that meet head-on after a minute, a row every ten seconds. Of the second nothing is heard
// from `lost_s` to `found_s`, while its rows go on with the last position, as those of OpenSky do.
std::string opensky_table(int lost_s, int found_s) {
  std::string text =
      "time,icao24,lat,lon,velocity,heading,vertrate,callsign,onground,"
      "baroaltitude,geoaltitude,lastposupdate,lastcontact\n";
  for (int t = 0; t <= 120; t += 10) {
    const int heard_s = t > lost_s && t < found_s ? lost_s : t;
    const auto row = [&](const char* id, double lon, const char* heading, int position_s) {
      const std::string time_s = std::to_string(1772373600 + t);
      text += time_s + "," + id + ",50.0," + std::to_string(lon) + ",230," + heading +
              ",0,FLY,False,10668,10780," + std::to_string(1772373600 + position_s) + "," + time_s +
              "\n";
    };
    row("3c6501", 7.8 + 0.0032 * t, "90", t);
    row("406a02", 8.184 - 0.0032 * heard_s, "270", heard_s);
  }
  return text;
}

TEST(DoubtfulTables, APositionIsOfTheTimeWhenItWasMeasured) {
  const Finished heard = enroute(opensky_table(200, 200));
  EXPECT_EQ(heard.exit_code, 1);
  EXPECT_EQ(rows_of(heard.out).size(), 1u) << heard.out << heard.err;
  EXPECT_NE(heard.err.find("lastposupdate"), std::string::npos) << heard.err;

  // Silent while they meet: where it was then is not known.
  const Finished lost = enroute(opensky_table(10, 110));
  EXPECT_EQ(lost.exit_code, 1) << lost.out << lost.err;
  EXPECT_EQ(lost.err.find("keeps its distance"), std::string::npos) << lost.err;

  // As if the rows were told anew where it is: it stands, and flies past in the end.
  const Finished believed = enroute(opensky_table(10, 110), {"--columns", "time=1"});
  EXPECT_NE(believed.err.find("times are read from column 1"), std::string::npos) << believed.err;
}

TEST(DoubtfulTables, MinimaOfTheIcaoAreOfPressureHeights) {
  const Said other_day{"34200", "33000"};
  const Finished finished = enroute(table(other_day));
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(rows_of(finished.out).size(), 1u) << finished.err;
  expect_parts(finished.err,
               {"heights    pressure altitude\n",
                "note       heights are by pressure, of column 6 'altitude'; column 10 "
                "'geoaltitude' is passed over (--heights geometric takes it)\n"});
  const Finished geometric = enroute(table(other_day), {"--heights", "geometric"});
  EXPECT_EQ(geometric.exit_code, 0) << geometric.out;
  expect_parts(geometric.err, {"column 6 'altitude' is passed over (--heights pressure takes it)"});
  const Finished of_drones = run({"replay", "--separation", "well-clear-suas"}, table(other_day));
  expect_parts(of_drones.err, {"heights are above the ellipsoid, of column 10 'geoaltitude'"});
}

TEST(DoubtfulTables, HeightsThatContradictEachOtherAreNotBelieved) {
  const Said zero{"34200", "0"};
  const Finished finished = enroute(table(zero), {"--heights", "geometric"});
  EXPECT_EQ(finished.exit_code, 1);
  expect_parts(finished.err, {"6 records whose heights by pressure and above the ellipsoid are "
                              "more than 1,500 m apart are left out",
                              "known nowhere: 3c6444\n"});
  expect_parts(enroute(table({"34200", "20000"})).err, {"known nowhere: 3c6444\n"});
  // A height of 0 is none; the other one is believed.
  const Finished by_pressure = enroute(table(zero));
  EXPECT_EQ(rows_of(by_pressure.out).size(), 1u) << by_pressure.err;
}

TEST(DoubtfulTables, WithoutGeoaltitudeTheLayoutSaysTheUnits) {
  const Finished finished = enroute(table(lower(), false));
  EXPECT_EQ(finished.exit_code, 1);
  EXPECT_EQ(rows_of(finished.out).size(), 1u) << finished.err;
  expect_parts(finished.err, {"heights in ft: the header is that of traffic, which has 'altitude'",
                              "speeds in kt: the header is that of traffic"});
}

// Straight from fix to fix: how fast aircraft say that they go does not matter.
TEST(DoubtfulTables, ReplayAsksForNoUnitThatItDoesNotNeed) {
  const std::string input =
      "time_s,icao24,lat,lon,altitude_ft,groundspeed,track\n"
      "0,a,50,7.5,35000,450,90\n1,a,50,7.501,35000,450,90\n"
      "0,b,50.05,7.5,34200,450,90\n1,b,50.05,7.501,34200,450,90\n";
  const Finished finished = run({"replay", "--separation", "enroute"}, input);
  EXPECT_EQ(finished.exit_code, 0) << finished.err;
  EXPECT_EQ(rows_of(finished.out).size(), 1u);
  expect_parts(finished.err, {"velocities are not read, and not needed here"});
  EXPECT_EQ(run({"predict", "--separation", "enroute"}, input).exit_code, 2);
  EXPECT_EQ(run({"replay", "--report", "events", "--separation", "enroute"}, input).exit_code, 2);
}

// One at some 85 kt, eastward, for two minutes, that says for some of them that it is on the
// ground.
template <class Height>
std::string says_ground(int from_s, int to_s, const Height& height_ft) {
  std::string text = kColumns + ",onground\n";
  for (int t = 0; t <= 120; t += 5) {
    const int minute = t / 60;
    const std::string time = "2018-10-12 23:5" + std::to_string(minute) + ":" +
                             (t % 60 < 10 ? "0" : "") + std::to_string(t % 60) + "+00:00,";
    const std::string longitude = std::to_string(7.5 + 0.0006 * t);
    const bool ground = from_s <= t && t <= to_s;
    text += time + "4ca7b3,SAYS,50.0," + longitude + "," + std::to_string(height_ft(t)) +
            ",85,90,0," + (ground ? "True" : "False") + "\n";
    text += time + "3c6444,OTHER,51.0," + longitude + ",5000,90,90,0,False\n";
  }
  return text;
}

// Below the limits that no aircraft on the ground exceeds, the records beside tell.
TEST(DoubtfulTables, WhoFliesByTheRecordsBesideIsNotOnTheGround) {
  const char* const hides =
      " records of aircraft that say that they are on the ground, but fly by what they report "
      "before and after are left out";
  const auto level = [](int /*t*/) { return 3000; };
  // Level before and after.
  const Finished flies = enroute(says_ground(40, 60, level));
  EXPECT_EQ(flies.exit_code, 1);
  expect_parts(flies.err, {std::string("5") + hides});
  // It never says that it flies; but nothing rolls at 85 kt for two minutes.
  for (const std::string& input :
       {says_ground(0, 120, level), says_ground(0, 120, [](int t) { return 3000 + 8 * t; })}) {
    const Finished rolls = enroute(input);
    EXPECT_EQ(rolls.exit_code, 1);
    expect_parts(rolls.err, {std::string("25") + hides});
  }
  // It lands and stays, takes off, or touches down and goes.
  for (const std::string& input :
       {says_ground(60, 120, [](int t) { return 3000 - 10 * std::min(t, 60); }),
        says_ground(0, 20, [](int t) { return 3000 + 10 * std::max(0, t - 20); }),
        says_ground(50, 60, [](int t) {
          return 3000 + 10 * std::max({0, 50 - t, t - 60});
        })}) {
    const Finished finished = enroute(input);
    expect_parts(finished.err, {" records of aircraft on the ground are left out"});
    EXPECT_EQ(finished.err.find("fly by what"), std::string::npos) << finished.err;
  }
}

// Two far apart that go north by 120 m a second, and say so in m/s or in knots.
std::string northward(const std::string& speed, const std::string& height, int seconds) {
  std::string text = kColumns + "\n";
  for (int t = 0; t < seconds; ++t) {
    for (const char* const id : {"4ca7b3", "3c6444"}) {
      const double longitude = id[0] == '4' ? 7.0 : 8.0;
      text += "2018-10-12 23:55:" + std::string(t < 10 ? "0" : "") + std::to_string(t) + "+00:00," +
              id + ",FLY," + std::to_string(50.0 + 0.00107917 * t) + "," +
              std::to_string(longitude) + "," + height + "," + speed + ",0,0\n";
    }
  }
  return text;
}

// Under the names of traffic OpenSky has metres.
TEST(DoubtfulTables, WatchAndDetectAskAboutFeetAsReplayDoes) {
  const Arguments asked = {"--separation", "terminal"};
  for (const char* const command : {"replay", "watch"}) {
    const Arguments line = Arguments{command, "--fail-on-risk"} + asked;
    const Finished metres = run(line, northward("120", "3000", 20));
    EXPECT_NE(metres.exit_code, 0) << command;
    expect_parts(metres.err, {"are heights in feet and speeds in knots", "--units aviation"});
    const Finished feet = run(line, northward("233.3", "3000", 20));
    EXPECT_EQ(feet.exit_code, 0) << command << feet.err;
  }
  expect_parts(run(Arguments{"watch", "--fail-on-risk"} + asked, northward("120", "3000", 20)).err,
               {"no conflict; heights may be in metres, not in feet"});
  EXPECT_EQ(run(Arguments{"watch", "--fail-on-risk", "--units", "aviation"} + asked,
                northward("120", "3000", 20))
                .exit_code,
            0);
  const Finished low = run(Arguments{"detect"} + asked, northward("120", "3000", 1));
  EXPECT_EQ(low.exit_code, 2) << low.err;
  expect_parts(low.err, {"are heights in feet", "neither a height", "--units aviation"});
  EXPECT_EQ(run(Arguments{"detect"} + asked, northward("240", "35000", 1)).exit_code, 0);
  for (const char* const said : {"aviation", "height=m"}) {
    const Finished finished =
        run(Arguments{"detect", "--units", said} + asked, northward("120", "3000", 1));
    EXPECT_EQ(finished.exit_code, 0) << said << finished.err;
  }
}

}  // namespace
}  // namespace beespace::cli_test
