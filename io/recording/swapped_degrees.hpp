// Longitude and latitude under each other's name, as in one file of several: bees are thousands of
// kilometres from all others, and each of them would be beside one of these the other way round.
// What is likely is said; positions stay as they are.
#pragma once

#include "io/recording/recording.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace beespace::io {

struct SwappedDegrees {
  std::size_t bees = 0;  // how many
  std::string note;      // what is to be said of it
};

// Nothing where no bee looks so, or not in degrees.
std::optional<SwappedDegrees> swapped_degrees(const Recording& recording);

}  // namespace beespace::io
