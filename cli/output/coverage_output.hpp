// Of how much of a recording it is known where its bees were, as it is printed.
#pragma once

#include "analysis/recorded/coverage.hpp"
#include "io/json/json_writer.hpp"
#include "io/recording/recording.hpp"

#include <string>

namespace beespace::cli {

// The lines of a summary: the gaps, the longest ones by name, and the bees that are there for a
// part only.
void append_coverage(std::string& out, const analysis::Coverage& coverage,
                     const io::Recording& recording);

// The same as an object of JSON.
void write_coverage(io::JsonWriter& json, const analysis::Coverage& coverage,
                    const io::Recording& recording);

// Of records that were left out: the lines of a summary, and members in JSON.
void append_missing(std::string& out, const io::MissingRecords& missing);
void write_missing(io::JsonWriter& json, const io::MissingRecords& missing);

}  // namespace beespace::cli
