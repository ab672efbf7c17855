// Options that hold several numbers: a position, planes.
#pragma once

#include "cli/command_line/command.hpp"

#include <beespace/point.hpp>
#include <beespace/result.hpp>

#include <optional>
#include <string_view>
#include <vector>

namespace beespace::cli {

// So many finite numbers between commas; nothing where the text is something else.
std::optional<std::vector<double>> parse_numbers(std::string_view text, std::size_t count);

// "1,2.5,-3", in metres.
Result<Point> read_point(const Typed& typed);

}  // namespace beespace::cli
