// Drones that fly already when their log begins: what they did before is in no record.
#pragma once

#include "analysis/recorded/gaps.hpp"
#include "io/recording/recording.hpp"

#include <beespace/point.hpp>

#include <cstddef>
#include <string>

namespace beespace::analysis {

// How many begin with the recording, within a gap of its beginning, and surely in the air: by their
// own word, or clearly higher than they are later, and moving or just above where they come down.
// Of drones that were flown alone:
// nothing of a plan, nor of aircraft and animals.
std::size_t begins_in_air(const io::Recording& recording, const MaxGap& max_gap);

// Whether nothing speaks against it that this bee stands on the ground at its first fix: it does
// not move over ground then, and is neither above where it took off, by its own word, nor clearly
// higher than it is later.
bool may_stand_at_first(const io::Recording& recording, PointId number);

// "12 drones are in the air when the recording begins: what was before is not known"; nothing where
// none is.
std::string begins_in_air_text(std::size_t bees);

}  // namespace beespace::analysis
