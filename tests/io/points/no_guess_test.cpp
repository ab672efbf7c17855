// Where a reader might guess wrongly, it must refuse; input that is clear must be accepted.
#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

void expect_refused(std::string_view text, ErrorCode code, std::string_view message) {
  SCOPED_TRACE(text);
  const auto loaded = load_text(text);
  ASSERT_FALSE(loaded.has_value());
  EXPECT_EQ(to_string(loaded.error().code), to_string(code)) << to_string(loaded.error());
  EXPECT_NE(loaded.error().message.find(message), std::string::npos) << loaded.error().message;
}

void expect_frame(std::string_view text, Frame frame) {
  const auto loaded = load_text(text);
  ASSERT_TRUE(loaded.has_value()) << text << to_string(loaded.error());
  EXPECT_EQ(loaded.value().frame, frame) << text;
}

// Coordinates as loaded with --columns under an explicit order.
std::vector<Point> in_order(const std::string& text, const std::string& columns) {
  return points_of(load_text(text, with_columns(columns)));
}

TEST(NoGuess, LatitudeFirstIsReadAsSuchInManyNames) {
  const std::string rows = "50,7,100\n50,7.001,100\n50.001,7.01,300\n";
  const auto expected = in_order("a,b,c\n" + rows, "lat=1,lon=2,height=3");
  for (const char* header :
       {"Latitude N,Longitude E,Altitude m", "uav_lat,uav_lon,uav_alt",
        "Breitengrad,Längengrad,Höhe", "BREITENGRAD,LÄNGENGRAD,HÖHE", "широта,долгота,высота",
        "ШИРОТА,ДОЛГОТА,ВЫСОТА", "lat,lon,élévation", "Enlem,Boylam,h",
        "bee coordinate latitude,bee coordinate longitude,bee coordinate height"}) {
    EXPECT_EQ(points_of(load_text(std::string(header) + "\n" + rows)), expected) << header;
  }
}

TEST(NoGuess, NamesThatMayBeLatitudesAreRefusedNotTakenInOrder) {
  const std::string rows = "\n50,7,100\n50,7.001,100\n50.001,7.01,300\n";
  for (const char* header : {"Breite1,Laenge1,H1", "lat_std,lon_std,alt_std", "gpslat,gpslon,h",
                             "home_lat,home_lon,home_alt", "Latitude S,Longitude W,Altitude",
                             "uav_lat,drone2_lon,alt", "e,n,u"}) {
    expect_refused(header + rows, ErrorCode::kMissingColumn, "--columns lon=");
  }
}

TEST(NoGuess, ValuesShowDegreesButNotTheOrder) {
  std::string rows;
  for (int i = 0; i < 50; ++i) {
    rows += "50.00" + std::to_string(i) + ",7.00" + std::to_string(i) + "," +
            std::to_string(100 + 10 * i) + "\n";
  }
  expect_refused(rows, ErrorCode::kUnknownFrame, "lat=1,lon=2,height=3");
  expect_refused("a,b,c\n" + rows, ErrorCode::kUnknownFrame, "lat=1,lon=2,height=3");
  // Few points beyond 90 are no swarm to judge by.
  expect_refused("139.5,35.5,100\n139.6,35.5,300\n", ErrorCode::kUnknownFrame, "--columns");
}

TEST(NoGuess, LatitudeFirstBeyondNinetyIsNotMetres) {
  expect_refused("35.6,139.7,10\n35.6001,139.7001,40\n", ErrorCode::kUnknownFrame,
                 "columns 2 and 1");
  expect_refused("35.6,139.7\n35.6001,139.7001\n", ErrorCode::kUnknownFrame, "columns 2 and 1");
}

TEST(NoGuess, AxesWhosePillarWouldFitDegreesAreRefused) {
  const std::string rows = "\n7,50,10\n7.001,50,10.5\n7.001,50.001,2\n";
  for (const char* header : {"pos_x,pos_y,pos_z", "agent_x,agent_y,agent_z", "x,y,z", "X;Y;Z",
                             "x coordinate,y coordinate,z coordinate", "east,north,up"}) {
    std::string text = header + rows;
    if (text.find(';') != std::string::npos) {
      for (char& c : text) c = c == ',' ? ';' : c;
    }
    expect_refused(text, ErrorCode::kUnknownFrame, "--crs metres");
  }
  // A unit, or the kind of frame, leaves no doubt.
  for (const char* header : {"x [m],y [m],z [m]", "x_m,y_m,z_m", "enu_x,enu_y,enu_z"}) {
    expect_frame(header + rows, Frame::kMetres);
  }
}

TEST(NoGuess, WhatIsClearlyMetresStaysMetres) {
  for (const char* header : {"x,y,z", "pos_x,pos_y,pos_z", "x [m],y [m],z [m]", "east,north,up"}) {
    expect_frame(std::string(header) + "\n1.5,2.5,3.5\n-4,5,6\n", Frame::kMetres);
  }
  expect_frame("agent_x,agent_y,agent_z\n1,2,3\n900,5,6\n", Frame::kMetres);
  expect_frame("0.5,2,3\n900,-500,6\n", Frame::kMetres);
}

