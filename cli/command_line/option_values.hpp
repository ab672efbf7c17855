// What options mean, as typed: numbers in the units and limits of the library, or what is wrong.
//
// `command` is the subcommand whose help an error points at.
#pragma once

#include "io/units/stated_length.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace beespace::cli {

// kInvalidArgument, with the way to the help.
Error usage_error(std::string_view command, std::string message);

// A length above zero, in metres or with a unit, inside the coordinate domain, or that of what
// moves. Error: kInvalidThreshold.
Result<double> read_threshold(const std::string& text);
Result<double> read_threshold_in_motion(const std::string& text);

// A vertical threshold, as typed; nothing where it is not given.
Result<std::optional<io::StatedLength>> read_vertical(std::string_view command,
                                                      const std::string& text);

// Whole numbers. 0 threads are all; an empty `max_results` is no limit.
Result<unsigned> read_threads(std::string_view command, const std::string& text);
Result<std::uint64_t> read_max_results(std::string_view command, const std::string& text);

// A finite number from `least` on (or above it), of what `unit` says ("seconds"). Of "metres" and
// "metres per second" it may have another unit behind it.
struct Least {
  double value;
  bool itself;
};
Result<double> read_amount(std::string_view command, const std::string& option,
                           const std::string& text, const char* unit, Least least);

// The same, or nothing where the option is not given and `text` is empty.
Result<std::optional<double>> read_optional_amount(std::string_view command,
                                                   const std::string& option,
                                                   const std::string& text, const char* unit,
                                                   Least least);

// An amount that what moves can be computed with: 0, or in the motion domain. `text` is as typed.
Status in_motion_domain(std::string_view command, const std::string& option,
                        const std::string& text, double value);

}  // namespace beespace::cli
