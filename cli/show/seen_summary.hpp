// What was seen, at a glance, for those who wait for a page or a picture of it.
#pragma once

#include "cli/analysis/see.hpp"

#include <string>

namespace beespace::cli {

void append_seen(std::string& out, const Seen& seen);

// Where it went, and how long it took.
void append_written(std::string& out, const std::string& output, const SeenTimings& timings);

}  // namespace beespace::cli
