// --max-gap: how far two fixes may be apart in time (see analysis/recorded/gaps.hpp).
#pragma once

#include <beespace/result.hpp>

#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
}

namespace beespace::cli {

void add_max_gap_option(CLI::App& command, std::string& max_gap, const char* group);

// As typed: nothing, "never" (infinite), or seconds above zero. Errors: kInvalidArgument.
Result<std::optional<double>> read_max_gap(const char* command, const std::string& text);

}  // namespace beespace::cli
