// A drone show as Verge Aero and Finale 3D exchange it (VVIZ): JSON with homes and the ways from
// sample to sample.
//
// Sources: "VVIZ Format" in the manual of Verge Aero's Design Studio, and the specification of the
// format in the documentation of Finale 3D. A drone is at home (homeX, homeY, homeZ) at first; each
// sample says by how much it has moved (dx, dy, dz) since the one before it, and how long that
// took: dt in seconds, or else 1 / defaultPositionRate. Of the frame "ogl" x is to the right, y up
// and z forward. All times are timeOffsetSecs later. Lengths are those of a scene in metres, which
// the file does not say.
#pragma once

#include "io/json/json_document.hpp"
#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// Whether a JSON text is one: it has performances.
bool is_vviz(JsonElement root);

// Into the source that `assembly` has begun. Errors of a drone have its record.
std::optional<Error> read_vviz(JsonElement root, RecordingAssembly& assembly);

}  // namespace beespace::io
