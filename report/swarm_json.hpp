// What the page's JSON says of every swarm, snapshot or recording.
#pragma once

#include "io/json/json_writer.hpp"
#include "report/columns.hpp"
#include "report/facts.hpp"
#include "report/quantised.hpp"

#include <cstddef>
#include <vector>

namespace beespace::report {

void write_facts(io::JsonWriter& json, const SwarmFacts& swarm, std::size_t count,
                 Columns& columns);

// The columns x, y and z.
void write_positions(io::JsonWriter& json, const Quantised& positions, Differences differences,
                     Columns& columns);

// How far apart pairs are horizontally and in height: columns, where there are any; or members.
void write_apart(io::JsonWriter& json, const std::vector<Apart>& apart, Columns& columns);
void write_apart(io::JsonWriter& json, const Apart& apart);

}  // namespace beespace::report
