// Longitude and latitude under each other's name, as in one file of several: the bee is thousands
// of kilometres from all others, and would be beside them the other way round. What is likely is
// said; positions stay as they are.
#pragma once

#include "io/recording/recording.hpp"

#include <optional>
#include <string>

namespace beespace::io {

// What is to be said of it; nothing where no bee looks so, or not in degrees.
std::optional<std::string> swapped_degrees_note(const Recording& recording);

}  // namespace beespace::io
