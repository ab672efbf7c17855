// Which bees are too close as KML 2.2, for globes.
#pragma once

#include "report/facts.hpp"

#include "io/bytes/atomic_output.hpp"

#include <string>
#include <vector>

namespace beespace::report {

// Both need an origin; they return what had to be left out, which the file says too. Those at risk
// as placemarks, pairs as lines; of recordings paths as tracks in time, and conflicts as placemarks
// where they are closest, for as long as they last. Obstacles as their faces, or down to the ground
// where they have no lower end. Seconds that do not count from 1970 are shown as if they did.
std::vector<std::string> write_kml(const SnapshotFacts& facts, io::AtomicOutput& output);
std::vector<std::string> write_kml(const RecordingFacts& facts, io::AtomicOutput& output);

}  // namespace beespace::report
