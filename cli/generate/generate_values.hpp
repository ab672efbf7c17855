// What the options of `beespace generate` mean, as typed: numbers within its limits, or what is
// wrong with them.
#pragma once

#include "scenes/moving_scenes.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <cstdint>
#include <string>

namespace beespace::cli {

// kInvalidArgument, with the way to the help of generate.
Error generate_error(std::string message);

// A whole number from 1 to `most`.
Result<std::uint64_t> read_count(const std::string& text, const std::string& option,
                                 std::uint64_t most);

// Any whole number below 2^64.
Result<std::uint64_t> read_seed(const std::string& text);

// A length in metres that is not too extreme for a search; and the same, or 0.
Result<double> read_length(const std::string& text, const std::string& option);
Result<double> read_distance(const std::string& text, const std::string& option);

// "12800" or "3300x2300x480", in metres; an empty text is a cube of the default side.
Result<Point> read_size(const std::string& text, double default_side_m);

// "12" or "5-20", in metres per second.
Result<scenes::Speeds> read_speeds(const std::string& text);

// Seconds that are not too extreme for a search.
Result<double> read_seconds(const std::string& text, const std::string& option);

}  // namespace beespace::cli
