// Drones that are numbered, but for some: as where a file of a show, or a log, was forgotten.
#pragma once

#include "io/recording/recording.hpp"

#include <optional>
#include <string>
#include <vector>

namespace beespace::io {

// Where all ids are the same but for a number at their end, and few numbers between the least and
// the greatest are not there: which ones.
std::optional<std::string> missing_numbers_note(const std::vector<RecordedBee>& bees);

}  // namespace beespace::io
