// Degrees without a sign, and columns that say on which side of the equator and of Greenwich.
#include "io/tracks/sides.hpp"

#include "tests/io/tracks/recording_loading.hpp"

#include <string>
#include <vector>

namespace beespace::io {
namespace {

const std::string kWithSides = "id,time_s,LATITUDE,N/S,LONGITUDE,E/W\n";

TEST(Sides, AreRead) {
  for (const char* const header :
       {"id,time_s,LATITUDE,N/S,LONGITUDE,E/W\n", "id,time_s,lat,lat_dir,lon,lon_dir\n",
        "id,time_s,lat,NS,lon,EW\n"}) {
    const Recording read = recording_of(record(
        std::string(header) + "a,0,51.5,N,0.01,E\na,1,51.5,S,0.01,W\na,2,-51.5,s,-0.01,w\n"));
    ASSERT_EQ(read.bees.size(), 1u) << header;
    EXPECT_EQ(read.bees[0].fixes[0].position, (Point{0.01, 51.5, 0.0}));
    EXPECT_EQ(read.bees[0].fixes[1].position, (Point{-0.01, -51.5, 0.0}));
    EXPECT_EQ(read.bees[0].fixes[2].position, (Point{-0.01, -51.5, 0.0}));
    EXPECT_TRUE(has_note(read, "on which side of Greenwich places are is read from column 6"));
  }
}

// As that of a flight.
TEST(Sides, OtherDirectionsAreNone) {
  const Recording read =
      recording_of(record("id,time_s,lat,lon,direction\na,0,51,1,N\na,1,51,1,S\na,2,51,1,NE\n"));
  EXPECT_EQ(read.bees.at(0).fixes.at(1).position.y, 51.0);
}

TEST(Sides, WhatIsNoneOrContradictsTheSignIsAMistake) {
  expect_error(record(kWithSides + "a,0,51.5,N,0.01,E\na,1,51.5,N,0.01,\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:6", "'' is none of E and W"});
  expect_error(record(kWithSides + "a,0,51.5,N,0.01,E\na,1,-51.5,N,0.01,E\n"),
               {ErrorCode::kMalformedRecord, "bees.csv:3:4", "'N' contradicts the sign"});
}

TEST(Sides, PointsAreRefusedWhereItMatters) {
  const std::string header = "id,lat,N/S,lon,E/W\n";
  EXPECT_TRUE(load_text(header + "a,51.5,N,0.01,E\nb,51.6,N,0.01,E\n").has_value());
  expect_error(
      load_text(header + "a,51.5,N,0.01,E\nb,51.5,N,0.01,W\n"),
      {ErrorCode::kMalformedRecord, "bees.csv:3:5", "this place is 'W' by column 5 'E/W'"});
}

TEST(NoFix, IsNoPlaceAlsoWhereItIsCalledNotValid) {
  const Recording read = recording_of(
      record("id,time_s,VALID,lat,lon\na,0,SPS,51,1\na,1,NO FIX,51,1\na,2,DGPS,51.1,1\n"));
  EXPECT_EQ(times_of(read.bees.at(0)), (std::vector<double>{0.0, 2.0}));
  EXPECT_FALSE(read.missing.none());
}

TEST(OldPlaces, OfAircraftAreLeftOut) {
  const std::string header = "hex,time_s,lat,lon,alt_ft,seen_pos\n";
  const Recording read =
      recording_of(record(header + "a,0,48,8,35000,0.4\nb,0,48,8,35000,25\nc,0,48,8,35000,\n"));
  EXPECT_EQ(ids_of(read), (std::vector<std::string>{"a"}));
  EXPECT_EQ(read.missing.count, 2u);
  EXPECT_TRUE(has_note(read, "2 records whose place is more than 2 s old (seen_pos)"));
}

TEST(Directions, AreNoSpeedsAlongAnAxis) {
  RecordingOptions options;
  options.columns = "vx=5,vy=6,vz=7";
  options.units = *read_unit_overrides("aviation");
  expect_error(
      record("callsign,lat,lon,altitude_ft,rate,Course,sink\na,48,8,35000,450,90,0\n", options),
      {ErrorCode::kInvalidArgument, "bees.csv:1:6", "holds a direction"});
  const Recording read = recording_of(
      record("callsign,latitude,longitude,altitude_ft,ground speed (kts),Track (\u00b0),V/S (fpm)\n"
             "a,48,8,35000,450,90,60\n"));
  ASSERT_EQ(read.bees.at(0).velocities.size(), 1u);
  EXPECT_NEAR(read.bees[0].velocities[0].x, 231.5, 1e-9);
  EXPECT_NEAR(read.bees[0].velocities[0].z, 0.3048, 1e-9);
}

}  // namespace
}  // namespace beespace::io
