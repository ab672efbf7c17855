// What the feed of Flightradar24 answers with (JSON): an object whose members are flights, each an
// array of values that have their meaning by their place, beside some numbers about the answer.
#pragma once

#include "io/json/json_document.hpp"
#include "io/recording/recording_assembly.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

bool is_flightradar24_feed(JsonElement root);

// Into the source that `assembly` has begun. Errors: kMalformedRecord, kNotANumber, and those of
// AircraftGathering.
std::optional<Error> read_flightradar24_feed(JsonElement root, RecordingAssembly& assembly);

}  // namespace beespace::io
