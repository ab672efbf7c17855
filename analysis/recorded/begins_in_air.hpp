// Drones that fly already when their log begins: what they did before is in no record.
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "io/recording/recording.hpp"

#include <cstddef>
#include <string>

namespace beespace::analysis {

// How many begin with the recording, within a gap of its beginning, and surely in the air: by their
// own word, or clearly higher than they are later, and moving. Of drones that were flown alone:
// nothing of a plan, nor of aircraft and animals.
std::size_t begins_in_air(const io::Recording& recording, const MaxGap& max_gap);

// "12 drones are in the air when the recording begins: what was before is not known"; nothing where
// none is.
std::string begins_in_air_text(std::size_t bees);

}  // namespace beespace::analysis
