#include "cli/input/max_gap_option.hpp"

#include "cli/command_line/option_values.hpp"
#include "io/bytes/number_text.hpp"

#include <CLI/CLI.hpp>

#include <cmath>
#include <limits>

namespace beespace::cli {

void add_max_gap_option(CLI::App& command, std::string& max_gap, const char* group) {
  command
      .add_option("--max-gap", max_gap,
                  "Unknown between fixes farther apart in time\n(default: 5 times the typical "
                  "interval)")
      ->type_name("SECONDS|never")
      ->group(group);
}

Result<std::optional<double>> read_max_gap(const char* command, const std::string& text) {
  if (text.empty()) return std::optional<double>();
  if (text == "never") return std::optional<double>(std::numeric_limits<double>::infinity());
  const auto seconds = io::parse_number(text);
  if (seconds && *seconds > 0.0 && std::isfinite(*seconds)) return std::optional<double>(*seconds);
  return usage_error(command,
                     "--max-gap '" + text + "' is not a number of seconds above 0, nor 'never'");
}

}  // namespace beespace::cli
