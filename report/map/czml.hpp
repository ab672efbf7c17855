// Which bees are too close as CZML 1.0, for Cesium.
#pragma once

#include "report/facts.hpp"

#include "io/bytes/atomic_output.hpp"

#include <string>
#include <vector>

namespace beespace::report {

// As write_kml(). In recordings bees move, turn red while in conflict, and are joined by a line for
// as long; obstacles stand there, and round ones are round.
std::vector<std::string> write_czml(const SnapshotFacts& facts, io::AtomicOutput& output);
std::vector<std::string> write_czml(const RecordingFacts& facts, io::AtomicOutput& output);

}  // namespace beespace::report
