// Documents of many aircraft -> the bees of a recording: aircraft.json of readsb and dump1090, and
// the state vectors of OpenSky.
#pragma once

#include "io/json/json_document.hpp"
#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// Whether a document is one of these.
bool is_aircraft_document(JsonElement root);

// Into the source that `assembly` has begun. Errors have the record, and of the whole none.
std::optional<Error> read_aircraft_document(JsonElement root, RecordingAssembly& assembly);

}  // namespace beespace::io
