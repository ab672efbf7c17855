// Addresses of aircraft in capitals and in small letters are one aircraft; other ids are told apart
// by their letters.
#include "io/recording/address_names.hpp"

#include "tests/io/tracks/recording_loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

using Names = std::vector<std::string>;

std::string table_of_aircraft(const std::string& id_column, const Names& ids) {
  std::string text = "time_s," + id_column + ",lat,lon,alt_ft\n";
  int second = 0;
  for (const std::string& id : ids) {
    text += std::to_string(second) + "," + id + ",47,8.00" + std::to_string(second) + ",30000\n";
    ++second;
  }
  return text;
}

TEST(AddressNames, CapitalsAndSmallLettersAreOneAircraft) {
  for (const std::string column : {"icao24", "ICAO", "hex"}) {
    const auto recording =
        recording_of(record(table_of_aircraft(column, {"3C6444", "3c6444", "4b1814"})));
    EXPECT_EQ(ids_of(recording), (Names{"3C6444", "4b1814"})) << column;
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
    EXPECT_TRUE(has_note(recording,
                         "1 address of an aircraft is written in capitals and in small "
                         "letters, as '3c6444': one aircraft each"));
  }
}

TEST(AddressNames, OtherIdsAreToldApartByTheirLetters) {
  EXPECT_EQ(ids_of(recording_of(record(table_of_aircraft("callsign", {"ABCDEF", "abcdef"})))),
            (Names{"ABCDEF", "abcdef"}));
  EXPECT_EQ(ids_of(recording_of(record("time_s,bird,x_m,y_m\n0,ABCDEF,1,2\n0,abcdef,1,3\n"))),
            (Names{"ABCDEF", "abcdef"}));
  EXPECT_EQ(ids_of(recording_of(record(table_of_aircraft("icao24", {"Plane", "plane"})))),
            (Names{"Plane", "plane"}));
}

// Formats of aircraft write small letters, tables beside them perhaps capitals.
TEST(AddressNames, HoldOverSeveralInputs) {
  const TemporaryFolder folder;
  const std::string messages =
      folder.write("a.sbs",
                   "MSG,3,1,1,3C6444,1,2024/05/01,12:00:00.250,2024/05/01,12:00:00.250,,"
                   "35000,,,46.5,7.5,,,0,0,0,0\n");
  const std::string table = folder.write(
      "b.csv",
      "timestamp,icao24,lat,lon,baro_altitude_ft\n2024-05-01T12:00:01Z,3C6444,46.5,7.501,35000\n");
  for (const auto& order : {Names{messages, table}, Names{table, messages}}) {
    const auto recording = recording_of(load_recording(order));
    ASSERT_EQ(recording.bees.size(), 1u);
    EXPECT_EQ(recording.bees[0].fixes.size(), 2u);
  }
}

TEST(AddressNames, ANameIsTheFirstSpelling) {
  AddressNames names;
  EXPECT_EQ(names.name_of("3C6444"), "3C6444");
  EXPECT_EQ(names.name_of("3c6444"), "3C6444");
  EXPECT_EQ(names.name_of("~3c6444"), "~3c6444");
  EXPECT_EQ(names.name_of("123456"), "123456");
  EXPECT_EQ(names.name_of("3c644"), "3c644");
  EXPECT_EQ(names.name_of("3C644"), "3C644");
  EXPECT_EQ(names.spelt_twice(), 1u);
}

const std::string kOfPx4 =
    "timestamp,timestamp_sample,lat,lon,alt,alt_ellipsoid,eph\n1000000,0,47,8,500,548,1\n";

// PX4's drones tell both; a place in degrees is above the ellipsoid.
TEST(KnownTables, Ulog2csvHasTwoHeights) {
  const auto recording = recording_of(record(kOfPx4));
  ASSERT_EQ(recording.bees.size(), 1u);
  EXPECT_EQ(recording.bees[0].fixes[0].position.z, 548.0);
  EXPECT_EQ(recording.heights, HeightDatum::kEllipsoid);
  EXPECT_EQ(times_of(recording.bees[0]), std::vector<double>{1.0});
}

// Each drone counts from when it was switched on.
TEST(KnownTables, Ulog2csvOfTwoDronesHasTwoClocks) {
  const TemporaryFolder folder;
  const std::vector<std::string> both = {folder.write("north.csv", kOfPx4),
                                         folder.write("south.csv", kOfPx4)};
  expect_error(load_recording(both, {}), {ErrorCode::kInvalidArgument, both[1],
                                          "may be counted from a zero of each vehicle's own"});
  RecordingOptions together;
  together.time_unit = Unit::kMicrosecond;  // which is no word of the clock
  expect_error(load_recording(both, together),
               {ErrorCode::kInvalidArgument, both[1], "say so with --one-clock"});
  together.one_clock = true;
  EXPECT_EQ(recording_of(load_recording(both, together)).bees.size(), 2u);
}

// What trackpy measures beside the place is no third coordinate.
TEST(KnownTables, TrackpyIsFlat) {
  RecordingOptions options;
  options.frames_per_second = 25.0;
  options.pixel = StatedLength{1e-6, 1.0, Unit::kMicrometre};
  const auto recording =
      recording_of(record("y,x,mass,size,ecc,signal,raw_mass,ep,frame,particle\n"
                          "20,10,1000,3,0.1,30,3000,0.05,0,7\n20,11,1000,3,0.1,30,3000,0.05,1,7\n",
                          options));
  EXPECT_EQ(ids_of(recording), Names{"7"});
  EXPECT_TRUE(recording.flat);
}

// OpenSky's tables are in metres; some are not OpenSky's.
TEST(DoubtfulHeights, UnderTheNamesOfOpenSkyAreAskedFor) {
  const std::string header =
      "time,icao24,lat,lon,velocity,heading,vertrate,callsign,onground,baroaltitude,geoaltitude\n";
  const std::string high = header + "1700000000,3c6444,47,8,230,90,0,DLH1,false,37000,38000\n";
  expect_error(record(high),
               {ErrorCode::kInvalidArgument, "bees.csv",
                "heights go up to 38000 m (the header is that of OpenSky, which has 'geoaltitude' "
                "in it): are they in feet? Say it with --units height=ft, or height=m if"});
  RecordingOptions options;
  options.units.height = Unit::kFoot;
  const auto feet = recording_of(record(high, options));
  ASSERT_EQ(feet.bees.size(), 1u);
  EXPECT_DOUBLE_EQ(feet.bees[0].fixes[0].position.z, 38000 * 0.3048);
  options.units.height = Unit::kMetre;
  EXPECT_EQ(recording_of(record(high, options)).bees[0].fixes[0].position.z, 38000.0);
  EXPECT_TRUE(record(header + "1700000000,3c6444,47,8,230,90,0,DLH1,false,11277,11582\n"));
}

}  // namespace
}  // namespace beespace::io
