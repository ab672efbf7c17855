// What a recording is of, as pictures, pages and files for maps call it.
#pragma once

#include "io/recording/recording.hpp"
#include "report/facts.hpp"

namespace beespace::analysis {

// By what wrote it: drones of shows and autopilots, aircraft, animals; or else bees.
report::Noun noun_of(const io::Recording& recording);

}  // namespace beespace::analysis
