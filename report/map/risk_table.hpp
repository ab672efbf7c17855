// Which bees are too close as a table for spreadsheets (CSV, RFC 4180).
#pragma once

#include "report/facts.hpp"

#include "io/bytes/atomic_output.hpp"

#include <string>
#include <string_view>

namespace beespace::report {

// One row a pair, the closest first: both ids, the distance, where both are.
void write_risk_table(const SnapshotFacts& facts, io::AtomicOutput& output);
// One row a conflict, the closest first: both ids, when, how close, where both are then.
void write_risk_table(const RecordingFacts& facts, io::AtomicOutput& output);

// A text that a spreadsheet would take for a formula, as one that it takes for text: with an
// apostrophe before. Numbers, which begin with a digit behind a sign or none, stay as they are.
std::string harmless_in_spreadsheets(std::string_view text);

}  // namespace beespace::report
