#include "cli/command_line/flight_values.hpp"

#include "cli/command_line/option_values.hpp"
#include "io/bytes/number_text.hpp"

#include <limits>

namespace beespace::cli {
namespace {

struct Range {
  double least;
  double most;
};

Result<double> read_within(std::string_view command, const char* option, const std::string& text,
                           const char* unit, const Range& range) {
  const auto value = io::parse_amount(text, unit);
  if (value && *value >= range.least && *value <= range.most) return *value;
  return usage_error(command, std::string(option) + " '" + text + "' is not a number of " + unit +
                                  " from " + io::grouped(range.least, range.least > 0.0 ? 6 : 0) +
                                  " to " + io::grouped(range.most, 0));
}

}  // namespace

Result<double> read_speed(std::string_view command, const char* option, const std::string& text) {
  return read_within(command, option, text, "metres per second", {1e-6, 1e6});
}

Result<double> read_acceleration(std::string_view command, const char* option,
                                 const std::string& text) {
  if (text == "none") return std::numeric_limits<double>::infinity();
  return read_within(command, option, text, "metres per second squared", {1e-6, 1e9});
}

Result<double> read_span(std::string_view command, const char* option, const std::string& text) {
  return read_within(command, option, text, "seconds", {1e-6, 1e6});
}

Result<double> read_length(std::string_view command, const char* option, const std::string& text,
                           double least_m) {
  return read_within(command, option, text, "metres", {least_m, 1e9});
}

}  // namespace beespace::cli
