// Documents of many aircraft -> the bees of a recording: aircraft.json of readsb and dump1090, and
// the state vectors of OpenSky.
#pragma once

#include "io/json/json_document.hpp"
#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>
#include <string_view>

namespace beespace::io {

// Whether a document is one of these.
bool is_aircraft_document(JsonElement root);

// Into the source that `assembly` has begun. Errors have the record, and of the whole none.
std::optional<Error> read_aircraft_document(JsonElement root, RecordingAssembly& assembly);

// Whether the first line of a text is such a document, or one aircraft with a time of its own.
bool is_aircraft_lines(std::string_view text);

// The same, one a line. Errors have the line.
std::optional<Error> read_aircraft_lines(std::string_view text, RecordingAssembly& assembly);

}  // namespace beespace::io
