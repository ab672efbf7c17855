// Which bees are too close as GeoJSON (RFC 7946), for maps.
#pragma once

#include "report/facts.hpp"

#include "io/bytes/atomic_output.hpp"

namespace beespace::report {

// Both need an origin. A point for each bee at risk, then a line for each pair; of recordings, a
// point in the middle of each conflict where it is closest, then a line from one to the other.
// Where the facts do not have all pairs, or conflicts, the collection has a member "note" that says
// so.
void write_geojson(const SnapshotFacts& facts, io::AtomicOutput& output);
void write_geojson(const RecordingFacts& facts, io::AtomicOutput& output);

}  // namespace beespace::report
