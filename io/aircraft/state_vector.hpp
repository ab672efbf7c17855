// One aircraft as OpenSky writes it: a state vector, an array whose places have their meaning.
#pragma once

#include "io/aircraft/aircraft_report.hpp"
#include "io/json/json_document.hpp"

#include <beespace/result.hpp>

#include <optional>

namespace beespace::io {

// Metres, metres per second, seconds since 1970; what is null is not known. Errors without place:
// kMalformedRecord, kColumnCount, kNotANumber, kOutsideDomain.
std::optional<Error> read_state_vector(JsonElement state, AircraftReport& report);

}  // namespace beespace::io
