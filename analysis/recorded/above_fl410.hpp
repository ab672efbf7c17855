// Aircraft above flight level 410, of which ICAO Doc 4444 (5.3.2) asks for 2,000 ft of vertical
// separation: 1,000 ft is for what is below, with reduced vertical separation (RVSM).
#pragma once

#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"

#include <optional>
#include <string>

namespace beespace::analysis {

// "2 aircraft fly above FL410, ...", with what to type, where a smaller vertical minimum of air
// traffic control was asked for; otherwise nothing.
std::string above_fl410_text(const io::Recording& recording, double threshold_m,
                             const std::optional<io::StatedLength>& vertical);

}  // namespace beespace::analysis
