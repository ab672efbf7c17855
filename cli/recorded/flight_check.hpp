// Whether an input says where bees fly: what only says where they begin is no flight, nor are
// aircraft of which each is known for an instant only, and no verdict about one follows from them.
#pragma once

#include "cli/input/moving_options.hpp"
#include "io/recording/recording.hpp"

#include <beespace/result.hpp>

namespace beespace::cli {

// Errors: kUnsupportedFormat.
Status check_flight(const io::Recording& recording, const MovingRequest& request);

}  // namespace beespace::cli