TEST(NoGuess, TheCourseFormatStaysDegreesInAnyLanguageAndWithOneRow) {
  for (const char* header :
       {"Coordenada x de la abeja, coordenada y de la abeja, coordenada z de la abeja",
        "x coordinate of the bee,y coordinate of the bee,z coordinate of the bee",
        "X-Koordinate der Biene,Y-Koordinate der Biene,Z-Koordinate der Biene",
        "COORDONNÉE X DE L'ABEILLE,COORDONNÉE Y DE L'ABEILLE,COORDONNÉE Z DE L'ABEILLE",
        "bee coordinate x,bee coordinate y,bee coordinate z (m)"}) {
    expect_frame(std::string(header) + "\n-75.5,6.3,1500\n", Frame::kWgs84);
    expect_refused(std::string(header) + "\n-75.5,6.3,1500\n-75.5,630,1500\n",
                   ErrorCode::kInvalidLatitude, "'630'");
  }
}

TEST(NoGuess, UnitsAndFramesWeighMoreThanBees) {
  const std::string rows = "\n0,0,100\n50,50,100\n51,50,100\n";
  for (const char* word : {"(m)", "(metros)", "ENU", "local"}) {
    std::string header;
    for (const char* axis : {"x", "y", "z"}) {
      header += (header.empty() ? "" : ",") + std::string("bee coordinates ") + axis + " " + word;
    }
    expect_frame(header + rows, Frame::kMetres);
  }
  expect_refused("bee coordinate x (rad),bee coordinate y (rad)\n0,0\n",
                 ErrorCode::kUnsupportedFormat, "'rad'");
  expect_frame("bee coordinate x (ft),bee coordinate y (ft)\n0,0\n", Frame::kMetres);
  // A word that is not known leaves open what the axes are.
  expect_refused("bee coordinate x quux,bee coordinate y quux\n0,0\n", ErrorCode::kMissingColumn,
                 "--columns lon=1,lat=2");
}

TEST(NoGuess, OneBigColumnDoesNotMakeMetres) {
  expect_refused("0,-75.5,6.3\n500,-75.5,6.3\n", ErrorCode::kUnknownFrame, "columns 2 and 3");
  expect_refused("1500,-75.5,6.3\n1540,-75.5001,6.3001\n", ErrorCode::kUnknownFrame, "--columns");
  expect_refused("-755000000,63000000,1500\n-755000100,63000100,1520\n", ErrorCode::kUnknownFrame,
                 "10,000,000");
  std::string counted;
  for (int i = 0; i < 500; ++i) {
    counted += std::to_string(i) + "," + std::to_string(i % 7) + "," + std::to_string(i % 5) + "\n";
  }
  expect_refused(counted, ErrorCode::kUnknownFrame, "counts the records");
}

TEST(NoGuess, AHeightThatBeginsBlankIsNotDropped) {
  for (const char* first : {"", "N/A", "null"}) {
    const std::string row = "\n6,-75," + std::string(first) + "\n6,-75,100\n6,-75,300\n";
    expect_refused("lat,lon,Rel Alt" + row, ErrorCode::kMissingColumn,
                   "'Rel Alt' counts from where each one took off");
  }
  expect_refused("lat,lon,foo\n6,-75,\n6,-75,\n", ErrorCode::kMissingColumn, "may or may not");
  expect_frame("lat,lon,remark\n6,-75,\n6,-75,good\n", Frame::kWgs84);
}

TEST(NoGuess, ZOfXAndYIsNoHeightOfLongitudeAndLatitude) {
  LoadOptions options;
  options.frame = Frame::kWgs84;
  expect_error(load_text("lon,lat,x,y,z\n1,2,3,4,5\n", options),
               {ErrorCode::kMissingColumn, "bees.csv:1", "'z' may or may not be the height"});
  options.frame = Frame::kMetres;
  expect_error(load_text("lon,lat,height,x,y\n1,2,3,4,5\n", options),
               {ErrorCode::kMissingColumn, "bees.csv:1", "'height' may or may not be the z"});
}

TEST(NoGuess, XAndYWithDegreesAreRefused) {
  expect_refused("X,Y\n7.0312,50.0123\n7.0313,50.0124\n", ErrorCode::kUnknownFrame, "--crs wgs84");
  expect_refused("X,Y,Z\n7.0312,50.0123,0\n7.0313,50.0124,0\n", ErrorCode::kUnknownFrame,
                 "--crs wgs84");
  expect_frame("X,Y\n7,50\n8,51\n", Frame::kMetres);
  expect_frame("x [m],y [m]\n7.5,50.5\n7.6,50.4\n", Frame::kMetres);
}

TEST(NoGuess, HeightsAboveEachTakeOffAreNotComparedThoughTheyAreNamed) {
  const std::string table = "id,lat,lon,relative_alt_m\n1,47,8,10\n2,47.1,8,30\n";
  LoadOptions named = with_columns("lon=3,lat=2,height=4");
  const auto loaded = load_text(table, named);
  ASSERT_FALSE(loaded.has_value());
  EXPECT_NE(loaded.error().message.find("those of several cannot be compared"), std::string::npos);
  named.frame = Frame::kWgs84;
  EXPECT_TRUE(load_text(table, named).has_value());
}

}  // namespace
}  // namespace beespace::io
