// Which bees are too close as GeoJSON (RFC 7946), for maps.
#pragma once

#include "report/facts.hpp"

#include "io/bytes/atomic_output.hpp"

#include <string>
#include <vector>

namespace beespace::report {

// Both need an origin; they return what had to be left out. A point for each bee at risk, then a
// line for each pair; of recordings, a point in the middle of each conflict where it is closest,
// then a line from one to the other, then the paths, each cut where the bee is unknown. Obstacles
// are polygons at their lowest height, with heights as properties. What is left out, and where the
// facts do not have all pairs, or conflicts, a member "note" of the collection says.
std::vector<std::string> write_geojson(const SnapshotFacts& facts, io::AtomicOutput& output);
std::vector<std::string> write_geojson(const RecordingFacts& facts, io::AtomicOutput& output);

}  // namespace beespace::report
