// What `replay` writes of its findings: the rows of a report, and what stands before them in JSON.
#pragma once

#include "analysis/recorded/findings.hpp"
#include "cli/input/moving_output.hpp"
#include "cli/output/rows.hpp"
#include "cli/recorded/replay_command.hpp"
#include "io/json/json_writer.hpp"

namespace beespace::cli {

// Of any report but events.
Rows rows_of(const ReplayRequest& request, const analysis::Findings& findings,
             const Distances& distances);

void write_findings(io::JsonWriter& json, const analysis::Findings& findings,
                    const ReplayRequest& request, double threshold_m, const Distances& distances);

}  // namespace beespace::cli
