// Aircraft above flight level 410, of which ICAO Doc 4444 (5.3.2) asks for 2,000 ft of vertical
// separation: 1,000 ft is for what is below, with reduced vertical separation (RVSM).
#pragma once

#include "io/recording/recording.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/conflict.hpp>
#include <beespace/find_conflicts.hpp>
#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <optional>
#include <string>
#include <vector>

namespace beespace::analysis {

// "2 aircraft fly above FL410, ...", with what to type, where a smaller vertical minimum of air
// traffic control was asked for; otherwise nothing.
std::string above_fl410_text(const io::Recording& recording, double threshold_m,
                             const std::optional<io::StatedLength>& vertical);

// Where above_fl410_text() says something: when two of whom one is above that level come closer
// than 2,000 ft in height, and than the threshold over ground. `options` found the conflicts of the
// tracks, with that vertical threshold. Errors: those of find_conflicts().
Result<std::vector<Conflict>> closer_above_fl410(const io::Recording& recording,
                                                 const std::vector<Track>& tracks,
                                                 const std::optional<io::StatedLength>& vertical,
                                                 const ConflictOptions& options);

}  // namespace beespace::analysis
