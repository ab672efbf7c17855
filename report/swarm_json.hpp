// What the page's JSON says of every swarm, snapshot or recording.
#pragma once

#include "io/json/json_object.hpp"
#include "report/columns.hpp"
#include "report/facts.hpp"
#include "report/quantised.hpp"

#include <cstddef>

namespace beespace::report {

void add_swarm(io::JsonObject& json, const SwarmFacts& swarm, std::size_t count, Columns& columns);

// The columns x, y and z.
void add_positions(io::JsonObject& json, const Quantised& positions, Differences differences,
                   Columns& columns);

}  // namespace beespace::report
