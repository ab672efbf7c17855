// Positions and lines on the Earth as GeoJSON geometries (RFC 7946).
#pragma once

#include "io/json/json_writer.hpp"

#include <beespace/geodesy.hpp>

namespace beespace::io {

// Longitudes beyond half a turn are written within it.
void write_geojson_point(JsonWriter& json, const GeographicPosition& position);

// The short way round: where that crosses the antimeridian the line is cut in two there.
void write_geojson_line(JsonWriter& json, const GeographicPosition& from,
                        const GeographicPosition& to);

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
