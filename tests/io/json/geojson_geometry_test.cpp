#include "io/json/geojson_geometry.hpp"

#include <gtest/gtest.h>

namespace beespace::io {
namespace {

std::string line(const GeographicPosition& from, const GeographicPosition& to) {
  std::string out;
  JsonWriter json(out);
  write_geojson_line(json, from, to);
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

TEST(GeographicText, LongitudesBeyondHalfATurnAreTheSamePlaces) {
  EXPECT_EQ(line({200.0, 5.0, 0.0}, {-161.0, 5.0, 0.0}),
            R"({"type": "LineString", "coordinates": [[-160, 5, 0], [-161, 5, 0]]})");
}

}  // namespace
}  // namespace beespace::io
