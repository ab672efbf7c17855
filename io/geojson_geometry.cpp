#include "io/geojson_geometry.hpp"

#include "io/json_object.hpp"

#include <cmath>

namespace beespace::io {
namespace {

constexpr double kHalfTurn_deg = 180.0;
constexpr double kTurn_deg = 360.0;

// RFC 7946 has longitudes from -180 to 180. The remainder is exact; + 0.0 turns -0 into 0.
double within_half_turn(double longitude_deg) {
  if (std::abs(longitude_deg) <= kHalfTurn_deg) return longitude_deg;
  return std::remainder(longitude_deg, kTurn_deg) + 0.0;
}

void append_position(std::string& out, double longitude_deg, double latitude_deg, double height_m) {
  out += '[';
  out += json_number(longitude_deg);
  out += ", ";
  out += json_number(latitude_deg);
  out += ", ";
  out += json_number(height_m);
  out += ']';
}

void append_position(std::string& out, const GeographicPosition& position) {
  append_position(out, within_half_turn(position.longitude_deg), position.latitude_deg,
                  position.height_m);
}

// Where the way from one to the other meets the meridian of 180 degrees.
GeographicPosition crossing(const GeographicPosition& from, const GeographicPosition& to) {
  const double from_edge = kHalfTurn_deg - std::abs(within_half_turn(from.longitude_deg));
  const double to_edge = kHalfTurn_deg - std::abs(within_half_turn(to.longitude_deg));
  const double way = from_edge + to_edge;
  const double part = way > 0.0 ? from_edge / way : 0.0;
  return {kHalfTurn_deg, from.latitude_deg + part * (to.latitude_deg - from.latitude_deg),
          from.height_m + part * (to.height_m - from.height_m)};
}

}  // namespace

void append_geojson_point(std::string& out, const GeographicPosition& position) {
  out += R"({"type": "Point", "coordinates": )";
  append_position(out, position);
  out += '}';
}

void append_geojson_line(std::string& out, const GeographicPosition& from,
                         const GeographicPosition& to) {
  const double begin_deg = within_half_turn(from.longitude_deg);
  const double end_deg = within_half_turn(to.longitude_deg);
  if (std::abs(begin_deg - end_deg) <= kHalfTurn_deg) {
    out += R"({"type": "LineString", "coordinates": [)";
    append_position(out, from);
    out += ", ";
    append_position(out, to);
    out += "]}";
    return;
  }
  const GeographicPosition edge = crossing(from, to);
  const double side_deg = std::copysign(kHalfTurn_deg, begin_deg);
  out += R"({"type": "MultiLineString", "coordinates": [[)";
  append_position(out, from);
  out += ", ";
  append_position(out, side_deg, edge.latitude_deg, edge.height_m);
  out += "], [";
  append_position(out, -side_deg, edge.latitude_deg, edge.height_m);
  out += ", ";
  append_position(out, to);
  out += "]]}";
}

}  // namespace beespace::io
