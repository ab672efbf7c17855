// A snapshot in the page's JSON.
#pragma once

#include "io/json/json_writer.hpp"
#include "report/columns.hpp"
#include "report/facts.hpp"

namespace beespace::report {

void write_swarm(io::JsonWriter& json, const SnapshotFacts& facts, Columns& columns);

}  // namespace beespace::report
