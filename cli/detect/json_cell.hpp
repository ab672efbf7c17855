// The values of a table as members of a JSON object.
#pragma once

#include "analysis/snapshot/shown_ids.hpp"
#include "cli/output/table.hpp"
#include "io/json/json_writer.hpp"

#include <span>
#include <vector>

namespace beespace::cli {

// One for each column; null where there is none.
void write_cells(io::JsonWriter& json, const std::vector<Column>& columns, PointId bee,
                 const analysis::ShownIds& ids);

// An array.
void write_ids(io::JsonWriter& json, std::span<const PointId> bees, const analysis::ShownIds& ids);

}  // namespace beespace::cli
