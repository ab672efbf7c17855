// When something is, as text.
#pragma once

#include "io/recording/recording.hpp"

#include <string>

namespace beespace::analysis {

// "12.5 s", or the date and time where seconds count from 1970.
std::string moment_text(double time_s, const io::Recording& recording);

}  // namespace beespace::analysis
