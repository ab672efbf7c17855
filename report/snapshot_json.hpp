// A snapshot in the page's JSON.
#pragma once

#include "report/columns.hpp"
#include "report/facts.hpp"

#include <string>

namespace beespace::report {

std::string snapshot_json(const SnapshotFacts& facts, Columns& columns);

}  // namespace beespace::report
