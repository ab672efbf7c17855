// A speed of 0 in the air, which is that of a helicopter or of no measurement; and aircraft that
// may be there twice.
#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

std::string aircraft(const std::string& id, const std::string& more) {
  return R"({"hex": ")" + id +
         R"(", "lat": 50.0, "lon": 8.0, "seen_pos": 0.5, "track": 90, "gs": 0, "baro_rate": 0, )" +
         more + "}";
}

Recording by_pressure(const std::string& list) {
  RecordingOptions options;
  options.heights = HeightSource::kPressure;
  return recording_of(record(R"({"now": 1719835450, "aircraft": [)" + list + "]}", options));
}

TEST(StandingAircraft, HighInTheAirTheirVelocityIsNotKnown) {
  const auto recording =
      by_pressure(aircraft("a00001", R"("alt_baro": 35000)") + "," +
                  aircraft("a00002", R"("alt_baro": 35000, "category": "A3")") + "," +
                  aircraft("a00003", R"("alt_baro": 5000, "category": "A7")") + "," +
                  aircraft("a00004", R"("alt_baro": 1200)"));
  ASSERT_EQ(recording.bees.size(), 4u);
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities.at(0).x));
  EXPECT_TRUE(std::isnan(recording.bees[1].velocities.at(0).x));
  EXPECT_EQ(recording.bees[2].velocities.at(0), (Velocity{0, 0, 0}));  // a helicopter
  EXPECT_EQ(recording.bees[3].velocities.at(0), (Velocity{0, 0, 0}));  // parked, perhaps
  EXPECT_TRUE(has_note(recording, "2 records say that an aircraft stands still high in the air"));
}

TEST(StandingAircraft, OfTablesTheSame) {
  const auto recording =
      recording_of(record("timestamp,icao24,callsign,latitude,longitude,altitude,groundspeed,track,"
                          "vertical_rate\n2024-07-01T12:00:00Z,3c6444,DLH4AB,50,8,35000,0,90,0\n"
                          "2024-07-01T12:00:05Z,3c6444,DLH4AB,50,8.01,35000,450,90,0\n"));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_TRUE(std::isnan(recording.bees[0].velocities.at(0).x));
  EXPECT_GT(recording.bees[0].velocities.at(1).x, 200.0);
  EXPECT_TRUE(has_note(recording, "1 record says that an aircraft stands still high in the air"));
  // What is logged of drones may hover.
  const auto drone = recording_of(
      record("time_s,id,lat,lon,altitude_m,ground_speed_mps,track\n0,a,47,8,1500,0,90\n"));
  EXPECT_EQ(drone.bees.at(0).velocities.at(0).x, 0.0);
}

TEST(StandingAircraft, StateVectorsTellCategoriesToo) {
  const auto states = [](const std::string& category) {
    return recording_of(
        record(R"({"time": 1714564805, "states": [["4b1814","SWR12AB ","X",1714564800,1714564801,)"
               R"(8.5,47.25,9000,false,0,180,0,null,9144,"1000",false,0)" +
               category + "]]}"));
  };
  EXPECT_TRUE(std::isnan(states("").bees.at(0).velocities.at(0).x));
  EXPECT_TRUE(std::isnan(states(",4").bees.at(0).velocities.at(0).x));
  EXPECT_EQ(states(",8").bees.at(0).velocities.at(0).x, 0.0);
}

TEST(RelayedIds, MayBeOfAnAircraftThatIsThereUnderItsOwn) {
  const auto both = by_pressure(aircraft("~406a3c", R"("alt_baro": 1200)") + "," +
                                aircraft("406a3c", R"("alt_baro": 1200)"));
  EXPECT_TRUE(has_note(both,
                       "1 id begins with ~, as readsb marks what the ground tells (TIS-B, "
                       "ADS-R): '~406a3c' and '406a3c' may be the same aircraft"));
  const auto alone = by_pressure(aircraft("~406a3c", R"("alt_baro": 1200)"));
  EXPECT_TRUE(has_note(alone, "'~406a3c' may be the same aircraft as one that is here under its"));
  EXPECT_FALSE(has_note(by_pressure(aircraft("406a3c", R"("alt_baro": 1200)")), "with ~"));
}

TEST(FlightLevels, MayBeWrittenOut) {
  const std::string header =
      "timestamp,icao24,callsign,latitude,longitude,altitude,groundspeed,track,vertical_rate\n";
  const auto recording =
      recording_of(record(header + "2024-07-01T12:00:00Z,3c6444,DLH4AB,50,8,FL350,450,90,0\n"
                                   "2024-07-01T12:00:05Z,3c6444,DLH4AB,50,8.01,fl 351,450,90,0\n"));
  EXPECT_EQ(recording.bees.at(0).stated_heights, (std::vector<double>{35000, 35100}));
  EXPECT_EQ(recording.bees[0].fixes.at(0).position.z, 10668.0);
  expect_error(record(header + "2024-07-01T12:00:00Z,3c6444,DLH4AB,50,8,FLxx,450,90,0\n"),
               {ErrorCode::kNotANumber, "bees.csv:2:6", "'FLxx' is not a number (height)"});
}

TEST(VelocitiesOfTables, MayBeNull) {
  const auto recording = recording_of(
      record("time,icao24,lat,lon,velocity,heading,vertrate,baroaltitude\n"
             "1719835200,3c6444,50,8,NULL,90,0,10668\n1719835205,3c6444,50,8.01,200,90,0,10668\n"));
  EXPECT_TRUE(std::isnan(recording.bees.at(0).velocities.at(0).x));
  EXPECT_NEAR(recording.bees[0].velocities.at(1).x, 200.0, 1e-9);
}

TEST(RulersOfConsoles, ArePassedOver) {
  const std::string ruler = "+--------+----------+------+-----+--------+\n";
  const auto recording = recording_of(record(
      ruler + "| time_s | id       | x    | y   | z      |\n" + ruler +
      "| 0      | a        | 1.5  | 2   | 3      |\n| 1      | a        | 1.5  | 2   | 3      |\n" +
      ruler));
  ASSERT_EQ(ids_of(recording), std::vector<std::string>{"a"});
  EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
  EXPECT_TRUE(recording.missing.none());
}

TEST(TarArchives, AreNamedWithWhatToType) {
  std::string tar(512, '\0');
  tar.replace(0, 10, "states.csv");
  tar.replace(257, 5, "ustar");
  expect_error(record(tar + "time,id\n"),
               {ErrorCode::kUnsupportedFormat, "bees.csv", "tar xf FILE -C unpacked"});
}

}  // namespace
}  // namespace beespace::io
