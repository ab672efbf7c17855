// Positions, lines and outlines on the Earth as GeoJSON geometries (RFC 7946).
#pragma once

#include "io/json/json_writer.hpp"

#include <beespace/geodesy.hpp>

#include <span>

namespace beespace::io {

// Longitudes beyond half a turn are written within it.
void write_geojson_point(JsonWriter& json, const GeographicPosition& position);

// The short way round: where that crosses the antimeridian the line is cut in two there.
void write_geojson_line(JsonWriter& json, const GeographicPosition& from,
                        const GeographicPosition& to);

// The same from each of two or more places to the next.
void write_geojson_path(JsonWriter& json, std::span<const GeographicPosition> places);

// What corner after corner encloses, either way round, the last joined to the first; smaller than
// half the Earth, around no pole. Written counterclockwise, and cut in two at the antimeridian.
void write_geojson_polygon(JsonWriter& json, std::span<const GeographicPosition> outline);

// A feature: `write_geometry` writes its geometry, `write_properties` the members of its
// properties.
void write_geojson_feature(JsonWriter& json, JsonLayout of_properties, const auto& write_geometry,
                           const auto& write_properties) {
  json.begin_object().member("type", "Feature");
  json.key("geometry");
  write_geometry();
  json.begin_object("properties", of_properties);
  write_properties();
  json.end().end();
}

}  // namespace beespace::io
