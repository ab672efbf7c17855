#include "io/json/geojson_geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
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

using Outline = std::vector<GeographicPosition>;

// From each corner the short way to the next, beyond half a turn where that leads there.
Outline unrolled(std::span<const GeographicPosition> corners) {
  Outline outline(corners.begin(), corners.end());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    double& longitude_deg = outline[i].longitude_deg;
    const double before_deg = i == 0 ? 0.0 : outline[i - 1].longitude_deg;
    const double step_deg = longitude_deg - before_deg;
    if (std::abs(step_deg) <= kHalfTurn_deg) continue;
    longitude_deg = before_deg + std::remainder(step_deg, kTurn_deg);
  }
  return outline;
}

bool is_clockwise(const Outline& outline) {
  double doubled_area = 0.0;
  const GeographicPosition& origin = outline.front();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const GeographicPosition& a = outline[i];
    const GeographicPosition& b = outline[(i + 1) % outline.size()];
    doubled_area +=
        (a.longitude_deg - origin.longitude_deg) * (b.latitude_deg - origin.latitude_deg) -
        (b.longitude_deg - origin.longitude_deg) * (a.latitude_deg - origin.latitude_deg);
  }
  return doubled_area < 0.0;
}

// What of it lies east of a meridian (side = 1), or west of it (side = -1).
Outline beside(const Outline& outline, double meridian_deg, double side) {
  Outline part;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const GeographicPosition& a = outline[i];
    const GeographicPosition& b = outline[(i + 1) % outline.size()];
    const double from_deg = side * (a.longitude_deg - meridian_deg);
    const double to_deg = side * (b.longitude_deg - meridian_deg);
    if (from_deg >= 0.0) part.push_back(a);
    if ((from_deg < 0.0 && to_deg > 0.0) || (from_deg > 0.0 && to_deg < 0.0)) {
      const double share = from_deg / (from_deg - to_deg);
      part.push_back({meridian_deg, a.latitude_deg + share * (b.latitude_deg - a.latitude_deg),
                      a.height_m + share * (b.height_m - a.height_m)});
    }
  }
  return part;
}

using Ring = std::vector<Position>;

// Closed; `turn_deg` brings its longitudes within half a turn.
Ring ring_of(const Outline& outline, double turn_deg) {
  Ring ring;
  ring.reserve(outline.size() + 1);
  for (GeographicPosition corner : outline) {
    corner.longitude_deg += turn_deg;
    ring.push_back(position_of(corner));
  }
  ring.push_back(ring.front());
  return ring;
}

}  // namespace

void write_geojson_polygon(JsonWriter& json, std::span<const GeographicPosition> outline) {
  Outline corners = unrolled(outline);
  if (is_clockwise(corners)) std::reverse(corners.begin(), corners.end());
  const auto [west, east] = std::minmax_element(
      corners.begin(), corners.end(), [](const GeographicPosition& a, const GeographicPosition& b) {
        return a.longitude_deg < b.longitude_deg;
      });
  const double least_deg = west->longitude_deg;
  const double most_deg = east->longitude_deg;
  if (least_deg >= -kHalfTurn_deg && most_deg <= kHalfTurn_deg) {
    return write_geometry(json, "Polygon", std::array{ring_of(corners, 0.0)});
  }
  const double beyond = most_deg > kHalfTurn_deg ? 1.0 : -1.0;
  const double meridian_deg = beyond * kHalfTurn_deg;
  const Ring within = ring_of(beside(corners, meridian_deg, -beyond), 0.0);
  const Ring across = ring_of(beside(corners, meridian_deg, beyond), -beyond * kTurn_deg);
  write_geometry(json, "MultiPolygon", std::array{std::array{within}, std::array{across}});
}

void write_geojson_point(JsonWriter& json, const GeographicPosition& position) {
  write_geometry(json, "Point", position_of(within_half_turn(position)));
}

void write_geojson_line(JsonWriter& json, const GeographicPosition& from,
                        const GeographicPosition& to) {
  write_geojson_path(json, std::array{from, to});
}

void write_geojson_path(JsonWriter& json, std::span<const GeographicPosition> places) {
  std::vector<std::vector<Position>> parts;
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Line whole{within_half_turn(places[i - 1]), within_half_turn(places[i])};
    for (const Line& part : cut_at_half_turn(whole)) {
      const Position from = position_of(part.from);
      if (parts.empty() || parts.back().back() != from) parts.push_back({from});
      parts.back().push_back(position_of(part.to));
    }
  }
  if (parts.size() == 1) return write_geometry(json, "LineString", parts.front());
  write_geometry(json, "MultiLineString", parts);
}

}  // namespace beespace::io
