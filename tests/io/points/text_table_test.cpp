#include "tests/io/points/loading.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

namespace beespace::io {
namespace {

constexpr std::string_view kCourseHeader =
    "Coordenada x de la abeja, coordenada y de la abeja, coordenada z de la abeja\n";

TEST(TextTable, ReadsTheCourseFormatAsDegrees) {
  const auto loaded = load_text(std::string(kCourseHeader) + "180,0,0\n90,0,1000\n0,90,0\n");
  const auto points = points_of(loaded);
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(loaded.value().frame, Frame::kWgs84);
  EXPECT_EQ(loaded.value().format_description, "text, comma-separated");
  EXPECT_NE(loaded.value().frame_reason.find("bees"), std::string::npos);
  EXPECT_NEAR(points[0].x, -6'378'137.0, 1e-6);
  EXPECT_NEAR(points[1].y, 6'379'137.0, 1e-6);
  EXPECT_NEAR(points[2].z, 6'356'752.314245, 1e-6);
}

TEST(TextTable, CourseHeaderIsKnownInOtherLanguagesAndWithTwoColumns) {
  for (const char* header : {"Coordinate x of the bee;coordinate y of the bee",
                             "Koordinate x der Biene;Koordinate y der Biene",
                             "coordonn\xc3\xa9"
                             "e x de l'abeille;coordonn\xc3\xa9"
                             "e y de l'abeille",
                             "coordinata x dell'ape;coordinata y dell'ape"}) {
    const auto loaded = load_text(std::string(header) + "\n-75.5;6.3\n-75.6;6.4\n");
    EXPECT_EQ(points_of(loaded).size(), 2u) << header;
    if (!loaded) continue;
    EXPECT_EQ(loaded.value().frame, Frame::kWgs84) << header;
    ASSERT_EQ(loaded.value().notes.size(), 1u);
    EXPECT_EQ(loaded.value().notes[0], "no height column: every height is taken as 0 m");
  }
}

TEST(TextTable, TwoMetreColumnsLieAtHeightZeroAndThatIsReported) {
  const auto loaded = load_text("x,y\n1,2\n3,4\n");
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 0}, {3, 4, 0}}));
  ASSERT_EQ(loaded.value().notes.size(), 1u);
  EXPECT_EQ(loaded.value().notes[0], "no z column: every z is taken as 0 m");
}

TEST(TextTable, HeaderNamesGiveTheOrderOfTheColumns) {
  const auto swapped = load_text("lat,lon,alt\n6.3,-75.5,1500\n6.4,-75.6,1600\n");
  const auto straight = load_text("lon,lat,alt\n-75.5,6.3,1500\n-75.6,6.4,1600\n");
  EXPECT_EQ(points_of(swapped), points_of(straight));
  ASSERT_EQ(swapped.value().notes.size(), 1u);
  EXPECT_EQ(swapped.value().notes[0],
            "longitude, latitude, height are read from columns 2 'lon', 1 'lat', 3 'alt'");
}

TEST(TextTable, KnowsManyNamesForTheSameColumn) {
  const auto expected = points_of(load_text("lon,lat,height\n-75.5,6.3,1500\n"));
  for (const char* header : {"Longitude,Latitude,Altitude", "LONGITUD,LATITUD,ALTURA",
                             "lng,lat,elevation", "gps_longitude,gps_latitude,alt_m",
                             "lon (deg),lat (deg),h [m]", "\"longitude\",\"latitude\",\"height\"",
                             "x [deg],y [deg],z [m]", "L\xc3\xa4nge,Breite,H\xc3\xb6he",
                             "# lon,lat,alt", "longitude_deg,latitude_deg,height_m"}) {
    const auto loaded = load_text(std::string(header) + "\n-75.5,6.3,1500\n");
    EXPECT_EQ(points_of(loaded), expected) << header;
  }
}

TEST(TextTable, KnowsMetreHeaders) {
  for (const char* header : {"x,y,z", "X,Y,Z", "x [m],y [m],z [m]", "x_m,y_m,z_m", "east,north,up",
                             "ecef_x,ecef_y,ecef_z", "Easting,Northing,Height"}) {
    const auto loaded = load_text(std::string(header) + "\n1,2,3\n4,5,6\n");
    EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}})) << header;
    if (loaded) {
      EXPECT_EQ(loaded.value().frame, Frame::kMetres) << header;
    }
  }
}

