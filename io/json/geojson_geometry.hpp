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

}  // namespace beespace::io
