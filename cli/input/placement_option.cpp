#include "cli/input/placement_option.hpp"

#include "cli/command_line/option_values.hpp"
#include "cli/input/number_list.hpp"

#include <beespace/geodesy.hpp>

#include <string>
#include <vector>

namespace beespace::cli {

Result<report::Placement> read_placement(const Typed& typed) {
  const auto numbers = parse_numbers(typed.text, 4);
  if (!numbers && parse_numbers(typed.text, 3)) {
    return usage_error(typed.command,
                       "--origin needs the heading of the x axis too, in degrees clockwise from "
                       "north: lon,lat,height,heading; where y is north, x is east: 90");
  }
  if (!numbers) {
    return usage_error(typed.command, "'" + std::string(typed.text) +
                                          "' is no origin; say lon,lat,height,heading, as in "
                                          "--origin 19.06,47.48,110,90");
  }
  const std::vector<double>& n = *numbers;
  const report::Placement placement{{n[0], n[1], n[2]}, n[3], false, {}};
  const auto ecef = to_ecef(placement.origin);
  if (!ecef) return usage_error(typed.command, "--origin: " + ecef.error().message);
  return placement;
}

}  // namespace beespace::cli
