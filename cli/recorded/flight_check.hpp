// Whether an input says where bees fly: what only says where they begin is no flight, and no
// verdict about one follows from it.
#pragma once

#include "io/recording/recording.hpp"

#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// Errors: kUnsupportedFormat.
Status check_flight(const io::Recording& recording, const std::string& path);

}  // namespace beespace::cli
