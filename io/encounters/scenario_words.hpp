// The words of a BlueSky scenario: times, commands and their arguments.
#pragma once

#include <beespace/result.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace beespace::io {

// "0:00:10.50>CRE ..." is 10.5 s, and the commands behind it. Nothing where there is no time.
struct TimedCommands {
  double time_s = 0.0;
  std::string_view commands;
};
std::optional<TimedCommands> timed_commands(std::string_view line);

// The commands of a line, one behind each ";", each by its words in capitals: between blanks, or
// commas, two of which have an empty one between them.
std::vector<std::vector<std::string>> commands_in(std::string_view commands);

// A latitude or longitude in degrees: "52.3", "N52'18'13.5". Nothing for others, as the names of
// BlueSky's navigation data.
std::optional<double> degrees_in(std::string_view word);

// A heading in degrees from true north: "90", "90T". Nothing for others, as from magnetic north.
std::optional<double> heading_in(std::string_view word);

// In feet: "FL250", "25000".
std::optional<double> feet_in(std::string_view word);

// Calibrated, in knots, or a Mach number: "280", "M0.78", "M78", "0.78".
struct AirSpeed {
  double value = 0.0;
  bool mach = false;
};
std::optional<AirSpeed> air_speed_in(std::string_view word);

}  // namespace beespace::io
