// Conflicts that are hardly any: of two that keep nearly the whole vertical minimum, as those on
// adjacent flight levels whose heights go in steps, or waver.
#pragma once

#include "cli/input/moving_output.hpp"
#include "io/recording/recording.hpp"

#include <beespace/conflict.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// "all 7 conflicts are within 50 ft of the vertical limit: --threshold 5NM --vertical 900ft would
// leave 0", where most are; and of aircraft whose heights go in steps "25 ft is one step of the
// reported heights, and 1 conflict is by no more than that: --threshold 5NM --vertical 975ft leaves
// it out". Otherwise nothing.
std::string near_limit_text(const std::vector<Conflict>& conflicts, const MovingRequest& request,
                            const Distances& distances, const io::Recording& recording);

}  // namespace beespace::cli
