// Positions whose unit nothing names, and that would be faster in metres than anything like that;
// and units of columns whose names are not known.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace beespace::io {
namespace {

// Twelve rows, one `step_s` after the other, each so far from the one before.
std::string path_of(const std::string& header, double step_s, int along,
                    const std::string& behind = "") {
  std::string text = header + "\n";
  for (int k = 0; k < 12; ++k) {
    text += std::to_string(k * step_s) + "," + std::to_string(k * along) + ",0,500" + behind + "\n";
  }
  return text;
}

void expect_asked(const std::string& text, const RecordingOptions& options = {}) {
  expect_error(record(text, options),
               {ErrorCode::kInvalidArgument, "bees.csv", "are x, y, z in metres?"});
  for (const Unit unit : {Unit::kCentimetre, Unit::kMillimetre, Unit::kMetre}) {
    RecordingOptions said = options;
    said.units.position = unit;
    EXPECT_TRUE(record(text, said));
  }
}

TEST(DoubtfulMetres, OfShowsAreAskedAbout) {
  expect_asked(path_of("Time,X,Y,Z,R,G,B", 0.5, 100, ",255,0,0"), columns_are(""));
  expect_asked(path_of("Time,X,Y,Z,Color", 0.5, 100, ",#ff0000"), columns_are(""));
  EXPECT_TRUE(record(path_of("Time,X,Y,Z,R,G,B", 0.5, 5, ",255,0,0"), columns_are("")));
  EXPECT_TRUE(record(path_of("Time,x_m,y_m,z_m,R,G,B", 0.5, 100, ",255,0,0"), columns_are("")));
}

TEST(DoubtfulMetres, OfCamerasAndOthersAreAskedAbout) {
  RecordingOptions options;
  options.frames_per_second = 20.0;
  std::string text = "Frame,X,Y,Z\n";
  for (int k = 0; k < 12; ++k) text += std::to_string(k) + "," + std::to_string(k * 10) + ",0,1\n";
  expect_asked(text, options);
  expect_asked(path_of("time_s,x,y,z", 0.5, 500));
  EXPECT_TRUE(record(path_of("time_s,x,y,z", 0.5, 100)));  // an aircraft
}

TEST(UnitsOfNames, ThatAreNotKnownAreHeeded) {
  const auto place = [](const Result<Recording>& loaded) {
    const Recording recording = recording_of(loaded);
    return recording.bees.empty() ? Point() : recording.bees[0].fixes[0].position;
  };
  RecordingOptions options = columns_are("x=3,y=4,z=5", Unit::kUnstated);
  const std::string row = "a,0,100,200,300\n";
  EXPECT_EQ(place(record("id,time_s,posx(cm),posy(cm),posz(cm)\n" + row, options)),
            (Point{1, 2, 3}));
  EXPECT_FALSE(record("id,time_s,posx(px),posy(px),posz(px)\n" + row, options));
  options.columns = "lon=3,lat=4,height=5";
  const std::string in_feet = "id,time_s,lon,lat,altitude_above_seaLevel(feet)\na,0,19,47,1000\n";
  EXPECT_DOUBLE_EQ(place(record(in_feet, options)).z, 304.8);
  EXPECT_DOUBLE_EQ(place(record(in_feet)).z, 304.8);
  EXPECT_EQ(recording_of(record(in_feet)).heights, HeightDatum::kMeanSeaLevel);
  options.columns = "x=3,y=4,z=5,vx=6,vy=7";
  const Recording moving = recording_of(
      record("id,time_s,posx(m),posy(m),posz(m),dx(cm/s),dy(cm/s)\na,0,1,2,3,100,200\n", options));
  EXPECT_EQ(moving.bees[0].velocities[0].y, 2.0);
}

// As traffic names them, an aircraft to the east; one record every 10 s.
std::string under_names_of_traffic(double degrees_a_step, const std::string& height,
                                   const std::string& speed, int records = 12) {
  std::string text =
      "timestamp,icao24,callsign,latitude,longitude,altitude,geoaltitude,groundspeed,track,"
      "vertical_rate\n";
  for (int k = 0; k < records; ++k) {
    text += "2024-05-01 12:0" + std::to_string(k / 6) + ":" + std::to_string(k % 6) +
            "0Z,4b1814,AFR1,0," + std::to_string(2.0 + k * degrees_a_step) + "," + height + "," +
            height + "," + speed + ",90,0\n";
  }
  return text;
}

constexpr double kDegreesOf100Mps = 1000.0 / 111'320.0;  // along the equator, in 10 s

TEST(DoubtfulFeet, StateVectorsInMetresUnderTheNamesOfTrafficAreAskedAbout) {
  const std::string metres = under_names_of_traffic(kDegreesOf100Mps, "3000", "100");
  const std::string question =
      "aircraft go 1.94 times as fast as they say in knots. Say which: --units aviation, or "
      "--units height=m,speed=m/s,climb=m/s";
  expect_error(record(metres), {ErrorCode::kInvalidArgument, "bees.csv", question});
  RecordingOptions options;
  options.units.height = Unit::kMetre;
  options.units.speed = Unit::kMetrePerSecond;
  options.units.climb = Unit::kMetrePerSecond;
  EXPECT_EQ(recording_of(record(metres, options)).bees.at(0).fixes.at(0).position.z, 3000.0);
  options.units = {};
  options.units.convention = UnitConvention::kAviation;
  EXPECT_TRUE(record(metres, options));
  // Of one moment nothing can tell.
  const std::string moment = under_names_of_traffic(0.0, "3000", "100", 1);
  expect_error(record(moment), {ErrorCode::kInvalidArgument, "bees.csv",
                                "and here neither a height, a speed, nor the way from record to "
                                "record tells. Say which: --units aviation, or"});
  EXPECT_TRUE(record(moment, options));
}

TEST(DoubtfulFeet, TablesOfTrafficThatSayWhatTheyAreAreRead) {
  for (const std::string& text :
       {under_names_of_traffic(kDegreesOf100Mps, "3000", "194"),     // by its speed
        under_names_of_traffic(0.0, "35000", "194", 1),              // by its height
        under_names_of_traffic(kDegreesOf100Mps, "3000", "450", 1),  // too fast for m/s
        under_names_of_traffic(kDegreesOf100Mps * 0.9, "3000", "194")}) {
    const Recording recording = recording_of(record(text));
    EXPECT_EQ(recording.height_unit, Unit::kFoot) << text;
  }
}

// With flights told apart by traffic itself (assign_id), addresses and callsigns may be left out.
TEST(DoubtfulFeet, TablesOfTrafficMayNameFlightsAlone) {
  std::string text =
      "timestamp,latitude,longitude,groundspeed,track,vertical_rate,onground,altitude,geoaltitude,"
      "flight_id\n";
  for (int k = 0; k < 6; ++k) {
    text += "2024-05-01 12:00:" + std::to_string(k) + "0Z,0," + std::to_string(2.0 + 0.02 * k) +
            ",450,90,0,False,35000,35300,AFR1_1\n";
  }
  const Recording recording = recording_of(record(text));
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
  EXPECT_EQ(recording.heights, HeightDatum::kEllipsoid);  // unless heights by pressure are wanted
  EXPECT_EQ(ids_of(recording), std::vector<std::string>{"AFR1_1"});
}

// x and y, which traffic computes of longitude and latitude, are no other place.
TEST(DoubtfulFeet, TablesOfTrafficWithProjectedPlacesAreReadInDegrees) {
  std::istringstream table(under_names_of_traffic(kDegreesOf100Mps, "35000", "194"));
  std::string text;
  for (std::string line; std::getline(table, line);) {
    text += line + (text.empty() ? ",x,y\n" : ",12,-9\n");
  }
  const Recording recording = recording_of(record(text));
  EXPECT_EQ(recording.frame, Frame::kWgs84);
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
}

TEST(TimesOfTables, OfBlueSkyMayNameTheirUnit) {
  const Recording recording = recording_of(
      record("simt [s],id,lat [deg],lon [deg],alt [m]\n0,A,48,2,9000\n5,A,48,2.01,9000\n"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"A"});
  EXPECT_EQ(times_of(recording.bees[0]), (std::vector<double>{0, 5}));
}

// What its interface answers with: the documentation says feet, knots and feet per minute.
TEST(DoubtfulFeet, LivePositionsOfFlightradar24AreInFeetAndKnots) {
  const auto aircraft = [](const std::string& hex, const std::string& height,
                           const std::string& speed) {
    return R"({"fr24_id": "35a0)" + hex +
           R"(", "flight": "AF1", "callsign": "AFR1", "lat": 48.0, )" +
           R"("lon": 2.0, "track": 90, "alt": )" + height + R"(, "gspeed": )" + speed +
           R"(, "vspeed": 600, "squawk": "1000", "timestamp": "2024-06-05T10:04:00Z", )" +
           R"("source": "ADSB", "hex": ")" + hex + R"("})";
  };
  const Recording recording =
      recording_of(record(R"({"data": [)" + aircraft("3944EF", "35000", "450") + "," +
                          aircraft("4008F6", "0", "12") + "]}"));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"3944EF"});  // the other is on the ground
  EXPECT_EQ(recording.height_unit, Unit::kFoot);
  EXPECT_EQ(recording.heights, HeightDatum::kPressure);
  ASSERT_EQ(recording.bees[0].velocities.size(), 1U);
  EXPECT_NEAR(recording.bees[0].velocities[0].x, 450 * 1852.0 / 3600.0, 1e-9);
  EXPECT_NEAR(recording.bees[0].velocities[0].z, 600 * 0.3048 / 60.0, 1e-12);
}