TEST(TextTable, OtherColumnsAreLeftAloneAndTheIdIsFound) {
  const auto loaded =
      load_text("name,speed,y,x,z,remark\n\"bee \"\"1\"\"\",9,2,1,3,none\nb2,8,5,4,6,\"a, b\"\n");
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  ASSERT_TRUE(loaded.has_value());
  EXPECT_TRUE(has_id_column(loaded.value()));
  std::vector<std::string> ids;
  for_each_record(loaded.value(), {0, 1},
                  [&ids](const Record& record) { ids.emplace_back(record.id); });
  EXPECT_EQ(ids, (std::vector<std::string>{"bee \"1\"", "b2"}));
}

TEST(TextTable, ColumnsCanBeChosenByNumberAndByName) {
  const std::string text = "a,b,c,d\n9,1,2,3\n9,4,5,6\n";
  const std::vector<Point> expected = {{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(points_of(load_text(text, with_columns("x=2,y=3,z=4"))), expected);
  EXPECT_EQ(points_of(load_text(text, with_columns("x=b, y=c, z=d"))), expected);
  EXPECT_EQ(points_of(load_text(text, with_columns("z=D,y=C,x=2,id=a"))), expected);
  const auto flat = load_text(text, with_columns("x=2,y=3"));
  EXPECT_EQ(points_of(flat), (std::vector<Point>{{1, 2, 0}, {4, 5, 0}}));
  const auto geographic = load_text(text, with_columns("lon=2,lat=3,height=4"));
  ASSERT_TRUE(geographic.has_value());
  EXPECT_EQ(geographic.value().frame, Frame::kWgs84);
  EXPECT_EQ(geographic.value().frame_reason, "--columns names longitude, latitude and height");
}

TEST(TextTable, AnIdColumnMayBeNamedAloneAndTheRestTakenInOrder) {
  auto options = with_columns("id=1");
  options.frame = Frame::kMetres;
  const auto loaded = load_text("b7,1,2,3\nb8,4,5,6\n", options);
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_TRUE(has_id_column(loaded.value()));
}

TEST(TextTable, LineEndsMarksAndBlankLinesDoNotMatter) {
  const std::vector<Point> expected = {{1, 2, 3}, {4, 5, 6}};
  for (const char* text :
       {"x,y,z\n1,2,3\n4,5,6\n", "x,y,z\n1,2,3\n4,5,6", "x,y,z\r\n1,2,3\r\n4,5,6\r\n",
        "x,y,z\r1,2,3\r4,5,6\r", "\xEF\xBB\xBFx,y,z\n1,2,3\n4,5,6\n",
        "\n\n x,y,z\n\n1,2,3\n  \n\t\n4,5,6\n\n",
        "\xEF\xBB\xBFx,y,z\r\n\r\n1,2,3\r\n4,5,6\r\n \r\n", "x, y, z\n 1 , 2 ,\t3 \n4,5,6\n",
        "x;y;z\n1;2;3\n4;5;6\n", "x\ty\tz\n1\t2\t3\n4\t5\t6\n", "x y z\n1 2 3\n4 5 6\n",
        "  x   y  z  \n 1\t 2   3\n4  5  6  \n",
        "\"x\",\"y\",\"z\"\n\"1\",\" 2 \",3\n4,\"5\",\"6\"\n",
        "x,y,z\n+1,2.,03\n4e0,.5e1,600e-2\n"}) {
    EXPECT_EQ(points_of(load_text(text)), expected) << text;
  }
}

TEST(TextTable, OnePointIsEnough) {
  EXPECT_EQ(points_of(load_text("1 2 3", in_metres())), (std::vector<Point>{{1, 2, 3}}));
}

TEST(TextTable, AColonOfDelimitersAtTheEndOfEveryLineIsNoColumn) {
  EXPECT_EQ(points_of(load_text("a,b,c,\n1,2,3,\n", in_metres())), (std::vector<Point>{{1, 2, 3}}));
}

// Random tables, written in every style: the same doubles as strtod gives.
TEST(TextTable, EveryStyleGivesTheDoublesOfStrtod) {
  std::mt19937_64 random(7);
  std::array<char, 64> text = {};
  for (int table = 0; table < 300; ++table) {
    const char delimiter = ",;\t "[random() % 4];
    const std::string line_end = random() % 2 == 0 ? "\n" : "\r\n";
    const bool header = random() % 2 == 0;
    std::string content = random() % 2 == 0 ? "\xEF\xBB\xBF" : "";
    std::vector<Point> expected;
    const auto number = [&](double& value) {
      const double magnitude = std::ldexp(1.0, static_cast<int>(random() % 60) - 30);
      value = (static_cast<double>(random() % 2'000'001) - 1'000'000.0) / 997.0 * magnitude;
      const char* const formats[] = {"%.3f", "%.11f", "%.17g", "%g", "%+.6e", "%.0f"};
      std::snprintf(text.data(), text.size(), formats[random() % 6], value);
      value = std::strtod(text.data(), nullptr);
      std::string field = text.data();
      if (random() % 8 == 0) field = "\"" + field + "\"";
      if (random() % 8 == 0) field = " " + field;
      if (random() % 8 == 0) field += "  ";
      return field;
    };
    if (header) content += std::string("x") + delimiter + "y" + delimiter + "z" + line_end;
    const std::size_t rows = 1 + random() % 40;
    for (std::size_t row = 0; row < rows; ++row) {
      Point point;
      content += number(point.x);
      content += delimiter;
      content += number(point.y);
      content += delimiter;
      content += number(point.z);
      if (row + 1 < rows || random() % 2 == 0) content += line_end;
      if (random() % 10 == 0 && row + 1 < rows) content += line_end;
      expected.push_back(point);
    }
    EXPECT_EQ(points_of(load_text(content, in_metres())), expected) << content;
  }
}

TEST(JoinedTables, TheHeaderThatComesAgainIsNoRecord) {
  const auto loaded = load_text("id,x_m,y_m,z_m\na,1,2,3\nid,x_m,y_m,z_m\nb,4,5,6\nc,7,8,9\n");
  EXPECT_EQ(points_of(loaded), (std::vector<Point>{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}));
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->notes.back(),
            "1 line is the header again and is passed over, as where tables were joined");
  std::vector<std::string> ids;
  for_each_record(*loaded, {1, 2}, [&ids](const Record& record) { ids.emplace_back(record.id); });
  EXPECT_EQ(ids, (std::vector<std::string>{"b", "c"}));
}

TEST(JoinedTables, OtherColumnsAreRefusedWhateverIsLeftOut) {
  const std::string text = "id,x_m,y_m,z_m\na,1,2,3\nid,y_m,x_m,z_m\nb,4,5,6\n";
  LoadOptions skipping;
  skipping.skip_bad = true;
  for (const LoadOptions& options : {LoadOptions(), skipping}) {
    expect_error(load_text(text, options), {ErrorCode::kMalformedRecord, "bees.csv:3",
                                            "another header, 'id,y_m,x_m,z_m', than "});
  }
}

TEST(ScaledDegrees, AreKnownByTheirSize) {
  const std::string header = "id,lat,lon,alt\n";
  const std::string rows = "a,473977418,85455940,488000\nb,473977518,85455940,488000\n";
  expect_error(load_text(header + rows),
               {ErrorCode::kInvalidArgument, "bees.csv:1:4", "--units height=mm or height=m"});
  LoadOptions options;
  options.units.height = Unit::kMillimetre;
  const auto loaded = load_text(header + rows, options);
  const auto degrees =
      load_text("id,lat,lon,alt_m\na,47.3977418,8.5455940,488\nb,47.3977518,8.5455940,488\n");
  EXPECT_EQ(points_of(loaded), points_of(degrees));
  ASSERT_TRUE(loaded.has_value());
  EXPECT_EQ(loaded->frame, Frame::kWgs84);
  for_each_record(*loaded, {1}, [](const Record& record) {
    EXPECT_EQ(record.geographic.latitude_deg, 47.3977518);
    EXPECT_EQ(record.geographic.longitude_deg, 8.545594);
    EXPECT_EQ(record.geographic.height_m, 488.0);
  });
  const auto flat = load_text("lat,lon\n473977418,85455940\n473977518,85455940\n");
  ASSERT_TRUE(flat.has_value());
  EXPECT_NE(flat->notes.front().find("whole numbers of 1e-7 degrees"), std::string::npos);
}

TEST(ScaledDegrees, AreAllOrNone) {
  LoadOptions options;
  options.skip_bad = true;
  std::string rows = "lat,lon\n";
  for (int i = 0; i < 20; ++i) rows += "473977418,85455940\n";
  expect_error(load_text(rows + "47.3977518,8.545594\n", options),
               {ErrorCode::kMalformedRecord, "bees.csv:22:2",
                "'8.545594' is no whole number of 1e-7 degrees, as the first are"});
  options.frame = Frame::kMetres;
  expect_error(load_text("lat,lon\n473977418,85455940\n473977518,85455940\n", options),
               {ErrorCode::kUnknownFrame, "bees.csv:1", "leave --crs metres"});
  EXPECT_EQ(points_of(load_text("x,y,z\n473977,854559,48\n473978,854559,48\n")).front().x,
            473977.0);
}

}  // namespace
}  // namespace beespace::io
