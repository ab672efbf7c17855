// How a drone show keeps the limits that it declares, for pages.
#pragma once

#include "io/recording/recording.hpp"
#include "report/facts.hpp"

#include <beespace/result.hpp>

namespace beespace::analysis {

// Sets `declared` and `excesses` of a show in metres that declares limits; of many excesses the
// greatest are kept, and a note says of how many. Errors: those of check_path(), with the bee's id.
Status take_show_limits(const io::Recording& recording, report::RecordingFacts& facts);

}  // namespace beespace::analysis
