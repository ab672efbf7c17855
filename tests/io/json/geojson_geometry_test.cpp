#include "io/json/geojson_geometry.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace beespace::io {
namespace {

std::string line(const GeographicPosition& from, const GeographicPosition& to) {
  std::string out;
  JsonWriter json(out);
  write_geojson_line(json, from, to);
  return out;
}

std::string polygon(const std::vector<GeographicPosition>& outline) {
  std::string out;
  JsonWriter json(out);
  write_geojson_polygon(json, outline);
  return out;
}

TEST(GeographicText, ALineJoinsTheTwoPositions) {
  EXPECT_EQ(line({-75.5, 6.25, 1500.0}, {-75.25, 6.5, 1600.0}),
            R"({"type": "LineString", "coordinates": [[-75.5, 6.25, 1500], [-75.25, 6.5, 1600]]})");
}

TEST(GeographicText, ALineOverTheAntimeridianIsCutThere) {
  EXPECT_EQ(line({179.0, 10.0, 0.0}, {-177.0, 14.0, 400.0}),
            R"({"type": "MultiLineString", "coordinates": )"
            R"([[[179, 10, 0], [180, 11, 100]], [[-180, 11, 100], [-177, 14, 400]]]})");
  EXPECT_EQ(line({-177.0, 14.0, 400.0}, {539.0, 10.0, 0.0}),
            R"({"type": "MultiLineString", "coordinates": )"
            R"([[[-177, 14, 400], [-180, 11, 100]], [[180, 11, 100], [179, 10, 0]]]})");
}

TEST(GeographicText, ALineThatOnlyTouchesTheAntimeridianIsNotCut) {
  EXPECT_EQ(line({180.0, 10.0, 100.0}, {-179.0, 11.0, 200.0}),
            R"({"type": "LineString", "coordinates": [[-180, 10, 100], [-179, 11, 200]]})");
  EXPECT_EQ(line({-180.0, 10.0, 100.0}, {179.0, 11.0, 200.0}),
            R"({"type": "LineString", "coordinates": [[180, 10, 100], [179, 11, 200]]})");
  EXPECT_EQ(line({-179.0, 11.0, 200.0}, {180.0, 10.0, 100.0}),
            R"({"type": "LineString", "coordinates": [[-179, 11, 200], [-180, 10, 100]]})");
  EXPECT_EQ(line({180.0, 10.0, 100.0}, {-180.0, 11.0, 200.0}),
            R"({"type": "LineString", "coordinates": [[-180, 10, 100], [-180, 11, 200]]})");
}

TEST(GeographicText, APathIsOneLineOrOneOnEachSideOfTheAntimeridian) {
  const auto path = [](const std::vector<GeographicPosition>& places) {
    std::string out;
    JsonWriter json(out);
    write_geojson_path(json, places);
    return out;
  };
  EXPECT_EQ(
      path({{1, 1, 0}, {2, 1, 0}, {2, 1, 0}, {3, 2, 5}}),
      R"({"type": "LineString", "coordinates": [[1, 1, 0], [2, 1, 0], [2, 1, 0], [3, 2, 5]]})");
  EXPECT_EQ(
      path({{178, 1, 0}, {179, 1, 0}, {-179, 3, 0}, {-178, 3, 0}}),
      R"({"type": "MultiLineString", "coordinates": )"
      R"([[[178, 1, 0], [179, 1, 0], [180, 2, 0]], [[-180, 2, 0], [-179, 3, 0], [-178, 3, 0]]]})");
  EXPECT_EQ(path({{179, 1, 0}, {180, 1, 0}, {-179, 1, 0}}),
            R"({"type": "MultiLineString", "coordinates": )"
            R"([[[179, 1, 0], [180, 1, 0]], [[-180, 1, 0], [-179, 1, 0]]]})");
}

TEST(GeographicText, LongitudesBeyondHalfATurnAreTheSamePlaces) {
  EXPECT_EQ(line({200.0, 5.0, 0.0}, {-161.0, 5.0, 0.0}),
            R"({"type": "LineString", "coordinates": [[-160, 5, 0], [-161, 5, 0]]})");
}

TEST(GeographicText, APolygonIsClosedAndCounterclockwise) {
  const char* const square =
      R"({"type": "Polygon", "coordinates": [[[1, 1, 5], [3, 1, 5], [3, 2, 5], [1, 2, 5], [1, 1, 5]]]})";
  EXPECT_EQ(polygon({{1, 1, 5}, {3, 1, 5}, {3, 2, 5}, {1, 2, 5}}), square);
  EXPECT_EQ(polygon({{1, 2, 5}, {3, 2, 5}, {3, 1, 5}, {1, 1, 5}}), square);
}

TEST(GeographicText, APolygonOverTheAntimeridianIsCutThere) {
  const char* const cut =
      R"({"type": "MultiPolygon", "coordinates": )"
      R"([[[[179, 1, 0], [180, 1, 0], [180, 3, 0], [179, 3, 0], [179, 1, 0]]], )"
      R"([[[-180, 1, 0], [-179, 1, 0], [-179, 3, 0], [-180, 3, 0], [-180, 1, 0]]]]})";
  EXPECT_EQ(polygon({{179, 1, 0}, {-179, 1, 0}, {-179, 3, 0}, {179, 3, 0}}), cut);
  EXPECT_EQ(polygon({{179, 3, 0}, {-179, 3, 0}, {-179, 1, 0}, {179, 1, 0}}), cut);
  EXPECT_EQ(polygon({{179, 1, 0}, {180, 1, 0}, {-180, 3, 0}, {179, 3, 0}}),
            R"({"type": "Polygon", "coordinates": )"
            R"([[[179, 1, 0], [180, 1, 0], [180, 3, 0], [179, 3, 0], [179, 1, 0]]]})");
}

}  // namespace
}  // namespace beespace::io
