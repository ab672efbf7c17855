// When something is, as text.
#pragma once

#include "io/recording/recording.hpp"

#include <string>

namespace beespace::analysis {

// "2024-05-01T12:00:00.250Z"; nothing for what is not within a few thousand years of 1970.
std::string utc_text(double since_1970_s);

// "12.5 s", or the date and time where seconds count from 1970.
std::string moment_text(double time_s, const io::Recording& recording);

}  // namespace beespace::analysis
