// A recording in the page's JSON.
#pragma once

#include "report/columns.hpp"
#include "report/facts.hpp"

#include <string>

namespace beespace::report {

// Of very long recordings every second fix is left out, or more; the JSON says so.
std::string recording_json(const RecordingFacts& facts, Columns& columns);

}  // namespace beespace::report
