#include "io/json/geojson_geometry.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace beespace::io {
namespace {

constexpr double kHalfTurn_deg = 180.0;
constexpr double kTurn_deg = 360.0;

// RFC 7946 has longitudes from -180 to 180. The remainder is exact; + 0.0 turns -0 into 0.
double within_half_turn(double longitude_deg) {
  if (std::abs(longitude_deg) <= kHalfTurn_deg) return longitude_deg;
  return std::remainder(longitude_deg, kTurn_deg) + 0.0;
}

// As GeoJSON has it.
using Position = std::array<double, 3>;

Position position_of(const GeographicPosition& place) {
  return {place.longitude_deg, place.latitude_deg, place.height_m};
}

void write_geometry(JsonWriter& json, const char* type, const auto& coordinates) {
  json.begin_object().member("type", type).member("coordinates", coordinates).end();
}

GeographicPosition within_half_turn(GeographicPosition position) {
  position.longitude_deg = within_half_turn(position.longitude_deg);
  return position;
}

// Where the way from one to the other, both beside it, meets the meridian of 180 degrees.
GeographicPosition crossing(const GeographicPosition& from, const GeographicPosition& to) {
  const double from_edge = kHalfTurn_deg - std::abs(from.longitude_deg);
  const double to_edge = kHalfTurn_deg - std::abs(to.longitude_deg);
  const double part = from_edge / (from_edge + to_edge);
  return {kHalfTurn_deg, from.latitude_deg + part * (to.latitude_deg - from.latitude_deg),
          from.height_m + part * (to.height_m - from.height_m)};
}

// Longitudes from -180 to 180.
struct Line {
  GeographicPosition from;
  GeographicPosition to;
};

// The same place, on the meridian of 180 degrees as one comes there from `side_deg`.
GeographicPosition at_half_turn(GeographicPosition place, double side_deg) {
  place.longitude_deg = std::copysign(kHalfTurn_deg, side_deg);
  return place;
}

// What the line is on either side of that meridian. A side that it only touches is left out, as
// that would be a part without length.
std::vector<Line> cut_at_half_turn(const Line& line) {
  const double begin_deg = line.from.longitude_deg;
  const double end_deg = line.to.longitude_deg;
  if (std::abs(begin_deg - end_deg) <= kHalfTurn_deg) return {line};
  if (std::abs(begin_deg) == kHalfTurn_deg) return {{at_half_turn(line.from, end_deg), line.to}};
  if (std::abs(end_deg) == kHalfTurn_deg) return {{line.from, at_half_turn(line.to, begin_deg)}};
  const GeographicPosition edge = crossing(line.from, line.to);
  return {{line.from, at_half_turn(edge, begin_deg)}, {at_half_turn(edge, end_deg), line.to}};
}

}  // namespace

void write_geojson_point(JsonWriter& json, const GeographicPosition& position) {
  write_geometry(json, "Point", position_of(within_half_turn(position)));
}

void write_geojson_line(JsonWriter& json, const GeographicPosition& from,
                        const GeographicPosition& to) {
  std::vector<std::array<Position, 2>> parts;
  for (const Line& part : cut_at_half_turn({within_half_turn(from), within_half_turn(to)})) {
    parts.push_back({position_of(part.from), position_of(part.to)});
  }
  if (parts.size() == 1) return write_geometry(json, "LineString", parts.front());
  write_geometry(json, "MultiLineString", parts);
}

}  // namespace beespace::io
