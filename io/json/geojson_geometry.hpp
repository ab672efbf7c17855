// Positions and lines on the Earth as GeoJSON geometries (RFC 7946).
#pragma once

#include <beespace/geodesy.hpp>

#include <string>

namespace beespace::io {

// Longitudes beyond half a turn are written within it.
void append_geojson_point(std::string& out, const GeographicPosition& position);

// The short way round: where that crosses the antimeridian the line is cut in two there.
void append_geojson_line(std::string& out, const GeographicPosition& from,
                         const GeographicPosition& to);

}  // namespace beespace::io
