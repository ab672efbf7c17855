// What the values of options mean: numbers in the units and limits of the library, or what is
// wrong. Each reader is given to Command::option.
#pragma once

#include "cli/command_line/command.hpp"
#include "io/units/stated_length.hpp"

#include <beespace/result.hpp>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace beespace::cli {

using ReadNumber = std::function<Result<double>(const Typed&)>;
using ReadCount = std::function<Result<std::uint64_t>(const Typed&)>;

// kInvalidArgument, with the way to the help of the subcommand.
Error usage_error(std::string_view command, std::string message);

// As it stands: where it matters that nothing is given.
inline Result<std::string> take_text(const Typed& typed) {
  return typed.text;
}

// A length above zero, in metres or with a unit, inside the coordinate domain, or that of what
// moves. Error: kInvalidThreshold.
Result<double> read_threshold(const Typed& typed);
Result<double> read_threshold_in_motion(const Typed& typed);
// The same as typed, so that it can be said in its own unit.
Result<io::StatedLength> read_stated_threshold(const Typed& typed);
Result<io::StatedLength> read_stated_threshold_in_motion(const Typed& typed);

// Bytes: 500MB, 4GB, 2GiB; a thousand or 1024 a step.
Result<std::uint64_t> read_memory(const Typed& typed);

// A vertical threshold, as typed; of `..._in_motion` one that what moves can be computed with.
Result<io::StatedLength> read_vertical(const Typed& typed);
Result<io::StatedLength> read_vertical_in_motion(const Typed& typed);

// A finite number from `least` on (or above it), of what `unit` says ("seconds"). Of "metres" and
// "metres per second" it may have another unit behind it.
struct Least {
  double value;
  bool itself;
};
inline constexpr Least kAboveZero{0.0, false};
inline constexpr Least kFromZero{0.0, true};
ReadNumber amount(const char* unit, Least least);
// The same, and one that what moves can be computed with: 0, or in the motion domain.
ReadNumber amount_in_motion(const char* unit, Least least);

// Of flights, within limits inside which nothing is lost to rounding: from 0.000001 to 1e6 m/s, to
// 1e9 m/s^2 (infinite for "none"), to 1e6 s; and from `least_m` to 1e9 m.
Result<double> read_speed(const Typed& typed);
Result<double> read_acceleration(const Typed& typed);
Result<double> read_span(const Typed& typed);
inline constexpr double kLeastLength_m = 1e-6;
ReadNumber length_from(double least_m);

// Seconds above zero, or "never": infinite.
Result<double> read_max_gap(const Typed& typed);

// Whole numbers; the greatest is said with or without commas between its thousands. Of threads 0
// are all.
ReadCount whole(std::uint64_t least, std::uint64_t most);
ReadCount whole_without_commas(std::uint64_t least, std::uint64_t most);
Result<unsigned> read_threads(const Typed& typed);
Result<std::uint64_t> read_max_results(const Typed& typed);
Result<std::uint64_t> read_seed(const Typed& typed);

}  // namespace beespace::cli
