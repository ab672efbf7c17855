// The track of one aircraft as a JSON document: trace_full_*.json of readsb and tar1090 ("trace"),
// and OpenSky's tracks ("path"). Each place in it is an array whose values have their meaning.
#pragma once

#include "io/aircraft/aircraft_report.hpp"
#include "io/json/json_document.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string_view>

namespace beespace::io {

enum class TraceKind : std::uint8_t { kReadsb, kOpenSky };

// Nothing for what is none of these.
std::optional<TraceKind> trace_kind(JsonElement root);
// The key of the list.
std::string_view trace_key(TraceKind kind);

// What is the same for all of its places: the address, the flight, and when readsb begins to count.
// Errors without place: kMissingColumn, kMalformedRecord, kNotANumber.
struct TraceHead {
  AircraftReport report = {};
  double begins_s = 0.0;
};
Result<TraceHead> read_trace_head(JsonElement root, TraceKind kind);

// One place: readsb has seconds, feet, knots and feet per minute, OpenSky metres. What is null is
// not known. A flight, once told, is that of the places behind it, too. Errors without place:
// kColumnCount, kNotANumber, kOutsideDomain.
std::optional<Error> read_trace_place(JsonElement place, TraceKind kind, TraceHead& head,
                                      AircraftReport& report);

}  // namespace beespace::io
