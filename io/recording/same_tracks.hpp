// Bees that have the same track, fix for fix: one flight that was read twice, as of two acts of a
// show, or of a copy. They are in conflict with each other all the time.
#pragma once

#include "io/recording/recording.hpp"

#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

// What is to be said of them; nothing where there are none.
std::optional<std::string> same_tracks_note(const std::vector<RecordedBee>& bees);

}  // namespace beespace::io
