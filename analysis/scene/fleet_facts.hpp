// What the planner of a fleet said, of each bee of the recording of its flight.
#pragma once

#include "io/fleet/fleet_log.hpp"
#include "io/recording/recording.hpp"
#include "report/fleet_facts.hpp"

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace beespace::analysis {

// A page holds so many states at most.
inline constexpr std::size_t kMostFleetStates = 3'000'000;

// `tracks` are those of the recording. `skip_bad`: agents that the recording lacks are left out.
// Appends to `notes` what must be told. Errors: kMalformedRecord where the log is not one of
// this recording, with the place in the log; kTooManyPoints.
Result<report::FleetFacts> fleet_facts(const io::FleetLog& log, const io::Recording& recording,
                                       const std::vector<Track>& tracks, bool skip_bad,
                                       std::vector<std::string>& notes);

}  // namespace beespace::analysis