TEST(DoubtfulFeet, TheHistoryOfOpenSkyIsInMetresWhateverElseIsLeftOut) {
  for (const std::string names :
       {"time,icao24,lat,lon,velocity,baroaltitude", "time,icao24,lat,lon,velocity,geoaltitude"}) {
    const Recording recording = recording_of(record(names + "\n1714564800,a,48,2,180,3000\n"));
    EXPECT_EQ(recording.bees.at(0).fixes.at(0).position.z, 3000.0) << names;
    EXPECT_TRUE(recording.since_1970) << names;
  }
  const Recording all =
      recording_of(record("lat,lon,baroaltitude,geoaltitude,velocity,heading,vertrate,time,icao24\n"
                          "48,2,3000,3100,180,90,3,1714564800,a\n"));
  EXPECT_EQ(all.bees.at(0).fixes.at(0).position.z, 3100.0);
  EXPECT_NEAR(all.bees[0].velocities.at(0).x, 180.0, 1e-9);
}

// Their velocities were passed over, and a turn between two rows kept its distance.
TEST(DoubtfulFeet, TheNamesOfTheLiveInterfaceOfOpenSkyAreMetresToo) {
  const Recording recording = recording_of(record(
      "icao24,callsign,origin_country,time_position,last_contact,longitude,latitude,baro_altitude,"
      "on_ground,velocity,true_track,vertical_rate,sensors,geo_altitude,squawk,spi,"
      "position_source\n"
      "3c6444,DLH4AB  ,Germany,1717232639,1717232640,8.8,48.0,10668.0,False,231.5,90,2.5,,10788.0,"
      "1000,False,0\n"));
  ASSERT_EQ(recording.bees.size(), 1U);
  EXPECT_EQ(recording.bees[0].id, "3c6444");
  EXPECT_TRUE(recording.since_1970);
  EXPECT_EQ(recording.height_unit, Unit::kMetre);
  ASSERT_EQ(recording.bees[0].velocities.size(), 1U);
  EXPECT_NEAR(recording.bees[0].velocities[0].x, 231.5, 1e-9);
  EXPECT_NEAR(recording.bees[0].velocities[0].z, 2.5, 1e-12);
}

}  // namespace
}  // namespace beespace::io
