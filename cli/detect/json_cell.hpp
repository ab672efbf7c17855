// The values of a table as members of a JSON object.
#pragma once

#include "analysis/snapshot/shown_ids.hpp"
#include "cli/output/table.hpp"

#include <string>
#include <vector>

namespace beespace::cli {

// ", "name": value" for each column; null where there is none.
void append_json_members(std::string& out, const std::vector<Column>& columns, PointId bee,
                         const analysis::ShownIds& ids);

// "[1, 2]".
void append_json_ids(std::string& out, std::span<const PointId> bees,
                     const analysis::ShownIds& ids);

}  // namespace beespace::cli
