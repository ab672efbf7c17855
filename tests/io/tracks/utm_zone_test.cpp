#include "io/tracks/utm_zone.hpp"

#include "tests/io/tracks/recording_loading.hpp"

#include <string>

namespace beespace::io {
namespace {

const std::string kHeader = "id,time_s,utm-easting,utm-northing,utm-zone\n";

TEST(UtmZone, OneIsSaid) {
  const auto read =
      recording_of(record(kHeader + "a,0,724835,5292872,32N\nb,0,724836,5292872,32T\n"));
  EXPECT_TRUE(has_note(read, "eastings and northings are of UTM zone '32N', all of them"));
  EXPECT_EQ(read.bees.size(), 2u);
}

TEST(UtmZone, SeveralAreRefused) {
  for (const char* const header :
       {"id,time_s,utm-easting,utm-northing,utm-zone\n", "id,time_s,easting,northing,zone\n"}) {
    expect_error(
        record(std::string(header) + "a,0,724835,5292872,32N\nb,0,275164,5292872,33N\n"),
        {ErrorCode::kUnknownFrame, "bees.csv:3",
         "this easting and northing are of UTM zone '33N', but those before are of '32N'"});
  }
  expect_error(record(kHeader + "a,0,724835,5292872,32N\nb,0,275164,5292872,\n"),
               {ErrorCode::kUnknownFrame, "bees.csv:3", "of UTM zone ''"});
}

// Of the size of eastings and northings, whatever they are called.
TEST(UtmZone, EastingsMayBeCalledXAndY) {
  RecordingOptions flat;
  flat.columns = "x=3,y=4";
  expect_error(
      record("id,time_s,x,y,zone\na,0,756091.11,4432068.77,29\nb,0,243908,4432068,30\n", flat),
      {ErrorCode::kUnknownFrame, "bees.csv:3",
       "this easting and northing are of UTM zone '30', but those before are of '29'"});
}

// A zone that is a number is no third coordinate, about which nothing is asked first.
TEST(UtmZone, IsAskedAboutBeforeTheHeight) {
  for (const char* const header : {"id,time_s,easting,northing,zone", "id,time_s,x,y,zone",
                                   "id,time_s,easting,northing,utm_zone_number"}) {
    expect_error(record(std::string(header) + "\na,0,724835,5292872,32\nb,0,275164,5292872,33\n"),
                 {ErrorCode::kUnknownFrame, "bees.csv:3", "of UTM zone '33', but those before"});
    EXPECT_TRUE(recording_of(record(std::string(header) +
                                    "\na,0,724835,5292872,32\nb,0,275164,5292872,32\n"))
                    .flat);
  }
  expect_error(record("id,time_s,easting,northing,zone_number,zone_letter\n"
                      "a,0,724835,5292872,32,T\nb,0,275164,5292872,33,T\n"),
               {ErrorCode::kUnknownFrame, "bees.csv:3", "of UTM zone '33', but those before"});
}

TEST(UtmZone, OfOtherCoordinatesSaysNothing) {
  EXPECT_TRUE(
      recording_of(record("id,time_s,x_m,y_m,zone\na,0,1,1,A\nb,0,2,2,B\n")).missing.none());
  const auto degrees =
      recording_of(record("id,time_s,lon,lat,utm-zone\na,0,11.9,47,32N\nb,0,12.1,47,33N\n"));
  EXPECT_EQ(degrees.bees.size(), 2u);
}

TEST(UtmZone, BandsOfOneHemisphereAreOne) {
  EXPECT_EQ(utm_zone_of("32N"), utm_zone_of("32 u"));
  EXPECT_EQ(utm_zone_of("05Q"), utm_zone_of("5N"));
  EXPECT_EQ(utm_zone_of("32H"), utm_zone_of("32M"));
  EXPECT_NE(utm_zone_of("32N"), utm_zone_of("33N"));
  EXPECT_NE(utm_zone_of("32N"), utm_zone_of("32M"));
  EXPECT_NE(utm_zone_of("32S"), utm_zone_of("32N"));
  EXPECT_NE(utm_zone_of("32S"), utm_zone_of("32H"));
  EXPECT_NE(utm_zone_of("32"), utm_zone_of("32N"));
}

}  // namespace
}  // namespace beespace::io
