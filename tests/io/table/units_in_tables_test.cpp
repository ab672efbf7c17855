// In which unit the numbers of a table are: as its header names it, as the caller says, as a known
// source has it; beside words of aviation nothing is assumed. The same at every door.
#include "io/load_plans.hpp"
#include "tests/io/live/report_lines_reading.hpp"
#include "tests/io/points/loading.hpp"
#include "tests/io/tracks/recording_loading.hpp"

#include <beespace/geodesy.hpp>

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {
namespace {

constexpr double k35000Feet_m = 10668.0;

Point at(double height_m) {
  return *to_ecef(GeographicPosition{2.0, 48.0, height_m});
}

LoadOptions with_units(std::string_view text) {
  LoadOptions options;
  options.units = *read_unit_overrides(text);
  return options;
}

RecordingOptions recording_units(std::string_view text) {
  RecordingOptions options;
  options.units = *read_unit_overrides(text);
  return options;
}

// The fault that all of this is about: 35,000 ft were read as 35,000 m.
TEST(UnitsInTables, AHeightBesideWordsOfAviationMustSayItsUnit) {
  for (const char* height : {"altitude", "alt", "elevation", "baro_altitude", "geoaltitude",
                             "baroaltitude", "Altitude", "h"}) {
    const std::string text = "icao24,lat,lon," + std::string(height) +
                             ",groundspeed,vertical_rate\na,48,2,35000,450,0\n";
    const auto loaded = load_text(text);
    expect_error(loaded, {ErrorCode::kInvalidArgument, "bees.csv:1:4", "but in which unit?"});
    const std::string& message = loaded.error().message;
    EXPECT_NE(message.find("--units height=ft"), std::string::npos) << message;
    const std::string remedy = std::string("'").append(height).append(" [ft]'");
    EXPECT_NE(message.find(remedy), std::string::npos) << message;
    EXPECT_NE(message.find("'icao24'"), std::string::npos) << message;
  }
  for (const char* word : {"callsign", "squawk", "icao24", "ICAO", "hex", "gs", "onground",
                           "vertical_rate", "vertrate", "Ground Speed (kt)", "aircraft"}) {
    expect_error(load_text(std::string(word) + ",lat,lon,altitude\n7,48,2,35000\n"),
                 {ErrorCode::kInvalidArgument, "bees.csv:1:4", "but in which unit?"});
  }
  // By its own name alone.
  expect_error(load_text("lat,lon,baro_altitude\n48,2,35000\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:3", "but in which unit?"});
  // Named by the caller it is the same column.
  LoadOptions wished;
  wished.columns = "lat=2,lon=3,height=4";
  expect_error(load_text("icao24,a,b,altitude\n7,48,2,35000\n", wished),
               {ErrorCode::kInvalidArgument, "bees.csv:1:4", "but in which unit?"});
}

TEST(UnitsInTables, TheHeaderOrTheCallerGivesThem) {
  const std::string before = "icao24,lat,lon,";
  const std::string row = "\na,48,2,35000\n";
  for (const char* height : {"altitude_ft", "altitude [ft]", "Altitude (feet)", "alt_ft",
                             "baro_altitude_ft", "geoaltitude [FT]"}) {
    const auto loaded = load_text(before + height + row);
    EXPECT_EQ(points_of(loaded), std::vector<Point>{at(k35000Feet_m)}) << height;
    ASSERT_EQ(loaded->units.size(), 1U);
    EXPECT_EQ(loaded->units[0].of, "heights");
    EXPECT_EQ(loaded->units[0].unit, Unit::kFoot);
    EXPECT_EQ(loaded->units[0].reason, "the header names it: '" + std::string(height) + "'");
    EXPECT_EQ(loaded->height_unit, Unit::kFoot);
  }
  EXPECT_EQ(points_of(load_text(before + "altitude_m" + row)), std::vector<Point>{at(35000.0)});
  EXPECT_EQ(points_of(load_text(before + "altitude_km\na,48,2,10.668\n")),
            std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(points_of(load_text(before + "alt_fl\na,48,2,350\n")),
            std::vector<Point>{at(k35000Feet_m)});
  const auto asked = load_text(before + "altitude" + row, with_units("height=ft"));
  EXPECT_EQ(points_of(asked), std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(asked->units.at(0).reason, "asked for with --units");
  EXPECT_EQ(points_of(load_text(before + "altitude" + row, with_units("height=m"))),
            std::vector<Point>{at(35000.0)});
  expect_error(
      load_text(before + "altitude_ft" + row, with_units("height=m")),
      {ErrorCode::kInvalidArgument, "bees.csv:1:4", "names its unit, ft, but --units says m"});
  expect_error(load_text("icao24,lat,lon\na,48,2\n", with_units("height=ft")),
               {ErrorCode::kInvalidArgument, "bees.csv", "there is no height"});
  expect_error(load_text(before + "altitude_ft" + row, with_units("position=ft")),
               {ErrorCode::kInvalidArgument, "bees.csv", "positions are in degrees"});
}

// They were offered as feet: FL330 below FL350 would be 20 ft apart.
TEST(UnitsInTables, FlightLevelsAreKnownByTheirName) {
  for (const char* header :
       {"icao24,lat,lon,FL", "id,lat,lon,Flight Level", "id,lat,lon,flight_level",
        "id,lat,lon,FlightLevel", "flight,lat,lon,fl"}) {
    const auto loaded = load_text(std::string(header) + "\na,48,2,350\n");
    EXPECT_EQ(points_of(loaded), std::vector<Point>{at(k35000Feet_m)}) << header;
    ASSERT_EQ(loaded->units.size(), 1U);
    EXPECT_EQ(loaded->units[0].unit, Unit::kFlightLevel);
    EXPECT_EQ(loaded->height_unit, Unit::kFlightLevel);
    EXPECT_EQ(loaded->heights, HeightDatum::kPressure);
  }
  // Whatever of columns and units the caller says.
  LoadOptions named = with_units("aviation");
  named.columns = "lat=2,lon=3,height=4";
  EXPECT_EQ(points_of(load_text("icao24,a,b,Flight Level\n7,48,2,350\n", named)),
            std::vector<Point>{at(k35000Feet_m)});
  expect_error(
      load_text("icao24,lat,lon,FL\n7,48,2,350\n", with_units("height=ft")),
      {ErrorCode::kInvalidArgument, "bees.csv:1:4", "names its unit, FL, but --units says ft"});
}

TEST(UnitsInTables, FlIsNoFlightLevelOfFishAndNotBesideAHeight) {
  // Their fork length; who says that it is a height means flight levels.
  expect_error(load_text("id,lat,lon,FL\na,48,2,35\n"),
               {ErrorCode::kMissingColumn, "bees.csv:1", "'FL' may or may not be it"});
  LoadOptions named;
  named.columns = "lat=2,lon=3,height=4";
  EXPECT_EQ(points_of(load_text("id,lat,lon,FL\na,48,2,350\n", named)),
            std::vector<Point>{at(k35000Feet_m)});
  const auto finer = load_text("icao24,lat,lon,altitude_ft,FL\na,48,2,35000,347\n");
  EXPECT_EQ(points_of(finer), std::vector<Point>{at(k35000Feet_m)});
}

TEST(UnitsInTables, WithoutWordsOfAviationHeightsAreMetresAndThatIsReported) {
  const auto loaded = load_text("lat,lon,alt\n48,2,350\n");
  EXPECT_EQ(points_of(loaded), std::vector<Point>{at(350.0)});
  ASSERT_EQ(loaded->units.size(), 1U);
  EXPECT_EQ(loaded->units[0].unit, Unit::kMetre);
  EXPECT_EQ(loaded->units[0].reason, "no unit is named, and nothing speaks of aviation");
  const auto plain = load_text("x,y,z\n1,2,3\n4000,5,6\n");
  ASSERT_TRUE(plain.has_value());
  ASSERT_EQ(plain->units.size(), 1U);
  EXPECT_EQ(plain->units[0].of, "x, y and z");
}

constexpr std::string_view kTraffic =
    "timestamp,icao24,callsign,latitude,longitude,altitude,geoaltitude,groundspeed,track,"
    "vertical_rate,onground\n"
    "2024-05-01 12:00:00Z,a,AFR1,48,2,34000,35000,360,90,600,False\n";
constexpr std::string_view kOpenSky =
    "time,icao24,lat,lon,velocity,heading,vertrate,callsign,onground,baroaltitude,geoaltitude\n"
    "1714564800,a,48,2,180,90,3,AFR1,False,10000,10668\n";

TEST(UnitsInTables, KnownSourcesAreRecognisedByTheirWholeHeader) {
  const auto traffic = load_text(kTraffic);
  EXPECT_EQ(points_of(traffic), std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(traffic->units.at(0).unit, Unit::kFoot);
  EXPECT_EQ(traffic->units.at(0).reason,
            "the header is that of traffic, which has 'geoaltitude' in it");
  EXPECT_EQ(traffic->heights, HeightDatum::kEllipsoid);
  const auto opensky = load_text(kOpenSky);
  EXPECT_EQ(points_of(opensky), std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(opensky->units.at(0).unit, Unit::kMetre);
  EXPECT_EQ(opensky->heights, HeightDatum::kEllipsoid);
  // One column less, and it is not known.
  std::string less(kTraffic);
  less.replace(less.find(",track"), 6, ",turn");
  expect_error(load_text(less, with_columns("lat=4,lon=5,height=6")),
               {ErrorCode::kInvalidArgument, "bees.csv:1:6", "but in which unit?"});
}

// The fault that this is about: metres were read as feet, and aircraft head-on kept their distance.
TEST(UnitsInTables, StateVectorsOfOpenSkyComeInFeetAndInMetres) {
  const std::string states =
      "icao24,callsign,origin_country,last_position,timestamp,longitude,latitude,altitude,onground,"
      "groundspeed,track,vertical_rate,sensors,geoaltitude,squawk,spi,position_source\n"
      "a,AFR1,France,2024-05-01 12:00:00Z,2024-05-01 12:00:01Z,2,48,10668,False,200,90,0,,10668,"
      "1000,False,0\n";
  expect_error(record(states),
               {ErrorCode::kInvalidArgument, "bees.csv:1:14",
                "State vectors of OpenSky have such columns: pyopensky writes them in metres, and "
                "traffic in feet and knots, where it may be ft or m; "});
  const Recording metres = recording_of(record(states, recording_units("metric")));
  EXPECT_EQ(metres.bees.at(0).fixes.at(0).position.z, k35000Feet_m);
  EXPECT_NEAR(metres.bees[0].velocities.at(0).x, 200.0, 1e-9);
  EXPECT_EQ(recording_of(record(states, recording_units("aviation"))).height_unit, Unit::kFoot);
  // With some of its columns only.
  for (const char* name : {"origin_country", "position_source", "sensors"}) {
    expect_error(load_text("timestamp,icao24,callsign,latitude,longitude,groundspeed,track,"
                           "vertical_rate,altitude," +
                           std::string(name) + "\n2024-05-01 12:00:00Z,a,AFR1,48,2,1,1,1,1,0\n"),
                 {ErrorCode::kInvalidArgument, "bees.csv:1:9", "but in which unit?"});
  }
}

// One word is enough, in the words of several languages and of two words too; and then positions
// are not taken for metres either.
TEST(UnitsInTables, AnyWordOfAviationMakesTheUnitAQuestion) {
  for (const char* word : {"flight",
                           "Flight ID",
                           "flight_number",
                           "registration",
                           "tail",
                           "tail_number",
                           "ident",
                           "plane",
                           "airline",
                           "mode_s",
                           "modes",
                           "transponder",
                           "call sign",
                           "n_number",
                           "vuelo",
                           "aeronave",
                           "avion",
                           "indicativo",
                           "immatriculation",
                           "Indicatif",
                           "Kennzeichen",
                           "Rufzeichen",
                           "Flug",
                           "vol",
                           "volo",
                           "matricula",
                           "voo"}) {
    const std::string header = std::string(word) + ",lat,lon,alt";
    expect_error(load_text(header + "\na,48,2,350\n"),
                 {ErrorCode::kInvalidArgument, "bees.csv:1:4", "but in which unit?"});
    EXPECT_TRUE(load_text(header + "_m\na,48,2,350\n").has_value()) << word;
  }
  expect_error(load_text("callsign,x,y,z\na,1,2,3\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:2", "holds the position, but in which"});
  expect_error(load_text("callsign,x_m,y_m,z\na,1,2,3\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:4", "but in which unit?"});
  LoadOptions metres;
  metres.units.position = Unit::kMetre;
  EXPECT_TRUE(load_text("callsign,x,y,z\na,1,2,3\n", metres).has_value());
  for (const char* word : {"drone", "bird", "species", "volume", "planet"}) {
    EXPECT_TRUE(load_text(std::string(word) + ",lat,lon,alt\na,48,2,350\n").has_value()) << word;
  }
}

TEST(UnitsInTables, HeightsByPressureAndBySatellitesAreNeverMixed) {
  LoadOptions pressure;
  pressure.heights = HeightSource::kPressure;
  const auto loaded = load_text(kTraffic, pressure);
  EXPECT_EQ(points_of(loaded), std::vector<Point>{at(in_metric(34000.0, Unit::kFoot))});
  EXPECT_EQ(loaded->heights, HeightDatum::kPressure);
  expect_error(load_text("lat,lon,geoaltitude_m\n48,2,3\n", pressure),
               {ErrorCode::kInvalidArgument, "bees.csv", "--heights pressure"});
  // A record without a height of that kind is left out, whatever else it has.
  std::string without(kTraffic);
  without += "2024-05-01 12:00:00Z,b,AFR2,48,2,34000,,360,90,600,False\n";
  EXPECT_FALSE(load_text(without).has_value());
  const TemporaryFolder folder;
  const auto one = folder.write("one.csv", "id,time_s,lat,lon,baro_altitude_m\na,0,48,2,5\n");
  const auto two = folder.write("two.csv", "id,time_s,lat,lon,geoaltitude_m\nb,0,48,2,5\n");
  const auto both = load_recording({one, two});
  ASSERT_FALSE(both.has_value());
  EXPECT_EQ(both.error().code, ErrorCode::kInvalidArgument);
}

TEST(UnitsInTables, RecordingsHaveThemInHeightsAndVelocities) {
  const Recording traffic = recording_of(record(kTraffic));
  ASSERT_EQ(traffic.bees.size(), 1U);
  EXPECT_EQ(traffic.height_unit, Unit::kFoot);
  EXPECT_EQ(traffic.bees[0].fixes.at(0).position.z, k35000Feet_m);
  EXPECT_EQ(traffic.bees[0].stated_heights, std::vector<double>{35000.0});
  ASSERT_EQ(traffic.bees[0].velocities.size(), 1U);
  EXPECT_NEAR(traffic.bees[0].velocities[0].x, 360.0 * 1852 / 3600, 1e-9);
  EXPECT_NEAR(traffic.bees[0].velocities[0].y, 0.0, 1e-9);
  EXPECT_NEAR(traffic.bees[0].velocities[0].z, 600 * 0.3048 / 60, 1e-9);
  ASSERT_EQ(traffic.units.size(), 3U);
  EXPECT_EQ(traffic.units[1].unit, Unit::kKnot);
  EXPECT_EQ(traffic.units[2].unit, Unit::kFootPerMinute);
  const Recording opensky = recording_of(record(kOpenSky));
  EXPECT_TRUE(opensky.since_1970) << "the time of OpenSky is known, too";
  EXPECT_TRUE(opensky.bees.at(0).stated_heights.empty());
  EXPECT_NEAR(opensky.bees[0].velocities.at(0).x, 180.0, 1e-9);
  EXPECT_EQ(opensky.bees[0].velocities[0].z, 3.0);

  const std::string header = "icao24,time_s,lat,lon,";
  expect_error(record(header + "altitude,groundspeed,track\na,0,48,2,35000,360,90\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:5", "holds the height"});
  expect_error(record(header + "altitude_ft,groundspeed,track\na,0,48,2,35000,360,90\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:6", "--units speed=kt"});
  expect_error(record(header + "alt_ft,gs_kt,track,vertical_rate\na,0,48,2,35000,360,90,0\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:8", "--units climb=ft/min"});
  const Recording said = recording_of(
      record(header + "altitude,groundspeed,track,vertical_rate\na,0,48,2,35000,360,90,600\n",
             recording_units("height=ft,speed=kt,climb=ft/min")));
  EXPECT_EQ(said.bees.at(0).fixes, (std::vector<Fix>{{0.0, {2.0, 48.0, k35000Feet_m}}}));
  EXPECT_NEAR(said.bees[0].velocities.at(0).x, 360.0 * 1852 / 3600, 1e-9);
}

TEST(UnitsInTables, VelocitiesAlongAxesAreConverted) {
  const Recording knots =
      recording_of(record("id,time_s,x_m,y_m,z_m,vx_kt,vy_kt,vz [ft/min]\na,0,1,2,3,36,0,-100\n"));
  ASSERT_EQ(knots.bees.at(0).velocities.size(), 1U);
  EXPECT_EQ(knots.bees[0].velocities[0].x, in_metric(36.0, Unit::kKnot));
  EXPECT_EQ(knots.bees[0].velocities[0].z, in_metric(-100.0, Unit::kFootPerMinute));
  expect_error(record("id,time_s,x,y,vx_kmh,vy\na,0,1,2,3,4\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:6", "names no unit"});
  expect_error(record("id,time_s,x_m,y_m,vx_kt,vy\na,0,1,2,3,4\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:6", "but in which unit?"});
}

TEST(UnitsInTables, CoordinatesMayBeInAnyUnitOfLength) {
  EXPECT_EQ(points_of(load_text("x [km],y [km],z [ft]\n1,2,1000\n")),
            (std::vector<Point>{{1000.0, 2000.0, 304.8}}));
  EXPECT_EQ(points_of(load_text("x,y,z\n1,2,1000\n9000,2,1000\n", with_units("height=ft"))),
            (std::vector<Point>{{1.0, 2.0, 304.8}, {9000.0, 2.0, 304.8}}));
  EXPECT_EQ(points_of(load_text("1,2,3\n", with_units("position=km"))),
            (std::vector<Point>{{1000.0, 2000.0, 3000.0}}));
  EXPECT_EQ(points_of(load_text("x,y,z_ft\n1,2,1000\n", with_units("position=km"))),
            (std::vector<Point>{{1000.0, 2000.0, 304.8}}));
  expect_error(load_text("x_ft,y_ft,z\n1,2,3\n"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:3", "'x_ft' is in ft, but 'z'"});
  expect_error(load_text("lat_ft,lon_ft\n1,2\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv:1:2", "in degrees"});
  expect_error(load_text("lat,lon,alt_ft\n48,2,9000000\n"),
               {ErrorCode::kInvalidHeight, "bees.csv:2:3", "'9000000' ft is no height"});
}

TEST(UnitsInTables, LinesThatComeOneByOneAreReadAlike) {
  const std::string header = "icao24,time_s,lat,lon,";
  ReportLines refused;
  EXPECT_FALSE(says_something(refused.take(header + "altitude")));
  expect_line_error(refused.take("a,0,48,2,35000"),
                    {ErrorCode::kInvalidArgument, "<stdin>:1:5", "but in which unit?"});
  EXPECT_FALSE(refused.understood());
  ReportLines feet;
  EXPECT_FALSE(says_something(feet.take(header + "altitude_ft")));
  const ReportLine line = report_of(feet.take("a,0,48,2,35000"));
  EXPECT_EQ(line.position.z, k35000Feet_m);
  EXPECT_EQ(line.stated_height, 35000.0);
  EXPECT_EQ(line.height_unit, Unit::kFoot);
  EXPECT_EQ(feet.units().at(0).unit, Unit::kFoot);

  ReportLines objects;
  expect_line_error(
      objects.take(R"({"icao24": "a", "time_s": 0, "lat": 48, "lon": 2, "altitude": 35000})"),
      {ErrorCode::kInvalidArgument, "<stdin>:1", "but in which unit?"});
  ReportLines named;
  EXPECT_EQ(
      report_of(named.take(R"({"icao24": "a", "time_s": 0, "lat": 48, "lon": 2, "alt_ft": 35000})"))
          .position.z,
      k35000Feet_m);
}

// Values that were taken for metres become doubtful; heights of another kind do not matter.
TEST(UnitsInTables, KeysThatComeLaterChangeNoUnitInSilence) {
  ReportLines lines;
  EXPECT_TRUE(says_something(
      lines.take(R"({"id": "a", "time_s": 0, "lat": 48, "lon": 2, "altitude": 15000})")));
  for (int i = 1; i < 3; ++i) {
    expect_line_error(
        lines.take(R"({"id": "a", "time_s": 1, "lat": 48, "lon": 2, )"
                   R"("altitude": 15000, "squawk": "7000"})"),
        {ErrorCode::kInvalidArgument, "<stdin>:" + std::to_string(i + 1), "but in which unit?"});
  }
  ReportLines kinds;
  const std::string before = R"({"id": "a", "time_s": 0, "lat": 48, "lon": 2, )";
  EXPECT_EQ(report_of(kinds.take(before + R"("baro_altitude_m": 100})")).position.z, 100.0);
  EXPECT_EQ(
      report_of(kinds.take(before + R"("geoaltitude_m": 200, "baro_altitude_m": 101})")).position.z,
      101.0);
}

TEST(UnitsInTables, PlansAreConverted) {
  const auto plans = load_flight_plans_from_memory(
      "id,x_ft,y_ft,z_ft,goal_x_m,goal_y_m,goal_z_m,vx_kt,vy_kt,vz_kt,max_speed_kmh\n"
      "a,1000,0,500,1,2,3,36,0,0,36\n",
      "bees.csv", PlanNeed::kGoals);
  ASSERT_TRUE(plans.has_value()) << to_string(plans.error());
  EXPECT_EQ(plans->positions.at(0).x, 304.8);
  EXPECT_EQ(plans->goals.at(0).z, 3.0);
  EXPECT_EQ(plans->velocities.at(0).x, in_metric(36.0, Unit::kKnot));
  EXPECT_EQ(plans->max_speeds_mps.at(0), 10.0);
  const auto half = load_flight_plans_from_memory("x,y,z [ft],goal_x,goal_y,goal_z\n1,2,3,4,5,6\n",
                                                  "bees.csv", PlanNeed::kGoals);
  expect_error(half, {ErrorCode::kInvalidArgument, "bees.csv:1:1", "names no unit"});
  // Places belong together, and so do speeds.
  const auto half_named = [](const char* header) {
    return load_flight_plans_from_memory(std::string(header) + "\n", "bees.csv",
                                         PlanNeed::kNothing);
  };
  expect_error(half_named("x_ft,y_ft,z_ft,goal_x,goal_y,goal_z"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:4", "names no unit"});
  expect_error(half_named("x,y,z,goal_x_ft,goal_y_ft,goal_z_ft"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:1", "names no unit"});
  expect_error(half_named("x,y,z,goal_x,goal_y,goal_z,vx_kt,vy_kt,vz_kt,max_speed"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:10", "names no unit"});
  expect_error(half_named("x,y,z,vx,vy,vz,want_vx_kmh,want_vy_kmh,want_vz_kmh"),
               {ErrorCode::kInvalidArgument, "bees.csv:1:4", "names no unit"});
}

TEST(UnitsInTables, FormatsWithUnitsOfTheirOwnTakeNoOthers) {
  const auto refused = record(R"({"now": 1, "aircraft": []})", recording_units("height=ft"));
  expect_error(refused, {ErrorCode::kInvalidArgument, "bees.csv", "leave --units out"});
}

TEST(UnitsInTables, AircraftKeepTheirHeightsAsTheyWereSent) {
  const Recording recording = recording_of(record(
      R"({"now": 10, "aircraft": [{"hex": "a", "lat": 1, "lon": 2, "seen_pos": 0,
          "alt_geom": 35025, "gs": 360, "track": 90, "geom_rate": 64}]})"));
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
  EXPECT_EQ(recording.bees.at(0).stated_heights, std::vector<double>{35025.0});
  EXPECT_EQ(recording.units.at(0).reason, "aircraft.json of readsb or dump1090 has them so");
}

TEST(UnitsInTables, FilesInDifferentUnitsAreComparedInMetres) {
  const TemporaryFolder folder;
  const auto feet = folder.write("feet.csv", "id,time_s,lat,lon,alt_ft\na,0,48,2,35000\n");
  const auto metres = folder.write("metres.csv", "id,time_s,lat,lon,alt_m\nb,0,48,2,10668\n");
  for (const auto& paths : {std::vector{feet, metres}, std::vector{metres, feet}}) {
    const Recording both = recording_of(load_recording(paths, on_one_clock()));
    EXPECT_EQ(both.height_unit, Unit::kMetre);
    ASSERT_EQ(both.bees.size(), 2U);
    EXPECT_TRUE(both.bees[0].stated_heights.empty() && both.bees[1].stated_heights.empty());
    EXPECT_EQ(both.bees[0].fixes[0].position.z, both.bees[1].fixes[0].position.z);
    EXPECT_TRUE(has_note(both, "inputs state heights in different units"));
  }
}

TEST(UnitsInTables, ArraysHaveThemAsAskedFor) {
  const std::vector<double> numbers = {1, 2, 1000, 9000, 2, 1000};
  const std::string bytes(reinterpret_cast<const char*>(numbers.data()),
                          numbers.size() * sizeof(double));
  LoadOptions options = with_units("height=ft");
  options.format = Format::kRawFloat64;
  options.frame = Frame::kMetres;
  const auto loaded = load_points_from_memory(bytes, "bees.bin", options);
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 304.8}, {9000, 2, 304.8}}));
  EXPECT_EQ(loaded->height_unit, Unit::kFoot);
}

TEST(UnitsInTables, AConventionHoldsWhereNothingElseSaysAUnit) {
  const std::string asked = "icao24,lat,lon,altitude\na,48,2,35000\n";
  EXPECT_EQ(points_of(load_text(asked, with_units("aviation"))),
            std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(points_of(load_text(asked, with_units("metric"))), std::vector<Point>{at(35000)});
  EXPECT_EQ(points_of(load_text("lat,lon,alt\n48,2,35000\n", with_units("aviation"))),
            std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(points_of(load_text("lat,lon,alt_ft\n48,2,35000\n", with_units("metric"))),
            std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(points_of(load_text(asked, with_units("aviation,height=m"))),
            std::vector<Point>{at(35000)});
  // A known source says another one: neither is passed over.
  expect_error(load_text(kOpenSky, with_units("aviation")),
               {ErrorCode::kInvalidArgument, "bees.csv:1:11",
                "'geoaltitude' is in m in tables of OpenSky, whose header this is, but --units "
                "aviation says ft; leave that out, or, for answers in these units only, say "
                "--units aviation,height=m,speed=m/s,climb=m/s, or, if the table is in them too, "
                "--units aviation,height=ft,speed=kt,climb=ft/min"});
  expect_error(load_text(kTraffic, with_units("metric")),
               {ErrorCode::kInvalidArgument, "bees.csv:1:7", "but --units metric says m;"});
  EXPECT_EQ(points_of(load_text(kTraffic, with_units("metric,height=ft,speed=kt,climb=ft/min"))),
            std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(points_of(load_text(kTraffic, with_units("aviation"))),
            std::vector<Point>{at(k35000Feet_m)});
  EXPECT_EQ(points_of(load_text(kOpenSky, with_units("metric"))),
            std::vector<Point>{at(k35000Feet_m)});
  expect_error(
      load_text("x,y,z\n1,2,3\n", with_units("aviation")),
      {ErrorCode::kInvalidArgument, "bees.csv:1:1", "does not say in which unit x, y and z"});
  const Recording fast = recording_of(
      record("icao24,time_s,lat,lon,altitude,gs,track,vertical_rate\na,0,48,2,1,90,90,60\n",
             recording_units("aviation")));
  EXPECT_NEAR(fast.bees.at(0).velocities.at(0).x, 46.3, 1e-9);
  EXPECT_NEAR(fast.bees[0].velocities[0].z, 0.3048, 1e-12);
}

}  // namespace
}  // namespace beespace::io
