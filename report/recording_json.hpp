// A recording in the page's JSON.
#pragma once

#include "io/json/json_writer.hpp"
#include "report/columns.hpp"
#include "report/facts.hpp"

namespace beespace::report {

// Of very long recordings every second fix is left out, or more; the JSON says so.
void write_swarm(io::JsonWriter& json, const RecordingFacts& facts, Columns& columns);

}  // namespace beespace::report
