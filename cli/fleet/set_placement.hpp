// Where on the Earth what was set in metres is, beside what was flown in degrees.
#pragma once

#include "cli/fleet/set_beside_flown.hpp"
#include "cli/fleet/set_matches.hpp"
#include "io/recording/recording.hpp"

#include <beespace/result.hpp>
#include <beespace/track.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// Brings what was set into the frame of what was flown. Errors: kUnsupportedFormat for frames that
// cannot be compared; kInvalidArgument where the options have to say more, or less, with the line
// to type.
Status bring_together(const io::Recording& flown, const io::Recording& set,
                      const SetOptions& options, const std::vector<Match>& matches,
                      std::vector<Track>& set_tracks, std::vector<std::string>& notes);

}  // namespace beespace::cli
