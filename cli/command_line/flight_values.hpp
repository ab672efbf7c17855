// What options about flying mean, as typed: within limits inside which nothing is lost to rounding.
//
// `command` is the subcommand whose help an error points at, `option` what the value was given for.
#pragma once

#include <beespace/result.hpp>

#include <string>
#include <string_view>

namespace beespace::cli {

// From 0.000001 to 1e6 m/s.
Result<double> read_speed(std::string_view command, const char* option, const std::string& text);

// From 0.000001 to 1e9 m/s^2; or infinite for "none".
Result<double> read_acceleration(std::string_view command, const char* option,
                                 const std::string& text);

// From 0.000001 to 1e6 s.
Result<double> read_span(std::string_view command, const char* option, const std::string& text);

// From `least_m` to 1e9 m.
inline constexpr double kLeastLength_m = 1e-6;
Result<double> read_length(std::string_view command, const char* option, const std::string& text,
                           double least_m);

}  // namespace beespace::cli
