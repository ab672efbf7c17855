// One aircraft as readsb and dump1090 write it: an object of aircraft.json, or of the JSON port.
// Older dump1090 (dump1090-mutability) has other words for the height by pressure, speed and climb.
#pragma once

#include "io/aircraft/aircraft_report.hpp"
#include "io/json/json_document.hpp"

#include <beespace/result.hpp>

namespace beespace::io {

// Whether an object is one of these and not of words of another source.
bool is_aircraft_object(JsonMap object);

// `now_s` is when the file was written; not-a-number where the object says it itself. Heights come
// in feet, speeds in knots, climbs in feet per minute, times in seconds before now. Errors without
// place, and with the key at the front of the message: kMissingColumn (hex, now), kNotANumber,
// kOutsideDomain, kMalformedRecord (a
// key that is there twice).
std::optional<Error> read_aircraft_object(JsonMap object, double now_s, AircraftReport& report);

}  // namespace beespace::io
