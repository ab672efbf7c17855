// What `watch` says of reports that cannot be read, and of bees whose reports do not go together.
// `line` is where the last one was read: "line 12".
#pragma once

#include "io/live/report_lines.hpp"

#include <beespace/result.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

// Faster than anything flies, than it says itself, or than it ever moved before, and back.
std::string jump_text(const std::string& bee, const std::string& line, double time_s);
// Out of a place that it had left before.
std::string thawed_text(const std::string& bee, const std::string& line, double time_s);
// To and fro between two places.
std::string shared_text(const std::string& bee, const std::string& line, double time_s);
// At two places at one time.
std::string contrary_text(const std::string& bee, double time_s);

// Two vehicles, of which each counts its times from when it was switched on. `live`: lines come as
// things happen.
Error own_clocks_problem(const std::string& first, const io::ReportLine& second, bool live);

// Of lines that all were no reports: the first error, and how many follow.
Error none_understood(const std::vector<Error>& errors);

}  // namespace beespace::cli
