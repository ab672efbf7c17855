// When by the clock of what was flown that was begun which was set.
#pragma once

#include "cli/fleet/set_beside_flown.hpp"
#include "cli/fleet/set_matches.hpp"
#include "io/recording/recording.hpp"

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// By how much times of what was set are to be moved, and what is to be noted where take-offs say
// otherwise, or where there are several flights. Errors: kUnsupportedFormat for clocks that cannot
// be compared; kInvalidArgument where the options have to say more, or less, with the line to type.
Result<double> begins_of(const io::Recording& flown, const io::Recording& set,
                         const SetOptions& options, const std::vector<Track>& set_tracks,
                         const std::vector<Match>& matches, std::vector<std::string>& notes);

}  // namespace beespace::cli
