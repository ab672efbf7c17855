// The answer of detect in each form that it can be asked for.
//
// `ids` are those of the bees at risk. Everything goes to `output` in large blocks; whether it
// arrived is known at its commit().
#pragma once

#include "cli/detection.hpp"
#include "cli/shown_ids.hpp"
#include "io/atomic_output.hpp"

namespace beespace::cli {

// One id a line; with the nearest: id, nearest id, distance in metres, tab-separated.
void write_ids(const Detection& detection, const ShownIds& ids, bool nearest,
               io::AtomicOutput& output);

// The records as they stood in the input, in their own delimiter, under their header line; with
// the nearest: one more column, nearest_m.
void write_csv(const io::LoadedPoints& loaded, const Detection& detection, bool nearest,
               io::AtomicOutput& output);

// One document: what was read, what was asked, what was found.
void write_json(const io::LoadedPoints& loaded, const Detection& detection, const ShownIds& ids,
                const DetectRequest& request, io::AtomicOutput& output);

// RFC 7946: a point for every bee at risk; longitude, latitude, height as in the input, which
// must be geographic. Longitudes beyond half a turn are written within it.
void write_geojson(const io::LoadedPoints& loaded, const Detection& detection, const ShownIds& ids,
                   bool nearest, io::AtomicOutput& output);

// {"error": {...}}: what --json says instead of an answer.
std::string error_as_json(const Error& error);

}  // namespace beespace::cli
