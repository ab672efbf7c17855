// What the options of `beespace generate` mean: numbers within its limits, or what is wrong with
// them.
#pragma once

#include "cli/command_line/command.hpp"
#include "scenes/moving_scenes.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <string>

namespace beespace::cli {

// kInvalidArgument, with the way to the help of generate.
Error generate_error(std::string message);

// A length in metres that is not too extreme for a search; and the same, or 0.
Result<double> read_length(const Typed& typed);
Result<double> read_distance(const Typed& typed);

// "12800", a cube, or "3300x2300x480", in metres.
Result<Point> read_size(const Typed& typed);

// "12" or "5-20", in metres per second.
Result<scenes::Speeds> read_speeds(const Typed& typed);

// Seconds that are not too extreme for a search.
Result<double> read_seconds(const Typed& typed);

}  // namespace beespace::cli
